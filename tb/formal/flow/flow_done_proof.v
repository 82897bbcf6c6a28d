// SPDX-License-Identifier: Apache-2.0
// Completions (hdl/flow/flow_done.v): each that is taken from link or panel is told once, to the task that owned the block when its
// request went out, or to the command; no other ever is; its status is kept for its block. The link goes before the panel, and
// each is served within a bounded time if tasks are.
`default_nettype none
`include "rung_flow.vh"

module flow_done_proof (
    input wire       clk_i,
    input wire       rst_ni,
    input wire       link_valid_i,
    input wire [4:0] link_block_i,
    input wire [7:0] link_status_i,
    input wire       panel_valid_i,
    input wire [4:0] panel_block_i,
    input wire [7:0] panel_status_i,
    input wire       owner_write_i,
    input wire [4:0] owner_block_i,
    input wire [6:0] owner_task_i,
    input wire       come_ready_i
);

  // Any block of those that there are.
  (* anyconst *) wire [4:0] block;
  always @* assume (block <= `RUNG_FLOW_PC_BLOCK);

  wire link_ready, panel_ready, come_valid;
  wire [6:0] come_task;
  wire [4:0] come_block;
  wire [8:0] came;
  wire [7:0] status;
  flow_done done (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .link_done_valid_i  (link_valid_i),
      .link_done_ready_o  (link_ready),
      .link_done_block_i  (link_block_i),
      .link_done_status_i (link_status_i),
      .panel_done_valid_i (panel_valid_i),
      .panel_done_ready_o (panel_ready),
      .panel_done_block_i (panel_block_i),
      .panel_done_status_i(panel_status_i),
      .owner_write_i      (owner_write_i),
      .owner_block_i      (owner_block_i),
      .owner_task_i       (owner_task_i),
      .come_valid_o       (come_valid),
      .come_ready_i       (come_ready_i),
      .come_task_o        (come_task),
      .come_block_o       (come_block),
      .came_o             (came),
      .status_block_i     (block),
      .status_o           (status)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  wire of_task = block < `RUNG_FLOW_TASK_BLOCKS;
  wire from_link = link_valid_i && link_ready && link_block_i == block;
  wire from_panel = panel_valid_i && panel_ready && panel_block_i == block;
  wire taken = rst_ni && (from_link || from_panel);
  wire asks = owner_write_i && owner_block_i == block;
  wire told = come_valid && come_ready_i && come_block == block;

  // A block has one request under way, and a completion answers one.
  reg asked_q;
  reg [6:0] task_q;
  reg due_q;  // taken, and not yet told
  reg came_q;
  reg [7:0] status_q;
  reg known_q;
  reg settled_q;  // its status has been in the memory for a clock
  always @* assume (!(asks && (asked_q || due_q)));
  always @* assume (!taken || asked_q);
  always @(posedge clk_i) begin
    if (!rst_ni) asked_q <= 1'b0;
    else if (asks) asked_q <= 1'b1;
    else if (taken) asked_q <= 1'b0;
    if (asks) task_q <= owner_task_i;

    if (!rst_ni) due_q <= 1'b0;
    else if (taken) due_q <= 1'b1;
    else if (told || !of_task) due_q <= 1'b0;

    if (!rst_ni || asks) came_q <= 1'b0;
    else if (due_q && !of_task) came_q <= 1'b1;

    if (!rst_ni) known_q <= 1'b0;
    else if (taken) known_q <= 1'b1;
    if (taken) status_q <= from_link ? link_status_i : panel_status_i;
    settled_q <= begun_q && rst_ni && known_q && !taken && !due_q;
  end

  always @* begin
    if (begun_q) begin
      assert (!(from_link && from_panel));
      if (of_task && come_valid && come_block == block) assert (due_q && come_task == task_q);
      if (of_task && due_q) assert (come_valid && come_block == block);
      if (!of_task) assert (came[block-`RUNG_FLOW_TASK_BLOCKS] == came_q);
      if (settled_q && known_q && !due_q) assert (status == status_q);
      // Whoever waits is served as soon as nobody is before it.
      if (!come_valid && link_valid_i && !due_any_q) assert (link_ready);
      if (!due_any_q && panel_valid_i && !link_valid_i) assert (panel_ready);
    end
  end
  reg due_any_q;  // one is being told
  always @(posedge clk_i) begin
    if (!rst_ni) due_any_q <= 1'b0;
    else if (due_any_q) due_any_q <= come_valid && !come_ready_i;
    else due_any_q <= link_valid_i || panel_valid_i;
  end

  // ---- for the induction -----------------------------------------------------------------------------
  (* hierconn *) wire \done.taken_q ;
  (* hierconn *) wire [4:0] \done.block_q ;
  (* hierconn *) wire [7:0] \done.status_q ;
  wire [255:0] statuses;
  wire [111:0] owners;
  (* hierconn *) wire [7:0] \done.statuses[0] ;
  assign statuses[0+:8] = \done.statuses[0] ;
  (* hierconn *) wire [7:0] \done.statuses[1] ;
  assign statuses[8+:8] = \done.statuses[1] ;
  (* hierconn *) wire [7:0] \done.statuses[2] ;
  assign statuses[16+:8] = \done.statuses[2] ;
  (* hierconn *) wire [7:0] \done.statuses[3] ;
  assign statuses[24+:8] = \done.statuses[3] ;
  (* hierconn *) wire [7:0] \done.statuses[4] ;
  assign statuses[32+:8] = \done.statuses[4] ;
  (* hierconn *) wire [7:0] \done.statuses[5] ;
  assign statuses[40+:8] = \done.statuses[5] ;
  (* hierconn *) wire [7:0] \done.statuses[6] ;
  assign statuses[48+:8] = \done.statuses[6] ;
  (* hierconn *) wire [7:0] \done.statuses[7] ;
  assign statuses[56+:8] = \done.statuses[7] ;
  (* hierconn *) wire [7:0] \done.statuses[8] ;
  assign statuses[64+:8] = \done.statuses[8] ;
  (* hierconn *) wire [7:0] \done.statuses[9] ;
  assign statuses[72+:8] = \done.statuses[9] ;
  (* hierconn *) wire [7:0] \done.statuses[10] ;
  assign statuses[80+:8] = \done.statuses[10] ;
  (* hierconn *) wire [7:0] \done.statuses[11] ;
  assign statuses[88+:8] = \done.statuses[11] ;
  (* hierconn *) wire [7:0] \done.statuses[12] ;
  assign statuses[96+:8] = \done.statuses[12] ;
  (* hierconn *) wire [7:0] \done.statuses[13] ;
  assign statuses[104+:8] = \done.statuses[13] ;
  (* hierconn *) wire [7:0] \done.statuses[14] ;
  assign statuses[112+:8] = \done.statuses[14] ;
  (* hierconn *) wire [7:0] \done.statuses[15] ;
  assign statuses[120+:8] = \done.statuses[15] ;
  (* hierconn *) wire [7:0] \done.statuses[16] ;
  assign statuses[128+:8] = \done.statuses[16] ;
  (* hierconn *) wire [7:0] \done.statuses[17] ;
  assign statuses[136+:8] = \done.statuses[17] ;
  (* hierconn *) wire [7:0] \done.statuses[18] ;
  assign statuses[144+:8] = \done.statuses[18] ;
  (* hierconn *) wire [7:0] \done.statuses[19] ;
  assign statuses[152+:8] = \done.statuses[19] ;
  (* hierconn *) wire [7:0] \done.statuses[20] ;
  assign statuses[160+:8] = \done.statuses[20] ;
  (* hierconn *) wire [7:0] \done.statuses[21] ;
  assign statuses[168+:8] = \done.statuses[21] ;
  (* hierconn *) wire [7:0] \done.statuses[22] ;
  assign statuses[176+:8] = \done.statuses[22] ;
  (* hierconn *) wire [7:0] \done.statuses[23] ;
  assign statuses[184+:8] = \done.statuses[23] ;
  (* hierconn *) wire [7:0] \done.statuses[24] ;
  assign statuses[192+:8]  = \done.statuses[24] ;
  assign statuses[255:200] = 56'd0;
  (* hierconn *) wire [6:0] \done.owners[0] ;
  assign owners[0+:7] = \done.owners[0] ;
  (* hierconn *) wire [6:0] \done.owners[1] ;
  assign owners[7+:7] = \done.owners[1] ;
  (* hierconn *) wire [6:0] \done.owners[2] ;
  assign owners[14+:7] = \done.owners[2] ;
  (* hierconn *) wire [6:0] \done.owners[3] ;
  assign owners[21+:7] = \done.owners[3] ;
  (* hierconn *) wire [6:0] \done.owners[4] ;
  assign owners[28+:7] = \done.owners[4] ;
  (* hierconn *) wire [6:0] \done.owners[5] ;
  assign owners[35+:7] = \done.owners[5] ;
  (* hierconn *) wire [6:0] \done.owners[6] ;
  assign owners[42+:7] = \done.owners[6] ;
  (* hierconn *) wire [6:0] \done.owners[7] ;
  assign owners[49+:7] = \done.owners[7] ;
  (* hierconn *) wire [6:0] \done.owners[8] ;
  assign owners[56+:7] = \done.owners[8] ;
  (* hierconn *) wire [6:0] \done.owners[9] ;
  assign owners[63+:7] = \done.owners[9] ;
  (* hierconn *) wire [6:0] \done.owners[10] ;
  assign owners[70+:7] = \done.owners[10] ;
  (* hierconn *) wire [6:0] \done.owners[11] ;
  assign owners[77+:7] = \done.owners[11] ;
  (* hierconn *) wire [6:0] \done.owners[12] ;
  assign owners[84+:7] = \done.owners[12] ;
  (* hierconn *) wire [6:0] \done.owners[13] ;
  assign owners[91+:7] = \done.owners[13] ;
  (* hierconn *) wire [6:0] \done.owners[14] ;
  assign owners[98+:7] = \done.owners[14] ;
  (* hierconn *) wire [6:0] \done.owners[15] ;
  assign owners[105+:7] = \done.owners[15] ;
  integer k;
  always @* begin
    if (begun_q) begin
      assert (\done.taken_q == due_any_q);
      assert (due_q == (\done.taken_q && \done.block_q == block));
      if (due_q) assert (\done.status_q == status_q && known_q && !asked_q);
      for (k = 0; k < 32; k = k + 1) begin
        if (known_q && !due_q && k[4:0] == block) assert (statuses[8*k+:8] == status_q);
      end
      for (k = 0; k < 16; k = k + 1) begin
        if ((asked_q || due_q) && k[4:0] == block) assert (owners[7*k+:7] == task_q);
      end
    end
  end

  always @* begin
    cover (begun_q && of_task && told && come_task == 7'd99 && status_q == 8'd1);
    cover (begun_q && !of_task && came_q && settled_q && status == 8'd2);
  end

endmodule

`default_nettype wire
