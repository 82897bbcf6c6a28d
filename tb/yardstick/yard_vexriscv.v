// SPDX-License-Identifier: Apache-2.0
// VexRiscv (plain or Lite) with 64 KB of block RAM on its two Wishbone buses, as it would stand in an
// FPGA. What the program writes at 0x8000_0000 and above leaves as a mark: the bench counts the clocks
// between marks, and the marks keep everything from being optimised away in place and route.
`default_nettype none

module yard_vexriscv (
    input  wire        clk_i,
    output reg         mark_valid_o,
    output reg  [ 3:0] mark_addr_o,   // word address
    output reg  [31:0] mark_data_o
);

  wire        rst_n;

  wire        i_cyc;
  wire        i_stb;
  wire        i_ack;
  wire        i_we;
  wire [29:0] i_adr;
  wire [ 3:0] i_sel;
  wire [ 2:0] i_cti;
  wire [31:0] i_rdata;
  wire        d_cyc;
  wire        d_stb;
  wire        d_ack;
  wire        d_we;
  wire [29:0] d_adr;
  wire [ 3:0] d_sel;
  wire [ 2:0] d_cti;
  wire [31:0] d_wdata;
  wire [31:0] d_rdata;

  wire [13:0] i_ram_addr;
  wire [13:0] d_ram_addr;
  wire [ 3:0] d_ram_we;
  wire        mark_we;

  power_on_reset power_on_reset (
      .clk_i (clk_i),
      .rst_no(rst_n)
  );

  VexRiscv core (
      .externalResetVector   (32'h0),
      .timerInterrupt        (1'b0),
      .softwareInterrupt     (1'b0),
      .externalInterruptArray(32'h0),
      .iBusWishbone_CYC      (i_cyc),
      .iBusWishbone_STB      (i_stb),
      .iBusWishbone_ACK      (i_ack),
      .iBusWishbone_WE       (i_we),
      .iBusWishbone_ADR      (i_adr),
      .iBusWishbone_DAT_MISO (i_rdata),
      .iBusWishbone_DAT_MOSI (),
      .iBusWishbone_SEL      (i_sel),
      .iBusWishbone_ERR      (1'b0),
      .iBusWishbone_CTI      (i_cti),
      .iBusWishbone_BTE      (),
      .dBusWishbone_CYC      (d_cyc),
      .dBusWishbone_STB      (d_stb),
      .dBusWishbone_ACK      (d_ack),
      .dBusWishbone_WE       (d_we),
      .dBusWishbone_ADR      (d_adr),
      .dBusWishbone_DAT_MISO (d_rdata),
      .dBusWishbone_DAT_MOSI (d_wdata),
      .dBusWishbone_SEL      (d_sel),
      .dBusWishbone_ERR      (1'b0),
      .dBusWishbone_CTI      (d_cti),
      .dBusWishbone_BTE      (),
      .clk                   (clk_i),
      .reset                 (!rst_n)
  );

  yard_wishbone i_bus (
      .clk_i     (clk_i),
      .rst_ni    (rst_n),
      .cyc_i     (i_cyc),
      .stb_i     (i_stb),
      .we_i      (i_we),
      .adr_i     (i_adr),
      .sel_i     (i_sel),
      .cti_i     (i_cti),
      .ack_o     (i_ack),
      .ram_addr_o(i_ram_addr),
      .ram_we_o  (),
      .mark_we_o ()
  );

  yard_wishbone d_bus (
      .clk_i     (clk_i),
      .rst_ni    (rst_n),
      .cyc_i     (d_cyc),
      .stb_i     (d_stb),
      .we_i      (d_we),
      .adr_i     (d_adr),
      .sel_i     (d_sel),
      .cti_i     (d_cti),
      .ack_o     (d_ack),
      .ram_addr_o(d_ram_addr),
      .ram_we_o  (d_ram_we),
      .mark_we_o (mark_we)
  );

  yard_ram ram (
      .clk_i    (clk_i),
      .i_addr_i (i_ram_addr),
      .i_rdata_o(i_rdata),
      .d_addr_i (d_ram_addr),
      .d_we_i   (d_ram_we),
      .d_wdata_i(d_wdata),
      .d_rdata_o(d_rdata)
  );

  always @(posedge clk_i) begin
    mark_valid_o <= mark_we;
    mark_addr_o  <= d_adr[3:0];
    mark_data_o  <= d_wdata;
  end

endmodule
`default_nettype wire
