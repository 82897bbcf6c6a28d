// SPDX-License-Identifier: Apache-2.0
// What a routine writes to next_word and task_word, of the words that the processor's slots write. The next step
// is told in the clock of its write; starts and stops wait, in their order, until they are taken, at most 16
// of them (more are lost). routine_i: a routine begins, nothing waits any more.
`default_nettype none
`include "rung_flow.vh"

module flow_writes (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [15:0] next_word_i,
    input  wire [15:0] task_word_i,
    input  wire        routine_i,
    input  wire [ 1:0] write_valid_i,
    input  wire [31:0] write_addr_i,
    input  wire [31:0] write_data_i,
    // next step
    output wire        next_o,
    output wire [10:0] step_o,
    output wire        end_o,          // there is none
    // starts and stops: some wait, or one is written; the first (bit 7: start) is command_o, and maybe the last
    output wire        commands_o,
    output wire [ 7:0] command_o,
    output wire        known_o,        // it is of a task that there may be
    output wire        last_o,
    input  wire        take_i
);

  localparam [6:0] TASKS = `RUNG_FLOW_TASKS;
  localparam [4:0] MOST = `RUNG_FLOW_TASK_COMMANDS;
  localparam [15:0] TASK_ENDS = 16'hffff;

  wire [15:0] data0 = write_data_i[15:0];
  wire [15:0] data1 = write_data_i[31:16];
  wire next0 = write_valid_i[0] && write_addr_i[15:0] == next_word_i;
  wire next1 = write_valid_i[1] && write_addr_i[31:16] == next_word_i;
  wire task0 = write_valid_i[0] && write_addr_i[15:0] == task_word_i;
  wire task1 = write_valid_i[1] && write_addr_i[31:16] == task_word_i;

  wire [15:0] next = next1 ? data1 : data0;
  assign next_o = next0 || next1;
  assign step_o = next[10:0];
  assign end_o  = next == TASK_ENDS;

  wire [15:0] task_data = task1 ? data1 : data0;
  wire known = task_data[15:9] == 7'd0 && !task_data[7] && task_data[6:0] < TASKS;

  (* ram_style = "distributed" *) reg [8:0] waiting[0:15];
  reg [4:0] written_q;
  reg [4:0] taken_q;
  wire write = (task0 || task1) && written_q != MOST;

  always @(posedge clk_i) begin
    if (write) waiting[written_q[3:0]] <= {known, task_data[8], task_data[6:0]};
    if (!rst_ni || routine_i) begin
      written_q <= 5'd0;
      taken_q   <= 5'd0;
    end else begin
      if (write) written_q <= written_q + 5'd1;
      if (take_i) taken_q <= taken_q + 5'd1;
    end
  end

  assign commands_o = write || written_q != taken_q;
  assign {known_o, command_o} = waiting[taken_q[3:0]];
  assign last_o = taken_q + 5'd1 == written_q;

endmodule

`default_nettype wire
