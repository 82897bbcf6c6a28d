// SPDX-License-Identifier: Apache-2.0
// The network of MPU4, seen from one operand (hdl/wide/row_operand.v): whatever the slots compute, whatever rows are
// written, an instruction that is in ID1 three clocks before has in EX exactly the value that its place names
// (hdl/wide/README.md, distances of hdl/isa/wide.toml). Results, rows, places are free in every clock.
`default_nettype none
`include "rung_wide.vh"

module wide_operand_proof #(
    parameter WIDTH = 1,
    parameter LANES = 4,
    parameter LANE_BITS = 2,
    parameter ADDR_BITS = 2,
    parameter NEAR_ONLY = 0  // 1: nothing of the memory is asserted, so that induction goes through
) (
    input wire clk_i,
    input wire [LANE_BITS-1:0] lane_i,
    input wire [`RUNG_WIDE_LAYOUT_ROW_BITS-1:0] row_i,
    input wire other_i,
    input wire [WIDTH-1:0] other_value_i,
    input wire [WIDTH-1:0] own_i,
    input wire [LANES*WIDTH-1:0] bus_i,
    input wire we_i,
    input wire [ADDR_BITS-1:0] addr_i
);

  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam NEAR_BITS = ROW_BITS - `RUNG_WIDE_LAYOUT_SPECIAL_BITS;
  localparam AGES = 5;

  // Any row: what is shown of it is shown of all.
  (* anyconst *) wire [ADDR_BITS-1:0] watched;

  wire [WIDTH-1:0] value;
  row_operand #(
      .WIDTH(WIDTH),
      .LANES(LANES),
      .LANE_BITS(LANE_BITS),
      .ADDR_BITS(ADDR_BITS)
  ) operand (
      .clk_i(clk_i),
      .d1_lane_i(lane_i),
      .d1_row_i(row_i),
      .d1_other_i(other_i),
      .d3_other_i(other_value_i),
      .w_own_i(own_i),
      .b_row_i(bus_i),
      .b_we_i(we_i),
      .b_addr_i(addr_i),
      .x_value_o(value)
  );

  // What was there so many clocks ago.
  reg [LANE_BITS-1:0] lane_q[1:AGES];
  reg [ROW_BITS-1:0] row_q[1:AGES];
  reg other_q[1:AGES];
  reg [WIDTH-1:0] other_value_q[1:AGES];
  reg [WIDTH-1:0] own_q[1:AGES];
  reg [LANES*WIDTH-1:0] bus_q[1:AGES];
  reg we_q[1:AGES];
  reg [ADDR_BITS-1:0] addr_q[1:AGES];
  reg [3:0] age_q;
  initial age_q = 4'd0;
  integer i;
  always @(posedge clk_i) begin
    lane_q[1] <= lane_i;
    row_q[1] <= row_i;
    other_q[1] <= other_i;
    other_value_q[1] <= other_value_i;
    own_q[1] <= own_i;
    bus_q[1] <= bus_i;
    we_q[1] <= we_i;
    addr_q[1] <= addr_i;
    for (i = 2; i <= AGES; i = i + 1) begin
      lane_q[i] <= lane_q[i-1];
      row_q[i] <= row_q[i-1];
      other_q[i] <= other_q[i-1];
      other_value_q[i] <= other_value_q[i-1];
      own_q[i] <= own_q[i-1];
      bus_q[i] <= bus_q[i-1];
      we_q[i] <= we_q[i-1];
      addr_q[i] <= addr_q[i-1];
    end
    if (age_q != 4'd15) age_q <= age_q + 4'd1;
  end

  // The watched row as the instruction in EX may see it: what was on the bus five clocks ago or before, which
  // is what steps up to distance.memory before it have computed.
  reg [LANES*WIDTH-1:0] word_q;
  reg word_known_q;
  initial word_known_q = 1'b0;
  always @(posedge clk_i) begin
    if (age_q > 4'd4 && we_q[4] && addr_q[4] == watched) begin
      word_q <= bus_q[4];
      word_known_q <= 1'b1;
    end
  end

  wire [LANE_BITS-1:0] lane = lane_q[3];
  wire [NEAR_BITS-1:0] near = row_q[3][NEAR_BITS-1:0];
  wire special = &row_q[3][ROW_BITS-1:NEAR_BITS];
  wire is_other = other_q[3] || (special && near == `RUNG_WIDE_NEAR_FLAG);
  wire is_near = special && !other_q[3];
  wire is_row = NEAR_ONLY == 0 && word_known_q && !special && !is_other &&
      row_q[3][ADDR_BITS-1:0] == watched;
  // distance.memory - 1: the read meets the write, and nobody may want it.
  wire meets = we_q[4] && addr_q[4] == watched;

  always @* begin
    if (age_q > 4'd6) begin
      if (is_other) assert (value == other_value_q[1]);
      if (is_near && near == `RUNG_WIDE_NEAR_ZERO) assert (value == {WIDTH{1'b0}});
      if (is_near && near == `RUNG_WIDE_NEAR_OWN_FIRST) assert (value == own_i);
      if (is_near && near == `RUNG_WIDE_NEAR_OWN_FIRST + 1) assert (value == own_q[1]);
      if (is_near && near == `RUNG_WIDE_NEAR_OWN_LAST) assert (value == own_q[2]);
      if (is_near && near == `RUNG_WIDE_NEAR_BUS_FIRST)
        assert (value == bus_q[2][lane*WIDTH+:WIDTH]);
      if (is_near && near == `RUNG_WIDE_NEAR_BUS_FIRST + 1)
        assert (value == bus_q[3][lane*WIDTH+:WIDTH]);
      if (is_near && near == `RUNG_WIDE_NEAR_BUS_LAST)
        assert (value == bus_q[4][lane*WIDTH+:WIDTH]);
      if (is_row && !meets) assert (value == word_q[lane*WIDTH+:WIDTH]);
    end
  end

  // Each way to a value is used with one that is not 0.
  always @* begin
    if (age_q > 4'd6) begin
      cover (is_near && near == `RUNG_WIDE_NEAR_OWN_FIRST && value != own_q[1]);
      cover (is_near && near == `RUNG_WIDE_NEAR_BUS_LAST && value != bus_q[3][lane*WIDTH+:WIDTH]);
      cover (is_other && value != {WIDTH{1'b0}});
    end
  end

  generate
    if (NEAR_ONLY == 0) begin : g_row
      always @* begin
        cover (is_row && !meets && value != {WIDTH{1'b0}});
        cover (is_row && we_q[3] && addr_q[3] == watched && value != bus_q[3][lane*WIDTH+:WIDTH]);
      end
    end
  endgenerate

endmodule

`default_nettype wire
