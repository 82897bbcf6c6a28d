// SPDX-License-Identifier: Apache-2.0
// Starts and stops that a routine writes (hdl/flow/flow_writes.v): the first 16 come out once each and in their order, whenever
// they are taken; those of a task that there cannot be are marked; the next step is the last write's, told in its clock.
`default_nettype none
`include "rung_flow.vh"

module flow_writes_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        routine_i,
    input wire [ 1:0] valid_i,
    input wire [31:0] addr_i,
    input wire [31:0] data_i,
    input wire        take_i
);

  (* anyconst *) wire [15:0] next_word;
  (* anyconst *) wire [15:0] task_word;
  wire next, next_end, commands, known, last;
  wire [10:0] step;
  wire [ 7:0] command;
  flow_writes writes (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .next_word_i  (next_word),
      .task_word_i  (task_word),
      .routine_i    (routine_i),
      .write_valid_i(valid_i),
      .write_addr_i (addr_i),
      .write_data_i (data_i),
      .next_o       (next),
      .step_o       (step),
      .end_o        (next_end),
      .commands_o   (commands),
      .command_o    (command),
      .known_o      (known),
      .last_o       (last),
      .take_i       (take_i)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  wire [1:0] to_task = {
    valid_i[1] && addr_i[31:16] == task_word, valid_i[0] && addr_i[15:0] == task_word
  };
  wire [1:0] to_next = {
    valid_i[1] && addr_i[31:16] == next_word, valid_i[0] && addr_i[15:0] == next_word
  };
  wire [15:0] task_data = to_task[1] ? data_i[31:16] : data_i[15:0];
  wire [15:0] next_data = to_next[1] ? data_i[31:16] : data_i[15:0];
  wire [4:0] number_of = {4'd0, to_task != 2'b00};

  // ---- any of the sixteen --------------------------------------------------------------------------------
  (* anyconst *) wire [3:0] watched;
  reg [4:0] written_q;
  reg [4:0] taken_q;
  reg [15:0] data_q;
  wire waits = written_q != taken_q;
  always @* begin
    // Both slots do not write the word in one clock; what is taken waits.
    assume (to_task != 2'b11 && to_next != 2'b11);
    assume (!take_i || waits);
  end
  wire writes_now = number_of != 5'd0 && written_q != 5'd16;
  always @(posedge clk_i) begin
    if (!rst_ni || routine_i) begin
      written_q <= 5'd0;
      taken_q   <= 5'd0;
    end else begin
      if (writes_now) written_q <= written_q + 5'd1;
      if (take_i) taken_q <= taken_q + 5'd1;
    end
    if (writes_now && written_q == {1'b0, watched}) data_q <= task_data;
  end
  wire [8:0] low = {1'b0, data_q[7:0]};

  always @* begin
    if (begun_q) begin
      assert (next == (to_next != 2'b00));
      if (next) assert (step == next_data[10:0] && next_end == (next_data == 16'hffff));
      assert (commands == (waits || writes_now));
      if (waits && taken_q == {1'b0, watched}) begin
        assert (command == {data_q[8], data_q[6:0]});
        assert (known == (data_q < 16'd512 && low < {2'd0, `RUNG_FLOW_TASKS}));
      end
      if (waits) assert (last == (written_q - taken_q == 5'd1));
      assert (written_q <= 5'd16 && taken_q <= written_q);
    end
  end

  // ---- for the induction -----------------------------------------------------------------------------------
  (* hierconn *) wire [  4:0] \writes.written_q ;
  (* hierconn *) wire [  4:0] \writes.taken_q ;
  wire [143:0] entries;
  (* hierconn *) wire [  8:0] \writes.waiting[0] ;
  assign entries[0+:9] = \writes.waiting[0] ;
  (* hierconn *) wire [8:0] \writes.waiting[1] ;
  assign entries[9+:9] = \writes.waiting[1] ;
  (* hierconn *) wire [8:0] \writes.waiting[2] ;
  assign entries[18+:9] = \writes.waiting[2] ;
  (* hierconn *) wire [8:0] \writes.waiting[3] ;
  assign entries[27+:9] = \writes.waiting[3] ;
  (* hierconn *) wire [8:0] \writes.waiting[4] ;
  assign entries[36+:9] = \writes.waiting[4] ;
  (* hierconn *) wire [8:0] \writes.waiting[5] ;
  assign entries[45+:9] = \writes.waiting[5] ;
  (* hierconn *) wire [8:0] \writes.waiting[6] ;
  assign entries[54+:9] = \writes.waiting[6] ;
  (* hierconn *) wire [8:0] \writes.waiting[7] ;
  assign entries[63+:9] = \writes.waiting[7] ;
  (* hierconn *) wire [8:0] \writes.waiting[8] ;
  assign entries[72+:9] = \writes.waiting[8] ;
  (* hierconn *) wire [8:0] \writes.waiting[9] ;
  assign entries[81+:9] = \writes.waiting[9] ;
  (* hierconn *) wire [8:0] \writes.waiting[10] ;
  assign entries[90+:9] = \writes.waiting[10] ;
  (* hierconn *) wire [8:0] \writes.waiting[11] ;
  assign entries[99+:9] = \writes.waiting[11] ;
  (* hierconn *) wire [8:0] \writes.waiting[12] ;
  assign entries[108+:9] = \writes.waiting[12] ;
  (* hierconn *) wire [8:0] \writes.waiting[13] ;
  assign entries[117+:9] = \writes.waiting[13] ;
  (* hierconn *) wire [8:0] \writes.waiting[14] ;
  assign entries[126+:9] = \writes.waiting[14] ;
  (* hierconn *) wire [8:0] \writes.waiting[15] ;
  assign entries[135+:9] = \writes.waiting[15] ;
  integer k;
  always @* begin
    if (begun_q) begin
      assert (\writes.written_q == written_q && \writes.taken_q == taken_q);
      for (k = 0; k < 16; k = k + 1) begin
        if (k[3:0] == watched && {1'b0, watched} < written_q) begin
          assert (entries[9*k+:8] == {data_q[8], data_q[6:0]});
          assert (entries[9*k+8] == (data_q < 16'd512 && low < {2'd0, `RUNG_FLOW_TASKS}));
        end
      end
    end
  end

  always @* begin
    cover (begun_q && waits && taken_q == 5'd2 && watched == 4'd2 && command == 8'hd0);
  end

endmodule

`default_nettype wire
