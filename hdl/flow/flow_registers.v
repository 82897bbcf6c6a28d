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
    // events: flow_pool_full, flow_held and on to flow_late, lowest first
    input  wire [  5:0] count_i,
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

  localparam [7:0] FIRST = `RUNG_REG_FLOW_POOL_FULL;
  localparam [7:0] HELD = `RUNG_REG_FLOW_HELD;
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

  // ---- events: counts in a memory, one of them a clock; none comes again before it is counted ---------------
  localparam [3:0] LAST_COUNT = 4'd7;
  (* ram_style = "distributed" *) reg [15:0] counts[0:7];
  reg [3:0] clearing_q;  // after reset, the counts become 0
  reg [5:0] due_q;
  reg [2:0] which;
  integer i, j;

  always @* begin
    which = 3'd0;
    for (j = 0; j < 6; j = j + 1) if (due_q[j]) which = j[2:0];
  end

  wire clearing = clearing_q != 4'd0;
  reg count_valid_q;
  reg clear_q;
  reg [2:0] count_addr_q;
  wire [15:0] count = counts[count_addr_q];

  always @(posedge clk_i) begin
    count_valid_q <= clearing || due_q != 6'd0;
    clear_q <= clearing;
    count_addr_q <= clearing ? clearing_q[2:0] : which;
    if (count_valid_q) counts[count_addr_q] <= clear_q ? 16'd0 : count + 16'd1;
    if (!rst_ni) begin
      due_q <= 6'd0;
      clearing_q <= LAST_COUNT + 4'd1;
    end else begin
      for (i = 0; i < 6; i = i + 1) begin
        due_q[i] <= count_i[i] || (due_q[i] && (clearing || which != i[2:0]));
      end
      if (clearing) clearing_q <= clearing_q - 4'd1;
    end
  end

  // ---- reads -----------------------------------------------------------------------------------------
  reg [15:0] high_q;
  reg [15:0] rdata_q;
  wire read = sel_register_i && read_i;
  wire [7:0] number = addr_i - FIRST;
  // Behind flow_pool_full's counter are those from flow_held on.
  wire [2:0] counted = addr_i == FIRST ? 3'd0 : addr_i[2:0] - HELD[2:0] + 3'd1;
  wire [15:0] counter = counts[counted];
  wire [32*16-1:0] all = {
    {10 * 16{1'b0}},
    panel_i,
    link_i,
    counter + late_i,
    {4{counter}},
    ladder_max_q,
    ladder_min_q,
    high_q,
    most_q[15:0],
    high_q,
    rounds_q[15:0],
    counter
  };

  always @(posedge clk_i) begin
    rdata_q <= all[{number[4:0], 4'd0}+:16] & {16{read && number[7:5] == 3'd0}};
    if (read && addr_i == `RUNG_REG_FLOW_ROUNDS_LOW) high_q <= rounds_q[31:16];
    if (read && addr_i == `RUNG_REG_FLOW_ROUND_MAX_LOW) high_q <= most_q[31:16];
  end
  assign rdata_o = rdata_q;

endmodule

`default_nettype wire
