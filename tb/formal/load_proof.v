// SPDX-License-Identifier: Apache-2.0
// What the load port (hdl/core/load_port.v) loads directly: a chunk of a step or the program's length is
// with fetch a clock after it was accepted, accesses during a scan are nowhere, and a look-up of any slot
// gets the row as it was last loaded. Devices are core_proof.v's, what fetch does with chunks
// fetch_proof.v's.
`default_nettype none
`include "rung_isa.vh"

module load_proof #(
    parameter SLOTS = 2,
    // not to be set
    parameter BIT_ADDR = 2,
    parameter WORD_ADDR = 1,
    parameter TAIL_AT = `RUNG_WORD_BITS + WORD_ADDR + BIT_ADDR + 1,
    parameter SLOT_BITS = TAIL_AT + `RUNG_ROW_BITS + `RUNG_OP_BITS
) (
    input wire clk_i,
    input wire start_i,
    input wire load_valid_i,
    input wire load_write_i,
    input wire [2:0] load_space_i,
    input wire [19:0] load_addr_i,
    input wire [15:0] load_data_i,
    input wire [SLOTS*SLOT_BITS-1:0] peek_step,
    input wire peek_valid,
    input wire [SLOTS*8-1:0] peek_row,
    input wire peek_chunk,
    input wire peek_lut,
    input wire peek_length,
    input wire [19:0] peek_addr,
    input wire [15:0] peek_data,
    input wire [SLOTS*8*`RUNG_LUT_ROWS-1:0] peek_rows
);

  reg [2:0] age_q;
  initial age_q = 3'd0;
  always @(posedge clk_i) if (age_q != 3'd6) age_q <= age_q + 3'd1;
  wire reset = age_q < 3'd5;
  wire known = age_q == 3'd6;

  wire busy, done, error, load_rvalid;
  wire [15:0] load_rdata;
  wire [31:0] clocks;
  wire [SLOTS-1:0] write_valid, retire_valid, retire_exc, retire_bit_we, retire_bit_data;
  wire [SLOTS-1:0] retire_word_we;
  wire [SLOTS*16-1:0] write_addr, write_data, retire_step, retire_bit_addr, retire_word_addr;
  wire [SLOTS*16-1:0] retire_word_data;
  core #(
      .LOOKUP(1),
      .SLOTS(SLOTS),
      .STEPS(4),
      .BIT_DEVICES(1 << BIT_ADDR),
      .WORD_DEVICES(1 << WORD_ADDR)
  ) core (
      .clk_i(clk_i),
      .rst_ni(!reset),
      .start_i(start_i && !reset),
      .busy_o(busy),
      .done_o(done),
      .error_o(error),
      .clocks_o(clocks),
      .range_i(1'b0),
      .entry_i(16'd0),
      .end_i(16'd0),
      .write_valid_o(write_valid),
      .write_addr_o(write_addr),
      .write_data_o(write_data),
      .load_valid_i(load_valid_i),
      .load_write_i(load_write_i),
      .load_space_i(load_space_i),
      .load_addr_i(load_addr_i),
      .load_data_i(load_data_i),
      .load_rvalid_o(load_rvalid),
      .load_rdata_o(load_rdata),
      .retire_valid_o(retire_valid),
      .retire_step_o(retire_step),
      .retire_exc_o(retire_exc),
      .retire_bit_we_o(retire_bit_we),
      .retire_bit_addr_o(retire_bit_addr),
      .retire_bit_data_o(retire_bit_data),
      .retire_word_we_o(retire_word_we),
      .retire_word_addr_o(retire_word_addr),
      .retire_word_data_o(retire_word_data)
  );

  // ---- one row, any: as it was last loaded -----------------------------------------------------
  (* anyconst *)wire [`RUNG_ROW_BITS-1:0] watched;
  reg accepted_q, write_q;
  reg [2:0] space_q;
  reg [19:0] addr_q;
  reg [15:0] data_q;
  reg [7:0] content_q;
  initial content_q = 8'd0;  // as the bitstream has it
  wire lut = accepted_q && write_q && space_q == 3'd1;
  always @(posedge clk_i) begin
    accepted_q <= load_valid_i && !busy && !reset;
    write_q <= load_write_i;
    space_q <= load_space_i;
    addr_q <= load_addr_i;
    data_q <= load_data_i;
    if (lut && !reset && addr_q[`RUNG_ROW_BITS-1:0] == watched) content_q <= data_q[7:0];
  end
  // Before the reset reaches the port it may load anything.
  always @* if (age_q == 3'd0) assume (!peek_lut && !accepted_q);
  always @* assert (age_q <= 3'd6);

  always @* begin
    if (known) begin
      assert (peek_chunk == (accepted_q && write_q && space_q == 3'd0));
      assert (peek_lut == lut);
      assert (peek_length == (accepted_q && write_q && space_q == 3'd4));
      if (accepted_q) assert (peek_addr == addr_q && peek_data == data_q);
    end
  end

  genvar s;
  generate
    for (s = 0; s < SLOTS; s = s + 1) begin : g_slot
      // The instruction in ID2 names the row. None is in ID1 with an access before it in IF3: core_proof.v.
      reg looked_q;
      always @(posedge clk_i) begin
        looked_q <= known && peek_valid && !lut &&
            peek_step[s*SLOT_BITS+TAIL_AT+:`RUNG_ROW_BITS] == watched;
      end
      always @* assert (peek_rows[(s*`RUNG_LUT_ROWS+watched)*8+:8] == content_q);
      always @* if (known && looked_q) assert (peek_row[s*8+:8] == content_q);
      always @* cover (known && looked_q && content_q == 8'hA6);
    end
  endgenerate

endmodule

`default_nettype wire
