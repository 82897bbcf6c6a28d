// SPDX-License-Identifier: Apache-2.0
// Tables of a program of flow tasks (hdl/flow/flow_tables.v), any step's, transfer's and board's: what is read is what was loaded last, and stays
// until the next read; the breakpoint is what was last set, by its register or by the load of its step, and none is lost;
// the setup registers are what was written to each, 0 after a reset.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"

module flow_tables_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        step_read_i,
    input wire [10:0] step_i,
    input wire        transfer_read_i,
    input wire [ 7:0] transfer_i,
    input wire [ 3:0] board_i,
    input wire        steps_write_i,
    input wire        transfers_write_i,
    input wire        setup_write_i,
    input wire [15:0] load_addr_i,
    input wire [15:0] load_data_i,
    input wire        sel_register_i,
    input wire [ 7:0] addr_i,
    input wire        read_i,
    input wire        write_i,
    input wire [15:0] wdata_i,
    // inside of it
    input wire [43:0] peek_step_watched,
    input wire [31:0] peek_transfer_watched,
    input wire [10:0] peek_break_watched,
    input wire [47:0] peek_step,
    input wire [63:0] peek_transfer,
    input wire        peek_break,
    input wire [63:0] peek_boards,
    input wire        peek_pending,
    input wire        peek_pending_value,
    input wire [10:0] peek_pending_step,
    input wire [10:0] peek_break_step
);

  (* anyconst *) wire [10:0] step;
  (* anyconst *) wire [ 7:0] transfer;
  (* anyconst *) wire [ 3:0] board;

  wire [15:0] entry, step_end, resource, first, count, head;
  wire [7:0] step_before, step_after;
  wire step_break;
  wire [1:0] enable, panel_parity;
  wire [3:0] unit, attributes;
  wire [15:0] next_word, task_word, status_word, link_timeout, panel_timeout, rdata;
  wire [ 7:0] panel_unit;
  wire [19:0] panel_baud;
  flow_tables tables (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .step_read_i        (step_read_i),
      .step_i             (step_i),
      .step_entry_o       (entry),
      .step_end_o         (step_end),
      .step_before_o      (step_before),
      .step_after_o       (step_after),
      .step_break_o       (step_break),
      .transfer_read_i    (transfer_read_i),
      .transfer_i         (transfer_i),
      .transfer_resource_o(resource),
      .transfer_first_o   (first),
      .transfer_count_o   (count),
      .transfer_head_o    (head),
      .enable_o           (enable),
      .unit_o             (unit),
      .next_word_o        (next_word),
      .task_word_o        (task_word),
      .status_word_o      (status_word),
      .link_timeout_o     (link_timeout),
      .panel_timeout_o    (panel_timeout),
      .panel_unit_o       (panel_unit),
      .panel_baud_o       (panel_baud),
      .panel_parity_o     (panel_parity),
      .board_i            (board_i),
      .board_o            (attributes),
      .steps_write_i      (steps_write_i),
      .transfers_write_i  (transfers_write_i),
      .setup_write_i      (setup_write_i),
      .load_addr_i        (load_addr_i),
      .load_data_i        (load_data_i),
      .sel_register_i     (sel_register_i),
      .addr_i             (addr_i),
      .read_i             (read_i),
      .write_i            (write_i),
      .wdata_i            (wdata_i),
      .rdata_o            (rdata)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- who uses it ---------------------------------------------------------------------------------------
  wire load = steps_write_i || transfers_write_i || setup_write_i;
  wire bus_write = sel_register_i && write_i;
  reg step_read_q, bus_write_q, load_q;
  always @(posedge clk_i) {step_read_q, bus_write_q, load_q} <= {step_read_i, bus_write, load};
  always @* begin
    // Nothing is loaded while a round runs, which reads tables, nor in the clock before it.
    assume (!(load && (step_read_i || transfer_read_i)));
    assume ({1'b0, steps_write_i} + {1'b0, transfers_write_i} + {1'b0, setup_write_i} <= 2'd1);
    // A turn reads its step in one clock and looks at it in the next; the bus has an access at most every second clock, and is
    // what loads.
    assume (!(step_read_i && step_read_q) && !(bus_write && bus_write_q) && !(bus_write && load));
    assume (!(load_q && step_read_i));
  end

  // ---- rows ------------------------------------------------------------------------------------------------
  reg [3:0] step_known_q, transfer_known_q;
  reg [63:0] step_q, transfer_q;
  reg [3:0] step_seen_q, transfer_seen_q;  // the last row that was read is the watched one
  reg [63:0] step_row_q, transfer_row_q;
  wire step_loads = steps_write_i && load_addr_i[15:2] == {3'd0, step};
  wire transfer_loads = transfers_write_i && load_addr_i[15:2] == {6'd0, transfer};
  integer k;
  always @(posedge clk_i) begin
    for (k = 0; k < 4; k = k + 1) begin
      if (!begun_q) step_known_q[k] <= 1'b0;
      else if (step_loads && load_addr_i[1:0] == k[1:0]) begin
        step_known_q[k]  <= 1'b1;
        step_q[16*k+:16] <= load_data_i;
      end
      if (!begun_q) transfer_known_q[k] <= 1'b0;
      else if (transfer_loads && load_addr_i[1:0] == k[1:0]) begin
        transfer_known_q[k]  <= 1'b1;
        transfer_q[16*k+:16] <= load_data_i;
      end
    end
    if (!begun_q) step_seen_q <= 4'd0;
    else if (step_read_i) step_seen_q <= step_i == step ? step_known_q : 4'd0;
    if (step_read_i) step_row_q <= step_q;
    if (!begun_q) transfer_seen_q <= 4'd0;
    else if (transfer_read_i) transfer_seen_q <= transfer_i == transfer ? transfer_known_q : 4'd0;
    if (transfer_read_i) transfer_row_q <= transfer_q;
  end

  // ---- its breakpoint: set by its register, taken away by its load; there for every read from the second clock on ---------
  wire sets = addr_i == `RUNG_REG_FLOW_BREAK && bus_write;
  reg [10:0] break_step_q;
  reg break_known_q, break_q;  // since its last change
  reg changing_q;  // it was changed in the clock before, or is about to
  reg break_seen_q, break_row_q;
  wire changes = begun_q && rst_ni &&
      ((sets && break_step_q == step) || (step_loads && load_addr_i[1:0] == 2'd0));
  always @(posedge clk_i) begin
    if (bus_write && addr_i == `RUNG_REG_FLOW_BREAK_STEP) break_step_q <= wdata_i[10:0];
    if (!begun_q) break_known_q <= 1'b0;
    else if (changes) {break_known_q, break_q} <= {1'b1, sets && wdata_i[0]};
    else if (!rst_ni && changing_q) break_known_q <= 1'b0;  // a reset in the clock behind it
    changing_q <= changes || (begun_q && rst_ni && changing_q && step_read_i);
    if (!begun_q) break_seen_q <= 1'b0;
    else if (step_read_i) break_seen_q <= step_i == step && break_known_q && !changing_q;
    if (step_read_i) break_row_q <= break_q;
  end

  // ---- setup -------------------------------------------------------------------------------------------------
  reg [175:0] setup_q;  // registers 0 to 10
  reg board_known_q;
  reg [3:0] board_q;
  integer n;
  always @(posedge clk_i) begin
    for (n = 0; n < 11; n = n + 1) begin
      if (!rst_ni) setup_q[16*n+:16] <= 16'd0;
      else if (setup_write_i && load_addr_i == n[15:0]) setup_q[16*n+:16] <= load_data_i;
    end
    if (!begun_q) board_known_q <= 1'b0;
    else if (setup_write_i && load_addr_i == `RUNG_FLOW_FIRST_BOARD + {12'd0, board}) begin
      board_known_q <= 1'b1;
      board_q <= load_data_i[3:0];
    end
  end

  reg rdata_known_q;
  reg [15:0] rdata_q;
  always @(posedge clk_i) begin
    rdata_known_q <= begun_q;
    rdata_q <= sel_register_i && read_i && addr_i == `RUNG_REG_FLOW_BREAK_STEP ?
        {5'd0, break_step_q} : 16'd0;
  end

  always @* begin
    if (begun_q) begin
      if (step_seen_q[0]) assert (entry == step_row_q[15:0]);
      if (step_seen_q[1]) assert (step_end == step_row_q[31:16]);
      if (step_seen_q[2]) assert (step_before == step_row_q[39:32]);
      if (step_seen_q[3]) assert (step_after == step_row_q[55:48]);
      if (break_seen_q) assert (step_break == break_row_q);
      if (transfer_seen_q[0]) assert (resource == transfer_row_q[15:0]);
      if (transfer_seen_q[1]) assert (first == transfer_row_q[31:16]);
      if (transfer_seen_q[2]) assert (count == transfer_row_q[47:32]);
      if (transfer_seen_q[3]) assert (head == transfer_row_q[63:48]);
      assert (enable == setup_q[16*`RUNG_FLOW_SETUP_ENABLE+:2]);
      assert (unit == setup_q[16*`RUNG_FLOW_SETUP_UNIT+:4]);
      assert (next_word == setup_q[16*`RUNG_FLOW_SETUP_NEXT_WORD+:16]);
      assert (task_word == setup_q[16*`RUNG_FLOW_SETUP_TASK_WORD+:16]);
      assert (status_word == setup_q[16*`RUNG_FLOW_SETUP_STATUS_WORD+:16]);
      assert (link_timeout == setup_q[16*`RUNG_FLOW_SETUP_LINK_TIMEOUT+:16]);
      assert (panel_timeout == setup_q[16*`RUNG_FLOW_SETUP_PANEL_TIMEOUT+:16]);
      assert (panel_unit == setup_q[16*`RUNG_FLOW_SETUP_PANEL_UNIT+:8]);
      assert (panel_baud[15:0] == setup_q[16*`RUNG_FLOW_SETUP_PANEL_BAUD_LOW+:16]);
      assert (panel_baud[19:16] == setup_q[16*`RUNG_FLOW_SETUP_PANEL_BAUD_HIGH+:4]);
      assert (panel_parity == setup_q[16*`RUNG_FLOW_SETUP_PANEL_PARITY+:2]);
      if (board_known_q && board_i == board) assert (attributes == board_q);
      if (rdata_known_q) assert (rdata == rdata_q);
    end
  end

  // ---- for the induction -----------------------------------------------------------------------------------
  integer j;
  always @* begin
    assume (peek_step_watched == {4{step}} && peek_break_watched == step);
    assume (peek_transfer_watched == {4{transfer}});
    if (!begun_q) assume (peek_break_step == break_step_q);  // whatever it is
    if (begun_q) begin
      assert (peek_break_step == break_step_q);
      if (step_known_q[0]) assert (peek_step[15:0] == step_q[15:0]);
      if (step_known_q[1]) assert (peek_step[31:16] == step_q[31:16]);
      if (step_known_q[2]) assert (peek_step[39:32] == step_q[39:32]);
      if (step_known_q[3]) assert (peek_step[47:40] == step_q[55:48]);
      for (j = 0; j < 4; j = j + 1) begin
        if (transfer_known_q[j]) assert (peek_transfer[16*j+:16] == transfer_q[16*j+:16]);
      end
      if (board_known_q) assert (peek_boards[4*board+:4] == board_q);
      assert (changing_q == (peek_pending && peek_pending_step == step));
      if (changing_q) assert (peek_pending_value == break_q && break_known_q);
      if (!changing_q && break_known_q) assert (peek_break == break_q);
      if (peek_pending) assert (step_read_q || recent_q);
    end
  end
  reg recent_q;  // a write or load in the clock before
  always @(posedge clk_i) recent_q <= sets || steps_write_i;

  always @* begin
    cover (begun_q && step_seen_q == 4'hf && break_seen_q && step_break && entry == 16'h1234
           && step_after == 8'd9);
    cover (begun_q && transfer_seen_q == 4'hf && head == 16'h1234 && board_known_q &&
        board_q == 4'd5);
  end

endmodule

`default_nettype wire
