// SPDX-License-Identifier: Apache-2.0
// Temporary storage (hdl/flow/flow_pool.v). A block is owned by at most one: what is offered is nobody's, and what is given back
// is offered again; there is an offer exactly if one is free. A word holds what was written to it last, by whichever client;
// each client reads that word and keeps it until its next read, and whoever waits for the memory loses nothing. The PC's
// block is the bus's too, which writes only while the PC waits. Requests, takes and returns are free in every clock.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"

module flow_pool_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        engine_valid_i,
    input wire        engine_write_i,
    input wire [ 9:0] engine_addr_i,
    input wire [15:0] engine_wdata_i,
    input wire        link_valid_i,
    input wire        link_write_i,
    input wire [ 9:0] link_addr_i,
    input wire [15:0] link_wdata_i,
    input wire        panel_valid_i,
    input wire        panel_write_i,
    input wire [ 9:0] panel_addr_i,
    input wire [15:0] panel_wdata_i,
    input wire        task_take_i,
    input wire        free_valid_i,
    input wire [ 4:0] free_block_i,
    input wire        event_take_i,
    input wire        event_free_valid_i,
    input wire [ 4:0] event_free_block_i,
    input wire        pc_waiting_i,
    input wire        sel_register_i,
    input wire [ 7:0] addr_i,
    input wire        read_i,
    input wire        write_i,
    input wire [15:0] wdata_i
);

  wire [15:0] engine_rdata, link_rdata, panel_rdata, rdata;
  wire link_ready, panel_ready, task_valid, event_valid;
  wire [4:0] task_block, event_block;
  flow_pool pool (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .engine_valid_i    (engine_valid_i),
      .engine_write_i    (engine_write_i),
      .engine_addr_i     (engine_addr_i),
      .engine_wdata_i    (engine_wdata_i),
      .engine_rdata_o    (engine_rdata),
      .link_valid_i      (link_valid_i),
      .link_ready_o      (link_ready),
      .link_write_i      (link_write_i),
      .link_addr_i       (link_addr_i),
      .link_wdata_i      (link_wdata_i),
      .link_rdata_o      (link_rdata),
      .panel_valid_i     (panel_valid_i),
      .panel_ready_o     (panel_ready),
      .panel_write_i     (panel_write_i),
      .panel_addr_i      (panel_addr_i),
      .panel_wdata_i     (panel_wdata_i),
      .panel_rdata_o     (panel_rdata),
      .task_valid_o      (task_valid),
      .task_block_o      (task_block),
      .task_take_i       (task_take_i),
      .free_valid_i      (free_valid_i),
      .free_block_i      (free_block_i),
      .event_valid_o     (event_valid),
      .event_block_o     (event_block),
      .event_take_i      (event_take_i),
      .event_free_valid_i(event_free_valid_i),
      .event_free_block_i(event_free_block_i),
      .pc_waiting_i      (pc_waiting_i),
      .sel_register_i    (sel_register_i),
      .addr_i            (addr_i),
      .read_i            (read_i),
      .write_i           (write_i),
      .wdata_i           (wdata_i),
      .rdata_o           (rdata)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- owners: of each block whether somebody has it ------------------------------------------------
  reg [23:0] owned_q;
  wire takes_task = task_take_i && task_valid;
  wire takes_event = event_take_i && event_valid;
  always @* begin
    // Nobody takes what is not offered, and who gives a block back had it.
    assume (!task_take_i || task_valid);
    assume (!event_take_i || event_valid);
    if (free_valid_i) begin
      assume (free_block_i < `RUNG_FLOW_PC_BLOCK || free_block_i == `RUNG_FLOW_PC_BLOCK);
      if (free_block_i < `RUNG_FLOW_TASK_BLOCKS) assume (owned_q[free_block_i]);
    end
    if (event_free_valid_i) begin
      assume (event_free_block_i >= `RUNG_FLOW_TASK_BLOCKS);
      assume (event_free_block_i < `RUNG_FLOW_PC_BLOCK && owned_q[event_free_block_i]);
    end
  end
  integer b;
  always @(posedge clk_i) begin
    for (b = 0; b < 24; b = b + 1) begin
      if (!rst_ni) owned_q[b] <= 1'b0;
      else if ((takes_task && task_block == b[4:0]) || (takes_event && event_block == b[4:0])) begin
        owned_q[b] <= 1'b1;
      end else if ((free_valid_i && free_block_i == b[4:0] && b < 16) ||
                   (event_free_valid_i && event_free_block_i == b[4:0])) begin
        owned_q[b] <= 1'b0;
      end
    end
  end
  always @* begin
    if (begun_q) begin
      assert (task_valid == !(&owned_q[15:0]));
      assert (event_valid == !(&owned_q[23:16]));
      if (task_valid) assert (task_block < 5'd16 && !owned_q[task_block]);
      if (event_valid)
        assert (event_block >= 5'd16 && event_block < 5'd24 && !owned_q[event_block]);
    end
  end

  // ---- the memory: any word of it, and what each client read last ------------------------------------
  (* anyconst *) wire [9:0] word;
  wire of_pc = word[9:5] == `RUNG_FLOW_PC_BLOCK;
  wire of_bus = sel_register_i && addr_i[7:5] == `RUNG_REG_FLOW_PC_DATA / 32;
  wire bus_here = sel_register_i && addr_i[7:5] == `RUNG_REG_FLOW_PC_DATA / 32 &&
      addr_i[4:0] == word[4:0] && of_pc;
  wire bus_writes = bus_here && write_i && pc_waiting_i;
  wire engine = engine_valid_i;
  wire link = link_valid_i && link_ready;
  wire panel = panel_valid_i && panel_ready;
  wire engine_here = engine && engine_addr_i == word;
  wire link_here = link && link_addr_i == word;
  wire panel_here = panel && panel_addr_i == word;
  wire client_writes = (engine_here && engine_write_i) || (link_here && link_write_i) ||
      (panel_here && panel_write_i);
  // While the PC waits, no transfer of its block is under way; the bus does not read what a transfer writes.
  always @* begin
    assume (!(of_bus && write_i && pc_waiting_i) ||
            !((engine && engine_addr_i[9:5] == `RUNG_FLOW_PC_BLOCK) ||
              (link && link_addr_i[9:5] == `RUNG_FLOW_PC_BLOCK) ||
              (panel && panel_addr_i[9:5] == `RUNG_FLOW_PC_BLOCK)));
    assume (!(read_i && write_i));
    assume (!(bus_here && read_i && client_writes));
  end
  reg known_q;
  reg [15:0] word_q;
  always @(posedge clk_i) begin
    if (!begun_q) known_q <= 1'b0;
    else if (client_writes || bus_writes) known_q <= 1'b1;
    if (bus_writes) word_q <= wdata_i;
    else if (client_writes) begin
      word_q <= engine_here ? engine_wdata_i : link_here ? link_wdata_i : panel_wdata_i;
    end
  end

  reg [2:0] last_q;  // the client's last read was of the word, with this value: engine, link, panel
  reg [15:0] engine_q;
  reg [15:0] link_q;
  reg [15:0] panel_q;
  reg bus_q;
  reg bus_any_q;
  reg [15:0] bus_word_q;
  always @(posedge clk_i) begin
    if (engine && !engine_write_i) {last_q[2], engine_q} <= {engine_here && known_q, word_q};
    if (link && !link_write_i) {last_q[1], link_q} <= {link_here && known_q, word_q};
    if (panel && !panel_write_i) {last_q[0], panel_q} <= {panel_here && known_q, word_q};
    if (!begun_q) last_q <= 3'd0;
    bus_q <= begun_q && bus_here && read_i && known_q;
    bus_any_q <= sel_register_i && addr_i[7:5] == `RUNG_REG_FLOW_PC_DATA / 32 && read_i;
    bus_word_q <= word_q;
  end
  always @* begin
    if (begun_q) begin
      if (last_q[2]) assert (engine_rdata == engine_q);
      if (last_q[1]) assert (link_rdata == link_q);
      if (last_q[0]) assert (panel_rdata == panel_q);
      if (bus_q) assert (rdata == bus_word_q);
      if (!bus_any_q) assert (rdata == 16'd0);
      // One at a time, and never nobody while somebody waits.
      assert ({1'b0, engine} + {1'b0, link} + {1'b0, panel} <= 2'd1);
      if (engine_valid_i || link_valid_i || panel_valid_i) assert (engine || link || panel);
    end
  end

  // ---- for the induction: the stand-ins of the memories watch this word ---------------------------------
  (* hierconn *) wire [ 9:0] \pool.blocks.watched ;
  (* hierconn *) wire [ 4:0] \pool.pc_block.watched ;
  (* hierconn *) wire [ 4:0] \pool.bus_block.watched ;
  (* hierconn *) wire [15:0] \pool.blocks.word_q ;
  (* hierconn *) wire [15:0] \pool.pc_block.word_q ;
  (* hierconn *) wire [15:0] \pool.bus_block.word_q ;
  (* hierconn *) wire [15:0] \pool.task_free_q ;
  (* hierconn *) wire [ 7:0] \pool.event_free_q ;
  (* hierconn *) wire [ 2:0] \pool.fresh_q ;
  (* hierconn *) wire [15:0] \pool.engine_q ;
  (* hierconn *) wire [15:0] \pool.link_q ;
  (* hierconn *) wire [15:0] \pool.panel_q ;
  always @* begin
    assume (\pool.blocks.watched == word);
    assume (\pool.pc_block.watched == word[4:0] && \pool.bus_block.watched == word[4:0]);
    if (begun_q) begin
      assert (\pool.task_free_q == ~owned_q[15:0] && \pool.event_free_q == ~owned_q[23:16]);
      if (known_q && !of_pc) assert (\pool.blocks.word_q == word_q);
      if (known_q && of_pc) assert (\pool.pc_block.word_q == word_q);
      if (known_q && of_pc) assert (\pool.bus_block.word_q == word_q);
      if (last_q[2] && !\pool.fresh_q [2]) assert (\pool.engine_q == engine_q);
      if (last_q[1] && !\pool.fresh_q [1]) assert (\pool.link_q == link_q);
      if (last_q[0] && !\pool.fresh_q [0]) assert (\pool.panel_q == panel_q);
    end
  end

  always @* begin
    cover (begun_q && last_q == 3'b111 && engine_q != link_q && link_q != panel_q);
    cover (begun_q && bus_q && rdata == 16'h1234);
    cover (begun_q && !task_valid);
  end

endmodule

`default_nettype wire
