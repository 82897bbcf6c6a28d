// SPDX-License-Identifier: Apache-2.0
// MPU1, 2 or 3 by parameter, as controllers and board tops hold them; the other parameters are the
// processor's own (hdl/isa/configs.toml). Scan and load port are those of hdl/mpu1.v.
`default_nettype none

module processor #(
    parameter integer MPU           = 3,     // 1, 2 or 3
    parameter integer STEPS         = 256,
    parameter integer BIT_DEVICES   = 1024,
    parameter integer WORD_DEVICES  = 256,
    parameter integer MUL_DSP       = 0,
    parameter integer MUL_LATENCY   = 20,
    parameter integer DIV_LATENCY   = 20,
    parameter integer MUL32_LATENCY = 40,    // this and the next: MPU1 only
    parameter integer DIV32_LATENCY = 40
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    // scan
    input  wire        start_i,
    output wire        done_o,
    output wire        error_o,
    output wire [31:0] clocks_o,
    // the steps of a run and the words they write: core/core.v. MPU1 and MPU2 write with slot 0 alone
    input  wire        range_i,
    input  wire [15:0] entry_i,
    input  wire [15:0] end_i,
    output wire [ 1:0] write_valid_o,
    output wire [31:0] write_addr_o,
    output wire [31:0] write_data_o,
    // load port
    input  wire        load_valid_i,
    input  wire        load_write_i,
    input  wire [ 2:0] load_space_i,
    input  wire [19:0] load_addr_i,
    input  wire [15:0] load_data_i,
    output wire        load_rvalid_o,
    output wire [15:0] load_rdata_o
);

  generate
    if (MPU == 1) begin : gen_mpu1
      mpu1 #(
          .STEPS        (STEPS),
          .BIT_DEVICES  (BIT_DEVICES),
          .WORD_DEVICES (WORD_DEVICES),
          .MUL_DSP      (MUL_DSP),
          .MUL_LATENCY  (MUL_LATENCY),
          .DIV_LATENCY  (DIV_LATENCY),
          .MUL32_LATENCY(MUL32_LATENCY),
          .DIV32_LATENCY(DIV32_LATENCY)
      ) mpu (
          .clk_i        (clk_i),
          .rst_ni       (rst_ni),
          .start_i      (start_i),
          .done_o       (done_o),
          // verilator lint_off PINCONNECTEMPTY
          .busy_o       (),
          // verilator lint_on PINCONNECTEMPTY
          .error_o      (error_o),
          .clocks_o     (clocks_o),
          .range_i      (range_i),
          .entry_i      (entry_i),
          .end_i        (end_i),
          .write_valid_o(write_valid_o[0]),
          .write_addr_o (write_addr_o[15:0]),
          .write_data_o (write_data_o[15:0]),
          .load_valid_i (load_valid_i),
          .load_write_i (load_write_i),
          .load_space_i (load_space_i),
          .load_addr_i  (load_addr_i),
          .load_data_i  (load_data_i),
          .load_rvalid_o(load_rvalid_o),
          .load_rdata_o (load_rdata_o)
      );
      assign write_valid_o[1] = 1'b0;
      assign write_addr_o[31:16] = 16'd0;
      assign write_data_o[31:16] = 16'd0;
    end else if (MPU == 2) begin : gen_mpu2
      mpu2 #(
          .STEPS       (STEPS),
          .BIT_DEVICES (BIT_DEVICES),
          .WORD_DEVICES(WORD_DEVICES),
          .MUL_DSP     (MUL_DSP),
          .MUL_LATENCY (MUL_LATENCY),
          .DIV_LATENCY (DIV_LATENCY)
      ) mpu (
          .clk_i        (clk_i),
          .rst_ni       (rst_ni),
          .start_i      (start_i),
          .done_o       (done_o),
          // verilator lint_off PINCONNECTEMPTY
          .busy_o       (),
          // verilator lint_on PINCONNECTEMPTY
          .error_o      (error_o),
          .clocks_o     (clocks_o),
          .range_i      (range_i),
          .entry_i      (entry_i),
          .end_i        (end_i),
          .write_valid_o(write_valid_o[0]),
          .write_addr_o (write_addr_o[15:0]),
          .write_data_o (write_data_o[15:0]),
          .load_valid_i (load_valid_i),
          .load_write_i (load_write_i),
          .load_space_i (load_space_i),
          .load_addr_i  (load_addr_i),
          .load_data_i  (load_data_i),
          .load_rvalid_o(load_rvalid_o),
          .load_rdata_o (load_rdata_o)
      );
      assign write_valid_o[1] = 1'b0;
      assign write_addr_o[31:16] = 16'd0;
      assign write_data_o[31:16] = 16'd0;
    end else begin : gen_mpu3
      mpu3 #(
          .STEPS       (STEPS),
          .BIT_DEVICES (BIT_DEVICES),
          .WORD_DEVICES(WORD_DEVICES),
          .MUL_DSP     (MUL_DSP),
          .MUL_LATENCY (MUL_LATENCY),
          .DIV_LATENCY (DIV_LATENCY)
      ) mpu (
          .clk_i        (clk_i),
          .rst_ni       (rst_ni),
          .start_i      (start_i),
          .done_o       (done_o),
          // verilator lint_off PINCONNECTEMPTY
          .busy_o       (),
          // verilator lint_on PINCONNECTEMPTY
          .error_o      (error_o),
          .clocks_o     (clocks_o),
          .range_i      (range_i),
          .entry_i      (entry_i),
          .end_i        (end_i),
          .write_valid_o(write_valid_o),
          .write_addr_o (write_addr_o),
          .write_data_o (write_data_o),
          .load_valid_i (load_valid_i),
          .load_write_i (load_write_i),
          .load_space_i (load_space_i),
          .load_addr_i  (load_addr_i),
          .load_data_i  (load_data_i),
          .load_rvalid_o(load_rvalid_o),
          .load_rdata_o (load_rdata_o)
      );
    end
  endgenerate

endmodule

`default_nettype wire
