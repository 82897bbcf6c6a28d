// SPDX-License-Identifier: Apache-2.0
// One operand of MPU4: a copy of all rows, the lane of it, and what is too new to be there. A place whose row is
// special (its high bits all 1) names a near value: 0, what this slot computed one to three steps ago, what any
// slot computed four to six steps ago, off the bus, or what the slot puts beside the operand (d3_other_i).
// The bus (c) is a copy of the last row beside this operand, so that the way across the chip (w, b, c) has two
// clocks of its own; synthesis has to keep the copies apart, or all operands read one.
//
// A row is wide (8 words of 16 bits), so what takes a lane of it is made shallow: a lane select is one register a
// lane, not a number, so that a choice of 8 is two look-ups deep and no select drives more than the bits of a value;
// and each row has one place only, its memory's output register or c, from which all distances are taken.
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
    // what this slot has computed, after EX
    input wire [WIDTH-1:0] w_own_i,
    // what all have computed, and where the row goes
    input wire [LANES*WIDTH-1:0] b_row_i,
    input wire b_we_i,
    input wire [ADDR_BITS-1:0] b_addr_i,
    // EX
    output wire [WIDTH-1:0] x_value_o
);

  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam NEAR_BITS = ROW_BITS - `RUNG_WIDE_LAYOUT_SPECIAL_BITS;
  // Near values by the low bits of a special row; 0 is what is left when none is taken.
  localparam [NEAR_BITS-1:0] OWN_1 = `RUNG_WIDE_NEAR_OWN_FIRST;
  localparam [NEAR_BITS-1:0] OWN_2 = `RUNG_WIDE_NEAR_OWN_FIRST + 1;
  localparam [NEAR_BITS-1:0] OWN_3 = `RUNG_WIDE_NEAR_OWN_LAST;
  localparam [NEAR_BITS-1:0] BUS_4 = `RUNG_WIDE_NEAR_BUS_FIRST;
  localparam [NEAR_BITS-1:0] BUS_5 = `RUNG_WIDE_NEAR_BUS_FIRST + 1;
  localparam [NEAR_BITS-1:0] BUS_6 = `RUNG_WIDE_NEAR_BUS_LAST;
  localparam [NEAR_BITS-1:0] OTHER = `RUNG_WIDE_NEAR_FLAG;

  function automatic [LANES-1:0] one_hot(input reg [LANE_BITS-1:0] lane, input reg valid);
    integer k;
    for (k = 0; k < LANES; k = k + 1) one_hot[k] = valid && lane == k[LANE_BITS-1:0];
  endfunction

  // The value of the lane whose select is 1; 0 if none is.
  function automatic [WIDTH-1:0] lane_of(input reg [LANES*WIDTH-1:0] row,
                                         input reg [LANES-1:0] select);
    integer k;
    begin
      lane_of = {WIDTH{1'b0}};
      for (k = 0; k < LANES; k = k + 1) begin
        lane_of = lane_of | (row[k*WIDTH+:WIDTH] & {WIDTH{select[k]}});
      end
    end
  endfunction

  // ---- the bus: in c the row four steps before that in ID3, five before ID2, six before ID1 ----
  (* keep *) reg [LANES*WIDTH-1:0] c_row_q;
  (* keep *) reg c_we_q;
  (* keep *) reg [ADDR_BITS-1:0] c_addr_q;
  (* keep *)
  always @(posedge clk_i) begin
    c_row_q  <= b_row_i;
    c_we_q   <= b_we_i;
    c_addr_q <= b_addr_i;
  end

  // ---- ID1: the oldest of the bus --------------------------------------------------------------
  wire d1_special = &d1_row_i[ROW_BITS-1:NEAR_BITS];
  wire [NEAR_BITS-1:0] d1_near = d1_row_i[NEAR_BITS-1:0];
  wire d1_near_value = d1_special && !d1_other_i;

  // ---- ID2: the memory; of the near values those that would be gone a clock later --------------
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

  reg [LANES-1:0] d2_bus5_lane_q;
  reg [WIDTH-1:0] d2_bus6_value_q;
  reg [LANE_BITS-1:0] d2_lane_q;
  reg d2_row_taken_q, d2_own1_q, d2_own2_q, d2_own3_q, d2_bus4_q, d2_bus6_q, d2_other_q;
  always @(posedge clk_i) begin
    d2_bus5_lane_q <= one_hot(d1_lane_i, d1_near_value && d1_near == BUS_5);
    d2_bus6_value_q <= c_row_q[d1_lane_i*WIDTH+:WIDTH];
    d2_lane_q <= d1_lane_i;
    d2_row_taken_q <= !d1_special && !d1_other_i;
    d2_own1_q <= d1_near_value && d1_near == OWN_1;
    d2_own2_q <= d1_near_value && d1_near == OWN_2;
    d2_own3_q <= d1_near_value && d1_near == OWN_3;
    d2_bus4_q <= d1_near_value && d1_near == BUS_4;
    d2_bus6_q <= d1_near_value && d1_near == BUS_6;
    d2_other_q <= d1_other_i || (d1_special && d1_near == OTHER);
  end
  wire [WIDTH-1:0] d2_bus5_value = lane_of(c_row_q, d2_bus5_lane_q);
  wire [WIDTH-1:0] d2_early = d2_bus5_value | (d2_bus6_value_q & {WIDTH{d2_bus6_q}}) |
      (w_own_i & {WIDTH{d2_own3_q}});

  // ---- ID3: at most one of these is not 0 ------------------------------------------------------
  reg [LANES*WIDTH-1:0] d3_row_q;
  reg [LANES-1:0] d3_row_lane_q;
  reg [LANES-1:0] d3_bus4_lane_q;
  reg [WIDTH-1:0] d3_early_q;
  reg d3_own1_q, d3_own2_q, d3_other_q;
  always @(posedge clk_i) begin
    d3_row_q <= d2_row;
    d3_row_lane_q <= one_hot(d2_lane_q, d2_row_taken_q);
    d3_bus4_lane_q <= one_hot(d2_lane_q, d2_bus4_q);
    d3_early_q <= d2_early;
    d3_own1_q <= d2_own1_q;
    d3_own2_q <= d2_own2_q;
    d3_other_q <= d2_other_q;
  end
  wire [WIDTH-1:0] d3_row_value = lane_of(d3_row_q, d3_row_lane_q);
  wire [WIDTH-1:0] d3_bus4_value = lane_of(c_row_q, d3_bus4_lane_q);
  wire [WIDTH-1:0] d3_value = d3_row_value | d3_bus4_value | d3_early_q |
      (w_own_i & {WIDTH{d3_own2_q}}) | (d3_other_i & {WIDTH{d3_other_q}});

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
