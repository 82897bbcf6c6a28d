// SPDX-License-Identifier: Apache-2.0
// Statistics of scans (hdl/controller/scan_statistics.v): number of scans, clocks of the last one, overruns; least and most are
// those of all scans since they were cleared: none is below the least or above the most, and both were one's. A 32-bit value
// is read in one piece: its high word is the one of the clock in which its low word was read.
`default_nettype none
`include "rung_controller.vh"

module scan_statistics_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        counted_i,
    input wire [31:0] clocks_i,
    input wire        overrun_i,
    input wire        clear_i,
    input wire        sel_register_i,
    input wire [ 7:0] addr_i,
    input wire        read_i
);

  wire [15:0] rdata;
  scan_statistics statistics (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .counted_i     (counted_i),
      .clocks_i      (clocks_i),
      .overrun_i     (overrun_i),
      .clear_i       (clear_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .rdata_o       (rdata)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // Scans take some clocks: three at least from one to the next, or to a clear.
  reg [1:0] since_q;
  always @(posedge clk_i)
    since_q <= !rst_ni ? 2'd3 : counted_i ? 2'd0 : since_q + {1'b0, since_q != 2'd3};
  always @* assume (since_q == 2'd3 || (!counted_i && !clear_i));
  always @* assume (!(counted_i && clear_i));

  reg [31:0] count_q, last_q, least_q, most_q;
  reg [15:0] overruns_q;
  always @(posedge clk_i) begin
    if (!rst_ni) {count_q, last_q} <= 64'd0;
    else if (counted_i) {count_q, last_q} <= {count_q + 32'd1, clocks_i};
    if (!rst_ni || clear_i) {least_q, most_q, overruns_q} <= {32'hffffffff, 32'd0, 16'd0};
    else begin
      if (counted_i && clocks_i < least_q) least_q <= clocks_i;
      if (counted_i && clocks_i > most_q) most_q <= clocks_i;
      if (overrun_i && overruns_q != 16'hffff) overruns_q <= overruns_q + 16'd1;
    end
  end

  // ---- what the bus reads, when a scan's clocks have been compared ---------------------------------------
  wire read = sel_register_i && read_i;
  reg [4:0] low_q;  // count, last, least, most, overruns were asked for in the clock before
  reg [31:0] count_1_q, last_1_q, least_1_q, most_1_q;
  reg [15:0] overruns_1_q;
  reg [31:0] held_value_q;
  reg held_known_q;
  reg high_known_q;
  always @(posedge clk_i) begin
    low_q <= {5{begun_q && read}} & {
      addr_i == `RUNG_REG_SCAN_OVERRUNS, addr_i == `RUNG_REG_SCAN_MAX_LOW && since_q == 2'd3,
      addr_i == `RUNG_REG_SCAN_MIN_LOW && since_q == 2'd3, addr_i == `RUNG_REG_SCAN_LAST_LOW,
      addr_i ==
    `RUNG_REG_SCAN_COUNT_LOW
    };
    {count_1_q, last_1_q, least_1_q, most_1_q} <= {count_q, last_q, least_q, most_q};
    overruns_1_q <= overruns_q;
    if (begun_q && read) begin
      case (addr_i)
        `RUNG_REG_SCAN_COUNT_LOW: {held_known_q, held_value_q} <= {1'b1, count_q};
        `RUNG_REG_SCAN_LAST_LOW: {held_known_q, held_value_q} <= {1'b1, last_q};
        `RUNG_REG_SCAN_MIN_LOW: {held_known_q, held_value_q} <= {since_q == 2'd3, least_q};
        `RUNG_REG_SCAN_MAX_LOW: {held_known_q, held_value_q} <= {since_q == 2'd3, most_q};
        default: ;
      endcase
    end
    if (!begun_q) held_known_q <= 1'b0;
    high_known_q <= begun_q && read && held_known_q &&
        (addr_i == `RUNG_REG_SCAN_COUNT_HIGH || addr_i == `RUNG_REG_SCAN_LAST_HIGH ||
         addr_i == `RUNG_REG_SCAN_MIN_HIGH || addr_i == `RUNG_REG_SCAN_MAX_HIGH);
  end
  always @* begin
    if (begun_q) begin
      if (low_q[0]) assert (rdata == count_1_q[15:0]);
      if (low_q[1]) assert (rdata == last_1_q[15:0]);
      if (low_q[2]) assert (rdata == least_1_q[15:0]);
      if (low_q[3]) assert (rdata == most_1_q[15:0]);
      if (low_q[4]) assert (rdata == overruns_1_q);
      if (high_known_q) assert (rdata == held_value_q[31:16]);
    end
  end

  // ---- for the induction -----------------------------------------------------------------------------------
  (* hierconn *) wire [31:0] \statistics.count_q ;
  (* hierconn *) wire [31:0] \statistics.last_q ;
  (* hierconn *) wire [31:0] \statistics.min_q ;
  (* hierconn *) wire [31:0] \statistics.max_q ;
  (* hierconn *) wire [15:0] \statistics.overruns_q ;
  (* hierconn *) wire [15:0] \statistics.high_q ;
  (* hierconn *) wire \statistics.compare_q ;
  (* hierconn *) wire \statistics.below_q ;
  (* hierconn *) wire \statistics.above_q ;
  always @* begin
    if (begun_q) begin
      assert (\statistics.count_q == count_q && \statistics.last_q == last_q);
      assert (\statistics.overruns_q == overruns_q);
      if (held_known_q) assert (\statistics.high_q == held_value_q[31:16]);
      assert (\statistics.compare_q == (since_q == 2'd0));
      // The least is right at once but for a scan that is being compared.
      if (since_q >= 2'd2) assert (\statistics.min_q == least_q && \statistics.max_q == most_q);
      if (since_q == 2'd0) begin
        assert (least_q == (last_q < \statistics.min_q ? last_q : \statistics.min_q ));
        assert (most_q == (last_q > \statistics.max_q ? last_q : \statistics.max_q ));
      end
      if (since_q == 2'd1) begin
        assert (least_q == (\statistics.below_q ? last_q : \statistics.min_q ));
        assert (most_q == (\statistics.above_q ? last_q : \statistics.max_q ));
      end else begin
        assert (!\statistics.below_q && !\statistics.above_q );
      end
    end
  end

  always @* begin
    cover (begun_q && high_known_q && count_q == 32'd2 && rdata == 16'h1234);
    cover (begun_q && low_q[2] && count_q == 32'd2 && rdata == 16'd55);
  end

endmodule

`default_nettype wire
