// SPDX-License-Identifier: Apache-2.0
// picorv32 (RV32IM: one-clock multiplier, divider, barrel shifter) with 64 KB of block RAM, as it would
// stand in an FPGA. LOOK_AHEAD=1 addresses the RAM through the core's look-ahead port, so that no access
// waits; 0 uses the plain port, and each access waits one clock. Marks as in yard_vexriscv.v.
`default_nettype none

module yard_picorv32 #(
    parameter integer LOOK_AHEAD = 1
) (
    input  wire        clk_i,
    output reg         mark_valid_o,
    output reg  [ 3:0] mark_addr_o,   // word address
    output reg  [31:0] mark_data_o
);

  wire        rst_n;
  wire        valid;
  wire [31:0] addr;
  wire [31:0] wdata;
  wire [ 3:0] wstrb;
  wire        la_write;
  wire [31:0] la_addr;
  wire [31:0] la_wdata;
  wire [ 3:0] la_wstrb;
  wire [31:0] rdata;
  reg         ready_q;

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
      .mem_valid   (valid),
      .mem_instr   (),
      .mem_ready   (LOOK_AHEAD != 0 || ready_q),
      .mem_addr    (addr),
      .mem_wdata   (wdata),
      .mem_wstrb   (wstrb),
      .mem_rdata   (rdata),
      .mem_la_read (),
      .mem_la_write(la_write),
      .mem_la_addr (la_addr),
      .mem_la_wdata(la_wdata),
      .mem_la_wstrb(la_wstrb),
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

  wire        request = LOOK_AHEAD != 0 ? la_write : valid && !ready_q && |wstrb;
  wire [31:0] ram_addr = LOOK_AHEAD != 0 ? la_addr : addr;
  wire [31:0] ram_wdata = LOOK_AHEAD != 0 ? la_wdata : wdata;
  wire [ 3:0] ram_wstrb = LOOK_AHEAD != 0 ? la_wstrb : wstrb;

  always @(posedge clk_i) begin
    if (!rst_n) ready_q <= 1'b0;
    else ready_q <= valid && !ready_q;
  end

  yard_ram ram (
      .clk_i    (clk_i),
      .i_addr_i (14'h0),
      .i_rdata_o(),
      .d_addr_i (ram_addr[15:2]),
      .d_we_i   ({4{request && !ram_addr[31]}} & ram_wstrb),
      .d_wdata_i(ram_wdata),
      .d_rdata_o(rdata)
  );

  always @(posedge clk_i) begin
    mark_valid_o <= request && ram_addr[31];
    mark_addr_o  <= ram_addr[5:2];
    mark_data_o  <= ram_wdata;
  end

endmodule
`default_nettype wire
