// SPDX-License-Identifier: Apache-2.0
// Any program whatever, in the place of hdl/core/fetch.v: any steps, with gaps, of any number, from the
// third clock after a start on, until an end token; held like its own. What fetch_proof.v shows of the real
// one is what is kept here.
`default_nettype none

module fetch #(
    parameter STEPS = 256,
    parameter STEP_BITS = 90
) (
    input  wire                 clk_i,
    input  wire                 rst_ni,
    input  wire                 start_i,
    input  wire                 range_i,
    input  wire [         15:0] entry_i,
    input  wire [         15:0] end_i,
    output wire                 scan_start_o,
    output wire                 busy_o,
    output wire                 done_o,
    output wire [         31:0] clocks_o,
    input  wire                 load_chunk_i,
    input  wire                 load_length_i,
    input  wire [         19:0] load_addr_i,
    input  wire [         15:0] load_data_i,
    input  wire [STEP_BITS-1:0] l_step_i,
    input  wire                 d1_hold_i,
    output wire [STEP_BITS-1:0] f3_step_o,
    output wire [STEP_BITS-1:0] d1_step_o,
    output wire                 d1_valid_o,
    output wire [         15:0] d1_number_o
);

  (* anyseq *)wire [STEP_BITS-1:0] step;
  (* anyseq *)wire [15:0] number;
  (* anyseq *)wire valid;
  (* anyseq *)wire finish;

  reg busy_q, done_q, ended_q, d1_end_q, d2_end_q, d3_end_q;
  reg [1:0] since_q;  // clocks since the start
  wire f3_may = busy_q && since_q == 2'd3 && !ended_q;
  wire f3_valid = f3_may && valid;
  wire f3_end = f3_may && !valid && finish;
  reg d1_valid_q;
  reg [15:0] d1_number_q;
  reg [STEP_BITS-1:0] d1_step_q;

  assign scan_start_o = start_i && !busy_q;
  assign busy_o = busy_q;
  assign done_o = done_q;
  assign clocks_o = 32'd0;
  assign f3_step_o = (step & {STEP_BITS{f3_valid}}) | l_step_i;
  assign d1_step_o = d1_step_q;
  assign d1_valid_o = d1_valid_q;
  assign d1_number_o = d1_number_q;

  always @(posedge clk_i) begin
    if (since_q != 2'd3) since_q <= since_q + 2'd1;
    if (!d1_hold_i) begin
      d1_valid_q <= f3_valid;
      d1_number_q <= number;
      d1_step_q <= f3_step_o;
      d1_end_q <= f3_end;
      if (f3_end) ended_q <= 1'b1;
    end
    d2_end_q <= d1_end_q;
    d3_end_q <= d2_end_q;
    if (d3_end_q) {busy_q, done_q} <= 2'b01;
    if (scan_start_o) {busy_q, done_q, ended_q, since_q} <= 5'b10001;
    if (!rst_ni) begin
      {busy_q, done_q, ended_q} <= 3'b000;
      {d1_end_q, d2_end_q, d3_end_q, d1_valid_q} <= 4'd0;
      d1_step_q <= {STEP_BITS{1'b0}};
    end
  end

  wire unused = &{1'b0, STEPS != 0, range_i, entry_i, end_i, load_chunk_i, load_length_i,
                  load_addr_i, load_data_i};

endmodule

`default_nettype wire
