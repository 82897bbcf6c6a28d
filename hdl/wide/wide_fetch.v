// SPDX-License-Identifier: Apache-2.0
// Scan control of MPU4: program counter, latched inputs, clock counter, and where each step's row goes.
// start_i is sampled at edge 0. Latch row i, sampled then too, is on the bus (b) in clock 3 + i, behind the last row
// of the scan before; the row of step t in clock 9 + t and, for latch rows beyond six, as many clocks later. done
// comes in the first clock in which a new start cannot overtake the last step's row: `fill` clocks beside those of
// the steps (hdl/isa/wide.toml).
`default_nettype none
`include "rung_wide.vh"

module wide_fetch #(
    parameter SLOTS = 16,
    parameter PC_BITS = 9,
    parameter LATCH_ROWS = 8,  // at most
    parameter LATCH_BITS = 4  // of a number of latch rows
) (
    input  wire                                  clk_i,
    input  wire                                  rst_ni,
    input  wire                                  start_i,
    input  wire [          LATCH_ROWS*SLOTS-1:0] in_i,
    output wire                                  busy_o,
    output wire                                  done_o,
    output wire [                          31:0] clocks_o,
    // the program's: steps, first latch row, number of latch rows
    input  wire [                     PC_BITS:0] length_i,
    input  wire [`RUNG_WIDE_LAYOUT_ROW_BITS-1:0] latch_row_i,
    input  wire [                LATCH_BITS-1:0] latch_rows_i,
    output wire [                   PC_BITS-1:0] f1_pc_o,
    output wire                                  f2_valid_o,
    // a latch row, for the bus of the next clock
    output wire                                  latch_valid_o,
    output wire [                     SLOTS-1:0] latch_bits_o,
    // IF3: what the load port does
    input  wire [`RUNG_WIDE_LAYOUT_ROW_BITS-1:0] l_host_row_i,
    input  wire                                  l_bit_we_i,
    input  wire                                  l_word_we_i,
    // EX, after EX, and a clock later
    output wire                                  x_start_o,
    output wire                                  w_valid_o,
    output wire                                  b_bit_we_o,
    output wire                                  b_word_we_o,
    output wire [`RUNG_WIDE_LAYOUT_ROW_BITS-1:0] w_addr_o,
    output wire [`RUNG_WIDE_LAYOUT_ROW_BITS-1:0] b_addr_o
);

  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam [LATCH_BITS-1:0] LATCH_FREE = `RUNG_WIDE_SCAN_LATCH_FREE;

  reg  busy_q;
  wire start = start_i && !busy_q;

  // ---- latch rows ------------------------------------------------------------------------------
  reg start_1_q, start_2_q, x_start_q;
  always @(posedge clk_i) {start_1_q, start_2_q, x_start_q} <= {start, start_1_q, start_2_q};

  reg [LATCH_ROWS*SLOTS-1:0] latch_q;
  reg [LATCH_BITS-1:0] latch_left_q;
  reg latch_valid_q;
  reg [ROW_BITS-1:0] latch_row_q;
  always @(posedge clk_i) begin
    // Sampled in every clock in which a scan may start: start_i itself would have to reach all these registers.
    if (!busy_q) begin
      latch_q <= in_i;
      latch_left_q <= latch_rows_i;
      latch_row_q <= latch_row_i;
    end else if (latch_valid_q) begin
      latch_q <= latch_q >> SLOTS;
      latch_left_q <= latch_left_q - 1'b1;
      latch_row_q <= latch_row_q + 1'b1;
    end
    if (!rst_ni) latch_valid_q <= 1'b0;
    else if (start_1_q) latch_valid_q <= latch_left_q != {LATCH_BITS{1'b0}};
    else if (latch_left_q == {{LATCH_BITS - 1{1'b0}}, 1'b1}) latch_valid_q <= 1'b0;
  end
  assign latch_valid_o = latch_valid_q;
  assign latch_bits_o  = latch_q[SLOTS-1:0];

  // ---- IF1 -------------------------------------------------------------------------------------
  reg [LATCH_BITS-1:0] wait_q;
  reg f1_active_q;
  reg [PC_BITS:0] f1_pc_q;
  wire f1_run = f1_active_q && wait_q == {LATCH_BITS{1'b0}};
  wire f1_end = f1_run && f1_pc_q == length_i;
  wire f1_valid = f1_run && f1_pc_q != length_i;
  always @(posedge clk_i) begin
    if (!busy_q) begin
      f1_active_q <= start_i;
      f1_pc_q <= {PC_BITS + 1{1'b0}};
      wait_q <= latch_rows_i > LATCH_FREE ? latch_rows_i - LATCH_FREE : {LATCH_BITS{1'b0}};
    end else if (f1_run) begin
      f1_active_q <= !f1_end;
      f1_pc_q <= f1_pc_q + 1'b1;
    end else begin
      wait_q <= wait_q - 1'b1;
    end
    if (!rst_ni) f1_active_q <= 1'b0;
  end
  assign f1_pc_o = f1_pc_q[PC_BITS-1:0];

  // ---- IF2, IF3; the end is four clocks behind that in IF1 -------------------------------------
  reg f2_valid_q, f3_valid_q, f2_end_q, f3_end_q, d1_end_q, d2_end_q;
  reg [PC_BITS-1:0] f2_pc_q;
  reg [PC_BITS-1:0] f3_pc_q;
  always @(posedge clk_i) begin
    f2_valid_q <= f1_valid && rst_ni;
    f3_valid_q <= f2_valid_q && rst_ni;
    f2_end_q   <= f1_end && rst_ni;
    f3_end_q   <= f2_end_q && rst_ni;
    d1_end_q   <= f3_end_q && rst_ni;
    d2_end_q   <= d1_end_q && rst_ni;
    f2_pc_q    <= f1_pc_q[PC_BITS-1:0];
    f3_pc_q    <= f2_pc_q;
  end
  assign f2_valid_o = f2_valid_q;

  reg done_q;
  reg [31:0] clocks_q;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q   <= 1'b0;
      done_q   <= 1'b0;
      clocks_q <= 32'd0;
    end else if (start) begin
      busy_q   <= 1'b1;
      done_q   <= 1'b0;
      clocks_q <= 32'd1;
    end else if (busy_q) begin
      clocks_q <= clocks_q + 32'd1;
      if (d2_end_q) begin
        busy_q <= 1'b0;
        done_q <= 1'b1;
      end
    end
  end
  assign busy_o   = busy_q;
  assign done_o   = done_q;
  assign clocks_o = clocks_q;

  // ---- where the row goes: with the step to the end of EX --------------------------------------
  wire [ROW_BITS-1:0] f3_step_row = {{ROW_BITS - PC_BITS{1'b0}}, f3_pc_q};
  reg d1_valid_q, d2_valid_q, d3_valid_q, x_valid_q, w_valid_q;
  reg d1_bit_we_q, d2_bit_we_q, d3_bit_we_q, x_bit_we_q, w_bit_we_q;
  reg d1_word_we_q, d2_word_we_q, d3_word_we_q, x_word_we_q, w_word_we_q;
  reg [ROW_BITS-1:0] d1_row_q;
  reg [ROW_BITS-1:0] d2_row_q;
  reg [ROW_BITS-1:0] d3_row_q;
  reg [ROW_BITS-1:0] x_row_q;
  reg [ROW_BITS-1:0] w_row_q;
  always @(posedge clk_i) begin
    d1_row_q <= (f3_step_row & {ROW_BITS{f3_valid_q}}) | l_host_row_i;
    d1_valid_q <= f3_valid_q && rst_ni;
    d1_bit_we_q <= (f3_valid_q || l_bit_we_i) && rst_ni;
    d1_word_we_q <= (f3_valid_q || l_word_we_i) && rst_ni;
    {d2_row_q, d3_row_q, x_row_q, w_row_q} <= {d1_row_q, d2_row_q, d3_row_q, x_row_q};
    {d2_valid_q, d3_valid_q, x_valid_q, w_valid_q} <= {
      d1_valid_q, d2_valid_q, d3_valid_q, x_valid_q
    };
    {d2_bit_we_q, d3_bit_we_q, x_bit_we_q, w_bit_we_q} <= {
      d1_bit_we_q, d2_bit_we_q, d3_bit_we_q, x_bit_we_q
    };
    {d2_word_we_q, d3_word_we_q, x_word_we_q, w_word_we_q} <= {
      d1_word_we_q, d2_word_we_q, d3_word_we_q, x_word_we_q
    };
  end
  assign x_start_o = x_start_q;
  assign w_valid_o = w_valid_q;
  reg b_bit_we_q, b_word_we_q;
  reg [ROW_BITS-1:0] b_row_q;
  always @(posedge clk_i) begin
    b_bit_we_q <= w_bit_we_q || latch_valid_q;
    b_word_we_q <= w_word_we_q;
    b_row_q <= latch_valid_q ? latch_row_q : w_row_q;
  end
  assign b_bit_we_o  = b_bit_we_q;
  assign b_word_we_o = b_word_we_q;
  assign b_addr_o    = b_row_q;
  assign w_addr_o    = w_row_q;

endmodule

`default_nettype wire
