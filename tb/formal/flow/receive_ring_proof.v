// SPDX-License-Identifier: Apache-2.0
// Receive ring of the link (hdl/flow/receive_ring.v): every record that goes in comes out once, behind those of its class
// that went in before it and before those after it, with its bytes; what has not been committed is never seen; room is there
// exactly if it is said to be. Any place and any byte of it: what is shown of the record in it is shown of all.
// The frames that come and the records that leave are free in every clock.
//
// Two proofs that lean on each other: COUNT 1 assumes what COUNT 0 shows of the clock before, COUNT 0 what COUNT 1
// shows of the same clock, so that both hold from the reset on, clock by clock.
//   COUNT 1  the number of used places is that of the records, so that one is free if there is room; assumed:
//            what leaves was in a used place, and what comes goes to a free one
//   COUNT 0  all the rest, and that what leaves was in a used place, and what comes goes to a free one; assumed:
//            if there is room a place is free, and there is room if there are fewer than eight records
`default_nettype none

module receive_ring_proof #(
    parameter COUNT = 0
) (
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

  (* hierconn *) wire [15:0] \ring.first_q ;
  (* hierconn *) wire [15:0] \ring.next_q ;
  (* hierconn *) wire [ 7:0] \ring.used_q ;
  (* hierconn *) wire [ 3:0] \ring.free_q ;
  (* hierconn *) wire [ 2:0] \ring.place ;
  (* hierconn *) wire [ 7:0] \ring.places.word_q ;
  always @* begin
    if (begun_q) begin
      assert (found == (count_q[4*find_class_i+:4] != 4'd0));
      if (COUNT != 0) begin
        assert (total <= 6'd8);
        assert (any_room == (total < 6'd8));
        assert (request_room == (total < 6'd7));
        if (any_room) assert (\ring.used_q != 8'hff);
      end else begin
        if (live_q && find_class_i == class_q) assert (found);
        if (commits) assert (!live_q);  // never over a record that waits
        if (read_q) assert (read_data == read_byte_q);
      end
    end
  end

  // ---- for the induction -----------------------------------------------------------------------------
  wire [95:0] heads;
  genvar g;
  generate
    for (g = 0; g < 4; g = g + 1) begin : g_class
      always @* begin
        if (begun_q) begin
          assert (\ring.next_q [4*g+:4] - \ring.first_q [4*g+:4] == count_q[4*g+:4]);
        end
      end
    end
  endgenerate
  (* hierconn *) wire [2:0] \ring.heads_q[0] ;
  (* hierconn *) wire [2:0] \ring.heads_q[1] ;
  (* hierconn *) wire [2:0] \ring.heads_q[2] ;
  (* hierconn *) wire [2:0] \ring.heads_q[3] ;
  (* hierconn *) wire [2:0] \ring.heads_q[4] ;
  (* hierconn *) wire [2:0] \ring.heads_q[5] ;
  (* hierconn *) wire [2:0] \ring.heads_q[6] ;
  (* hierconn *) wire [2:0] \ring.heads_q[7] ;
  (* hierconn *) wire [2:0] \ring.heads_q[8] ;
  (* hierconn *) wire [2:0] \ring.heads_q[9] ;
  (* hierconn *) wire [2:0] \ring.heads_q[10] ;
  (* hierconn *) wire [2:0] \ring.heads_q[11] ;
  (* hierconn *) wire [2:0] \ring.heads_q[12] ;
  (* hierconn *) wire [2:0] \ring.heads_q[13] ;
  (* hierconn *) wire [2:0] \ring.heads_q[14] ;
  (* hierconn *) wire [2:0] \ring.heads_q[15] ;
  (* hierconn *) wire [2:0] \ring.heads_q[16] ;
  (* hierconn *) wire [2:0] \ring.heads_q[17] ;
  (* hierconn *) wire [2:0] \ring.heads_q[18] ;
  (* hierconn *) wire [2:0] \ring.heads_q[19] ;
  (* hierconn *) wire [2:0] \ring.heads_q[20] ;
  (* hierconn *) wire [2:0] \ring.heads_q[21] ;
  (* hierconn *) wire [2:0] \ring.heads_q[22] ;
  (* hierconn *) wire [2:0] \ring.heads_q[23] ;
  (* hierconn *) wire [2:0] \ring.heads_q[24] ;
  (* hierconn *) wire [2:0] \ring.heads_q[25] ;
  (* hierconn *) wire [2:0] \ring.heads_q[26] ;
  (* hierconn *) wire [2:0] \ring.heads_q[27] ;
  (* hierconn *) wire [2:0] \ring.heads_q[28] ;
  (* hierconn *) wire [2:0] \ring.heads_q[29] ;
  (* hierconn *) wire [2:0] \ring.heads_q[30] ;
  (* hierconn *) wire [2:0] \ring.heads_q[31] ;
  assign heads = {
    \ring.heads_q[31] ,
    \ring.heads_q[30] ,
    \ring.heads_q[29] ,
    \ring.heads_q[28] ,
    \ring.heads_q[27] ,
    \ring.heads_q[26] ,
    \ring.heads_q[25] ,
    \ring.heads_q[24] ,
    \ring.heads_q[23] ,
    \ring.heads_q[22] ,
    \ring.heads_q[21] ,
    \ring.heads_q[20] ,
    \ring.heads_q[19] ,
    \ring.heads_q[18] ,
    \ring.heads_q[17] ,
    \ring.heads_q[16] ,
    \ring.heads_q[15] ,
    \ring.heads_q[14] ,
    \ring.heads_q[13] ,
    \ring.heads_q[12] ,
    \ring.heads_q[11] ,
    \ring.heads_q[10] ,
    \ring.heads_q[9] ,
    \ring.heads_q[8] ,
    \ring.heads_q[7] ,
    \ring.heads_q[6] ,
    \ring.heads_q[5] ,
    \ring.heads_q[4] ,
    \ring.heads_q[3] ,
    \ring.heads_q[2] ,
    \ring.heads_q[1] ,
    \ring.heads_q[0]
  };
  // What COUNT 1 assumes of the clock before.
  reg odd;
  reg odd_q;
  always @* begin
    odd = 1'b0;
    for (p = 0; p < 8; p = p + 1) begin
      if (leaves && \ring.place == p[2:0] && !\ring.used_q [p]) odd = 1'b1;
      if (commit_i && \ring.place_q == p[2:0] && \ring.used_q [p]) odd = 1'b1;
    end
  end
  always @(posedge clk_i) odd_q <= COUNT != 0 && begun_q && rst_ni && odd;
  integer p, k;
  reg [95:0] offset;  // of a head from the oldest of its class
  reg [31:0] waits;
  reg [ 3:0] used;
  always @* begin
    used = 4'd0;
    for (p = 0; p < 8; p = p + 1) used = used + {3'd0, \ring.used_q [p]};
    for (k = 0; k < 32; k = k + 1) begin
      offset[3*k+:3] = k[2:0] - \ring.first_q [4*(k/8)+:3];
      waits[k] = {1'b0, offset[3*k+:3]} < count_q[4*(k/8)+:4];
    end
    if (begun_q && COUNT != 0) begin
      assume (!odd_q);
      assert (\ring.free_q == 4'd8 - used);
      assert ({2'd0, used} == total);
      if (framing_q) assert (total < 6'd8);
    end
    if (begun_q && COUNT == 0) begin
      assume (!any_room || \ring.used_q != 8'hff);
      assume (total <= 6'd8 && any_room == (total < 6'd8));
      for (p = 0; p < 8; p = p + 1) begin
        if (p[2:0] == watched_place) begin
          assert (live_q == \ring.used_q [p]);
          if (leaves && \ring.place == p[2:0]) assert (\ring.used_q [p]);
          if (framing_q && of_place) assert (!\ring.used_q [p]);
        end
      end
      // A head that waits names the watched place if and only if it is its record's.
      for (k = 0; k < 32; k = k + 1) begin
        if (waits[k]) begin
          assert ((heads[3*k+:3] == watched_place) ==
                  (live_q && class_q == k[4:3] && ahead_q == {1'b0, offset[3*k+:3]}));
        end
      end
      for (k = 0; k < 4; k = k + 1) begin
        if (live_q && class_q == k[1:0]) assert (ahead_q < count_q[4*k+:4]);
      end
      if (live_q && live_known_q) assert (\ring.places.word_q == live_byte_q);
      if (framing_q && of_place && byte_known_q) assert (\ring.places.word_q == byte_q);
    end
  end

  always @* begin
    cover (begun_q && read_q && read_data == 8'h5a && count_q[4*class_q+:4] == 4'd2);
    cover (begun_q && live_q && ahead_q == 4'd2 && count_q[4*class_q+:4] == 4'd3);
  end

endmodule

`default_nettype wire
