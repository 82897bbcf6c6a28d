// SPDX-License-Identifier: Apache-2.0
// The processor: fetch, SLOTS slots side by side, their LUTs, the device memories and the load
// port. The three processors are three sets of parameters (mpu1.v, mpu2.v, mpu3.v); ports are
// described there and in ../README.md.
`default_nettype none
`include "rung_isa.vh"

module core #(
    parameter LOOKUP = 1,  // 1: look-up slots (MPU2, MPU3), 0: one contact at a time (MPU1)
    parameter SLOTS = 1,
    parameter STEPS = 256,  // depth of the instruction memory
    parameter BIT_DEVICES = 1024,
    parameter WORD_DEVICES = 256,
    parameter MUL_DSP = 1,  // 1: MUL in multiplier blocks, 0: by iteration
    parameter MUL_LATENCY = 3,  // see muldiv.v
    parameter DIV_LATENCY = 19,
    parameter MUL32_LATENCY = 34,
    parameter DIV32_LATENCY = 37
) (
    input  wire                             clk_i,
    input  wire                             rst_ni,
    // scan
    input  wire                             start_i,
    output wire                             busy_o,
    output wire                             done_o,
    output wire                             error_o,
    output wire [                     31:0] clocks_o,
    // the steps that a run is, sampled with start_i: 0: all of the program; 1: entry_i to end_i - 1
    input  wire                             range_i,
    input  wire [                     15:0] entry_i,
    input  wire [                     15:0] end_i,
    // words that the program's steps write, slot 0 lowest, 16 bits a slot where not 1; the last ones
    // come in the clock after the first with done_o. Two slots never write the same word at once
    output wire [                SLOTS-1:0] write_valid_o,
    output wire [             SLOTS*16-1:0] write_addr_o,
    output wire [             SLOTS*16-1:0] write_data_o,
    // load port
    input  wire                             load_valid_i,
    input  wire                             load_write_i,
    input  wire [                      2:0] load_space_i,
    input  wire [                     19:0] load_addr_i,
    input  wire [                     15:0] load_data_i,
    output wire                             load_rvalid_o,
    output wire [                     15:0] load_rdata_o
`ifdef RUNG_RETIRE
    ,
    // retire port: what completes in EX in this clock, slot 0 lowest; 16 bits a slot where not 1
    output wire [                SLOTS-1:0] retire_valid_o,
    output wire [             SLOTS*16-1:0] retire_step_o,
    output wire [                SLOTS-1:0] retire_exc_o,
    output wire [                SLOTS-1:0] retire_bit_we_o,
    output wire [             SLOTS*16-1:0] retire_bit_addr_o,
    output wire [                SLOTS-1:0] retire_bit_data_o,
    output wire [                SLOTS-1:0] retire_word_we_o,
    output wire [             SLOTS*16-1:0] retire_word_addr_o,
    output wire [             SLOTS*16-1:0] retire_word_data_o
`endif
);

  localparam BIT_ADDR = $clog2(BIT_DEVICES);
  localparam WORD_ADDR = $clog2(WORD_DEVICES);
  localparam READS = LOOKUP != 0 ? 3 : 1;
  localparam BITS = `RUNG_WORD_BITS;
  `include "fields.vh"

  // ---- load port -------------------------------------------------------------------------------
  wire busy;
  wire l_chunk, l_lut, l_length;
  wire [19:0] l_addr;
  wire [15:0] l_data;
  wire [SLOT_BITS-1:0] l_instruction;
  wire w_access;
  wire [SLOTS-1:0] w_bit_value;
  wire [SLOTS*BITS-1:0] w_word_value;

  load_port #(
      .LOOKUP(LOOKUP),
      .BIT_ADDR(BIT_ADDR),
      .WORD_ADDR(WORD_ADDR),
      .INSTRUCTION_BITS(SLOT_BITS)
  ) load_port (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .busy_i(busy),
      .load_valid_i(load_valid_i),
      .load_write_i(load_write_i),
      .load_space_i(load_space_i),
      .load_addr_i(load_addr_i),
      .load_data_i(load_data_i),
      .load_rvalid_o(load_rvalid_o),
      .load_rdata_o(load_rdata_o),
      .l_chunk_o(l_chunk),
      .l_lut_o(l_lut),
      .l_length_o(l_length),
      .l_addr_o(l_addr),
      .l_data_o(l_data),
      .l_instruction_o(l_instruction),
      .w_access_o(w_access),
      .w_bit_i(w_bit_value[0]),
      .w_word_i(w_word_value[0+:BITS])
  );

  // ---- IF1, IF2, IF3 ---------------------------------------------------------------------------
  wire scan_start;
  wire d1_hold;
  wire [SLOTS*SLOT_BITS-1:0] f3_step;
  wire [SLOTS*SLOT_BITS-1:0] d1_step;
  wire unused_f3_step = &{1'b0, f3_step};  // of IF3 only the opcodes matter
  wire [SLOTS*SLOT_BITS-1:0] l_step;
  assign l_step[SLOT_BITS-1:0] = l_instruction;
  generate
    if (SLOTS > 1) begin : g_other_slots
      assign l_step[SLOTS*SLOT_BITS-1:SLOT_BITS] = {(SLOTS - 1) * SLOT_BITS{1'b0}};
    end
  endgenerate
`ifdef RUNG_RETIRE
  wire d1_valid;
  wire [15:0] d1_number;
`endif

  fetch #(
      .STEPS(STEPS),
      .STEP_BITS(SLOTS * SLOT_BITS)
  ) fetch (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(start_i),
      .range_i(range_i),
      .entry_i(entry_i),
      .end_i(end_i),
      .scan_start_o(scan_start),
      .busy_o(busy),
      .done_o(done_o),
      .clocks_o(clocks_o),
      .load_chunk_i(l_chunk),
      .load_length_i(l_length),
      .load_addr_i(l_addr),
      .load_data_i(l_data),
      .l_step_i(l_step),
      .d1_hold_i(d1_hold),
      .f3_step_o(f3_step),
      .d1_step_o(d1_step)
`ifdef RUNG_RETIRE
      ,
      .d1_valid_o(d1_valid),
      .d1_number_o(d1_number)
`endif
  );
  assign busy_o = busy;

  // ---- ID1: waiting steps ----------------------------------------------------------------------
  wire d1_first, d1_last;
  wire [SLOTS*`RUNG_OP_BITS-1:0] f3_op;
  wire [SLOTS*`RUNG_OP_BITS-1:0] d1_op;

  sequencer #(
      .SLOTS(SLOTS),
      .MUL_LATENCY(MUL_LATENCY),
      .DIV_LATENCY(DIV_LATENCY),
      .MUL32_LATENCY(MUL32_LATENCY),
      .DIV32_LATENCY(DIV32_LATENCY)
  ) sequencer (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .f3_op_i(f3_op),
      .d1_first_o(d1_first),
      .d1_last_o(d1_last),
      .d1_hold_o(d1_hold)
  );

  // ---- device memories -------------------------------------------------------------------------
  wire [SLOTS*READS*BIT_ADDR-1:0] d1_bit_addr;
  wire [SLOTS*READS*SLOTS-1:0] d2_bit_bank;
  wire [SLOTS*SLOTS-1:0] d2_bit_cross;
  wire [SLOTS*BIT_ADDR-1:0] d2_bit_dest, d3_bit_dest, x_bit_dest, w_bit_dest;
  wire [SLOTS-1:0] x_bit_we, w_bit_we, w_bit_bank, v_bit_value, v_bit_bank;

  // A slot reads the device that it writes anyway: it is operand c.
  device_memory #(
      .SLOTS(SLOTS),
      .READS(READS),
      .CROSS(0),
      .WIDTH(1),
      .DEPTH(BIT_DEVICES),
      .ADDR_BITS(BIT_ADDR)
  ) bit_memory (
      .clk_i(clk_i),
      .d1_addr_i(d1_bit_addr),
      .d1_dest_i({SLOTS * BIT_ADDR{1'b0}}),
      .d2_bank_o(d2_bit_bank),
      .d2_cross_o(d2_bit_cross),
      .w_we_i(w_bit_we),
      .w_dest_i(w_bit_dest),
      .w_bank_i(w_bit_bank)
  );
  wire unused_bit_cross = &{1'b0, d2_bit_cross};

  wire [SLOTS*2*WORD_ADDR-1:0] d1_word_addr;
  wire [SLOTS*WORD_ADDR-1:0] d1_word_dest, d2_word_dest, d3_word_dest, x_word_dest, w_word_dest;
  wire [SLOTS*2*SLOTS*BITS-1:0] d2_word_bank;
  wire [SLOTS*SLOTS*BITS-1:0] d2_word_cross;
  wire [SLOTS-1:0] x_word_we, w_word_we;
  wire [SLOTS*BITS-1:0] w_word_bank, v_word_value, v_word_bank;

  device_memory #(
      .SLOTS(SLOTS),
      .READS(2),
      .CROSS(1),
      .WIDTH(BITS),
      .DEPTH(WORD_DEVICES),
      .ADDR_BITS(WORD_ADDR)
  ) word_memory (
      .clk_i(clk_i),
      .d1_addr_i(d1_word_addr),
      .d1_dest_i(d1_word_dest),
      .d2_bank_o(d2_word_bank),
      .d2_cross_o(d2_word_cross),
      .w_we_i(w_word_we),
      .w_dest_i(w_word_dest),
      .w_bank_i(w_word_bank)
  );

  // ---- slots -----------------------------------------------------------------------------------
  wire [SLOTS-1:0] w_div_by_0;
  genvar s;
  generate
    for (s = 0; s < SLOTS; s = s + 1) begin : g_slot
      wire [`RUNG_ROW_BITS-1:0] d1_row;
      wire [7:0] d2_row;
      assign f3_op[s*`RUNG_OP_BITS+:`RUNG_OP_BITS] = f3_step[s*SLOT_BITS+OP_AT+:`RUNG_OP_BITS];
      assign d1_op[s*`RUNG_OP_BITS+:`RUNG_OP_BITS] = d1_step[s*SLOT_BITS+OP_AT+:`RUNG_OP_BITS];

      if (LOOKUP != 0) begin : g_lut
        bank_ram #(
            .WIDTH(8),
            .DEPTH(`RUNG_LUT_ROWS),
            .ADDR_BITS(`RUNG_ROW_BITS)
        ) lut (
            .clk_i(clk_i),
            .read_i(1'b1),
            .read_addr_i(d1_row),
            .read_data_o(d2_row),
            .write_i(l_lut),
            .write_addr_i(l_addr[`RUNG_ROW_BITS-1:0]),
            .write_data_i(l_data[7:0])
        );
      end else begin : g_no_lut
        assign d2_row = 8'd0;
        wire unused_lut = &{1'b0, l_lut, d1_row};
      end

      slot #(
          .LOOKUP(LOOKUP),
          .SLOTS(SLOTS),
          .SLOT(s),
          .READS(READS),
          .BIT_ADDR(BIT_ADDR),
          .WORD_ADDR(WORD_ADDR),
          .FIELD_BITS(OP_AT),
          .MUL_DSP(MUL_DSP)
      ) slot (
          .clk_i(clk_i),
          .rst_ni(rst_ni),
          .scan_start_i(scan_start),
          .f3_op_i(f3_op[s*`RUNG_OP_BITS+:`RUNG_OP_BITS]),
          .d1_hold_i(d1_hold),
          .d1_op_i(d1_op[s*`RUNG_OP_BITS+:`RUNG_OP_BITS]),
          .d1_fields_i(d1_step[s*SLOT_BITS+:OP_AT]),
          .d1_first_i(d1_first),
          .d1_last_i(d1_last),
          .d1_bit_addr_o(d1_bit_addr[s*READS*BIT_ADDR+:READS*BIT_ADDR]),
          .d1_row_o(d1_row),
          .d1_word_addr_o(d1_word_addr[s*2*WORD_ADDR+:2*WORD_ADDR]),
          .d1_word_dest_o(d1_word_dest[s*WORD_ADDR+:WORD_ADDR]),
          .d2_row_i(d2_row),
          .d2_bit_bank_i(d2_bit_bank[s*READS*SLOTS+:READS*SLOTS]),
          .d2_word_bank_i(d2_word_bank[s*2*SLOTS*BITS+:2*SLOTS*BITS]),
          .d2_word_cross_i(d2_word_cross[s*SLOTS*BITS+:SLOTS*BITS]),
          .d2_bit_dest_o(d2_bit_dest[s*BIT_ADDR+:BIT_ADDR]),
          .d3_bit_dest_o(d3_bit_dest[s*BIT_ADDR+:BIT_ADDR]),
          .x_bit_dest_o(x_bit_dest[s*BIT_ADDR+:BIT_ADDR]),
          .w_bit_dest_o(w_bit_dest[s*BIT_ADDR+:BIT_ADDR]),
          .x_bit_we_o(x_bit_we[s]),
          .w_bit_we_o(w_bit_we[s]),
          .w_bit_value_o(w_bit_value[s]),
          .w_bit_bank_o(w_bit_bank[s]),
          .v_bit_value_o(v_bit_value[s]),
          .v_bit_bank_o(v_bit_bank[s]),
          .d2_word_dest_o(d2_word_dest[s*WORD_ADDR+:WORD_ADDR]),
          .d3_word_dest_o(d3_word_dest[s*WORD_ADDR+:WORD_ADDR]),
          .x_word_dest_o(x_word_dest[s*WORD_ADDR+:WORD_ADDR]),
          .w_word_dest_o(w_word_dest[s*WORD_ADDR+:WORD_ADDR]),
          .x_word_we_o(x_word_we[s]),
          .w_word_we_o(w_word_we[s]),
          .w_word_value_o(w_word_value[s*BITS+:BITS]),
          .w_word_bank_o(w_word_bank[s*BITS+:BITS]),
          .v_word_value_o(v_word_value[s*BITS+:BITS]),
          .v_word_bank_o(v_word_bank[s*BITS+:BITS]),
          .d2_bit_dest_i(d2_bit_dest),
          .d3_bit_dest_i(d3_bit_dest),
          .x_bit_dest_i(x_bit_dest),
          .w_bit_dest_i(w_bit_dest),
          .x_bit_we_i(x_bit_we),
          .w_bit_we_i(w_bit_we),
          .w_bit_value_i(w_bit_value),
          .w_bit_bank_i(w_bit_bank),
          .v_bit_value_i(v_bit_value),
          .v_bit_bank_i(v_bit_bank),
          .d2_word_dest_i(d2_word_dest),
          .d3_word_dest_i(d3_word_dest),
          .x_word_dest_i(x_word_dest),
          .w_word_dest_i(w_word_dest),
          .x_word_we_i(x_word_we),
          .w_word_we_i(w_word_we),
          .w_word_value_i(w_word_value),
          .w_word_bank_i(w_word_bank),
          .v_word_value_i(v_word_value),
          .v_word_bank_i(v_word_bank),
          .w_div_by_0_o(w_div_by_0[s])
`ifdef RUNG_RETIRE
          ,
          .x_exc_next_o(retire_exc_o[s]),
          .x_bit_value_o(retire_bit_data_o[s]),
          .x_word_value_o(retire_word_data_o[s*16+:16])
`endif
      );
    end
  endgenerate

  // ---- error flag: any executed division by 0 in this scan, in time for the earliest done ------
  reg error_q;
  assign error_o = error_q || |w_div_by_0;
  always @(posedge clk_i) begin
    error_q <= error_o && !scan_start && rst_ni;
  end

  // ---- words written, in registers of their own: what reads them may lie far away -----------------
  reg [SLOTS-1:0] write_valid_q;
  reg [SLOTS*WORD_ADDR-1:0] write_addr_q;
  reg [SLOTS*BITS-1:0] write_data_q;
  always @(posedge clk_i) begin
    write_valid_q <= w_word_we & {SLOTS{rst_ni}};
    if (w_access) write_valid_q[0] <= 1'b0;
    write_addr_q <= w_word_dest;
    write_data_q <= w_word_value;
  end
  assign write_valid_o = write_valid_q;
  assign write_data_o  = write_data_q;
  generate
    for (s = 0; s < SLOTS; s = s + 1) begin : g_write
      assign write_addr_o[s*16+:16] = {
        {16 - WORD_ADDR{1'b0}}, write_addr_q[s*WORD_ADDR+:WORD_ADDR]
      };
    end
  endgenerate

`ifdef RUNG_RETIRE
  // ---- retire port -----------------------------------------------------------------------------
  reg [`RUNG_OP_BITS-1:0] d1_retire_op;
  reg [SLOTS-1:0] d1_retire, d2_retire_q, d3_retire_q, x_retire_q;
  reg [15:0] d2_number_q, d3_number_q, x_number_q;
  integer r;
  always @* begin
    for (r = 0; r < SLOTS; r = r + 1) begin
      d1_retire_op = d1_op[r*`RUNG_OP_BITS+:`RUNG_OP_BITS];
      if (d1_retire_op == `RUNG_OP_MUL || d1_retire_op == `RUNG_OP_DIV ||
          d1_retire_op == `RUNG_OP_MULD || d1_retire_op == `RUNG_OP_DIVD) begin
        d1_retire[r] = d1_valid && d1_last;
      end else begin
        d1_retire[r] = d1_valid && d1_first;
      end
    end
  end
  always @(posedge clk_i) begin
    d2_retire_q <= d1_retire & {SLOTS{rst_ni}};
    d3_retire_q <= d2_retire_q & {SLOTS{rst_ni}};
    x_retire_q  <= d3_retire_q & {SLOTS{rst_ni}};
    d2_number_q <= d1_number;
    d3_number_q <= d2_number_q;
    x_number_q  <= d3_number_q;
  end
  assign retire_valid_o   = x_retire_q;
  assign retire_step_o    = {SLOTS{x_number_q}};
  assign retire_bit_we_o  = x_bit_we & x_retire_q;
  assign retire_word_we_o = x_word_we & x_retire_q;
  generate
    for (s = 0; s < SLOTS; s = s + 1) begin : g_retire
      assign retire_bit_addr_o[s*16+:16] = {
        {16 - BIT_ADDR{1'b0}}, x_bit_dest[s*BIT_ADDR+:BIT_ADDR]
      };
      assign retire_word_addr_o[s*16+:16] = {
        {16 - WORD_ADDR{1'b0}}, x_word_dest[s*WORD_ADDR+:WORD_ADDR]
      };
    end
  endgenerate
`endif

endmodule

`default_nettype wire
