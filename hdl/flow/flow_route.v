// SPDX-License-Identifier: Apache-2.0
// Where a transfer leads, and who holds the boards that cannot be shared. resource_i, first_i and count_i are
// taken with take_i; in the second clock after it way_o and what goes with it are right, until the next take_i:
//   way_o      refused: no such unit, board, variable or count; local: words of this unit; panel; link
//   gives_up_o the board's data lie over a link: who wants them does not wait in its place
//   held_o     a board that cannot be shared is held (at once, by whoever it is)
// lock_i: lock_block_i holds board lock_board_i. free_valid_i: free_block_i holds none any more.
// send_i: the transfer that was taken goes out, with block_i and write_i, on the way that it has; sending_o until it
// has gone.
`default_nettype none
`include "rung_flow.vh"
`include "flow_ops.vh"

module flow_route #(
    parameter integer WORD_POINTS = 472  // of the device map
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    // setup
    input  wire [ 3:0] unit_i,
    input  wire [ 3:0] attributes_i,       // of board_o, in the same clock
    // the transfer
    input  wire        take_i,
    input  wire [15:0] resource_i,
    input  wire [15:0] first_i,
    input  wire [15:0] count_i,
    output wire [ 1:0] way_o,
    output wire        gives_up_o,
    output wire        exclusive_o,
    output wire        held_o,
    output wire [ 3:0] board_o,
    output wire [15:0] first_o,
    output wire [ 5:0] count_o,
    // locks
    input  wire        lock_i,
    input  wire [ 3:0] lock_board_i,
    input  wire [ 4:0] lock_block_i,
    input  wire        free_valid_i,
    input  wire [ 4:0] free_block_i,
    // requests
    input  wire        send_i,
    input  wire        write_i,
    input  wire [ 4:0] block_i,
    output wire        sending_o,
    output wire        link_req_valid_o,
    input  wire        link_req_ready_i,
    output wire        panel_req_valid_o,
    input  wire        panel_req_ready_i,
    output wire [ 4:0] req_block_o,
    output wire        req_write_o,
    output wire [ 7:0] req_unit_o,
    output wire [ 7:0] req_board_o,
    output wire [15:0] req_first_o,
    output wire [ 5:0] req_count_o
);

  localparam BOARDS = `RUNG_FLOW_BOARDS;
  localparam [15:0] MOST = `RUNG_FLOW_BLOCK_WORDS;
  localparam [7:0] UNITS = `RUNG_FLOW_UNITS;

  // ---- the transfer ------------------------------------------------------------------------------
  reg [7:0] unit_q;
  reg [7:0] board_q;
  reg [15:0] first_q;
  reg [15:0] count_q;

  always @(posedge clk_i) begin
    if (take_i) begin
      {unit_q, board_q} <= resource_i;
      first_q <= first_i;
      count_q <= count_i;
    end
  end

  // ---- its way -----------------------------------------------------------------------------------
  wire own = unit_q == {4'd0, unit_i};
  wire counted = count_q != 16'd0 && count_q <= MOST;
  wire there = attributes_i[`RUNG_BOARD_BIT_THERE] && board_q[7:4] == 4'd0;
  wire panel = attributes_i[`RUNG_BOARD_BIT_PANEL];
  wire [16:0] behind = {1'b0, first_q} + {11'd0, count_q[5:0]};
  wire mapped = behind <= WORD_POINTS[16:0];
  wire other = unit_q != 8'd0 && unit_q <= UNITS;
  reg [1:0] way_q;
  reg gives_up_q;
  reg exclusive_q;
  reg blocked_q;
  reg [BOARDS-1:0] held_q;
  wire exclusive = own && there && attributes_i[`RUNG_BOARD_BIT_EXCLUSIVE];

  always @(posedge clk_i) begin
    if (!counted) way_q <= `FLOW_WAY_REFUSED;
    else if (!own) way_q <= other ? `FLOW_WAY_LINK : `FLOW_WAY_REFUSED;
    else if (!there) way_q <= `FLOW_WAY_REFUSED;
    else if (panel) way_q <= `FLOW_WAY_PANEL;
    else way_q <= mapped ? `FLOW_WAY_LOCAL : `FLOW_WAY_REFUSED;
    gives_up_q  <= !own || attributes_i[`RUNG_BOARD_BIT_OVER_LINK];
    exclusive_q <= exclusive;
    blocked_q <= exclusive && held_q[board_q[3:0]];
  end

  // ---- locks -------------------------------------------------------------------------------------
  reg [4:0] holder_q[0:BOARDS-1];
  reg lock_q;
  reg [3:0] lock_board_q;
  reg [4:0] lock_block_q;
  integer i;

  always @(posedge clk_i) begin
    // A clock later: nobody asks before it is done.
    lock_q <= lock_i && rst_ni;
    lock_board_q <= lock_board_i;
    lock_block_q <= lock_block_i;
    for (i = 0; i < BOARDS; i = i + 1) begin
      if (lock_q && lock_board_q == i[3:0]) begin
        held_q[i]   <= 1'b1;
        holder_q[i] <= lock_block_q;
      end else if (free_valid_i && holder_q[i] == free_block_i) begin
        held_q[i] <= 1'b0;
      end
    end
    if (!rst_ni) held_q <= {BOARDS{1'b0}};
  end

  assign way_o = way_q;
  assign gives_up_o = gives_up_q;
  assign exclusive_o = exclusive_q;
  assign held_o = blocked_q;
  assign board_o = board_q[3:0];
  assign first_o = first_q;
  assign count_o = count_q[5:0];

  // ---- requests: their receivers have room for one of each block, so this one is soon empty ---------------
  reg link_valid_q;
  reg panel_valid_q;
  reg [4:0] block_q;
  reg write_q;
  reg [7:0] req_unit_q;
  reg [7:0] req_board_q;
  reg [15:0] req_first_q;
  reg [5:0] req_count_q;

  always @(posedge clk_i) begin
    if (send_i) begin
      block_q <= block_i;
      write_q <= write_i;
      {req_unit_q, req_board_q, req_first_q, req_count_q} <= {
        unit_q, board_q, first_q, count_q[5:0]
      };
    end
    if (!rst_ni) begin
      link_valid_q  <= 1'b0;
      panel_valid_q <= 1'b0;
    end else if (send_i) begin
      link_valid_q  <= way_q == `FLOW_WAY_LINK;
      panel_valid_q <= way_q == `FLOW_WAY_PANEL;
    end else begin
      if (link_req_ready_i) link_valid_q <= 1'b0;
      if (panel_req_ready_i) panel_valid_q <= 1'b0;
    end
  end

  assign sending_o = (link_valid_q && !link_req_ready_i) || (panel_valid_q && !panel_req_ready_i);
  assign link_req_valid_o = link_valid_q;
  assign panel_req_valid_o = panel_valid_q;
  assign req_block_o = block_q;
  assign req_write_o = write_q;
  assign req_unit_o = req_unit_q;
  assign req_board_o = req_board_q;
  assign req_first_o = req_first_q;
  assign req_count_o = req_count_q;

endmodule

`default_nettype wire
