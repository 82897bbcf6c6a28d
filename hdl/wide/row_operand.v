// SPDX-License-Identifier: Apache-2.0
// One operand of MPU4: a copy of all rows, the lane of it, and what is too new to be there. A place whose row is
// special (its high bits all 1) names a near value: 0, what this slot computed one to three steps ago, what any
// slot computed four to six steps ago, off the bus, or what the slot puts beside the operand (d3_other_i).
// The bus (c) is a copy of the last row beside this operand, so that the way across the chip (w, b, c) has two
// clocks of its own; synthesis has to keep the copies apart, or all operands read one.
`default_nettype none
`include "rung_wide.vh"

module row_operand #(
    parameter WIDTH = 1,  // bits of a value
    parameter LANES = 16,  // values of a row
    parameter LANE_BITS = 4,
    parameter ADDR_BITS = 10  // of the memory: rows it holds
) (
    input wire clk_i,
    // ID1: the place
    input wire [LANE_BITS-1:0] d1_lane_i,
    input wire [`RUNG_WIDE_LAYOUT_ROW_BITS-1:0] d1_row_i,
    input wire d1_other_i,  // takes d3_other_i, whatever the place says
    // ID3
    input wire [WIDTH-1:0] d3_other_i,
    // what this slot has computed, after EX and a clock later
    input wire [WIDTH-1:0] w_own_i,
    input wire [WIDTH-1:0] b_own_i,
    // what all have computed, and where the row goes
    input wire [LANES*WIDTH-1:0] b_row_i,
    input wire b_we_i,
    input wire [ADDR_BITS-1:0] b_addr_i,
    // EX
    output wire [WIDTH-1:0] x_value_o
);

  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam NEAR_BITS = ROW_BITS - `RUNG_WIDE_LAYOUT_SPECIAL_BITS;
  // Near values by the low bits of a special row.
  localparam [NEAR_BITS-1:0] ZERO = `RUNG_WIDE_NEAR_ZERO;
  localparam [NEAR_BITS-1:0] OWN_1 = `RUNG_WIDE_NEAR_OWN_FIRST;
  localparam [NEAR_BITS-1:0] OWN_2 = `RUNG_WIDE_NEAR_OWN_FIRST + 1;
  localparam [NEAR_BITS-1:0] OWN_3 = `RUNG_WIDE_NEAR_OWN_LAST;
  localparam [NEAR_BITS-1:0] BUS_4 = `RUNG_WIDE_NEAR_BUS_FIRST;
  localparam [NEAR_BITS-1:0] BUS_5 = `RUNG_WIDE_NEAR_BUS_FIRST + 1;
  localparam [NEAR_BITS-1:0] BUS_6 = `RUNG_WIDE_NEAR_BUS_LAST;
  localparam [NEAR_BITS-1:0] OTHER = `RUNG_WIDE_NEAR_FLAG;

  // ---- the bus: the row four steps before that in ID3, and the one before it -------------------
  (* keep *) reg [LANES*WIDTH-1:0] c_row_q;
  (* keep *) reg c_we_q;
  (* keep *) reg [ADDR_BITS-1:0] c_addr_q;
  reg [LANES*WIDTH-1:0] c_last_q;
  (* keep *)
  always @(posedge clk_i) begin
    c_row_q  <= b_row_i;
    c_we_q   <= b_we_i;
    c_addr_q <= b_addr_i;
  end
  always @(posedge clk_i) c_last_q <= c_row_q;

  // ---- ID1 -------------------------------------------------------------------------------------
  wire d1_special = &d1_row_i[ROW_BITS-1:NEAR_BITS];
  wire [NEAR_BITS-1:0] d1_near = d1_row_i[NEAR_BITS-1:0];

  // ---- ID2: the memory; of the values from the bus those that would be gone a clock later ------
  wire [LANES*WIDTH-1:0] d2_row;
  bank_ram #(
      .WIDTH(LANES * WIDTH),
      .DEPTH(1 << ADDR_BITS),
      .ADDR_BITS(ADDR_BITS)
  ) rows (
      .clk_i(clk_i),
      .read_i(1'b1),
      .read_addr_i(d1_row_i[ADDR_BITS-1:0]),
      .read_data_o(d2_row),
      .write_i(c_we_q),
      .write_addr_i(c_addr_q),
      .write_data_i(c_row_q)
  );

  wire d1_near_value = d1_special && !d1_other_i;
  reg d2_zero_q, d2_own1_q, d2_own2_q, d2_own3_q, d2_bus4_q, d2_bus5_q, d2_bus6_q, d2_other_q;
  reg [LANE_BITS-1:0] d2_lane_q;
  always @(posedge clk_i) begin
    d2_zero_q  <= d1_near_value && d1_near == ZERO;
    d2_own1_q  <= d1_near_value && d1_near == OWN_1;
    d2_own2_q  <= d1_near_value && d1_near == OWN_2;
    d2_own3_q  <= d1_near_value && d1_near == OWN_3;
    d2_bus4_q  <= d1_near_value && d1_near == BUS_4;
    d2_bus5_q  <= d1_near_value && d1_near == BUS_5;
    d2_bus6_q  <= d1_near_value && d1_near == BUS_6;
    d2_other_q <= d1_other_i || (d1_special && d1_near == OTHER);
    d2_lane_q  <= d1_lane_i;
  end
  wire [WIDTH-1:0] d2_bus =
      d2_bus6_q ? c_last_q[d2_lane_q*WIDTH+:WIDTH] : c_row_q[d2_lane_q*WIDTH+:WIDTH];

  // ---- ID3: the lane ---------------------------------------------------------------------------
  reg [LANES*WIDTH-1:0] d3_row_q;
  reg [WIDTH-1:0] d3_early_q;
  reg [LANE_BITS-1:0] d3_lane_q;
  reg d3_own1_q, d3_own2_q, d3_own3_q, d3_bus_q, d3_early_valid_q, d3_other_q;
  always @(posedge clk_i) begin
    d3_row_q <= d2_row;
    d3_early_q <= d2_bus & {WIDTH{!d2_zero_q}};
    d3_lane_q <= d2_lane_q;
    d3_own1_q <= d2_own1_q;
    d3_own2_q <= d2_own2_q;
    d3_own3_q <= d2_own3_q;
    d3_bus_q <= d2_bus4_q;
    d3_early_valid_q <= d2_bus5_q || d2_bus6_q || d2_zero_q;
    d3_other_q <= d2_other_q;
  end
  wire [WIDTH-1:0] d3_any =
      d3_bus_q ? c_row_q[d3_lane_q*WIDTH+:WIDTH] : d3_row_q[d3_lane_q*WIDTH+:WIDTH];
  wire [WIDTH-1:0] d3_own = d3_own2_q ? w_own_i : b_own_i;
  wire [WIDTH-1:0] d3_value = d3_other_q ? d3_other_i :
      d3_early_valid_q ? d3_early_q : d3_own2_q || d3_own3_q ? d3_own : d3_any;

  // ---- EX --------------------------------------------------------------------------------------
  reg [WIDTH-1:0] x_value_q;
  reg x_own1_q;
  always @(posedge clk_i) begin
    x_value_q <= d3_value;
    x_own1_q  <= d3_own1_q;
  end
  assign x_value_o = x_own1_q ? w_own_i : x_value_q;

endmodule

`default_nettype wire
