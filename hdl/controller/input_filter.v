// SPDX-License-Identifier: Apache-2.0
// One input pin: two registers against metastability, then a filter that lets a new level through when
// `samples_i` samples in a row have it; 0: not filtered. sample_i is 1 for the clock of a sample.
`default_nettype none

module input_filter (
    input  wire       clk_i,
    input  wire       rst_ni,
    input  wire       sample_i,
    input  wire [3:0] samples_i,
    input  wire       invert_i,
    input  wire       pin_i,
    output wire       level_o
);

  reg [1:0] pin_q;
  reg [3:0] count_q;
  reg level_q;
  wire level = pin_q[1] ^ invert_i;

  always @(posedge clk_i) begin
    pin_q <= {pin_q[0], pin_i};
    if (!rst_ni) begin
      level_q <= 1'b0;
      count_q <= 4'd0;
    end else if (samples_i == 4'd0) begin
      level_q <= level;
      count_q <= 4'd0;
    end else if (sample_i) begin
      if (level == level_q) begin
        count_q <= 4'd0;
      end else if (count_q + 4'd1 >= samples_i) begin
        level_q <= level;
        count_q <= 4'd0;
      end else begin
        count_q <= count_q + 4'd1;
      end
    end
  end

  assign level_o = level_q;

endmodule

`default_nettype wire
