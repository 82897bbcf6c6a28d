// SPDX-License-Identifier: Apache-2.0
// Scan control and the fetch stages: IF1 addresses the instruction memory with the program counter,
// IF2 takes its data into a register, IF3 moves them to ID1. On a large FPGA the memory's block
// RAMs lie all over the chip, and IF3 is the way from there. Straight-line code: the counter runs
// from 0 to the program's length, or from an entry to an end, then an end token follows the last
// step down the pipeline. A run of no steps is the token alone.
// Takes start; gives one step a clock to ID1, done, busy and the clocks of the scan.
`default_nettype none

module fetch #(
    parameter STEPS = 256,  // depth of the instruction memory
    parameter STEP_BITS = 90  // bits of one step, all slots
) (
    input  wire                 clk_i,
    input  wire                 rst_ni,
    // scan: start_i is looked at when busy_o is 0; scan_start_o is 1 in the clock that accepts it
    input  wire                 start_i,
    // sampled with start_i: 0: all of the program; 1: steps entry_i to end_i - 1
    input  wire                 range_i,
    input  wire [         15:0] entry_i,
    input  wire [         15:0] end_i,
    output wire                 scan_start_o,
    output wire                 busy_o,
    output wire                 done_o,
    output wire [         31:0] clocks_o,
    // load port: 16-bit chunk of a step (address: step * 8 + chunk), and the program's length
    input  wire                 load_chunk_i,
    input  wire                 load_length_i,
    input  wire [         19:0] load_addr_i,
    input  wire [         15:0] load_data_i,
    // a host access as a step, all 0 if there is none; only while no scan is fetching
    input  wire [STEP_BITS-1:0] l_step_i,
    // IF3: the step that ID1 has next, unless it holds; ID1: the step. All 0, NOPs, between scans
    input  wire                 d1_hold_i,
    output wire [STEP_BITS-1:0] f3_step_o,
    output wire [STEP_BITS-1:0] d1_step_o
`ifdef RUNG_RETIRE
    ,
    // ID1: a step of the program, and its number
    output wire                 d1_valid_o,
    output wire [         15:0] d1_number_o
