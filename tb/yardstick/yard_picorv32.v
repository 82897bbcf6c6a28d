// SPDX-License-Identifier: Apache-2.0
// picorv32 (RV32IM: one-clock multiplier, divider, barrel shifter) with 64 KB of block RAM, as it would
// stand in an FPGA. The core's look-ahead port addresses the RAM, so that no access waits; through its
// plain port, at one wait clock, it was slower by a third. Marks as in yard_vexriscv.v.
`default_nettype none

module yard_picorv32 (
    input  wire        clk_i,
    output reg         mark_valid_o,
    output reg  [ 3:0] mark_addr_o,   // word address
    output reg  [31:0] mark_data_o
);

  wire        rst_n;
  wire        write;
  wire [31:0] addr;
  wire [31:0] wdata;
  wire [ 3:0] wstrb;
  wire [31:0] rdata;

  power_on_reset power_on_reset (
      .clk_i (clk_i),
      .rst_no(rst_n)
  );

  picorv32 #(
      .ENABLE_COUNTERS(0),
      .ENABLE_COUNTERS64(0),
      .BARREL_SHIFTER(1),
      .ENABLE_FAST_MUL(1),
      .ENABLE_DIV(1),
      .CATCH_MISALIGN(0),
      .STACKADDR(32'h0001_0000)
  ) core (
      .clk         (clk_i),
      .resetn      (rst_n),
      .trap        (),
      .mem_valid   (),
      .mem_instr   (),
      .mem_ready   (1'b1),
      .mem_addr    (),
      .mem_wdata   (),
      .mem_wstrb   (),
      .mem_rdata   (rdata),
      .mem_la_read (),
      .mem_la_write(write),
      .mem_la_addr (addr),
      .mem_la_wdata(wdata),
      .mem_la_wstrb(wstrb),
      .pcpi_valid  (),
      .pcpi_insn   (),
      .pcpi_rs1    (),
      .pcpi_rs2    (),
      .pcpi_wr     (1'b0),
      .pcpi_rd     (32'h0),
      .pcpi_wait   (1'b0),
      .pcpi_ready  (1'b0),
      .irq         (32'h0),
      .eoi         (),
      .trace_valid (),
      .trace_data  ()
  );

  yard_ram ram (
      .clk_i    (clk_i),
      .i_addr_i (14'h0),
      .i_rdata_o(),
      .d_addr_i (addr[15:2]),
      .d_we_i   ({4{write && !addr[31]}} & wstrb),
      .d_wdata_i(wdata),
      .d_rdata_o(rdata)
  );

  always @(posedge clk_i) begin
    mark_valid_o <= write && addr[31];
    mark_addr_o  <= addr[5:2];
    mark_data_o  <= wdata;
  end

endmodule
`default_nettype wire
