// SPDX-License-Identifier: Apache-2.0
// Output pins. During a refresh the values of its entries come one after the other (value_valid_i); with
// end_i all pins change together, in the next clock. With safe_i each pin goes to its level of the setup or,
// if that says so, keeps what it shows, from the next clock on, until the next end_i. A pin without an entry
// shows its level of the setup. After reset all pins are 0, before any setup.
// setup_i, 3 bits a pin: safe level, keeps, inverted at the pin.
// Bus: registers outputs of hdl/isa/controller.toml; rdata_o in the clock after read_i, else 0.
`default_nettype none
`include "rung_controller.vh"

module output_pins #(
    parameter integer OUTPUTS = 32  // 1 to 64
) (
    input  wire                 clk_i,
    input  wire                 rst_ni,
    output wire [  OUTPUTS-1:0] out_o,
    input  wire [3*OUTPUTS-1:0] setup_i,
    // refresh
    input  wire                 begin_i,
    input  wire                 value_valid_i,
    input  wire [          7:0] value_pin_i,
    input  wire                 value_i,
    input  wire                 end_i,
    input  wire                 safe_i,
    // bus
    input  wire                 sel_register_i,
    input  wire [          7:0] addr_i,
    input  wire                 read_i,
    output wire [         15:0] rdata_o
);

  localparam [7:0] FIRST_REGISTER = `RUNG_REG_OUTPUTS;
  localparam integer UNUSED = 64 - OUTPUTS;

  reg [OUTPUTS-1:0] next_q;
  reg [OUTPUTS-1:0] level_q;  // before inversion
  reg [OUTPUTS-1:0] out_q;

  genvar i;
  generate
    for (i = 0; i < OUTPUTS; i = i + 1) begin : g_pin
      wire safe_level = setup_i[3*i];
      wire keeps = setup_i[3*i+1];
      wire inverted = setup_i[3*i+2];
      wire level = safe_i ? (keeps ? level_q[i] : safe_level) : end_i ? next_q[i] : level_q[i];
      always @(posedge clk_i) begin
        if (begin_i) next_q[i] <= safe_level;
        else if (value_valid_i && value_pin_i == i[7:0]) next_q[i] <= value_i;

        level_q[i] <= rst_ni && level;
        out_q[i]   <= rst_ni && (level ^ inverted);
      end
    end
  endgenerate

  assign out_o = out_q;

  wire [63:0] levels;
  generate
    if (UNUSED == 0) begin : g_all
      assign levels = level_q;
    end else begin : g_some
      assign levels = {{UNUSED{1'b0}}, level_q};
    end
  endgenerate

  reg  [15:0] rdata_q;
  wire [ 7:0] offset = addr_i ^ FIRST_REGISTER;

  always @(posedge clk_i) begin
    rdata_q <= 16'd0;
    if (sel_register_i && read_i && offset[7:2] == 6'd0) rdata_q <= levels[{offset[1:0], 4'd0}+:16];
  end

  assign rdata_o = rdata_q;

endmodule

`default_nettype wire
