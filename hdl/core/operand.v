// SPDX-License-Identifier: Apache-2.0
// One operand from ID1 to EX, with forwarding. What a step computes in EX stands in registers (w_)
// in the next clock, at the end of which the device memory is written. The four steps behind it
// have then read the memory too early: distances 4 and 3 are mended in ID2, distance 2 in ID3,
// distance 1 in EX. From distance 5 on the memory has it. The memory's data come late, from afar:
// they go into a register and nowhere else.
`default_nettype none

module operand #(
    parameter WIDTH = 16,  // bits of a device
    parameter ADDR_BITS = 8,  // bits of a device number
    parameter WRITERS = 1  // slots whose writes are forwarded; also banks that are XORed
) (
    input  wire                         clk_i,
    // ID1: the device, and the devices that the steps now in ID2, ID3, EX and behind EX write
    input  wire [        ADDR_BITS-1:0] d1_addr_i,
    input  wire [WRITERS*ADDR_BITS-1:0] d2_dest_i,
    input  wire [WRITERS*ADDR_BITS-1:0] d3_dest_i,
    input  wire [WRITERS*ADDR_BITS-1:0] x_dest_i,
    input  wire [WRITERS*ADDR_BITS-1:0] w_dest_i,
    // ID2: the memory's data
    input  wire [    WRITERS*WIDTH-1:0] d2_bank_i,
    // ID3: if d3_device_i is 0, the operand is d3_other_i instead of the device
    input  wire                         d3_device_i,
    input  wire [            WIDTH-1:0] d3_other_i,
    // the write enables of the step in EX, what the step before it wrote, and the one before that
    input  wire [          WRITERS-1:0] x_we_i,
    input  wire [          WRITERS-1:0] w_we_i,
    input  wire [    WRITERS*WIDTH-1:0] w_data_i,
    input  wire [    WRITERS*WIDTH-1:0] v_data_i,
    // EX
    output wire [            WIDTH-1:0] x_value_o
);

  // ---- ID1 -------------------------------------------------------------------------------------
  reg [WRITERS-1:0] d1_match1;
  reg [WRITERS-1:0] d1_match2;
  reg [WRITERS-1:0] d1_match3;
  reg [WRITERS-1:0] d1_match4;
  integer i;
  always @* begin
    for (i = 0; i < WRITERS; i = i + 1) begin
      d1_match1[i] = d1_addr_i == d2_dest_i[i*ADDR_BITS+:ADDR_BITS];
      d1_match2[i] = d1_addr_i == d3_dest_i[i*ADDR_BITS+:ADDR_BITS];
      d1_match3[i] = d1_addr_i == x_dest_i[i*ADDR_BITS+:ADDR_BITS];
      d1_match4[i] = d1_addr_i == w_dest_i[i*ADDR_BITS+:ADDR_BITS];
    end
  end

  // ---- ID2 -------------------------------------------------------------------------------------
  reg [WRITERS-1:0] d2_match1_q;
  reg [WRITERS-1:0] d2_match2_q;
  reg [WRITERS-1:0] d2_match3_q;
  reg [WRITERS-1:0] d2_hit4_q;
  always @(posedge clk_i) begin
    d2_match1_q <= d1_match1;
    d2_match2_q <= d1_match2;
    d2_match3_q <= d1_match3;
    d2_hit4_q   <= d1_match4 & w_we_i;
  end

  wire [WRITERS-1:0] d2_hit3 = d2_match3_q & w_we_i;
  reg [WIDTH-1:0] d2_forward;
  integer j;
  always @* begin
    d2_forward = {WIDTH{1'b0}};
    for (j = 0; j < WRITERS; j = j + 1) begin
      d2_forward = d2_forward | (v_data_i[j*WIDTH+:WIDTH] & {WIDTH{d2_hit4_q[j]}});
    end
    for (j = 0; j < WRITERS; j = j + 1) begin
      if (d2_hit3[j]) d2_forward = w_data_i[j*WIDTH+:WIDTH];
    end
  end

  // ---- ID3 -------------------------------------------------------------------------------------
  reg [WRITERS-1:0] d3_match1_q;
  reg [WRITERS-1:0] d3_match2_q;
  reg d3_hit_q;
  reg [WIDTH-1:0] d3_forward_q;
  reg [WRITERS*WIDTH-1:0] d3_bank_q;
  always @(posedge clk_i) begin
    d3_match1_q <= d2_match1_q;
    d3_match2_q <= d2_match2_q;
    d3_hit_q <= |d2_hit3 || |d2_hit4_q;
    d3_forward_q <= d2_forward;
    d3_bank_q <= d2_bank_i;
  end

  wire [WRITERS-1:0] d3_hit2 = d3_match2_q & w_we_i;
  reg [WIDTH-1:0] d3_memory;
  reg [WIDTH-1:0] d3_value;
  integer k;
  always @* begin
    d3_memory = {WIDTH{1'b0}};
    for (k = 0; k < WRITERS; k = k + 1) d3_memory = d3_memory ^ d3_bank_q[k*WIDTH+:WIDTH];
    d3_value = d3_hit_q ? d3_forward_q : d3_memory;
    for (k = 0; k < WRITERS; k = k + 1) begin
      if (d3_hit2[k]) d3_value = w_data_i[k*WIDTH+:WIDTH];
    end
    if (!d3_device_i) d3_value = d3_other_i;
  end

  // ---- EX --------------------------------------------------------------------------------------
  reg [WIDTH-1:0] x_value_q;
  reg [WRITERS-1:0] x_hit1_q;
  always @(posedge clk_i) begin
    x_value_q <= d3_value;
    x_hit1_q  <= d3_match1_q & x_we_i & {WRITERS{d3_device_i}};
  end

  reg [WIDTH-1:0] x_value;
  integer m;
  always @* begin
    x_value = x_value_q;
    for (m = 0; m < WRITERS; m = m + 1) begin
      if (x_hit1_q[m]) x_value = w_data_i[m*WIDTH+:WIDTH];
    end
  end

  assign x_value_o = x_value;

endmodule

`default_nettype wire
