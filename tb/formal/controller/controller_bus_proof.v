// SPDX-License-Identifier: Apache-2.0
// The micro-sequencer's bus (hdl/controller/controller_bus.v), all of its modules as they are, around any processor: each read
// is answered in the next clock, by the one module that has the address (hdl/isa/controller.toml, by its numbers), and all
// others are silent then; an address that no register has reads 0, and without a read nothing answers. Constants of
// board and configuration are what they have to be. The status that a scan's latch takes says of it whether it is a first scan.
`default_nettype none

module controller_bus_proof #(
    parameter integer INPUTS  = 32,
    parameter integer OUTPUTS = 32
) (
    input wire              clk_i,
    input wire              rst_ni,
    input wire [INPUTS-1:0] in_i,
    input wire [     127:0] adc_i,
    input wire              rx_i,
    input wire              flash_miso_i,
    input wire              run_switch_i,
    input wire              host_rx_active_i,
    input wire              host_rx_valid_i,
    input wire [       7:0] host_rx_data_i,
    input wire              host_rx_error_i,
    input wire              host_tx_ready_i,
    input wire              host_tx_busy_i,
    input wire [      15:0] mem_addr_i,
    input wire              mem_read_i,
    input wire              mem_write_i,
    input wire [      15:0] mem_wdata_i
);

  localparam integer BOARD = 3;
  localparam integer CONFIG = 2;
  localparam integer MPU = 2;
  localparam integer BASE = 1234;
  wire [15:0] rdata;
  // verilator lint_off PINCONNECTEMPTY
  controller_bus #(
      .MPU       (MPU),
      .CONFIG_ID (CONFIG),
      .BOARD_ID  (BOARD),
      .INPUTS    (INPUTS),
      .OUTPUTS   (OUTPUTS),
      .FLASH_BASE(BASE)
  ) bus (
      .clk_i           (clk_i),
      .rst_ni          (rst_ni),
      .in_i            (in_i),
      .out_o           (),
      .adc_i           (adc_i),
      .pwm_o           (),
      .rx_i            (rx_i),
      .tx_o            (),
      .flash_csn_o     (),
      .flash_sck_o     (),
      .flash_mosi_o    (),
      .flash_miso_i    (flash_miso_i),
      .run_switch_i    (run_switch_i),
      .upper_rx_i      (1'b1),
      .lower_rx_i      (1'b1),
      .panel_rx_i      (1'b1),
      .upper_tx_o      (),
      .lower_tx_o      (),
      .panel_tx_o      (),
      .panel_de_o      (),
      .run_o           (),
      .fault_o         (),
      .forced_o        (),
      .line_o          (),
      .baud_step_o     (),
      .parity_o        (),
      .host_rx_active_i(host_rx_active_i),
      .host_rx_valid_i (host_rx_valid_i),
      .host_rx_data_i  (host_rx_data_i),
      .host_rx_error_i (host_rx_error_i),
      .host_tx_valid_o (),
      .host_tx_data_o  (),
      .host_tx_ready_i (host_tx_ready_i),
      .host_tx_busy_i  (host_tx_busy_i),
      .mem_addr_i      (mem_addr_i),
      .mem_read_i      (mem_read_i),
      .mem_write_i     (mem_write_i),
      .mem_wdata_i     (mem_wdata_i),
      .mem_rdata_o     (rdata)
  );
  // verilator lint_on PINCONNECTEMPTY

  (* hierconn *) wire [15:0] \bus.line_rdata ;
  (* hierconn *) wire [15:0] \bus.flash_rdata ;
  (* hierconn *) wire [15:0] \bus.crc_rdata ;
  (* hierconn *) wire [15:0] \bus.exchange_rdata ;
  (* hierconn *) wire [15:0] \bus.scan_rdata ;
  (* hierconn *) wire [15:0] \bus.statistics_rdata ;
  (* hierconn *) wire [15:0] \bus.input_rdata ;
  (* hierconn *) wire [15:0] \bus.output_rdata ;
  (* hierconn *) wire [15:0] \bus.keep_rdata ;
  (* hierconn *) wire [15:0] \bus.constant_rdata_q ;
  (* hierconn *) wire [15:0] \bus.milliseconds ;
  (* hierconn *) wire \bus.latch ;
  (* hierconn *) wire \bus.first ;
  (* hierconn *) wire [15:0] \bus.status ;

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // Who has an address: nobody, or a place in `shown`.
  localparam [3:0] NOBODY = 4'd15;
  function automatic [3:0] owner(input reg [15:0] addr);
    reg [15:0] number;
    begin
      number = addr - 16'h300;
      owner = NOBODY;
      if (addr < 16'h200) owner = 4'd0;  // rx_frame, tx_frame
      else if (addr < 16'h300) owner = 4'd3;  // exchange_buffer
      else if (number <= 16'd11) owner = 4'd0;  // line
      else if (number >= 16'd16 && number <= 16'd18) owner = 4'd1;  // flash
      else if (number >= 16'd20 && number <= 16'd23) owner = 4'd2;  // crc
      else if (number >= 16'd32 && number <= 16'd39) owner = 4'd3;  // exchange
      else if (number >= 16'd48 && number <= 16'd51) owner = 4'd4;  // scan_command to fault_set
      else if (number >= 16'd52 && number <= 16'd60) owner = 4'd5;  // statistics
      else if (number == 16'd61) owner = 4'd9;  // milliseconds
      else if (number >= 16'd64 && number <= 16'd67) owner = 4'd6;  // inputs
      else if (number >= 16'd68 && number <= 16'd71) owner = 4'd7;  // outputs
      else if (number >= 16'd72 && number <= 16'd75) owner = 4'd8;  // keep
      else if (number >= 16'd80 && number <= 16'd83) owner = 4'd9;  // board_id to flash_base
    end
  endfunction

  wire [159:0] shown = {
    \bus.constant_rdata_q ,
    \bus.keep_rdata ,
    \bus.output_rdata ,
    \bus.input_rdata ,
    \bus.statistics_rdata ,
    \bus.scan_rdata ,
    \bus.exchange_rdata ,
    \bus.crc_rdata ,
    \bus.flash_rdata ,
    \bus.line_rdata
  };
  reg [3:0] owner_q;
  reg [15:0] addr_q;
  reg read_q;
  reg [15:0] milliseconds_q;
  always @(posedge clk_i) begin
    owner_q <= mem_read_i ? owner(mem_addr_i) : NOBODY;
    addr_q <= mem_addr_i;
    read_q <= mem_read_i;
    milliseconds_q <= \bus.milliseconds ;
  end
  integer i;
  always @* begin
    if (begun_q) begin
      for (i = 0; i < 10; i = i + 1) begin
        if (owner_q != i[3:0]) assert (shown[16*i+:16] == 16'd0);
        else assert (rdata == shown[16*i+:16]);
      end
      if (owner_q == NOBODY) assert (rdata == 16'd0);
      if (read_q && addr_q == 16'h300 + 16'd61) assert (rdata == milliseconds_q);
      if (read_q && addr_q == 16'h300 + 16'd80) assert (rdata == BOARD);
      if (read_q && addr_q == 16'h300 + 16'd81) assert (rdata == CONFIG);
      if (read_q && addr_q == 16'h300 + 16'd82) assert (rdata == MPU);
      if (read_q && addr_q == 16'h300 + 16'd83) assert (rdata == BASE);
    end
  end

  // Status bits off, on, first scan, not first scan.
  reg latched_q;
  initial latched_q = 1'b0;
  reg first_q;
  always @(posedge clk_i) begin
    if (\bus.latch ) {latched_q, first_q} <= {1'b1, \bus.first };
  end
  always @* begin
    if (begun_q) assert (\bus.status [1:0] == 2'b10);
    if (begun_q && latched_q) assert (\bus.status [3:2] == {!first_q, first_q});
  end

  always @* begin
    cover (begun_q && owner_q == 4'd4 && rdata != 16'd0);
    cover (begun_q && owner_q == 4'd6 && rdata == 16'h8001);
  end

endmodule

`default_nettype wire