`endif
);

  localparam PC_BITS = $clog2(STEPS);
  localparam CHUNKS = (STEP_BITS + 15) / 16;

  // ---- scan control ----------------------------------------------------------------------------
  reg busy_q;
  reg done_q;
  reg d2_end_q;
  reg d3_end_q;
  reg [31:0] clocks_q;
  reg [PC_BITS:0] length_q;

  assign scan_start_o = start_i && !busy_q;
  assign busy_o = busy_q;
  assign done_o = done_q;
  assign clocks_o = clocks_q;

  always @(posedge clk_i) begin
    if (scan_start_o) begin
      clocks_q <= 32'd1;
    end else if (busy_q) begin
      clocks_q <= clocks_q + 32'd1;
    end
    if (load_length_i) length_q <= load_data_i[PC_BITS:0];

    if (!rst_ni) begin
      busy_q   <= 1'b0;
      done_q   <= 1'b0;
      clocks_q <= 32'd0;
      length_q <= {PC_BITS + 1{1'b0}};
    end else if (scan_start_o) begin
      busy_q <= 1'b1;
      done_q <= 1'b0;
    end else if (d3_end_q) begin
      busy_q <= 1'b0;
      done_q <= 1'b1;
    end
  end

  // ---- IF1 -------------------------------------------------------------------------------------
  reg f1_active_q;
  reg [PC_BITS:0] f1_pc_q;
  reg [PC_BITS:0] f1_stop_q;  // the step behind the last one
  wire f1_end = f1_active_q && f1_pc_q == f1_stop_q;
  wire f1_valid = f1_active_q && f1_pc_q != f1_stop_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      f1_active_q <= 1'b0;
    end else if (scan_start_o) begin
      f1_active_q <= 1'b1;
      f1_pc_q <= range_i ? entry_i[PC_BITS:0] : {PC_BITS + 1{1'b0}};
      // The length may be loaded in the clock before start.
      f1_stop_q <= range_i ? end_i[PC_BITS:0] :
          load_length_i ? load_data_i[PC_BITS:0] : length_q;
    end else if (!d1_hold_i) begin
      f1_active_q <= f1_valid;
      f1_pc_q <= f1_pc_q + 1'b1;
    end
  end

  // One memory a chunk, so that a chunk is written without reading the others. The load port is far
  // from them too: its accesses take a clock to get there.
  reg [CHUNKS-1:0] m_write_q;
  reg [PC_BITS-1:0] m_addr_q;
  reg [15:0] m_data_q;
  integer i;
  always @(posedge clk_i) begin
    for (i = 0; i < CHUNKS; i = i + 1) m_write_q[i] <= load_chunk_i && load_addr_i[2:0] == i[2:0];
    m_addr_q <= load_addr_i[3+:PC_BITS];
    m_data_q <= load_data_i;
  end

  wire [STEP_BITS-1:0] f2_step;
  genvar chunk;
  generate
    for (chunk = 0; chunk < CHUNKS; chunk = chunk + 1) begin : g_chunk
      localparam CHUNK_BITS = STEP_BITS - 16 * chunk < 16 ? STEP_BITS - 16 * chunk : 16;
      bank_ram #(
          .WIDTH(CHUNK_BITS),
          .DEPTH(STEPS),
          .ADDR_BITS(PC_BITS),
          .CLEARED(0)
      ) memory (
          .clk_i(clk_i),
          .read_i(!d1_hold_i),
          .read_addr_i(f1_pc_q[PC_BITS-1:0]),
          .read_data_o(f2_step[16*chunk+:CHUNK_BITS]),
          .write_i(m_write_q[chunk]),
          .write_addr_i(m_addr_q),
          .write_data_i(m_data_q[CHUNK_BITS-1:0])
      );
    end
  endgenerate

  wire unused_addr = &{1'b0, load_addr_i[19:3+PC_BITS]};
  wire unused_range = &{1'b0, entry_i[15:PC_BITS], end_i[15:PC_BITS]};

  // ---- IF2, IF3 --------------------------------------------------------------------------------
  reg f2_valid_q;
  reg f2_end_q;
  reg f3_valid_q;
  reg f3_end_q;
  reg d1_end_q;
  reg [STEP_BITS-1:0] f3_step_q;
  reg [STEP_BITS-1:0] d1_step_q;

  assign f3_step_o = (f3_step_q & {STEP_BITS{f3_valid_q}}) | l_step_i;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      f2_valid_q <= 1'b0;
      f2_end_q   <= 1'b0;
      f3_valid_q <= 1'b0;
      f3_end_q   <= 1'b0;
      d1_end_q   <= 1'b0;
      d1_step_q  <= {STEP_BITS{1'b0}};
    end else if (!d1_hold_i) begin
      f2_valid_q <= f1_valid;
      f2_end_q   <= f1_end;
      f3_valid_q <= f2_valid_q;
      f3_end_q   <= f2_end_q;
      f3_step_q  <= f2_step;
      d1_end_q   <= f3_end_q;
      d1_step_q  <= f3_step_o;
    end
    // A step that holds ID1 is not the end, so the token needs no hold of its own.
    d2_end_q <= d1_end_q && rst_ni;
    d3_end_q <= d2_end_q && rst_ni;
  end

  assign d1_step_o = d1_step_q;

`ifdef RUNG_RETIRE
  reg [PC_BITS-1:0] f2_number_q;
  reg [PC_BITS-1:0] f3_number_q;
  reg [PC_BITS-1:0] d1_number_q;
  reg d1_valid_q;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      d1_valid_q <= 1'b0;
    end else if (!d1_hold_i) begin
      f2_number_q <= f1_pc_q[PC_BITS-1:0];
      f3_number_q <= f2_number_q;
      d1_number_q <= f3_number_q;
      d1_valid_q  <= f3_valid_q;
    end
  end
  assign d1_valid_o  = d1_valid_q;
  assign d1_number_o = {{16 - PC_BITS{1'b0}}, d1_number_q};
`endif

endmodule

`default_nettype wire
