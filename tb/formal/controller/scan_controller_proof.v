// SPDX-License-Identifier: Apache-2.0
// Scan controller (hdl/controller/scan_controller.v): the course of a scan, clock by clock, as the table at the top of the file
// has it, whatever the processor, the bus and the RUN switch do; and what the design promises:
//   a watchdog always ends a scan: in clock t + W at the latest, t being its latch, it is over or the state is fault;
//   with a period latches are exactly that far apart, or follow the exchange at once;
//   outputs are safe in all but running and one scan, from the clock of the fault on;
//   a program can be written only while stopped, with no scan under way and its processor out of reset.
`default_nettype none
`include "rung_controller.vh"

module scan_controller_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        run_switch_i,
    input wire        done_i,
    input wire        error_i,
    input wire        sel_register_i,
    input wire [ 7:0] addr_i,
    input wire        read_i,
    input wire        write_i,
    input wire [15:0] wdata_i
);

  // Any setup, which stays as it is.
  (* anyconst *) wire [ 8:0] latch_count;
  (* anyconst *) wire [ 8:0] refresh_count;
  (* anyconst *) wire [11:0] exchange_points;
  (* anyconst *) wire [31:0] period;
  (* anyconst *) wire [31:0] watchdog;
  always @* assume (watchdog != 32'd1);  // less than a latch takes
`ifdef RUNG_NARROW
  always @* assume (latch_count == 9'd0 && refresh_count == 9'd0 && exchange_points == 12'd0);
  always @* assume (period == 32'd0 && (watchdog == 32'd0 || watchdog == 32'd20) && run_switch_i);
  always @* assume (rst_ni == begun_q && (addr_i == `RUNG_REG_SCAN_COMMAND));
