// SPDX-License-Identifier: Apache-2.0
// The course of a round: commands, turns of the tasks, ladder. begin_o until the tasks are as a program starts them
// (walking_i, busy_i); commands_o, steps_o and ladder_o start the phases, each a pulse. Without flows a
// round is the ladder's scan, in the same clocks. give_up_i: it ends here.
`default_nettype none

module flow_round (
    input  wire clk_i,
    input  wire rst_ni,
    input  wire flows_i,
    input  wire give_up_i,
    input  wire round_i,
    output wire round_done_o,
    // phases
    input  wire walking_i,
    input  wire busy_i,
    output wire begin_o,
    output wire commands_o,
    input  wire commands_done_i,
    output wire steps_o,
    input  wire steps_done_i,
    output wire of_steps_o,       // routes and copies are the tasks'
    output wire ladder_o,
    input  wire ladder_done_i,
    // with flows
    output wire flow_ladder_o,
    output wire flow_done_o
);

  localparam [2:0] IDLE = 3'd0;
  localparam [2:0] BEGIN = 3'd1;
  localparam [2:0] COMMANDS = 3'd2;
  localparam [2:0] TASKS = 3'd3;
  localparam [2:0] LADDER = 3'd4;
  localparam [2:0] SCANNING = 3'd5;

  reg [2:0] state_q;
  reg commands_q;
  reg steps_q;
  wire begins = state_q == BEGIN && !walking_i && !busy_i;

  always @(posedge clk_i) begin
    commands_q <= begins && rst_ni && !give_up_i;
    steps_q <= state_q == COMMANDS && commands_done_i && rst_ni && !give_up_i;
    case (state_q)
      IDLE: if (round_i && flows_i) state_q <= BEGIN;
      BEGIN: if (begins) state_q <= COMMANDS;
      COMMANDS: if (commands_done_i) state_q <= TASKS;
      TASKS: if (steps_done_i) state_q <= LADDER;
      LADDER: state_q <= SCANNING;
      SCANNING: if (ladder_done_i) state_q <= IDLE;
      default: state_q <= IDLE;
    endcase
    if (!rst_ni || give_up_i) state_q <= IDLE;
  end

  assign begin_o = begins;
  assign commands_o = commands_q;
  assign steps_o = steps_q;
  assign of_steps_o = state_q == TASKS;
  assign flow_ladder_o = state_q == LADDER;
  assign flow_done_o = state_q == SCANNING && ladder_done_i;
  assign ladder_o = flows_i ? flow_ladder_o : round_i;
  assign round_done_o = flows_i ? flow_done_o : ladder_done_i;

endmodule

`default_nettype wire
