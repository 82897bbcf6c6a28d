// SPDX-License-Identifier: Apache-2.0
// One operand from ID1 to EX, with forwarding. A step in EX writes the device memory at the end of
// its clock; the step after it is then in ID2 (distance 1) and the one after that in ID1 (distance
// 2), and both have read the memory too early. Distance 2 is mended in ID2, distance 1 in EX. The
// memory's data come late in ID2: they meet one AND-XOR and nothing else.
`default_nettype none

module operand #(
    parameter WIDTH = 16,  // bits of a device
    parameter ADDR_BITS = 8,  // bits of a device number
    parameter WRITERS = 1  // slots whose writes are forwarded; also banks that are XORed
) (
    input  wire                         clk_i,
    // ID1: the device, and the devices that the steps now in ID2 and in EX write
    input  wire [        ADDR_BITS-1:0] d1_addr_i,
    input  wire [WRITERS*ADDR_BITS-1:0] d2_dest_i,
    input  wire [WRITERS*ADDR_BITS-1:0] x_dest_i,
    // ID2: the memory's data; if d2_device_i is 0, the operand is d2_other_i instead of the device
    input  wire [    WRITERS*WIDTH-1:0] d2_bank_i,
    input  wire                         d2_device_i,
    input  wire [            WIDTH-1:0] d2_other_i,
    // the write enables of the step in EX, and what the step before it wrote
    input  wire [          WRITERS-1:0] x_we_i,
    input  wire [          WRITERS-1:0] w_we_i,
    input  wire [    WRITERS*WIDTH-1:0] w_data_i,
    // EX
    output wire [            WIDTH-1:0] x_value_o
);

  // ID1: addresses
  reg [WRITERS-1:0] d1_near;
  reg [WRITERS-1:0] d1_far;
  integer i;
  always @* begin
    for (i = 0; i < WRITERS; i = i + 1) begin
      d1_near[i] = d1_addr_i == d2_dest_i[i*ADDR_BITS+:ADDR_BITS];
      d1_far[i]  = d1_addr_i == x_dest_i[i*ADDR_BITS+:ADDR_BITS];
    end
  end

  reg [WRITERS-1:0] d2_near_q;
  reg [WRITERS-1:0] d2_far_q;
  always @(posedge clk_i) begin
    d2_near_q <= d1_near;
    d2_far_q  <= d1_far;
  end

  // ID2: the memory, or what was written two steps ago, or no device at all
  wire [WRITERS-1:0] d2_forward = d2_far_q & w_we_i & {WRITERS{d2_device_i}};
  wire d2_use_memory = d2_device_i & ~|(d2_far_q & w_we_i);
  reg [WIDTH-1:0] d2_memory;
  reg [WIDTH-1:0] d2_early;
  integer j;
  always @* begin
    d2_memory = {WIDTH{1'b0}};
    d2_early  = d2_device_i ? {WIDTH{1'b0}} : d2_other_i;
    for (j = 0; j < WRITERS; j = j + 1) begin
      d2_memory = d2_memory ^ d2_bank_i[j*WIDTH+:WIDTH];
      d2_early  = d2_early | (w_data_i[j*WIDTH+:WIDTH] & {WIDTH{d2_forward[j]}});
    end
  end

  reg [  WIDTH-1:0] x_value_q;
  reg [WRITERS-1:0] x_near_q;
  always @(posedge clk_i) begin
    x_value_q <= (d2_memory & {WIDTH{d2_use_memory}}) ^ d2_early;
    x_near_q  <= d2_near_q & x_we_i & {WRITERS{d2_device_i}};
  end

  // EX: what the step just before wrote is newer than anything found in ID2
  reg [WIDTH-1:0] x_value;
  integer k;
  always @* begin
    x_value = x_value_q;
    for (k = 0; k < WRITERS; k = k + 1) begin
      if (x_near_q[k]) x_value = w_data_i[k*WIDTH+:WIDTH];
    end
  end

  assign x_value_o = x_value;

endmodule

`default_nettype wire
