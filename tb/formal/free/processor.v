// SPDX-License-Identifier: Apache-2.0
// Any processor whatever, in the place of hdl/processor.v: for proofs of what is around one.
`default_nettype none

module processor #(
    parameter integer MPU           = 3,
    parameter integer STEPS         = 256,
    parameter integer BIT_DEVICES   = 1024,
    parameter integer WORD_DEVICES  = 256,
    parameter integer MUL_DSP       = 0,
    parameter integer MUL_LATENCY   = 20,
    parameter integer DIV_LATENCY   = 20,
    parameter integer MUL32_LATENCY = 40,
    parameter integer DIV32_LATENCY = 40
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        start_i,
    output wire        done_o,
    output wire        error_o,
    output wire [31:0] clocks_o,
    input  wire        range_i,
    input  wire [15:0] entry_i,
    input  wire [15:0] end_i,
    output wire [ 1:0] write_valid_o,
    output wire [31:0] write_addr_o,
    output wire [31:0] write_data_o,
    input  wire        load_valid_i,
    input  wire        load_write_i,
    input  wire [ 2:0] load_space_i,
    input  wire [19:0] load_addr_i,
    input  wire [15:0] load_data_i,
    output wire        load_rvalid_o,
    output wire [15:0] load_rdata_o
);

  (* anyseq *) wire [116:0] any;
  assign {done_o, error_o, clocks_o, write_valid_o, write_addr_o, write_data_o} = any[116:17];
  assign {load_rvalid_o, load_rdata_o} = any[16:0];

endmodule

`default_nettype wire
