// SPDX-License-Identifier: Apache-2.0
// Receive ring of one side of the link: places of 128 bytes in a block RAM, and a ring that registers the head of
// each received record, in the order in which they came: its place and its class. The record is never moved; what
// reads it gets its head from the ring and its bytes from their place.
//
// A frame is written into the next free place byte by byte, and becomes a record with commit_i, which needs
// room_o; until then nobody sees it, and the next frame is written over it. Records leave in any order (free_i), so
// that one that has to wait does not hold up others: the oldest of class find_class_i is found in the clock. The last
// free place is kept for replies: room_o is 1 for a reply if a place is free, for a request if two are.
// free_i takes what is found away; it is ignored in the clock of a commit_i (free_ready_o is 0).
// Read data are there in the clock after read_i.
`default_nettype none

module receive_ring (
    input  wire       clk_i,
    input  wire       rst_ni,
    // a frame comes
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
    input  wire       free_i,
    output wire       free_ready_o
);

  // The ring: places of the records, oldest first, behind them the free places. Each place is in it once, so
  // that taking one out and putting it at the end is all that happens when it becomes free.
  reg [23:0] places_q;
  reg [15:0] classes_q;
  reg [ 3:0] count_q;

  integer i;
  integer k;
  reg [2:0] position;
  reg found;
  always @(*) begin
    position = 3'd0;
    found = 1'b0;
    for (i = 7; i >= 0; i = i - 1) begin
      if (i[3:0] < count_q && classes_q[2*i+:2] == find_class_i) begin
        position = i[2:0];
        found = 1'b1;
      end
    end
  end

  wire [2:0] found_place = places_q[3*position+:3];
  wire [2:0] write_place = places_q[3*count_q[2:0]+:3];
  wire free = free_i && found && !commit_i;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      places_q <= {3'd7, 3'd6, 3'd5, 3'd4, 3'd3, 3'd2, 3'd1, 3'd0};
      count_q  <= 4'd0;
    end else if (commit_i) begin
      count_q <= count_q + 4'd1;
    end else if (free) begin
      count_q <= count_q - 4'd1;
      for (k = 0; k < 7; k = k + 1) begin
        if (k[2:0] >= position) places_q[3*k+:3] <= places_q[3*k+3+:3];
      end
      places_q[23:21] <= found_place;
    end

    if (commit_i) begin
      classes_q[2*count_q[2:0]+:2] <= commit_class_i;
    end else if (free) begin
      for (k = 0; k < 7; k = k + 1) begin
        if (k[2:0] >= position) classes_q[2*k+:2] <= classes_q[2*k+2+:2];
      end
    end
  end

  assign any_room_o = !count_q[3];
  assign request_room_o = count_q < 4'd7;
  assign found_o = found;
  assign free_ready_o = !commit_i;

  bank_ram #(
      .WIDTH(8),
      .DEPTH(1024),
      .ADDR_BITS(10),
      .CLEARED(0)
  ) bytes (
      .clk_i       (clk_i),
      .read_i      (read_i),
      .read_addr_i ({found_place, read_index_i}),
      .read_data_o (read_data_o),
      .write_i     (write_i && any_room_o),
      .write_addr_i({write_place, write_index_i}),
      .write_data_i(write_data_i)
  );

endmodule

`default_nettype wire
