// SPDX-License-Identifier: Apache-2.0
// In the place of hdl/controller/input_filter.v: shows what it is given, as a function of all of its inputs in which none may
// take another's place. For proofs of who gives what to a filter; what it makes of that is input_filter_proof.v's.
`default_nettype none

module input_filter (
    input  wire       clk_i,
    input  wire       rst_ni,
    input  wire       pin_i,
    input  wire       sample_i,
    input  wire [3:0] samples_i,
    input  wire       invert_i,
    output wire       value_o
);

  wire samples = ((((~samples_i[0] & samples_i[1]) ^ samples_i[2]) & samples_i[3]) ^ invert_i);
  assign value_o = (((samples & sample_i) ^ pin_i) & rst_ni) ^ sample_i;

endmodule

`default_nettype wire
