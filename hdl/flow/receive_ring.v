// SPDX-License-Identifier: Apache-2.0
// Receive ring of one side of the link: places of 128 bytes in a block RAM, and a ring for each class of
// records that registers the heads of those received, in the order in which they came: each head is the number of
// the record's place. The record is never moved; what reads it gets its head from the ring and its bytes from there.
//
// A frame is written into a free place byte by byte, from begin_i on, and becomes a record with commit_i, which needs
// room; until then nobody sees it, and the next frame is written over it. One ring for each class, so that
// records that have to wait do not hold up others. The last free place is kept for replies: any_room_o is 1 if a
// place is free, request_room_o if two are.
// found_o and the bytes that are read are those of the oldest record of class find_class_i; free_i takes it away.
// Read data are there in the clock after read_i.
`default_nettype none

module receive_ring (
    input  wire       clk_i,
    input  wire       rst_ni,
    // a frame comes
    input  wire       begin_i,
    input  wire       write_i,
    input  wire [6:0] write_index_i,
    input  wire [7:0] write_data_i,
    input  wire       commit_i,
    input  wire [1:0] commit_class_i,
    output wire       any_room_o,
    output wire       request_room_o,
    // records
    input  wire [1:0] find_class_i,
    output wire       found_o,
    input  wire       read_i,
    input  wire [6:0] read_index_i,
    output wire [7:0] read_data_o,
    input  wire       free_i
);

  reg [ 2:0] heads_q[0:31];
  // Of each class: where the oldest head is in its ring of eight, and one bit more.
  reg [15:0] first_q;
  reg [15:0] next_q;  // where the next one goes
  reg [ 7:0] used_q;  // places with records
  reg [ 3:0] free_q;  // places without
  reg [ 2:0] place_q;  // of the frame that comes

  wire [ 3:0] first = first_q[4*find_class_i+:4];
  wire [ 3:0] next = next_q[4*find_class_i+:4];
  wire [ 3:0] commit_next = next_q[4*commit_class_i+:4];
  wire [ 2:0] place = heads_q[{find_class_i, first[2:0]}];
  wire        found = first != next;
  wire        leaves = free_i && found;

  integer i;
  integer k;
  reg [2:0] free_place;
  always @(*) begin
    free_place = 3'd0;
    for (i = 7; i >= 0; i = i - 1) if (!used_q[i]) free_place = i[2:0];
  end

  always @(posedge clk_i) begin
    if (begin_i) place_q <= free_place;
    if (commit_i) heads_q[{commit_class_i, commit_next[2:0]}] <= place_q;

    if (!rst_ni) begin
      first_q <= 16'd0;
      next_q <= 16'd0;
      used_q <= 8'd0;
      free_q <= 4'd8;
    end else begin
      for (k = 0; k < 4; k = k + 1) begin
        if (leaves && find_class_i == k[1:0]) first_q[4*k+:4] <= first + 4'd1;
        if (commit_i && commit_class_i == k[1:0]) next_q[4*k+:4] <= commit_next + 4'd1;
      end
      for (k = 0; k < 8; k = k + 1) begin
        if (leaves && place == k[2:0]) used_q[k] <= 1'b0;
        if (commit_i && place_q == k[2:0]) used_q[k] <= 1'b1;
      end
      if (leaves && !commit_i) free_q <= free_q + 4'd1;
      else if (commit_i && !leaves) free_q <= free_q - 4'd1;
    end
  end

  assign any_room_o = free_q != 4'd0;
  assign request_room_o = free_q[3:1] != 3'd0;
  assign found_o = found;

  bank_ram #(
      .WIDTH(8),
      .DEPTH(1024),
      .ADDR_BITS(10),
      .CLEARED(0)
  ) places (
      .clk_i       (clk_i),
      .read_i      (read_i),
      .read_addr_i ({place, read_index_i}),
      .read_data_o (read_data_o),
      .write_i     (write_i),
      .write_addr_i({place_q, write_index_i}),
      .write_data_i(write_data_i)
  );

endmodule

`default_nettype wire
