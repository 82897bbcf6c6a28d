// SPDX-License-Identifier: Apache-2.0
// CRC of a link frame (hdl/flow/link_crc.v): after any bytes since start_i, each with the eight clocks that it takes, it is the
// CRC-16 of Modbus over them, and busy_o is 1 for exactly these clocks. The model is the division that the standard means,
// highest power first, by x^16 + x^15 + x^2 + 1: each bit, those of a byte lowest first, is multiplied by x^16 and taken modulo
// the polynomial, from a remainder of all ones; what is sent is the remainder mirrored. A frame with its own CRC behind it,
// low byte first, comes to 0.
`default_nettype none

module link_crc_proof (
    input wire       clk_i,
    input wire       start_i,
    input wire       byte_i,
    input wire [7:0] data_i
);

  wire busy;
  wire [15:0] crc;
  link_crc link_crc (
      .clk_i  (clk_i),
      .start_i(start_i),
      .byte_i (byte_i),
      .data_i (data_i),
      .busy_o (busy),
      .crc_o  (crc)
  );

  // The remainder behind the first `bits` bits of a byte.
  function automatic [15:0] divide(input reg [15:0] remainder, input reg [7:0] data,
                                   input reg [3:0] bits);
    integer i;
    begin
      divide = remainder;
      for (i = 0; i < 8; i = i + 1) begin
        if (i < bits) divide = {divide[14:0], 1'b0} ^ (divide[15] ^ data[i] ? 16'h8005 : 16'd0);
      end
    end
  endfunction

  function automatic [15:0] mirror(input reg [15:0] value);
    integer i;
    for (i = 0; i < 16; i = i + 1) mirror[i] = value[15-i];
  endfunction

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  // There is no reset: what comes before the first frame's start counts for nothing.
  always @* if (!begun_q) assume (start_i);
  always @* if (begun_q) assume (!byte_i || !busy);

  reg [15:0] before_q;  // the remainder before the last byte
  reg [7:0] byte_q;
  reg [3:0] done_q;  // its bits that are in
  reg empty_q;  // there is no byte yet
  wire [15:0] now = empty_q ? 16'hffff : divide(before_q, byte_q, 4'd8);
  wire settled = empty_q || done_q == 4'd8;
  always @(posedge clk_i) begin
    if (byte_i) begin
      before_q <= start_i ? 16'hffff : now;
      byte_q   <= data_i;
      done_q   <= 4'd0;
      empty_q  <= 1'b0;
    end else if (start_i) begin
      empty_q <= 1'b1;
    end else if (!settled) begin
      done_q <= done_q + 4'd1;
    end
  end

  always @* begin
    if (begun_q) begin
      assert (busy == !settled);
      if (settled) assert (crc == mirror(now));
    end
  end

  // Whatever the remainder of a frame is, its CRC behind it makes it 0.
  (* anyconst *) wire [15:0] remainder;
  wire [15:0] sent = mirror(remainder);
  always @* assert (divide(divide(remainder, sent[7:0], 4'd8), sent[15:8], 4'd8) == 16'd0);

  // For the induction.
  (* hierconn *) wire [7:0] \link_crc.left_q ;
  always @* begin
    if (begun_q && !empty_q) begin
      assert (done_q <= 4'd8);
      assert (crc == (mirror(divide(before_q, byte_q, done_q)) ^ ({8'd0, byte_q} >> done_q)));
      assert (\link_crc.left_q == 8'hff >> done_q);
    end
    if (begun_q && empty_q) assert (crc == 16'hffff && \link_crc.left_q == 8'd0);
  end

  // 40bf is the CRC of one byte 0.
  reg one_q;
  always @(posedge clk_i) if (byte_i) one_q <= start_i || empty_q;
  always @* begin
    cover (begun_q && settled && !empty_q && one_q && byte_q == 8'd0 && crc == 16'h40bf);
    cover (begun_q && settled && !empty_q && !one_q && crc == 16'd0);
  end

endmodule

`default_nettype wire
