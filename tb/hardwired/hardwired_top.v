// SPDX-License-Identifier: Apache-2.0
// A hard-wired program (rung_program, of `rung translate --to verilog`) as something to place and
// route: scan after scan, its ports behind hardwired_link. scripts/hardwired.py sets the widths.
`default_nettype none

module hardwired_top #(
    parameter integer HOST    = 0,
    parameter integer INPUTS  = 1,
    parameter integer CLOCKS  = 1,
    parameter integer TICKS   = 1,
    parameter integer OUTPUTS = 1,
    parameter integer STATE   = 1
) (
    input  wire clk_i,
    input  wire sdi_i,
    input  wire shift_i,
    input  wire frame_i,
    output wire sdo_o,
    output wire done_o,
    output wire error_o
);

  wire rst_n;
  wire busy;
  wire done;
  wire error;
  wire state_load;
  wire [INPUTS+CLOCKS+TICKS-1:0] in;
  wire [OUTPUTS-1:0] out;
  wire [STATE-1:0] state_in;
  wire [STATE-1:0] state_out;

  power_on_reset power_on_reset (
      .clk_i(clk_i),
      .rst_no(rst_n)
  );

  hardwired_link #(
      .HOST(HOST),
      .INPUTS(INPUTS + CLOCKS + TICKS),
      .OUTPUTS(OUTPUTS),
      .STATE(STATE)
  ) link (
      .clk_i(clk_i),
      .rst_i(~rst_n),
      .sdi_i(sdi_i),
      .shift_i(shift_i),
      .frame_i(frame_i),
      .sdo_o(sdo_o),
      .in_o(in),
      .out_i(out),
      .busy_i(busy),
      .state_load_o(state_load),
      .state_o(state_in),
      .state_i(state_out)
  );

  rung_program wired (
      .clk_i(clk_i),
      .rst_i(~rst_n),
      .start_i(rst_n & ~state_load),
      .busy_o(busy),
      .done_o(done),
      .error_o(error),
      .in_i(in[0+:INPUTS]),
      .clocks_i(in[INPUTS+:CLOCKS]),
      .ticks_i(in[INPUTS+CLOCKS+:TICKS]),
      .out_o(out),
      .state_load_i(state_load),
      .state_i(state_in),
      .state_o(state_out)
  );

  reg done_q;
  reg error_q;
  always @(posedge clk_i) begin
    done_q  <= done;
    error_q <= error;
  end
  assign done_o  = done_q;
  assign error_o = error_q;

endmodule
