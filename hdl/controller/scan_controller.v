// SPDX-License-Identifier: Apache-2.0
// States and phases of scans: registers scan_command to fault_set of hdl/isa/controller.toml but those of
// scan_statistics.v. Clocks of the phases:
//   latch     latch_count + 4       latch_o in the first
//   scan      n + 33 for a program with device ports, n + 4 without, n being the processor's own clocks;
//             scan_o in the first
//   refresh   refresh_count + 15    refresh_o in the first, refresh_end_o in the last
//   exchange  exchange_points + exchange_clocks    exchange_o in the first
//   wait      up to the minimum period
// While no program runs, exchange phases follow each other. A latch's first clock is t: with a period P the
// next one's is t + P, or the clock after the exchange if that is later. Does a scan still need clock t + W,
// W being the watchdog, then the state is fault in that clock.
// In fault, and for 8 clocks after it and after a reset, core_rst_no holds the processor and its device ports;
// restore_o then gives the processor its program's length back before anything else.
// Bus: select, address and data in the clock of read_i or write_i; rdata_o in the clock after read_i, else 0.
`default_nettype none
`include "rung_controller.vh"

module scan_controller (
    input  wire        clk_i,
    input  wire        rst_ni,
    // setup
    input  wire [ 8:0] latch_count_i,
    input  wire [ 8:0] refresh_count_i,
    input  wire [11:0] exchange_points_i,
    input  wire [31:0] period_i,
    input  wire [31:0] watchdog_i,
    input  wire        run_switch_i,
    // phases
    output wire        latch_o,
    output wire        first_o,            // with latch_o: it is a first scan's
    output wire        scan_o,
    input  wire        done_i,
    input  wire        error_i,
    output wire        scanning_o,
    output wire        refresh_o,
    output wire        refreshing_o,
    output wire        refresh_end_o,
    output wire        exchange_o,
    output wire        give_up_o,          // the phase under way ends here: fault
    // states
    output wire        active_o,           // running, or one scan
    output wire        fault_o,
    output wire        safe_o,             // outputs have to be safe from the next clock on
    output wire        idle_o,             // spaces 0 to 5 may be written
    output wire        core_rst_no,
    output wire        restore_o,
    // statistics
    output wire        counted_o,
    output wire [31:0] clocks_o,
    output wire        overrun_o,
    output wire        clear_o,
    // bus
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o
);

  localparam [7:0] COMMAND = `RUNG_REG_SCAN_COMMAND;
  localparam [7:0] STATUS = `RUNG_REG_SCAN_STATUS;
  localparam [7:0] FIRST = `RUNG_REG_SCAN_FIRST;
  localparam [7:0] FAULT_SET = `RUNG_REG_FAULT_SET;
  localparam [15:0] COMMAND_RUN = 16'd1;
  localparam [15:0] COMMAND_STOP = 16'd2;
  localparam [15:0] COMMAND_ONE = 16'd3;
  localparam [15:0] COMMAND_CLEAR = 16'd4;
  localparam [15:0] COMMAND_LEAVE = 16'd5;

  localparam [1:0] STOPPED = 2'd0;
  localparam [1:0] RUNNING = 2'd1;
  localparam [1:0] ONE = 2'd2;
  localparam [1:0] FAULT = 2'd3;
  localparam [1:0] FAULT_NONE = 2'd0;
  localparam [1:0] FAULT_WATCHDOG = 2'd1;
  localparam [1:0] FAULT_FIRMWARE = 2'd2;

  localparam [2:0] EXCHANGE = 3'd0;
  localparam [2:0] WAIT = 3'd1;
  localparam [2:0] LATCH = 3'd2;
  localparam [2:0] SCAN = 3'd3;
  localparam [2:0] SCANNING = 3'd4;
  localparam [2:0] REFRESH = 3'd5;

  // Clocks of a phase beyond its entries or points, less 1.
  localparam [12:0] LATCH_CLOCKS = 13'd3;
  localparam [12:0] REFRESH_CLOCKS = 13'd14;
  localparam [12:0] EXCHANGE_CLOCKS = `RUNG_MICRO_EXCHANGE_CLOCKS - 1;
  localparam [3:0] HOLD_CLOCKS = 4'd8;

  // ---- commands --------------------------------------------------------------------------------
  wire register_write = sel_register_i && write_i;
  wire command = register_write && addr_i == COMMAND;
  wire fault_set = register_write && addr_i == FAULT_SET;

  reg [1:0] state_q;
  reg [1:0] fault_q;
  reg stop_asked_q;
  reg first_q;
  reg error_q;
  wire stop = stop_asked_q || !run_switch_i;

  // ---- the course of a scan --------------------------------------------------------------------
  reg [2:0] phase_q;
  reg [12:0] left_q;  // clocks of the phase behind this one
  reg last_q;  // there are none
  reg begun_q;  // first clock of a phase
  reg in_scan_q;  // latch to exchange of a scan; not what goes on while stopped
  reg due_q;  // the minimum period has passed, if the next latch begins in the next clock
  reg due_before_q;
  reg late_q;  // a clock more is one too much for the watchdog
  reg length_due_q;  // the processor's length is lost

  wire exchange_end = phase_q == EXCHANGE && last_q;
  wire scan_end = exchange_end && in_scan_q;
  wire trip = late_q && in_scan_q && !scan_end;
  wire fault = trip || fault_set;
  wire may_begin = !stop && !length_due_q && (state_q == RUNNING || (state_q == ONE && !in_scan_q));
  wire begin_scan = !fault && may_begin &&
      ((exchange_end && (due_q || !in_scan_q)) || (phase_q == WAIT && due_q));
  wire wait_next = scan_end && state_q == RUNNING && !stop;
  reg [2:0] next_phase;
  reg enter;  // a phase begins in the next clock

  always @* begin
    next_phase = phase_q;
    enter = 1'b1;
    if (fault) begin
      next_phase = EXCHANGE;
    end else if (begin_scan) begin
      next_phase = LATCH;
    end else begin
      case (phase_q)
        EXCHANGE: begin
          enter = last_q;
          if (last_q && wait_next) next_phase = WAIT;
        end
        WAIT: begin
          enter = stop;
          if (stop) next_phase = EXCHANGE;
        end
        LATCH: begin
          enter = last_q;
          if (last_q) next_phase = SCAN;
        end
        SCAN: next_phase = SCANNING;
        SCANNING: begin
          enter = done_i;
          if (done_i) next_phase = REFRESH;
        end
        default: begin
          enter = last_q;
          if (last_q) next_phase = EXCHANGE;
        end
      endcase
    end
  end

  wire [12:0] entries = next_phase == LATCH ? {4'd0, latch_count_i} :
      next_phase == REFRESH ? {4'd0, refresh_count_i} : {1'b0, exchange_points_i};
  wire [12:0] beyond = next_phase == LATCH ? LATCH_CLOCKS :
      next_phase == REFRESH ? REFRESH_CLOCKS : EXCHANGE_CLOCKS;
  wire next_last = left_q == 13'd1;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      phase_q <= EXCHANGE;
      left_q <= EXCHANGE_CLOCKS;
      last_q <= 1'b0;
      begun_q <= 1'b0;
      in_scan_q <= 1'b0;
    end else begin
      phase_q <= next_phase;
      begun_q <= enter;
      left_q  <= enter ? entries + beyond : left_q - 13'd1;
      last_q  <= !enter && next_last;
      if (begin_scan) in_scan_q <= 1'b1;
      else if (scan_end || fault) in_scan_q <= 1'b0;
    end
  end

  assign latch_o = phase_q == LATCH && begun_q;
  assign first_o = first_q;
  assign scan_o = phase_q == SCAN;
  assign scanning_o = phase_q == SCANNING;
  assign refresh_o = phase_q == REFRESH && begun_q;
  assign refreshing_o = phase_q == REFRESH;
  assign refresh_end_o = phase_q == REFRESH && last_q;
  assign exchange_o = phase_q == EXCHANGE && begun_q;
  assign give_up_o = fault;

  // ---- clocks of a scan: 2 in its first, so that compares have a clock for themselves -----------
  reg [31:0] since_q;

  always @(posedge clk_i) begin
    since_q <= begin_scan ? 32'd2 : since_q + 32'd1;
    due_q <= !begin_scan && since_q >= period_i;
    due_before_q <= !begin_scan && due_q;
    late_q <= rst_ni && !begin_scan && since_q >= watchdog_i && watchdog_i != 32'd0;
  end

  assign clocks_o  = since_q;
  assign counted_o = phase_q == EXCHANGE && in_scan_q && next_last && !fault;
  assign overrun_o = begin_scan && in_scan_q && due_before_q && period_i != 32'd0;
  assign clear_o   = command && wdata_i == COMMAND_CLEAR;

  // ---- states ----------------------------------------------------------------------------------
  reg [3:0] hold_q;
  reg core_rst_nq;
  wire restore = exchange_end && length_due_q && core_rst_nq;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= STOPPED;
      fault_q <= FAULT_NONE;
      stop_asked_q <= 1'b0;
      hold_q <= HOLD_CLOCKS;
      core_rst_nq <= 1'b0;
      length_due_q <= 1'b1;
      first_q <= 1'b1;
      error_q <= 1'b0;
    end else begin
      if (fault) begin
        state_q <= FAULT;
        // The first fault is the one that is shown.
        if (state_q != FAULT) fault_q <= fault_set ? FAULT_FIRMWARE : FAULT_WATCHDOG;
      end else begin
        case (state_q)
          STOPPED: begin
            if (command && wdata_i == COMMAND_RUN && run_switch_i) state_q <= RUNNING;
            if (command && wdata_i == COMMAND_ONE && run_switch_i) state_q <= ONE;
          end
          RUNNING: if (stop && (exchange_end || phase_q == WAIT)) state_q <= STOPPED;
          ONE: if (exchange_end && (in_scan_q || stop)) state_q <= STOPPED;
          default: begin
            if (command && wdata_i == COMMAND_LEAVE) begin
              state_q <= STOPPED;
              fault_q <= FAULT_NONE;
            end
          end
        endcase
      end

      if (state_q == STOPPED || state_q == FAULT) stop_asked_q <= 1'b0;
      else if (command && wdata_i == COMMAND_STOP) stop_asked_q <= 1'b1;

      if (state_q == FAULT) hold_q <= HOLD_CLOCKS;
      else if (hold_q != 4'd0) hold_q <= hold_q - 4'd1;
      core_rst_nq <= state_q != FAULT && !fault && hold_q == 4'd0;
      if (!core_rst_nq) length_due_q <= 1'b1;
      else if (restore) length_due_q <= 1'b0;

      if (register_write && addr_i == FIRST) first_q <= 1'b1;
      else if (latch_o) first_q <= 1'b0;
      if (phase_q == SCANNING && done_i) error_q <= error_i;
    end
  end

  assign active_o = state_q == RUNNING || state_q == ONE;
  assign fault_o = state_q == FAULT;
  assign safe_o = !active_o || fault;
  assign idle_o = state_q == STOPPED && !length_due_q;
  assign core_rst_no = core_rst_nq;
  assign restore_o = restore;

  // ---- reads -----------------------------------------------------------------------------------
  reg [15:0] rdata_q;

  always @(posedge clk_i) begin
    rdata_q <= 16'd0;
    if (sel_register_i && read_i && addr_i == STATUS) begin
      rdata_q <= {6'd0, fault_q, 2'd0, error_q, first_q, run_switch_i, idle_o, state_q};
    end
  end

  assign rdata_o = rdata_q;

endmodule

`default_nettype wire
