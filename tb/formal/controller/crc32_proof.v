// SPDX-License-Identifier: Apache-2.0
// CRC-32 (hdl/controller/crc32.v): after any bytes since the last clear, with the clocks between them that the top of the
// file asks for, its registers show the CRC of IEEE 802.3. The model is the standard's own form, highest power first:
// a division by the polynomial 0x04c11db7, bits of a byte lowest first, the remainder mirrored and inverted.
`default_nettype none
`include "rung_controller.vh"

module crc32_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        sel_register_i,
    input wire [ 7:0] addr_i,
    input wire        read_i,
    input wire        write_i,
    input wire [15:0] wdata_i
);

  wire [15:0] rdata;
  crc32 crc (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .write_i       (write_i),
      .wdata_i       (wdata_i),
      .rdata_o       (rdata)
  );

  function automatic [31:0] divide(input reg [31:0] remainder, input reg [7:0] data,
                                   input integer bits);
    integer i;
    begin
      divide = remainder;
      for (i = 0; i < bits; i = i + 1) begin
        divide = {divide[30:0], 1'b0} ^ (divide[31] ^ data[i] ? 32'h04c11db7 : 32'd0);
      end
    end
  endfunction

  function automatic [31:0] mirror(input reg [31:0] value);
    integer i;
    for (i = 0; i < 32; i = i + 1) mirror[i] = value[31-i];
  endfunction

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  wire write = sel_register_i && write_i;
  wire clear = !rst_ni || (write && addr_i == `RUNG_REG_CRC_CLEAR);
  wire add = write && addr_i == `RUNG_REG_CRC_BYTE;

  // Remainder before the last byte, that byte, and the clocks since its write.
  reg [31:0] before_q;
  reg [7:0] byte_q;
  reg [1:0] since_q;  // 0: no byte yet; 1, 2: the byte's own clocks; 3: it is in
  wire [31:0] now = since_q == 2'd0 ? before_q : divide(before_q, byte_q, 8);
  wire settled = since_q == 2'd0 || since_q == 2'd3;
  always @* assume (!add || settled);  // an instruction of the sequencer takes longer

  always @(posedge clk_i) begin
    if (clear) begin
      before_q <= 32'hffffffff;
      since_q  <= 2'd0;
    end else if (add) begin
      before_q <= now;
      byte_q   <= wdata_i[7:0];
      since_q  <= 2'd1;
    end else if (!settled) begin
      since_q <= since_q + 2'd1;
    end
  end

  // ---- what the bus reads ------------------------------------------------------------------------
  reg low_q;
  reg high_q;
  reg known_q;
  reg [31:0] now_q;
  always @(posedge clk_i) begin
    low_q   <= sel_register_i && read_i && addr_i == `RUNG_REG_CRC_LOW;
    high_q  <= sel_register_i && read_i && addr_i == `RUNG_REG_CRC_HIGH;
    known_q <= begun_q && settled;
    now_q   <= ~mirror(now);
  end

  always @* begin
    if (begun_q) begin
      if (low_q && known_q) assert (rdata == now_q[15:0]);
      if (high_q && known_q) assert (rdata == now_q[31:16]);
      if (known_q && !low_q && !high_q) assert (rdata == 16'd0);
    end
  end

  // ---- for the induction: the register on the way from one byte to the next ------------------------
  (* hierconn *) wire [31:0] \crc.crc_q ;
  (* hierconn *) wire [ 1:0] \crc.left_q ;
  always @* begin
    if (begun_q) begin
      case (since_q)
        2'd1: begin
          assert (\crc.crc_q == (mirror(before_q) ^ {24'd0, byte_q}));
          assert (\crc.left_q == 2'd2);
        end
        2'd2: begin
          assert (\crc.crc_q == (mirror(divide(before_q, byte_q, 4)) ^ {28'd0, byte_q[7:4]}));
          assert (\crc.left_q == 2'd1);
        end
        default: assert (\crc.crc_q == mirror(now) && \crc.left_q == 2'd0);
      endcase
    end
  end

  // d202ef8d is the CRC of one byte 0.
  reg [1:0] bytes_q;
  always @(posedge clk_i) bytes_q <= clear ? 2'd0 : bytes_q + {1'b0, add};
  always @* begin
    cover (low_q && known_q && bytes_q == 2'd1 && byte_q == 8'd0 && rdata == 16'hef8d);
    cover (high_q && known_q && bytes_q == 2'd2 && rdata == 16'h0000);
  end

endmodule

`default_nettype wire