`endif

  wire latch, first, scan, scanning, refresh, refreshing, refresh_end, exchange, give_up;
  wire active, fault, safe, idle, core_rst_n, restore, counted, overrun, clear;
  wire [31:0] clocks;
  wire [15:0] rdata;
  scan_controller control (
      .clk_i            (clk_i),
      .rst_ni           (rst_ni),
      .latch_count_i    (latch_count),
      .refresh_count_i  (refresh_count),
      .exchange_points_i(exchange_points),
      .period_i         (period),
      .watchdog_i       (watchdog),
      .run_switch_i     (run_switch_i),
      .latch_o          (latch),
      .first_o          (first),
      .scan_o           (scan),
      .done_i           (done_i),
      .error_i          (error_i),
      .scanning_o       (scanning),
      .refresh_o        (refresh),
      .refreshing_o     (refreshing),
      .refresh_end_o    (refresh_end),
      .exchange_o       (exchange),
      .give_up_o        (give_up),
      .active_o         (active),
      .fault_o          (fault),
      .safe_o           (safe),
      .idle_o           (idle),
      .core_rst_no      (core_rst_n),
      .restore_o        (restore),
      .counted_o        (counted),
      .clocks_o         (clocks),
      .overrun_o        (overrun),
      .clear_o          (clear),
      .sel_register_i   (sel_register_i),
      .addr_i           (addr_i),
      .read_i           (read_i),
      .write_i          (write_i),
      .wdata_i          (wdata_i),
      .rdata_o          (rdata)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);
  reg was_reset_q;
  always @(posedge clk_i) was_reset_q <= !rst_ni;

  // ---- the table of phases -------------------------------------------------------------------------
  localparam [2:0] EXCHANGE = 3'd0;
  localparam [2:0] WAIT = 3'd1;
  localparam [2:0] LATCH = 3'd2;
  localparam [2:0] SCAN = 3'd3;  // its first clock
  localparam [2:0] SCANNING = 3'd4;
  localparam [2:0] REFRESH = 3'd5;
  reg [2:0] phase_q;
  reg [12:0] gone_q;  // clocks of the phase before this one
  reg whole_q;  // it has begun with exchange_o: not the first one after a reset
  reg of_scan_q;  // the exchange belongs to a scan
  wire [12:0] long = phase_q == LATCH ? {4'd0, latch_count} + 13'd4 :
      phase_q == REFRESH ? {4'd0, refresh_count} + 13'd15 :
      (whole_q ? {1'b0, exchange_points} : 13'd0) + `RUNG_MICRO_EXCHANGE_CLOCKS;
  wire last = gone_q + 13'd1 == long;
  wire phase_ends = phase_q == SCAN || (phase_q == SCANNING ? done_i : phase_q != WAIT && last);
  wire exchange_ends = phase_q == EXCHANGE && phase_ends;
  wire of_scan = phase_q == LATCH || phase_q == SCAN || phase_q == SCANNING ||
      phase_q == REFRESH || (phase_q == EXCHANGE && of_scan_q);

  // Clocks since the last latch's first, which is clock 0.
  reg [32:0] since_q;
  reg since_latch_q;  // there was one

  // ---- commands and states ---------------------------------------------------------------------------
  localparam [1:0] STOPPED = 2'd0;
  localparam [1:0] RUNNING = 2'd1;
  localparam [1:0] ONE = 2'd2;
  localparam [1:0] FAULT = 2'd3;
  wire command = sel_register_i && write_i && addr_i == `RUNG_REG_SCAN_COMMAND;
  wire firmware_fault = sel_register_i && write_i && addr_i == `RUNG_REG_FAULT_SET;
  reg [1:0] state_q;
  reg stop_q;  // STOP while active
  reg ready_q;  // the processor has its length
  wire stop = stop_q || !run_switch_i;
  // The scan is not over in clock W - 1: it would need clock W.
  wire trips = of_scan && watchdog != 32'd0 && since_q + 33'd1 >= {1'b0, watchdog} &&
      !exchange_ends;
  wire faults = trips || firmware_fault;
  wire may = ready_q && !stop && !faults && (state_q == RUNNING || (state_q == ONE && !of_scan));
  wire due = since_q + 33'd1 >= {1'b0, period};
  wire begins = may && (of_scan ? exchange_ends && due : phase_q == WAIT ? due : exchange_ends);

  always @(posedge clk_i) begin
    if (!rst_ni || faults) begin
      phase_q <= EXCHANGE;
      gone_q <= 13'd0;
      whole_q <= rst_ni;
      of_scan_q <= 1'b0;
    end else begin
      gone_q <= gone_q + 13'd1;
      if (begins) begin
        phase_q <= LATCH;
        gone_q  <= 13'd0;
      end else if (phase_q == WAIT) begin
        if (stop) begin
          phase_q <= EXCHANGE;
          gone_q <= 13'd0;
          whole_q <= 1'b1;
          of_scan_q <= 1'b0;
        end
      end else if (exchange_ends) begin
        phase_q <= of_scan_q && state_q == RUNNING && !stop ? WAIT : EXCHANGE;
        gone_q <= 13'd0;
        whole_q <= 1'b1;
        of_scan_q <= 1'b0;
      end else if (phase_ends) begin
        phase_q <= phase_q == REFRESH ? EXCHANGE : phase_q + 3'd1;
        gone_q <= 13'd0;
        whole_q <= 1'b1;
        of_scan_q <= 1'b1;
      end
    end
    since_q <= begins ? 33'd0 : since_q + 33'd1;
    since_latch_q <= rst_ni && (begins || since_latch_q);

    if (!rst_ni) begin
      state_q <= STOPPED;
      stop_q  <= 1'b0;
    end else begin
      stop_q <= active && (stop_q || (command && wdata_i == 16'd2));
      if (faults) state_q <= FAULT;
      else if (state_q == FAULT) begin
        if (command && wdata_i == 16'd5) state_q <= STOPPED;
      end else if (state_q == STOPPED) begin
        if (command && wdata_i == 16'd1 && run_switch_i) state_q <= RUNNING;
        if (command && wdata_i == 16'd3 && run_switch_i) state_q <= ONE;
      end else if (state_q == RUNNING) begin
        if (stop && (exchange_ends || phase_q == WAIT)) state_q <= STOPPED;
      end else if (exchange_ends && (of_scan || stop)) begin
        state_q <= STOPPED;
      end
    end
  end
  // The longest period or watchdog is some minutes; nobody waits longer for a scan without one.
  always @* assume (since_q < 33'h0fffffff0 || !since_latch_q || !(of_scan || phase_q == WAIT));

  // ---- the processor's reset, and its length ----------------------------------------------------------
  reg [3:0] held_q;  // clocks in reset since fault or reset of the controller
  always @(posedge clk_i) begin
    if (!rst_ni || faults || state_q == FAULT) held_q <= 4'd0;
    else if (held_q != 4'd15) held_q <= held_q + 4'd1;
    if (!rst_ni || !core_rst_n) ready_q <= 1'b0;
    else if (restore) ready_q <= 1'b1;
  end

  // ---- what is shown ---------------------------------------------------------------------------------
  always @* begin
    if (begun_q) begin
      // The phases.
      assert (latch == (phase_q == LATCH && gone_q == 13'd0));
      assert (scan == (phase_q == SCAN));
      assert (scanning == (phase_q == SCANNING));
      assert (refresh == (phase_q == REFRESH && gone_q == 13'd0));
      assert (refreshing == (phase_q == REFRESH));
      assert (refresh_end == (phase_q == REFRESH && last));
      assert (exchange == (phase_q == EXCHANGE && gone_q == 13'd0 && whole_q));
      assert (give_up == faults);
      // The states; nothing of a scan goes on outside of running and one scan.
      assert (active == (state_q == RUNNING || state_q == ONE));
      assert (fault == (state_q == FAULT));
      assert (safe == (!active || faults));
      if (of_scan || phase_q == WAIT) assert (active);
      // The watchdog.
      if (of_scan && watchdog != 32'd0) assert (since_q < {1'b0, watchdog});
      // The period: a latch that does not begin a run is at its time, or at once.
      if (begins && since_latch_q && (of_scan || phase_q == WAIT)) begin
        assert (since_q + 33'd1 >= {1'b0, period});
        if (phase_q == WAIT) assert (since_q + 33'd1 == {1'b0, period});
      end
      // Reset of the processor: in fault and for 8 clocks after it, then its length before anything else.
      if (fault) assert (!core_rst_n);
      if (!fault && !core_rst_n) assert (!active || phase_q == EXCHANGE);
      if (of_scan || phase_q == WAIT) assert (core_rst_n);
      assert (core_rst_n == (held_q > 4'd8));
      if (idle) assert (state_q == STOPPED && ready_q && core_rst_n && !of_scan);
      if (state_q == STOPPED && ready_q) assert (idle);
      // Counted once, in the last clock but one, and with the scan's own clocks.
      if (counted) assert (of_scan && phase_q == EXCHANGE && gone_q + 13'd2 == long);
      if (counted && rst_ni) assert (clocks == since_q[31:0] + 32'd2);
    end
  end

  // ---- for the induction -----------------------------------------------------------------------------
  (* hierconn *) wire [2:0] \control.phase_q ;
  (* hierconn *) wire [12:0] \control.left_q ;
  (* hierconn *) wire \control.last_q ;
  (* hierconn *) wire \control.begun_q ;
  (* hierconn *) wire \control.in_scan_q ;
  (* hierconn *) wire \control.due_q ;
  (* hierconn *) wire \control.late_q ;
  (* hierconn *) wire [31:0] \control.since_q ;
  (* hierconn *) wire [1:0] \control.state_q ;
  (* hierconn *) wire \control.stop_asked_q ;
  (* hierconn *) wire [3:0] \control.hold_q ;
  (* hierconn *) wire \control.length_due_q ;
  always @* begin
    if (begun_q) begin
      assert (\control.phase_q == phase_q && phase_q <= REFRESH);
      assert (\control.state_q == state_q);
      assert (\control.stop_asked_q == stop_q);
      assert (\control.in_scan_q == of_scan);
      assert (\control.length_due_q == !ready_q);
      if (phase_q == EXCHANGE || phase_q == LATCH || phase_q == REFRESH) begin
        assert (gone_q < long);
        assert (\control.left_q == long - 13'd1 - gone_q);
        assert (\control.last_q == last);
        assert (\control.begun_q == (gone_q == 13'd0 && (phase_q != EXCHANGE || whole_q)));
      end
      if (of_scan || phase_q == WAIT) begin
        assert (since_latch_q);
        assert (\control.since_q == since_q[31:0] + 32'd2 && !since_q[32]);
        assert (\control.due_q == (since_q != 33'd0 && due));
        assert (\control.late_q == (since_q != 33'd0 && watchdog != 32'd0 &&
                                    since_q + 33'd1 >= {1'b0, watchdog}));
      end
      if (phase_q == WAIT) assert (!since_q[32] && (!due || since_q + 33'd1 == {1'b0, period}));
      if (phase_q == WAIT) assert (state_q == RUNNING);
      if (of_scan && phase_q == LATCH) assert (since_q == {20'd0, gone_q});
      if (of_scan || phase_q == WAIT) assert (ready_q);
      if (ready_q) assert (core_rst_n || state_q == FAULT);
      assert (\control.hold_q <= 4'd8);
      if (held_q < 4'd8 && state_q != FAULT) assert (\control.hold_q == 4'd8 - held_q);
      if (held_q >= 4'd8 && state_q != FAULT) assert (\control.hold_q == 4'd0);
    end
  end

  always @* begin
    cover (begun_q && counted);
    cover (begun_q && fault && since_latch_q && !was_reset_q && state_q == FAULT && held_q == 4'd0);
    cover (begun_q && latch && since_latch_q);
  end

endmodule

`default_nettype wire
