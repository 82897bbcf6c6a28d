// SPDX-License-Identifier: Apache-2.0
// MPU2 (paper, section 4.3): up to three contacts in one look-up a clock, which may also write its
// device. A scan: start_i is sampled while busy_o is 0; the clocks from that edge to the first
// that samples done_o as 1 are a constant of the program, and clocks_o counts them. The load port
// is described in core/load_port.v. rst_ni is synchronous and has to last 5 clocks; it leaves all
// memories alone.
`default_nettype none

module mpu2 #(
    parameter STEPS = 512,  // depth of the instruction memory, a power of two
    parameter BIT_DEVICES = 1024,  // a power of two
    parameter WORD_DEVICES = 256,  // a power of two
    parameter MUL_DSP = 0,  // 1: MUL in multiplier blocks, 0: by iteration
    parameter MUL_LATENCY = 18,  // clocks until MUL can be collected, not less than muldiv.v says
    parameter DIV_LATENCY = 19  // the same of DIV
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    // scan: error_o is 1 from an executed division by 0 until the next start
    input  wire        start_i,
    output wire        busy_o,
    output wire        done_o,
    output wire        error_o,
    output wire [31:0] clocks_o,
    // the steps of a run and the words they write: core/core.v
    input  wire        range_i,
    input  wire [15:0] entry_i,
    input  wire [15:0] end_i,
    output wire [ 0:0] write_valid_o,
    output wire [15:0] write_addr_o,
    output wire [15:0] write_data_o,
    // load port
    input  wire        load_valid_i,
    input  wire        load_write_i,
    input  wire [ 2:0] load_space_i,
    input  wire [19:0] load_addr_i,
    input  wire [15:0] load_data_i,
    output wire        load_rvalid_o,
    output wire [15:0] load_rdata_o
`ifdef RUNG_RETIRE
    ,
    // retire port: what completes in this clock
    output wire [ 0:0] retire_valid_o,
    output wire [15:0] retire_step_o,
    output wire [ 0:0] retire_exc_o,
    output wire [ 0:0] retire_bit_we_o,
    output wire [15:0] retire_bit_addr_o,
    output wire [ 0:0] retire_bit_data_o,
    output wire [ 0:0] retire_word_we_o,
    output wire [15:0] retire_word_addr_o,
    output wire [15:0] retire_word_data_o
`endif
);

  core #(
      .LOOKUP(1),
      .SLOTS(1),
      .STEPS(STEPS),
      .BIT_DEVICES(BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES),
      .MUL_DSP(MUL_DSP),
      .MUL_LATENCY(MUL_LATENCY),
      .DIV_LATENCY(DIV_LATENCY)
  ) core (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(start_i),
      .busy_o(busy_o),
      .done_o(done_o),
      .error_o(error_o),
      .clocks_o(clocks_o),
      .range_i(range_i),
      .entry_i(entry_i),
      .end_i(end_i),
      .write_valid_o(write_valid_o),
      .write_addr_o(write_addr_o),
      .write_data_o(write_data_o),
      .load_valid_i(load_valid_i),
      .load_write_i(load_write_i),
      .load_space_i(load_space_i),
      .load_addr_i(load_addr_i),
      .load_data_i(load_data_i),
      .load_rvalid_o(load_rvalid_o),
      .load_rdata_o(load_rdata_o)
`ifdef RUNG_RETIRE
      ,
      .retire_valid_o(retire_valid_o),
      .retire_step_o(retire_step_o),
      .retire_exc_o(retire_exc_o),
      .retire_bit_we_o(retire_bit_we_o),
      .retire_bit_addr_o(retire_bit_addr_o),
      .retire_bit_data_o(retire_bit_data_o),
      .retire_word_we_o(retire_word_we_o),
      .retire_word_addr_o(retire_word_addr_o),
      .retire_word_data_o(retire_word_data_o)
`endif
  );

endmodule

`default_nettype wire
