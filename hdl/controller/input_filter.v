// SPDX-License-Identifier: Apache-2.0
// One input pin: two registers bring it into the clock domain, then value_o changes when `samples_i` samples
// in a row, taken in clocks with sample_i, differ from it. samples_i 0: value_o is the second register.
// invert_i turns value_o round, behind the filter.
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

  reg  [1:0] pin_q;
  reg  [3:0] differ_q;  // samples in a row that differed
  reg        steady_q;

  wire       filtered = samples_i != 4'd0;

  always @(posedge clk_i) begin
    pin_q <= {pin_q[0], pin_i};

    if (!rst_ni || !filtered) begin
      // What a filter begins with, when it is asked for.
      steady_q <= pin_q[1];
      differ_q <= 4'd0;
    end else if (sample_i) begin
      if (pin_q[1] == steady_q) begin
        differ_q <= 4'd0;
      end else if (differ_q + 4'd1 >= samples_i) begin
        steady_q <= pin_q[1];
        differ_q <= 4'd0;
      end else begin
        differ_q <= differ_q + 4'd1;
      end
    end
  end

  assign value_o = (filtered ? steady_q : pin_q[1]) ^ invert_i;

endmodule

`default_nettype wire
