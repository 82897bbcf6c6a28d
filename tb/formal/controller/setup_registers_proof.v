// SPDX-License-Identifier: Apache-2.0
// Space setup (hdl/controller/setup_registers.v): each bit of what the scan controller and the pins are told is the one that was
// last written to the address that hdl/isa/controller.toml gives it, at its place in that word, and 0 since a reset; no
// other write and nothing else changes it. The table is here by its numbers, not by the header that is made of it.
`default_nettype none

module setup_registers_proof #(
    parameter integer INPUTS  = 32,
    parameter integer OUTPUTS = 32
) (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        write_i,
    input wire [ 7:0] addr_i,
    input wire [15:0] data_i
);

  wire [8:0] latch_count, refresh_count;
  wire [7:0] refresh_first;
  wire [11:0] exchange_points;
  wire [31:0] period, watchdog, pwm_hz;
  wire [15:0] filter_clocks;
  wire [23:0] adc_route;
  wire [5*INPUTS-1:0] filter;
  wire [3*OUTPUTS-1:0] outputs;

  setup_registers #(
      .INPUTS (INPUTS),
      .OUTPUTS(OUTPUTS)
  ) setup (
      .clk_i            (clk_i),
      .rst_ni           (rst_ni),
      .write_i          (write_i),
      .addr_i           (addr_i),
      .data_i           (data_i),
      .latch_count_o    (latch_count),
      .refresh_first_o  (refresh_first),
      .refresh_count_o  (refresh_count),
      .exchange_points_o(exchange_points),
      .period_o         (period),
      .watchdog_o       (watchdog),
      .filter_clocks_o  (filter_clocks),
      .pwm_hz_o         (pwm_hz),
      .adc_route_o      (adc_route),
      .filter_o         (filter),
      .output_o         (outputs)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // Any address, and the word that was last written there.
  (* anyconst *) wire [7:0] address;
  reg [15:0] word_q;
  always @(posedge clk_i) begin
    if (!rst_ni) word_q <= 16'd0;
    else if (write_i && addr_i == address) word_q <= data_i;
  end

  wire [7:0] input_pin = address - 8'd64;
  wire [7:0] output_pin = address - 8'd128;
  wire [2:0] channel = address[2:0];
  always @* begin
    if (begun_q) begin
      case (address)
        8'd0: assert (latch_count == word_q[8:0]);
        8'd1: assert (refresh_first == word_q[7:0]);
        8'd2: assert (refresh_count == word_q[8:0]);
        8'd3: assert (exchange_points == word_q[11:0]);
        8'd4: assert (period[15:0] == word_q);
        8'd5: assert (period[31:16] == word_q);
        8'd6: assert (watchdog[15:0] == word_q);
        8'd7: assert (watchdog[31:16] == word_q);
        8'd8: assert (filter_clocks == word_q);
        8'd9: assert (pwm_hz[15:0] == word_q);
        8'd10: assert (pwm_hz[31:16] == word_q);
        default: ;
      endcase
      if (address >= 8'd16 && address < 8'd24) assert (adc_route[3*channel+:3] == word_q[2:0]);
      if (address >= 8'd64 && input_pin < INPUTS) assert (filter[5*input_pin+:5] == word_q[4:0]);
      if (address >= 8'd128 && output_pin < OUTPUTS) begin
        assert (outputs[3*output_pin+:3] == word_q[2:0]);
      end
    end
  end

  always @* begin
    cover (begun_q && address == 8'd90 && filter[5*26+:5] == 5'd19);
    cover (begun_q && watchdog == 32'h00020001);
  end

endmodule

`default_nettype wire
