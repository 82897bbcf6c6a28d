// SPDX-License-Identifier: Apache-2.0
// Receive ring of the link (hdl/flow/receive_ring.v): every record that goes in comes out once, behind those of its class
// that went in before it and before those after it, with its bytes; what has not been committed is never seen; room is there
// exactly if it is said to be. Any place and any byte of it: what is shown of the record in it is shown of all.
// The frames that come and the records that leave are free in every clock; a frame may be committed in the clock
// after it began, so that the ring is full after 16.
`default_nettype none

module receive_ring_proof (
    input wire       clk_i,
    input wire       rst_ni,
    input wire       begin_i,
    input wire       write_i,
    input wire [6:0] write_index_i,
    input wire [7:0] write_data_i,
    input wire       commit_i,
    input wire [1:0] commit_class_i,
    input wire [1:0] find_class_i,
    input wire       read_i,
    input wire [6:0] read_index_i,
    input wire       free_i
);

  wire any_room, request_room, found;
  wire [7:0] read_data;
  receive_ring ring (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .begin_i       (begin_i),
      .write_i       (write_i),
      .write_index_i (write_index_i),
      .write_data_i  (write_data_i),
      .commit_i      (commit_i),
      .commit_class_i(commit_class_i),
      .any_room_o    (any_room),
      .request_room_o(request_room),
      .find_class_i  (find_class_i),
      .found_o       (found),
      .read_i        (read_i),
      .read_index_i  (read_index_i),
      .read_data_o   (read_data),
      .free_i        (free_i)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- who writes: a frame that began with room, one at a time --------------------------------------
  reg framing_q;
  always @(posedge clk_i) begin
    if (!rst_ni) framing_q <= 1'b0;
    else if (begin_i) framing_q <= any_room;
    else if (commit_i) framing_q <= 1'b0;
  end
  always @* begin
    if (begin_i) assume (!write_i && !commit_i);
    if (write_i || commit_i) assume (framing_q);
  end

  // ---- the ring as its page has it: how many records of each class ------------------------------------
  reg [15:0] count_q;
  wire leaves = free_i && count_q[4*find_class_i+:4] != 4'd0;
  integer c;
  always @(posedge clk_i) begin
    for (c = 0; c < 4; c = c + 1) begin
      if (!rst_ni) count_q[4*c+:4] <= 4'd0;
      else begin
        count_q[4*c+:4] <= count_q[4*c+:4] + {3'd0, commit_i && commit_class_i == c[1:0]} -
            {3'd0, leaves && find_class_i == c[1:0]};
      end
    end
  end
  wire [5:0] total = {2'd0, count_q[3:0]} + {2'd0, count_q[7:4]} + {2'd0, count_q[11:8]} +
      {2'd0, count_q[15:12]};

  // ---- the record that comes into the watched place, and its watched byte ------------------------------
  (* hierconn *) wire [9:0] \ring.places.watched ;
  (* hierconn *) wire [2:0] \ring.place_q ;
  wire [2:0] watched_place = \ring.places.watched [9:7];
  wire [6:0] watched_index = \ring.places.watched [6:0];
  wire of_place = \ring.place_q == watched_place;
  reg byte_known_q;  // of the frame that comes
  reg [7:0] byte_q;
  reg live_q;
  reg live_known_q;
  reg [7:0] live_byte_q;
  reg [1:0] class_q;
  reg [3:0] ahead_q;  // records of its class before it
  wire commits = commit_i && of_place;
  wire oldest = live_q && find_class_i == class_q && ahead_q == 4'd0;
  wire writes = write_i && of_place && write_index_i == watched_index;

  always @(posedge clk_i) begin
    if (begin_i) byte_known_q <= 1'b0;
    else if (writes) byte_known_q <= 1'b1;
    if (writes) byte_q <= write_data_i;

    if (!rst_ni) live_q <= 1'b0;
    else if (commits) live_q <= 1'b1;
    else if (leaves && oldest) live_q <= 1'b0;
    if (commits) begin
      live_known_q <= byte_known_q || writes;
      live_byte_q <= writes ? write_data_i : byte_q;
      class_q <= commit_class_i;
      ahead_q <= count_q[4*commit_class_i+:4] - {3'd0, leaves && find_class_i == commit_class_i};
    end else if (leaves && find_class_i == class_q) begin
      ahead_q <= ahead_q - 4'd1;
    end
  end

  reg read_q;
  reg [7:0] read_byte_q;
  always @(posedge clk_i) begin
    read_q <= begun_q && rst_ni && read_i && read_index_i == watched_index && oldest &&
        live_known_q;
    read_byte_q <= live_byte_q;
  end

  always @* begin
    if (begun_q) begin
      assert (found == (count_q[4*find_class_i+:4] != 4'd0));
      assert (total <= 6'd8);
      assert (any_room == (total < 6'd8));
      assert (request_room == (total < 6'd7));
      if (live_q && find_class_i == class_q) assert (found);
      if (commits) assert (!live_q);  // never over a record that waits
      if (read_q) assert (read_data == read_byte_q);
    end
  end

  always @* begin
    cover (begun_q && read_q && read_data == 8'h5a && count_q[4*class_q+:4] == 4'd2);
    cover (begun_q && !any_room && live_q && ahead_q == 4'd3);
  end

endmodule

`default_nettype wire
