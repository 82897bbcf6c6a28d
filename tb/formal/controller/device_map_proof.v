// SPDX-License-Identifier: Apache-2.0
// Device map (hdl/controller/device_map.v), any point of either area: in the clock after its look-up it is a device exactly if the
// word last written for it says so, with bit 15, and then the one that this word names; other points, other areas and
// writes behind the last point change nothing; what is no point is no device. The last word device has no point.
`default_nettype none

module device_map_proof #(
    parameter integer BIT_POINTS   = 1024,
    parameter integer WORD_POINTS  = 472,
    parameter integer BIT_DEVICES  = 1024,
    parameter integer WORD_DEVICES = 256
) (
    input wire        clk_i,
    input wire        read_i,
    input wire        words_i,
    input wire [15:0] point_i,
    input wire        bit_write_i,
    input wire        word_write_i,
    input wire [15:0] write_addr_i,
    input wire [15:0] write_data_i
);

  wire mapped;
  wire [14:0] device;
  device_map #(
      .BIT_POINTS  (BIT_POINTS),
      .WORD_POINTS (WORD_POINTS),
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES)
  ) map (
      .clk_i       (clk_i),
      .read_i      (read_i),
      .words_i     (words_i),
      .point_i     (point_i),
      .mapped_o    (mapped),
      .device_o    (device),
      .bit_write_i (bit_write_i),
      .word_write_i(word_write_i),
      .write_addr_i(write_addr_i),
      .write_data_i(write_data_i)
  );

  (* anyconst *) wire words;
  (* anyconst *) wire [15:0] point;
  wire exists = point < (words ? WORD_POINTS : BIT_POINTS);
  wire writes = (words ? word_write_i : bit_write_i) && write_addr_i == point;
  wire looks = read_i && words_i == words && point_i == point;
  reg known_q;  // it has been written
  reg [15:0] entry_q;
  reg looked_q;
  reg was_known_q;
  reg [15:0] was_q;
  initial {known_q, looked_q} = 2'b00;
  always @(posedge clk_i) begin
    if (writes) {known_q, entry_q} <= {1'b1, write_data_i};
    // A look-up in the clock of the write gives anything.
    looked_q <= looks && (!writes || !exists);
    {was_known_q, was_q} <= {known_q, entry_q};
  end

  wire [14:0] named = was_q[14:0] & (words ? WORD_DEVICES - 1 : BIT_DEVICES - 1);
  wire last_word = words && named == WORD_DEVICES - 1;
  always @* begin
    if (looked_q && !exists) assert (!mapped);
    if (looked_q && exists && was_known_q) begin
      assert (mapped == (was_q[15] && !last_word));
      if (mapped) assert (device == named);
    end
  end

  // For the induction: the words of the memories that stand for theirs are those of the point.
  localparam integer BIT_POINT = $clog2(BIT_POINTS);
  localparam integer WORD_POINT = $clog2(WORD_POINTS);
  localparam integer BIT_ADDR = $clog2(BIT_DEVICES);
  localparam integer WORD_ADDR = $clog2(WORD_DEVICES);
  (* hierconn *) wire [BIT_POINT-1:0] \map.bit_map.watched ;
  (* hierconn *) wire [WORD_POINT-1:0] \map.word_map.watched ;
  (* hierconn *) wire [BIT_ADDR:0] \map.bit_map.word_q ;
  (* hierconn *) wire [BIT_ADDR:0] \map.bit_map.read_data_q ;
  (* hierconn *) wire [WORD_ADDR-1:0] \map.word_map.word_q ;
  (* hierconn *) wire [WORD_ADDR-1:0] \map.word_map.read_data_q ;
  (* hierconn *) wire \map.words_q ;
  (* hierconn *) wire \map.exists_q ;
  wire [WORD_ADDR-1:0] word_entry = entry_q[15] ? entry_q[WORD_ADDR-1:0] : {WORD_ADDR{1'b1}};
  wire [WORD_ADDR-1:0] word_was = was_q[15] ? was_q[WORD_ADDR-1:0] : {WORD_ADDR{1'b1}};
  always @* begin
    if (words) assume (\map.word_map.watched == point[WORD_POINT-1:0]);
    else assume (\map.bit_map.watched == point[BIT_POINT-1:0]);
    if (exists && known_q) begin
      if (words) assert (\map.word_map.word_q == word_entry);
      else assert (\map.bit_map.word_q == {entry_q[15], entry_q[BIT_ADDR-1:0]});
    end
    if (looked_q) assert (\map.words_q == words && \map.exists_q == exists);
    if (looked_q && exists && was_known_q) begin
      if (words) assert (\map.word_map.read_data_q == word_was);
      else assert (\map.bit_map.read_data_q == {was_q[15], was_q[BIT_ADDR-1:0]});
    end
  end

  always @* begin
    cover (looked_q && words && was_known_q && mapped && point == 16'd471 && device == 15'd254);
    cover (looked_q && !words && was_known_q && mapped && point == 16'd1023 && device == 15'd1023);
    cover (looked_q && words && was_known_q && was_q == 16'h80ff && !mapped);
  end

endmodule

`default_nettype wire
