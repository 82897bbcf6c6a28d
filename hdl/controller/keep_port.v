// SPDX-License-Identifier: Apache-2.0
// The lasting memory as a program sees it: registers keep_* of hdl/isa/controller.toml between
// port_exchange.v and the firmware, which has the memory. Not ready after reset, nor while a value waits.
// Bus: select, address and data in the clock of read_i or write_i; rdata_o in the clock after read_i, else 0.
`default_nettype none
`include "rung_controller.vh"

module keep_port (
    input  wire        clk_i,
    input  wire        rst_ni,
    // port_exchange.v
    output wire        ready_o,
    input  wire        keep_valid_i,
    input  wire [ 5:0] keep_index_i,
    input  wire [15:0] keep_value_i,
    // bus
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o
);

  localparam [7:0] STATUS = `RUNG_REG_KEEP_STATUS;
  localparam [7:0] INDEX = `RUNG_REG_KEEP_INDEX;
  localparam [7:0] VALUE = `RUNG_REG_KEEP_VALUE;
  localparam [7:0] DONE = `RUNG_REG_KEEP_DONE;

  reg ready_q;
  reg wanted_q;
  reg [5:0] index_q;
  reg [15:0] value_q;
  reg [15:0] rdata_q;

  always @(posedge clk_i) begin
    if (keep_valid_i) {index_q, value_q} <= {keep_index_i, keep_value_i};

    if (!rst_ni) begin
      ready_q  <= 1'b0;
      wanted_q <= 1'b0;
    end else begin
      if (sel_register_i && write_i && addr_i == DONE) ready_q <= wdata_i[0];
      if (keep_valid_i) wanted_q <= 1'b1;
      else if (sel_register_i && write_i && addr_i == DONE && wdata_i[0]) wanted_q <= 1'b0;
    end

    rdata_q <= 16'd0;
    if (sel_register_i && read_i) begin
      case (addr_i)
        STATUS:  rdata_q <= {15'd0, wanted_q};
        INDEX:   rdata_q <= {10'd0, index_q};
        VALUE:   rdata_q <= value_q;
        default: ;
      endcase
    end
  end

  assign ready_o = ready_q && !wanted_q;
  assign rdata_o = rdata_q;

  // verilator lint_off UNUSEDSIGNAL
  wire unused = &{1'b0, wdata_i[15:1]};
  // verilator lint_on UNUSEDSIGNAL

endmodule

`default_nettype wire
