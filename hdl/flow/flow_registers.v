// SPDX-License-Identifier: Apache-2.0
// Counters of flow tasks, and the bus registers that show them and those of the link and the panel (numbers 107 to
// 128 of hdl/isa/flow.toml). Events are pulses; counts are modulo 2^16. clear_i: a program starts: most
// clocks of a round and the ladder's clocks begin anew. A round's clocks are those from the edge that samples
// round_i to the edge that samples round_done_o, the ladder's from ladder_o to ladder_done_i, as a scan's.
// rdata_o is there in the clock after read_i, else 0. The low word of a pair holds the high word for the next read.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"

module flow_registers (
    input  wire         clk_i,
    input  wire         rst_ni,
    input  wire         clear_i,
    // rounds
    input  wire         round_i,
    input  wire         round_done_i,
    input  wire         ladder_i,
    input  wire         ladder_done_i,
    // events, in the order of their registers from flow_pool_full on, but flow_late
    input  wire [  4:0] count_i,
    input  wire         failed_too_i,     // both kinds of failures at once
    input  wire         vanished_i,       // an answer that nobody waited for
    // counters of others
    input  wire [ 15:0] late_i,
    input  wire [127:0] link_i,           // link_upper_bad lowest
    input  wire [ 31:0] panel_i,          // panel_bad lowest
    // bus
    input  wire         sel_register_i,
    input  wire [  7:0] addr_i,
    input  wire         read_i,
    output wire [ 15:0] rdata_o
);

  localparam [7:0] FIRST_LINK = `RUNG_REG_LINK_UPPER_BAD;
  localparam [15:0] MOST = 16'hffff;

  // ---- clocks ------------------------------------------------------------------------------------
  reg [31:0] rounds_q;
  reg [31:0] clocks_q;
  reg [31:0] most_q;
  reg [15:0] ladder_q;
  reg [15:0] ladder_min_q;
  reg [15:0] ladder_max_q;
  reg round_ended_q;
  reg ladder_ended_q;
  reg more_q;

  always @(posedge clk_i) begin
    // Compared in a clock of its own.
    round_ended_q <= rst_ni && round_done_i;
    ladder_ended_q <= rst_ni && ladder_done_i;
    clocks_q <= round_i ? 32'd1 : clocks_q + {31'd0, !round_done_i && !round_ended_q};
    if (ladder_i) ladder_q <= 16'd1;
    else if (ladder_q != MOST && !ladder_done_i && !ladder_ended_q) ladder_q <= ladder_q + 16'd1;
    more_q <= clocks_q > most_q;

    if (!rst_ni) rounds_q <= 32'd0;
    else if (round_ended_q) rounds_q <= rounds_q + 32'd1;
    if (!rst_ni || clear_i) begin
      most_q <= 32'd0;
      ladder_min_q <= MOST;
      ladder_max_q <= 16'd0;
    end else begin
      if (round_ended_q && more_q) most_q <= clocks_q;
      if (ladder_ended_q && ladder_q < ladder_min_q) ladder_min_q <= ladder_q;
      if (ladder_ended_q && ladder_q > ladder_max_q) ladder_max_q <= ladder_q;
    end
  end

  // ---- events -------------------------------------------------------------------------------------
  reg [15:0] full_q, held_q, failed_q, events_q, waits_q, vanished_q;
  always @(posedge clk_i) begin
    full_q <= full_q + {15'd0, count_i[0]};
    held_q <= held_q + {15'd0, count_i[1]};
    failed_q <= failed_q + {15'd0, count_i[2]} + {15'd0, failed_too_i};
    events_q <= events_q + {15'd0, count_i[3]};
    waits_q <= waits_q + {15'd0, count_i[4]};
    vanished_q <= vanished_q + {15'd0, vanished_i};
    if (!rst_ni) {full_q, held_q, failed_q, events_q, waits_q, vanished_q} <= 96'd0;
  end

  // ---- reads -----------------------------------------------------------------------------------------
  reg [15:0] high_q;
  reg [15:0] rdata_q;
  wire read = sel_register_i && read_i;
  wire [2:0] counter = addr_i[2:0] - FIRST_LINK[2:0];

  always @(posedge clk_i) begin
    rdata_q <= 16'd0;
    if (read) begin
      case (addr_i)
        `RUNG_REG_FLOW_ROUNDS_LOW: {high_q, rdata_q} <= rounds_q;
        `RUNG_REG_FLOW_ROUND_MAX_LOW: {high_q, rdata_q} <= most_q;
        `RUNG_REG_FLOW_ROUNDS_HIGH, `RUNG_REG_FLOW_ROUND_MAX_HIGH: rdata_q <= high_q;
        `RUNG_REG_FLOW_LADDER_MIN: rdata_q <= ladder_min_q;
        `RUNG_REG_FLOW_LADDER_MAX: rdata_q <= ladder_max_q;
        `RUNG_REG_FLOW_POOL_FULL: rdata_q <= full_q;
        `RUNG_REG_FLOW_HELD: rdata_q <= held_q;
        `RUNG_REG_FLOW_FAILED: rdata_q <= failed_q;
        `RUNG_REG_FLOW_EVENTS: rdata_q <= events_q;
        `RUNG_REG_FLOW_EVENT_WAITS: rdata_q <= waits_q;
        `RUNG_REG_FLOW_LATE: rdata_q <= late_i + vanished_q;
        `RUNG_REG_LINK_UPPER_BAD, `RUNG_REG_LINK_UPPER_FULL, `RUNG_REG_LINK_UPPER_AGAIN,
        `RUNG_REG_LINK_UPPER_LOST, `RUNG_REG_LINK_LOWER_BAD, `RUNG_REG_LINK_LOWER_FULL,
        `RUNG_REG_LINK_LOWER_AGAIN, `RUNG_REG_LINK_LOWER_LOST: begin
          rdata_q <= link_i[{counter, 4'd0}+:16];
        end
        `RUNG_REG_PANEL_BAD: rdata_q <= panel_i[15:0];
        `RUNG_REG_PANEL_TIMEOUTS: rdata_q <= panel_i[31:16];
        default: ;
      endcase
    end
  end
  assign rdata_o = rdata_q;

endmodule

`default_nettype wire
