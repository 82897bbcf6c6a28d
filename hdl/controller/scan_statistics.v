// SPDX-License-Identifier: Apache-2.0
// What scans were like: registers scan_count to scan_overruns of hdl/isa/controller.toml. counted_i: a scan
// has taken clocks_i clocks. overrun_i: it began late. clear_i: minimum, maximum and overruns begin anew.
// Bus: select and address in the clock of read_i; rdata_o in the clock after read_i, else 0.
`default_nettype none
`include "rung_controller.vh"

module scan_statistics (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        counted_i,
    input  wire [31:0] clocks_i,
    input  wire        overrun_i,
    input  wire        clear_i,
    // bus
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    output wire [15:0] rdata_o
);

  localparam [7:0] COUNT_LOW = `RUNG_REG_SCAN_COUNT_LOW;
  localparam [7:0] COUNT_HIGH = `RUNG_REG_SCAN_COUNT_HIGH;
  localparam [7:0] LAST_LOW = `RUNG_REG_SCAN_LAST_LOW;
  localparam [7:0] LAST_HIGH = `RUNG_REG_SCAN_LAST_HIGH;
  localparam [7:0] MIN_LOW = `RUNG_REG_SCAN_MIN_LOW;
  localparam [7:0] MIN_HIGH = `RUNG_REG_SCAN_MIN_HIGH;
  localparam [7:0] MAX_LOW = `RUNG_REG_SCAN_MAX_LOW;
  localparam [7:0] MAX_HIGH = `RUNG_REG_SCAN_MAX_HIGH;
  localparam [7:0] OVERRUNS = `RUNG_REG_SCAN_OVERRUNS;

  reg [31:0] count_q;
  reg [31:0] last_q;
  reg [31:0] min_q;
  reg [31:0] max_q;
  reg [15:0] overruns_q;
  // A scan's clocks are compared in the clock after it, and taken in the next.
  reg compare_q;
  reg below_q;
  reg above_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q <= 32'd0;
      last_q <= 32'd0;
      compare_q <= 1'b0;
    end else begin
      compare_q <= counted_i;
      if (counted_i) begin
        count_q <= count_q + 32'd1;
        last_q  <= clocks_i;
      end
    end

    if (!rst_ni || clear_i) begin
      min_q <= 32'hffffffff;
      max_q <= 32'd0;
      below_q <= 1'b0;
      above_q <= 1'b0;
      overruns_q <= 16'd0;
    end else begin
      below_q <= compare_q && last_q < min_q;
      above_q <= compare_q && last_q > max_q;
      if (below_q) min_q <= last_q;
      if (above_q) max_q <= last_q;
      if (overrun_i && overruns_q != 16'hffff) overruns_q <= overruns_q + 16'd1;
    end
  end

  // ---- reads: a low word holds its high word ----------------------------------------------------
  reg [15:0] high_q;
  reg [15:0] rdata_q;

  always @(posedge clk_i) begin
    rdata_q <= 16'd0;
    if (sel_register_i && read_i) begin
      case (addr_i)
        COUNT_LOW: {high_q, rdata_q} <= count_q;
        LAST_LOW: {high_q, rdata_q} <= last_q;
        MIN_LOW: {high_q, rdata_q} <= min_q;
        MAX_LOW: {high_q, rdata_q} <= max_q;
        COUNT_HIGH, LAST_HIGH, MIN_HIGH, MAX_HIGH: rdata_q <= high_q;
        OVERRUNS: rdata_q <= overruns_q;
        default: ;
      endcase
    end
  end

  assign rdata_o = rdata_q;

endmodule

`default_nettype wire
