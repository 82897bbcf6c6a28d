// SPDX-License-Identifier: Apache-2.0
// Bit devices or word devices: each slot reads READS devices a clock and writes one. Every slot
// writes its own bank only; a device's value is the XOR of all banks at its address, so any slot
// can write any device. A bank has one copy (block RAM) for each read of it.
`default_nettype none

module device_memory #(
    parameter SLOTS = 1,
    parameter READS = 2,  // device reads of one slot a clock
    parameter CROSS = 1,  // 1: each slot also reads the other banks at the device it will write
    parameter WIDTH = 16,  // bits of a device
    parameter DEPTH = 256,  // devices
    parameter ADDR_BITS = 8  // bits of a device number
) (
    input  wire                               clk_i,
    // ID1: addresses, slot 0 lowest, and within a slot operand 0 lowest
    input  wire [  SLOTS*READS*ADDR_BITS-1:0] d1_addr_i,
    input  wire [        SLOTS*ADDR_BITS-1:0] d1_dest_i,
    // ID2: what the banks hold, in the order of the addresses, and for each of them bank 0 lowest
    output wire [SLOTS*READS*SLOTS*WIDTH-1:0] d2_bank_o,
    // ID2: for each slot the banks at its d1_dest_i; its own bank, which it does not need, reads 0
    output wire [      SLOTS*SLOTS*WIDTH-1:0] d2_cross_o,
    // after EX: the writes, each to the slot's own bank
    input  wire [                  SLOTS-1:0] w_we_i,
    input  wire [        SLOTS*ADDR_BITS-1:0] w_dest_i,
    input  wire [            SLOTS*WIDTH-1:0] w_bank_i
);

  genvar bank, read;
  generate
    for (bank = 0; bank < SLOTS; bank = bank + 1) begin : g_bank
      for (read = 0; read < SLOTS * READS; read = read + 1) begin : g_read
        bank_ram #(
            .WIDTH(WIDTH),
            .DEPTH(DEPTH),
            .ADDR_BITS(ADDR_BITS)
        ) copy (
            .clk_i(clk_i),
            .read_i(1'b1),
            .read_addr_i(d1_addr_i[read*ADDR_BITS+:ADDR_BITS]),
            .read_data_o(d2_bank_o[(read*SLOTS+bank)*WIDTH+:WIDTH]),
            .write_i(w_we_i[bank]),
            .write_addr_i(w_dest_i[bank*ADDR_BITS+:ADDR_BITS]),
            .write_data_i(w_bank_i[bank*WIDTH+:WIDTH])
        );
      end
      for (read = 0; read < SLOTS; read = read + 1) begin : g_cross
        if (CROSS != 0 && read != bank) begin : g_other
          bank_ram #(
              .WIDTH(WIDTH),
              .DEPTH(DEPTH),
              .ADDR_BITS(ADDR_BITS)
          ) copy (
              .clk_i(clk_i),
              .read_i(1'b1),
              .read_addr_i(d1_dest_i[read*ADDR_BITS+:ADDR_BITS]),
              .read_data_o(d2_cross_o[(read*SLOTS+bank)*WIDTH+:WIDTH]),
              .write_i(w_we_i[bank]),
              .write_addr_i(w_dest_i[bank*ADDR_BITS+:ADDR_BITS]),
              .write_data_i(w_bank_i[bank*WIDTH+:WIDTH])
          );
        end else begin : g_own
          assign d2_cross_o[(read*SLOTS+bank)*WIDTH+:WIDTH] = {WIDTH{1'b0}};
          wire unused_dest = &{1'b0, d1_dest_i};
        end
      end
    end
  endgenerate

endmodule

`default_nettype wire
