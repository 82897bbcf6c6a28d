// SPDX-License-Identifier: Apache-2.0
// Counters of flow tasks (hdl/flow/flow_registers.v), any one event's: each event is counted once, higher ones first; rounds, most
// clocks of a round, least and most of the ladder are those between the edges of their pulses, a program's start begins them anew;
// each register shows its own, a pair of words one value, and nobody else's register shows anything.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"

module flow_registers_proof (
    input wire         clk_i,
    input wire         rst_ni,
    input wire         clear_i,
    input wire         round_i,
    input wire         round_done_i,
    input wire         ladder_i,
    input wire [  5:0] count_i,
    input wire [ 15:0] late_i,
    input wire [127:0] link_i,
    input wire [ 31:0] panel_i,
    input wire         sel_register_i,
    input wire [  7:0] addr_i,
    input wire         read_i,
    // inside of it
    input wire [127:0] peek_counts,
    input wire [  3:0] peek_clearing,
    input wire [  5:0] peek_due,
    input wire         peek_count_valid,
    input wire         peek_clear,
    input wire [  2:0] peek_count_addr,
    input wire [ 31:0] peek_rounds,
    input wire [ 31:0] peek_clocks,
    input wire [ 31:0] peek_most,
    input wire [ 15:0] peek_ladder,
    input wire [ 15:0] peek_ladder_min,
    input wire [ 15:0] peek_ladder_max,
    input wire         peek_round_ended,
    input wire         peek_ladder_ended,
    input wire         peek_more,
    input wire [ 15:0] peek_high
);

  // The ladder's end is the round's (flow_round.v).
  wire [15:0] rdata;
  flow_registers registers (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .clear_i       (clear_i),
      .round_i       (round_i),
      .round_done_i  (round_done_i),
      .ladder_i      (ladder_i),
      .ladder_done_i (round_done_i),
      .count_i       (count_i),
      .late_i        (late_i),
      .link_i        (link_i),
      .panel_i       (panel_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .rdata_o       (rdata)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- events: any one of them; none comes again before it is counted --------------------------------------
  (* anyconst *) wire [2:0] watched;
  wire comes = count_i[watched];
  reg [15:0] events_q;
  reg [3:0] cold_q;  // clocks until the counters can be read after a reset
  wire higher = (peek_due >> watched) > 6'd1;
  wire waits = peek_due[watched];
  wire served = waits && !higher && peek_clearing == 4'd0;
  always @* begin
    assume (watched <= 3'd5);
    assume (!(comes && waits && !served));
  end
  always @(posedge clk_i) begin
    if (!rst_ni) cold_q <= 4'd9;
    else if (cold_q != 4'd0) cold_q <= cold_q - 4'd1;
    if (!rst_ni) events_q <= 16'd0;
    else if (comes) events_q <= events_q + 16'd1;
  end
  wire counting = peek_count_valid && !peek_clear && peek_count_addr == watched;
  wire [15:0] counted = events_q - {15'd0, waits} - {15'd0, counting};

  // ---- rounds --------------------------------------------------------------------------------------------
  reg in_round_q, in_ladder_q, ended_q;
  reg [31:0] rounds_q, round_q, last_round_q, most_q;
  reg [15:0] ladder_q, last_ladder_q, least_q, longest_q;
  always @* begin
    // A round that is given up has no end; another one may begin at any time, but not with an end.
    assume (!(round_done_i && (round_i || ladder_i || clear_i || !in_round_q || !in_ladder_q)));
    assume (!(ladder_i && !in_round_q));
  end
  always @(posedge clk_i) begin
    if (!rst_ni || round_done_i) in_round_q <= 1'b0;
    else if (round_i) in_round_q <= 1'b1;
    if (!rst_ni || round_done_i || round_i) in_ladder_q <= 1'b0;
    else if (ladder_i) in_ladder_q <= 1'b1;
    round_q  <= round_i ? 32'd1 : round_q + 32'd1;
    ladder_q <= ladder_i ? 16'd1 : ladder_q + {15'd0, ladder_q != 16'hffff};
    ended_q  <= round_done_i && rst_ni;
    if (round_done_i) {last_round_q, last_ladder_q} <= {round_q, ladder_q};
    if (!rst_ni) rounds_q <= 32'd0;
    else if (ended_q) rounds_q <= rounds_q + 32'd1;
    if (!rst_ni || clear_i) begin
      {most_q, least_q, longest_q} <= {32'd0, 16'hffff, 16'd0};
    end else if (ended_q) begin
      if (last_round_q > most_q) most_q <= last_round_q;
      if (last_ladder_q < least_q) least_q <= last_ladder_q;
      if (last_ladder_q > longest_q) longest_q <= last_ladder_q;
    end
  end

  // ---- reads -----------------------------------------------------------------------------------------------
  reg [15:0] high_q;  // of the pair whose low word was read last
  reg [1:0] pair_q;
  reg known_q;  // what the read has to give
  reg [15:0] due_q;
  wire read = read_i && sel_register_i;
  always @(posedge clk_i) begin
    if (!begun_q) pair_q <= 2'd0;
    else if (read && addr_i == `RUNG_REG_FLOW_ROUNDS_LOW) pair_q <= 2'd1;
    else if (read && addr_i == `RUNG_REG_FLOW_ROUND_MAX_LOW) pair_q <= 2'd2;
    if (read && addr_i == `RUNG_REG_FLOW_ROUNDS_LOW) high_q <= rounds_q[31:16];
    if (read && addr_i == `RUNG_REG_FLOW_ROUND_MAX_LOW) high_q <= most_q[31:16];
    known_q <= 1'b1;
    due_q   <= 16'd0;
    if (read) begin
      case (addr_i)
        `RUNG_REG_FLOW_POOL_FULL: {known_q, due_q} <= {watched == 3'd0 && cold_q == 4'd0, counted};
        `RUNG_REG_FLOW_HELD: {known_q, due_q} <= {watched == 3'd1 && cold_q == 4'd0, counted};
        `RUNG_REG_FLOW_FAILED: {known_q, due_q} <= {watched == 3'd2 && cold_q == 4'd0, counted};
        `RUNG_REG_FLOW_EVENTS: {known_q, due_q} <= {watched == 3'd3 && cold_q == 4'd0, counted};
        `RUNG_REG_FLOW_EVENT_WAITS:
        {known_q, due_q} <= {watched == 3'd4 && cold_q == 4'd0, counted};
        `RUNG_REG_FLOW_LATE: begin
          {known_q, due_q} <= {watched == 3'd5 && cold_q == 4'd0, counted + late_i};
        end
        `RUNG_REG_FLOW_ROUNDS_LOW: due_q <= rounds_q[15:0];
        `RUNG_REG_FLOW_ROUNDS_HIGH: {known_q, due_q} <= {pair_q == 2'd1, high_q};
        `RUNG_REG_FLOW_ROUND_MAX_LOW: due_q <= most_q[15:0];
        `RUNG_REG_FLOW_ROUND_MAX_HIGH: {known_q, due_q} <= {pair_q == 2'd2, high_q};
        `RUNG_REG_FLOW_LADDER_MIN: due_q <= least_q;
        `RUNG_REG_FLOW_LADDER_MAX: due_q <= longest_q;
        `RUNG_REG_LINK_UPPER_BAD: due_q <= link_i[15:0];
        `RUNG_REG_LINK_UPPER_FULL: due_q <= link_i[31:16];
        `RUNG_REG_LINK_UPPER_AGAIN: due_q <= link_i[47:32];
        `RUNG_REG_LINK_UPPER_LOST: due_q <= link_i[63:48];
        `RUNG_REG_LINK_LOWER_BAD: due_q <= link_i[79:64];
        `RUNG_REG_LINK_LOWER_FULL: due_q <= link_i[95:80];
        `RUNG_REG_LINK_LOWER_AGAIN: due_q <= link_i[111:96];
        `RUNG_REG_LINK_LOWER_LOST: due_q <= link_i[127:112];
        `RUNG_REG_PANEL_BAD: due_q <= panel_i[15:0];
        `RUNG_REG_PANEL_TIMEOUTS: due_q <= panel_i[31:16];
        default: ;
      endcase
    end
    if (!begun_q) known_q <= 1'b0;
  end
  reg served_q, again_q;
  always @(posedge clk_i) {served_q, again_q} <= {served && rst_ni && begun_q, comes};
  always @* begin
    if (begun_q) begin
      if (known_q) assert (rdata == due_q);
      // Nobody waits but for those before him.
      if (served_q && !again_q) assert (!waits);
    end
  end

  // ---- for the induction --------------------------------------------------------------------------------------
  wire [3:0] turn = watched == 3'd0 ? 4'd8 : {1'b0, watched};  // the clearing that is its own
  always @* begin
    if (begun_q) begin
      assert (peek_clearing <= 4'd8 && cold_q <= 4'd9);
      if (cold_q != 4'd0) assert (peek_clearing == cold_q - 4'd1);
      else assert (peek_clearing == 4'd0);
      if (peek_clearing != 4'd8) assert (peek_clear == (cold_q != 4'd0));
      if (peek_clear && peek_clearing != 4'd8) begin
        assert (peek_count_valid && peek_count_addr == peek_clearing[2:0] + 3'd1);
      end
      if (cold_q == 4'd0 || turn > peek_clearing + 4'd1) begin
        assert (peek_counts[16*watched+:16] == counted);
      end else begin
        assert (events_q == {15'd0, waits});
      end
      if (in_round_q) assert (peek_clocks == round_q);
      if (in_ladder_q) assert (peek_ladder == ladder_q);
      assert (!in_ladder_q || in_round_q);
      assert (peek_round_ended == ended_q && peek_ladder_ended == ended_q);
      if (ended_q) begin
        assert (peek_clocks == last_round_q && peek_ladder == last_ladder_q);
        assert (peek_more == (last_round_q > most_q) && !in_round_q);
      end
      assert (peek_rounds == rounds_q && peek_most == most_q);
      assert (peek_ladder_min == least_q && peek_ladder_max == longest_q);
      if (pair_q != 2'd0) assert (peek_high == high_q);
    end
  end

  always @* begin
    cover (begun_q && known_q && rdata == 16'd2 && cold_q == 4'd0 && watched == 3'd0 &&
        events_q == 16'd2);
    cover (begun_q && rounds_q == 32'd2 && most_q == 32'd4 && least_q == 16'd1 &&
        longest_q == 16'd3);
  end

endmodule

`default_nettype wire
