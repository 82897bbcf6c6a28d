// SPDX-License-Identifier: Apache-2.0
// The course of a round (hdl/flow/flow_round.v): beginning, commands, turns, ladder, in this order and each once in a round, none
// twice or out of turn, whatever each of them takes; nothing goes on when the round has been given up; and without flows a
// round is the ladder's scan, in the same clocks.
`default_nettype none

module flow_round_proof (
    input wire clk_i,
    input wire rst_ni,
    input wire give_up_i,
    input wire round_i,
    input wire walking_i,
    input wire busy_i,
    input wire commands_done_i,
    input wire steps_done_i,
    input wire ladder_done_i
);

  (* anyconst *) wire flows;
  wire done, begins, commands, steps, of_steps, ladder, flow_ladder, flow_done;
  flow_round round (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .flows_i        (flows),
      .give_up_i      (give_up_i),
      .round_i        (round_i),
      .round_done_o   (done),
      .walking_i      (walking_i),
      .busy_i         (busy_i),
      .begin_o        (begins),
      .commands_o     (commands),
      .commands_done_i(commands_done_i),
      .steps_o        (steps),
      .steps_done_i   (steps_done_i),
      .of_steps_o     (of_steps),
      .ladder_o       (ladder),
      .ladder_done_i  (ladder_done_i),
      .flow_ladder_o  (flow_ladder),
      .flow_done_o    (flow_done)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // How far a round has come: 0 no round, 1 waits for the tasks' start, 2 commands, 3 turns, 4 ladder.
  reg [2:0] stage_q;
  reg commands_due_q;  // its pulse comes in this clock
  reg steps_due_q;
  reg ladder_due_q;
  wire stops = !rst_ni || give_up_i;
  // A round is asked for when none is under way; a phase ends when it has begun.
  always @* begin
    assume (!round_i || stage_q == 3'd0);
    assume (!commands_done_i || (stage_q == 3'd2 && !commands_due_q));
    assume (!steps_done_i || (stage_q == 3'd3 && !steps_due_q));
    if (flows) assume (!ladder_done_i || (stage_q == 3'd4 && !ladder_due_q));
  end
  always @(posedge clk_i) begin
    {commands_due_q, steps_due_q, ladder_due_q} <= 3'b000;
    if (stops || !flows) stage_q <= 3'd0;
    else begin
      case (stage_q)
        3'd0: if (round_i) stage_q <= 3'd1;
        3'd1: if (!walking_i && !busy_i) {stage_q, commands_due_q} <= {3'd2, 1'b1};
        3'd2: if (commands_done_i) {stage_q, steps_due_q} <= {3'd3, 1'b1};
        3'd3: if (steps_done_i) {stage_q, ladder_due_q} <= {3'd4, 1'b1};
        default: if (ladder_done_i) stage_q <= 3'd0;
      endcase
    end
  end

  always @* begin
    if (begun_q && flows) begin
      assert (begins == (stage_q == 3'd1 && !walking_i && !busy_i));
      assert (commands == commands_due_q && steps == steps_due_q && ladder == ladder_due_q);
      assert (of_steps == (stage_q == 3'd3));
      assert (done == (stage_q == 3'd4 && !ladder_due_q && ladder_done_i));
    end
    if (!flows) begin
      assert (ladder == round_i && done == ladder_done_i);
      if (begun_q) assert (!begins && !commands && !steps && !of_steps);
    end
  end

  // For the induction.
  (* hierconn *) wire [2:0] \round.state_q ;
  always @* begin
    if (begun_q) begin
      case (stage_q)
        3'd0, 3'd1, 3'd2, 3'd3: assert (\round.state_q == stage_q);
        3'd4: assert (\round.state_q == (ladder_due_q ? 3'd4 : 3'd5));
        default: assert (1'b0);
      endcase
      assert (!commands_due_q || stage_q == 3'd2);
      assert (!steps_due_q || stage_q == 3'd3);
      assert (!ladder_due_q || stage_q == 3'd4);
    end
  end

  always @* cover (begun_q && flows && done);

endmodule

`default_nettype wire
