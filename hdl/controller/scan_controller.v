// SPDX-License-Identifier: Apache-2.0
// States and phases of a scan (README.md): latch, scan, refresh, exchange, wait; minimum period, watchdog,
// statistics. Each phase is begun by a strobe of one clock and ends when its part says so; a part takes the
// same clocks every time. In the clock of latch_o inputs and time are to be held.
//
// Stopped, exchange phases follow one another. A command is one clock with command_i: 1 run, 2 stop after the
// scan under way, 3 one scan, 4 clear statistics, 5 leave the fault.
`default_nettype none

module scan_controller (
    input  wire        clk_i,
    input  wire        rst_ni,
    // from the firmware
    input  wire        command_i,
    input  wire [ 2:0] command_number_i,
    input  wire        first_i,            // the next scan is a first scan
    input  wire        fault_set_i,
    // settings, constant while running
    input  wire [31:0] period_i,           // clocks from latch to latch, 0: free running
    input  wire [31:0] watchdog_i,         // most clocks of a scan, 0: any
    input  wire        run_switch_i,       // synchronous, debounced
    // phases
    output wire        latch_o,
    input  wire        latch_done_i,
    output wire        scan_o,
    input  wire        scan_done_i,
    output wire        refresh_o,
    input  wire        refresh_done_i,
    output wire        exchange_o,
    input  wire        exchange_done_i,
    // state
    output wire        running_o,          // running or one scan: outputs are the program's
    output wire        idle_o,             // stopped, and no scan under way
    output wire        fault_o,
    output wire [ 7:0] fault_number_o,     // 1 watchdog, 2 set by the firmware
    output wire [ 1:0] state_o,            // 0 stopped, 1 running, 2 one scan, 3 fault
    output wire        next_first_o,       // the next scan is a first scan
    output wire        first_o,            // the scan under way is
    // statistics
    output wire [31:0] scans_o,
    output wire [31:0] last_o,
    output wire [31:0] min_o,
    output wire [31:0] max_o,
    output wire [15:0] overruns_o
);

  localparam [2:0] COMMAND_RUN = 3'd1;
  localparam [2:0] COMMAND_STOP = 3'd2;
  localparam [2:0] COMMAND_ONE = 3'd3;
  localparam [2:0] COMMAND_CLEAR = 3'd4;
  localparam [2:0] COMMAND_LEAVE = 3'd5;

  localparam [2:0] STOPPED = 3'd0;
  localparam [2:0] LATCH = 3'd1;
  localparam [2:0] SCAN = 3'd2;
  localparam [2:0] REFRESH = 3'd3;
  localparam [2:0] EXCHANGE = 3'd4;
  localparam [2:0] WAIT = 3'd5;
  localparam [2:0] FAULT = 3'd6;

  reg [2:0] phase_q;
  reg run_q;  // go on after this scan
  reg one_q;  // one scan is asked for, or under way
  reg exchange_q;  // stopped: an exchange phase is under way
  reg first_q;
  reg this_first_q;
  reg [7:0] fault_number_q;
  reg latch_q, scan_q, refresh_q, exchange_start_q;

  wire stop = (command_i && command_number_i == COMMAND_STOP) || !run_switch_i;
  wire in_scan = phase_q == LATCH || phase_q == SCAN || phase_q == REFRESH || phase_q == EXCHANGE;

  // ---- period and watchdog: clocks since the clock of latch_o ---------------------------------------
  reg [31:0] clocks_q;
  reg in_time_q;  // the next latch can still be a period after the last one
  reg due_q;
  reg trip_q;
  wire free = period_i == 32'd0;
  wire begin_scan = phase_q == STOPPED ? !exchange_q && (run_q || one_q) :
      phase_q == WAIT && run_q && !stop && (free || due_q || !in_time_q);

  always @(posedge clk_i) begin
    clocks_q <= begin_scan ? 32'd0 : clocks_q + 32'd1;
    // latch_o is a register behind begin_scan, and due_q one before it.
    due_q <= !begin_scan && clocks_q + 32'd3 == period_i;
    if (begin_scan) in_time_q <= 1'b1;
    else if (due_q && phase_q != WAIT) in_time_q <= 1'b0;
    trip_q <= in_scan && watchdog_i != 32'd0 && clocks_q >= watchdog_i;
  end

  // ---- phases ------------------------------------------------------------------------------------
  always @(posedge clk_i) begin
    latch_q <= 1'b0;
    scan_q <= 1'b0;
    refresh_q <= 1'b0;
    exchange_start_q <= 1'b0;
    if (!rst_ni) begin
      phase_q <= STOPPED;
      run_q <= 1'b0;
      one_q <= 1'b0;
      exchange_q <= 1'b0;
      fault_number_q <= 8'd0;
      first_q <= 1'b1;
      this_first_q <= 1'b0;
    end else begin
      if (first_i) first_q <= 1'b1;
      if (stop) run_q <= 1'b0;
      else if (command_i && command_number_i == COMMAND_RUN && phase_q != FAULT) run_q <= 1'b1;
      if (command_i && command_number_i == COMMAND_ONE && idle_o && !run_q) one_q <= 1'b1;

      case (phase_q)
        STOPPED: begin
          if (begin_scan) begin
            phase_q <= LATCH;
            latch_q <= 1'b1;
          end else if (exchange_q) begin
            if (exchange_done_i) exchange_q <= 1'b0;
          end else begin
            exchange_q <= 1'b1;
            exchange_start_q <= 1'b1;
          end
        end
        LATCH: begin
          if (latch_q) begin
            this_first_q <= first_q;
            first_q <= 1'b0;
          end
          if (latch_done_i) begin
            phase_q <= SCAN;
            scan_q <= 1'b1;
          end
        end
        SCAN: begin
          if (scan_done_i) begin
            phase_q <= REFRESH;
            refresh_q <= 1'b1;
          end
        end
        REFRESH: begin
          if (refresh_done_i) begin
            phase_q <= EXCHANGE;
            exchange_start_q <= 1'b1;
          end
        end
        EXCHANGE: begin
          if (exchange_done_i) phase_q <= WAIT;
        end
        WAIT: begin
          one_q <= 1'b0;
          if (begin_scan) begin
            phase_q <= LATCH;
            latch_q <= 1'b1;
          end else if (!run_q || stop) begin
            phase_q <= STOPPED;
          end
        end
        default: begin
          if (command_i && command_number_i == COMMAND_LEAVE) begin
            phase_q <= STOPPED;
            fault_number_q <= 8'd0;
          end
        end
      endcase

      if ((trip_q && in_scan) || fault_set_i) begin
        phase_q <= FAULT;
        fault_number_q <= fault_set_i ? 8'd2 : 8'd1;
        run_q <= 1'b0;
        one_q <= 1'b0;
        exchange_q <= 1'b0;
        latch_q <= 1'b0;
        scan_q <= 1'b0;
        refresh_q <= 1'b0;
        exchange_start_q <= 1'b0;
      end
    end
  end

  assign latch_o = latch_q;
  assign scan_o = scan_q;
  assign refresh_o = refresh_q;
  assign exchange_o = exchange_start_q;
  assign fault_o = phase_q == FAULT;
  assign fault_number_o = fault_number_q;
  assign running_o = phase_q != STOPPED && phase_q != FAULT;
  assign idle_o = phase_q == STOPPED && !run_q && !one_q;
  assign state_o = fault_o ? 2'd3 : one_q ? 2'd2 : run_q || running_o ? 2'd1 : 2'd0;
  assign next_first_o = first_q;
  assign first_o = latch_q ? first_q : this_first_q;

  // ---- statistics --------------------------------------------------------------------------------
  reg measure_q;  // a scan's last clock has been counted
  reg [31:0] scans_q, last_q, min_q, max_q;
  reg [15:0] overruns_q;
  reg lower_q, higher_q, compared_q;
  wire clear = command_i && command_number_i == COMMAND_CLEAR;
  wire overrun = begin_scan && phase_q == WAIT && !free && !in_time_q;

  always @(posedge clk_i) begin
    measure_q <= phase_q == EXCHANGE && exchange_done_i;
    // clocks_q is 0 in the clock of latch_o, so here it is how many clocks lie before this one.
    if (phase_q == EXCHANGE && exchange_done_i) last_q <= clocks_q + 32'd1;
    compared_q <= measure_q;
    lower_q  <= last_q < min_q;
    higher_q <= last_q > max_q;
    if (!rst_ni) begin
      scans_q <= 32'd0;
      min_q <= 32'hffffffff;
      max_q <= 32'd0;
      overruns_q <= 16'd0;
      last_q <= 32'd0;
    end else begin
      if (measure_q) scans_q <= scans_q + 32'd1;
      if (clear) begin
        min_q <= 32'hffffffff;
        max_q <= 32'd0;
        overruns_q <= 16'd0;
      end else begin
        if (compared_q && lower_q) min_q <= last_q;
        if (compared_q && higher_q) max_q <= last_q;
        if (overrun && overruns_q != 16'hffff) overruns_q <= overruns_q + 16'd1;
      end
    end
  end

  assign scans_o = scans_q;
  assign last_o = last_q;
  assign min_o = min_q;
  assign max_o = max_q;
  assign overruns_o = overruns_q;

endmodule

`default_nettype wire
