// SPDX-License-Identifier: Apache-2.0
// For core_proof.v: what the device memories hold, as devices: the exclusive-or of the banks, of which all
// copies are to be alike.
`default_nettype none

module banks #(
    parameter SLOTS = 1,  // banks, too
    parameter COPIES = 2,  // of each bank
    parameter WIDTH = 16,
    parameter ADDR_BITS = 2,
    // not to be set
    parameter BANK = WIDTH << ADDR_BITS
) (
    input wire [SLOTS*COPIES*BANK-1:0] memory_i,
    // the writes that the memories take at the end of this clock
    input wire [SLOTS-1:0] we_i,
    input wire [SLOTS*ADDR_BITS-1:0] dest_i,
    input wire [SLOTS*WIDTH-1:0] data_i,
    // each bank; the devices now, and behind those writes, and then what the others of each bank hold
    output reg alike_o,
    output reg [SLOTS*BANK-1:0] banks_o,
    output reg [BANK-1:0] held_o,
    output reg [BANK-1:0] coming_o,
    output reg [SLOTS*BANK-1:0] others_o
);

  reg [SLOTS*BANK-1:0] next;
  integer b, c;
  always @* begin
    alike_o  = 1'b1;
    held_o   = {BANK{1'b0}};
    coming_o = {BANK{1'b0}};
    for (b = 0; b < SLOTS; b = b + 1) begin
      banks_o[b*BANK+:BANK] = memory_i[b*COPIES*BANK+:BANK];
      for (c = 1; c < COPIES; c = c + 1) begin
        if (memory_i[(b*COPIES+c)*BANK+:BANK] != memory_i[b*COPIES*BANK+:BANK]) alike_o = 1'b0;
      end
    end
    next = banks_o;
    for (b = 0; b < SLOTS; b = b + 1) begin
      if (we_i[b])
        next[b*BANK+dest_i[b*ADDR_BITS+:ADDR_BITS]*WIDTH+:WIDTH] = data_i[b*WIDTH+:WIDTH];
      held_o = held_o ^ banks_o[b*BANK+:BANK];
      coming_o = coming_o ^ next[b*BANK+:BANK];
    end
    for (b = 0; b < SLOTS; b = b + 1) others_o[b*BANK+:BANK] = coming_o ^ next[b*BANK+:BANK];
  end

endmodule

`default_nettype wire
