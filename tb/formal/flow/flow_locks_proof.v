// SPDX-License-Identifier: Apache-2.0
// Routes, locks and requests of transfers (hdl/flow/flow_route.v). A board that cannot be shared has one holder at most, stays
// his until his block is free, and whoever else asks for it is told that it is held; the way of a transfer is the one that the
// page has for its unit, board, variable and count; each request that goes out is offered once, unchanged, until it is taken.
`default_nettype none
`include "rung_flow.vh"
`include "flow_ops.vh"

module flow_locks_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire [ 3:0] attributes_i,
    input wire        take_i,
    input wire [15:0] resource_i,
    input wire [15:0] first_i,
    input wire [15:0] count_i,
    input wire        lock_i,
    input wire [ 3:0] lock_board_i,
    input wire [ 4:0] lock_block_i,
    input wire        free_valid_i,
    input wire [ 4:0] free_block_i,
    input wire        send_i,
    input wire        write_i,
    input wire [ 4:0] block_i,
    input wire        link_ready_i,
    input wire        panel_ready_i
);

  localparam POINTS = 472;
  (* anyconst *) wire [3:0] unit;
  (* anyconst *) wire [3:0] watched;  // board
  wire [1:0] way;
  wire gives_up, exclusive, held, sending, link_valid, panel_valid, req_write;
  wire [3:0] board;
  wire [15:0] first, req_first;
  wire [5:0] count, req_count;
  wire [4:0] req_block;
  wire [7:0] req_unit, req_board;
  flow_route #(
      .WORD_POINTS(POINTS)
  ) route (
      .clk_i            (clk_i),
      .rst_ni           (rst_ni),
      .unit_i           (unit),
      .attributes_i     (attributes_i),
      .take_i           (take_i),
      .resource_i       (resource_i),
      .first_i          (first_i),
      .count_i          (count_i),
      .way_o            (way),
      .gives_up_o       (gives_up),
      .exclusive_o      (exclusive),
      .held_o           (held),
      .board_o          (board),
      .first_o          (first),
      .count_o          (count),
      .lock_i           (lock_i),
      .lock_board_i     (lock_board_i),
      .lock_block_i     (lock_block_i),
      .free_valid_i     (free_valid_i),
      .free_block_i     (free_block_i),
      .send_i           (send_i),
      .write_i          (write_i),
      .block_i          (block_i),
      .sending_o        (sending),
      .link_req_valid_o (link_valid),
      .link_req_ready_i (link_ready_i),
      .panel_req_valid_o(panel_valid),
      .panel_req_ready_i(panel_ready_i),
      .req_block_o      (req_block),
      .req_write_o      (req_write),
      .req_unit_o       (req_unit),
      .req_board_o      (req_board),
      .req_first_o      (req_first),
      .req_count_o      (req_count)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* assume (rst_ni == begun_q);

  // ---- the transfer that was taken, and its board's attributes in the clock after it or later -----------------
  reg taken_q;  // there was one
  reg [1:0] since_q;
  reg [15:0] resource_q, first_q, count_q;
  reg [3:0] attributes_q;
  always @(posedge clk_i) begin
    if (!begun_q) taken_q <= 1'b0;
    else if (take_i) taken_q <= 1'b1;
    since_q <= take_i ? 2'd0 : since_q + {1'b0, since_q != 2'd3};
    if (take_i) {resource_q, first_q, count_q} <= {resource_i, first_i, count_i};
    attributes_q <= attributes_i;
  end
  wire own = resource_q[15:8] == {4'd0, unit};
  wire counted = count_q >= 16'd1 && count_q <= `RUNG_FLOW_BLOCK_WORDS;
  wire there = resource_q[7:0] < `RUNG_FLOW_BOARDS && attributes_q[`RUNG_BOARD_BIT_THERE];
  wire other = resource_q[15:8] >= 8'd1 && resource_q[15:8] <= `RUNG_FLOW_UNITS;
  wire fits = {1'b0, first_q} + {1'b0, count_q} <= POINTS;
  wire settled = taken_q && since_q >= 2'd1;
  reg [1:0] due;
  always @* begin
    if (!counted) due = `FLOW_WAY_REFUSED;
    else if (!own) due = other ? `FLOW_WAY_LINK : `FLOW_WAY_REFUSED;
    else if (!there) due = `FLOW_WAY_REFUSED;
    else if (attributes_q[`RUNG_BOARD_BIT_PANEL]) due = `FLOW_WAY_PANEL;
    else due = fits ? `FLOW_WAY_LOCAL : `FLOW_WAY_REFUSED;
  end

  // ---- the watched board's holder -------------------------------------------------------------------------
  reg held_q;
  reg [4:0] holder_q;
  reg locking_q;  // it was locked in the clock before
  wire locks = lock_i && lock_board_i == watched;
  // A lock is taken by one who has seen that the board is free, or in two clocks, if both of his transfers have that board; his
  // block is not given back in that clock.
  always @* assume (!locks || (!held_q && !locking_q) || (locking_q && lock_block_i == holder_q));
  always @*
    assume (!free_valid_i || !(lock_i || lock_before_q) ||
                    (free_block_i != lock_block_i && free_block_i != lock_block_q));
  reg lock_before_q;
  reg [4:0] lock_block_q;
  reg held_before_q;
  always @(posedge clk_i) begin
    lock_before_q <= begun_q && lock_i;
    lock_block_q <= lock_block_i;
    locking_q <= begun_q && locks && !held_q;
    if (!begun_q) held_q <= 1'b0;
    else if (locks) held_q <= 1'b1;
    else if (held_q && free_valid_i && free_block_i == holder_q) held_q <= 1'b0;
    if (locks) holder_q <= lock_block_i;
    held_before_q <= held_q && !locking_q;
  end

  // ---- a request ------------------------------------------------------------------------------------------
  reg link_q, panel_q;
  reg [43:0] request_q;
  always @*
    assume (!send_i || (settled && !sending && (way == `FLOW_WAY_LINK || way == `FLOW_WAY_PANEL)));
  always @(posedge clk_i) begin
    if (!begun_q) {link_q, panel_q} <= 2'b00;
    else if (send_i) {link_q, panel_q} <= {way == `FLOW_WAY_LINK, way == `FLOW_WAY_PANEL};
    else {link_q, panel_q} <= {link_q && !link_ready_i, panel_q && !panel_ready_i};
    if (send_i) request_q <= {block_i, write_i, resource_q, first_q, count_q[5:0]};
  end

  always @* begin
    if (begun_q) begin
      if (settled) begin
        assert (way == due);
        assert (gives_up == (!own || attributes_q[`RUNG_BOARD_BIT_OVER_LINK]));
        assert (exclusive == (own && there && attributes_q[`RUNG_BOARD_BIT_EXCLUSIVE]));
        if (exclusive && board == watched && !locking_q) assert (held || !held_before_q);
        if (held && board == watched) assert (held_before_q || locking_q || freed_q);
      end
      assert (link_valid == link_q && panel_valid == panel_q);
      if (link_q || panel_q) begin
        assert ({req_block, req_write, req_unit, req_board, req_first, req_count} == request_q);
      end
    end
  end
  reg freed_q;
  always @(posedge clk_i) freed_q <= free_valid_i;

  // ---- for the induction ------------------------------------------------------------------------------------
  (* hierconn *) wire [15:0] \route.held_q ;
  (* hierconn *) wire \route.lock_q ;
  (* hierconn *) wire [3:0] \route.lock_board_q ;
  (* hierconn *) wire [4:0] \route.lock_block_q ;
  (* hierconn *) wire [7:0] \route.unit_q ;
  (* hierconn *) wire [7:0] \route.board_q ;
  (* hierconn *) wire [15:0] \route.first_q ;
  (* hierconn *) wire [15:0] \route.count_q ;
  wire [79:0] holders;
  (* hierconn *) wire [4:0] \route.holder_q[0] ;
  (* hierconn *) wire [4:0] \route.holder_q[1] ;
  (* hierconn *) wire [4:0] \route.holder_q[2] ;
  (* hierconn *) wire [4:0] \route.holder_q[3] ;
  (* hierconn *) wire [4:0] \route.holder_q[4] ;
  (* hierconn *) wire [4:0] \route.holder_q[5] ;
  (* hierconn *) wire [4:0] \route.holder_q[6] ;
  (* hierconn *) wire [4:0] \route.holder_q[7] ;
  (* hierconn *) wire [4:0] \route.holder_q[8] ;
  (* hierconn *) wire [4:0] \route.holder_q[9] ;
  (* hierconn *) wire [4:0] \route.holder_q[10] ;
  (* hierconn *) wire [4:0] \route.holder_q[11] ;
  (* hierconn *) wire [4:0] \route.holder_q[12] ;
  (* hierconn *) wire [4:0] \route.holder_q[13] ;
  (* hierconn *) wire [4:0] \route.holder_q[14] ;
  (* hierconn *) wire [4:0] \route.holder_q[15] ;
  assign holders = {
    \route.holder_q[15] ,
    \route.holder_q[14] ,
    \route.holder_q[13] ,
    \route.holder_q[12] ,
    \route.holder_q[11] ,
    \route.holder_q[10] ,
    \route.holder_q[9] ,
    \route.holder_q[8] ,
    \route.holder_q[7] ,
    \route.holder_q[6] ,
    \route.holder_q[5] ,
    \route.holder_q[4] ,
    \route.holder_q[3] ,
    \route.holder_q[2] ,
    \route.holder_q[1] ,
    \route.holder_q[0]
  };
  integer k;
  always @* begin
    if (begun_q) begin
      if (taken_q) begin
        assert ({\route.unit_q , \route.board_q } == resource_q);
        assert (\route.first_q == first_q && \route.count_q == count_q);
      end
      assert (\route.lock_q == lock_before_q);
      if (lock_before_q) assert (\route.lock_block_q == lock_block_q);
      if (locking_q) assert (\route.lock_q && \route.lock_board_q == watched);
      if (lock_before_q && \route.lock_board_q == watched) begin
        assert (held_q && holder_q == lock_block_q);
      end
      if (locking_q) assert (held_q && holder_q == lock_block_q);
      for (k = 0; k < 16; k = k + 1) begin
        if (k[3:0] == watched) begin
          assert (\route.held_q [k] == (held_q && !locking_q));
          if (held_q && !locking_q) assert (holders[5*k+:5] == holder_q);
        end
      end
    end
  end

  always @* begin
    cover (begun_q && settled && exclusive && held && board == watched && own);
    cover (begun_q && link_q && !link_ready_i && req_count == 6'd32);
  end

endmodule

`default_nettype wire
