// SPDX-License-Identifier: Apache-2.0
// Commands of a round, from start_i to done_o, both pulses: the PC's (registers flow_pc_*), begun or gone on
// with, then those event commands that the ring holds at start_i, each once. One whose board is held, or whose data
// are awaited, goes behind the others in the ring. stop_i: the round ends here; what was under way begins
// anew, or goes on, in the next one. Routes and copies as in flow_step.v.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"
`include "flow_ops.vh"

module flow_commands (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        start_i,
    input  wire        stop_i,
    output wire        done_o,
    // setup
    input  wire        in_place_i,
    input  wire [ 3:0] unit_i,
    // event commands from the link
    input  wire        event_valid_i,
    output wire        event_ready_o,
    input  wire [ 4:0] event_block_i,      // the offered one, which it takes
    input  wire        event_block_valid_i,
    input  wire        event_write_i,
    input  wire [ 7:0] event_board_i,
    input  wire [15:0] event_first_i,
    input  wire [ 5:0] event_count_i,
    input  wire [ 7:0] event_from_i,
    input  wire [ 7:0] event_tag_i,
    // replies
    output wire        reply_valid_o,
    input  wire        reply_ready_i,
    output wire [ 4:0] reply_block_o,
    output wire        reply_write_o,
    output wire [ 7:0] reply_status_o,
    output wire [ 5:0] reply_count_o,
    output wire [ 7:0] reply_to_o,
    output wire [ 7:0] reply_tag_o,
    // completions
    input  wire [ 8:0] came_i,
    input  wire [ 7:0] status_i,           // of block_o
    // route
    output wire        take_o,
    output wire [15:0] resource_o,
    output wire [15:0] first_o,
    output wire [15:0] count_o,
    input  wire [ 1:0] way_i,
    input  wire        gives_up_i,
    input  wire        exclusive_i,
    input  wire        held_i,
    output wire        lock_o,
    output wire        free_o,             // locks of block_o
    output wire        send_o,
    output wire        write_o,
    output wire [ 4:0] block_o,
    input  wire        sending_i,
    // copies
    output wire        copy_start_o,
    input  wire        copy_done_i,
    // counters
    output wire        held_o,
    output wire        failed_o,
    output wire        executed_o,
    output wire        suspended_o,
    // bus
    output wire        pc_waiting_o,
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o
);

  localparam [4:0] PC_BLOCK = `RUNG_FLOW_PC_BLOCK;
  localparam [4:0] FIRST_EVENT = `RUNG_FLOW_TASK_BLOCKS;
  localparam [7:0] REFUSED = `RUNG_FLOW_STATUS_REFUSED;
  localparam [1:0] PC_WAIT = 2'd0;
  localparam [1:0] PC_EXECUTE = 2'd1;
  localparam [1:0] PC_PAUSE = 2'd2;

  localparam [3:0] IDLE = 4'd0;
  localparam [3:0] PC = 4'd1;
  localparam [3:0] EVENT = 4'd2;  // the head of the ring is read
  localparam [3:0] LOOK = 4'd3;
  localparam [3:0] TAKE = 4'd4;
  localparam [3:0] ROUTE = 4'd5;
  localparam [3:0] ROUTED = 4'd6;
  localparam [3:0] COPY = 4'd7;
  localparam [3:0] SEND = 4'd8;
  localparam [3:0] AWAIT = 4'd9;  // in place
  localparam [3:0] CAME = 4'd10;
  localparam [3:0] FINISH = 4'd11;
  localparam [3:0] NEXT = 4'd12;  // the head goes behind the others
  localparam [3:0] LEAVE = 4'd13;  // or leaves

  // ---- the PC's command ----------------------------------------------------------------------------
  reg [1:0] pc_state_q;
  reg pc_write_q;
  reg [15:0] pc_resource_q;
  reg [15:0] pc_first_q;
  reg [15:0] pc_count_q;
  reg [7:0] pc_status_q;
  wire register_write = sel_register_i && write_i;
  wire pc_waits = pc_state_q == PC_WAIT;
  wire pc_begins = register_write && addr_i == `RUNG_REG_FLOW_PC_CONTROL && wdata_i[0] && pc_waits;
  assign pc_waiting_o = pc_waits;

  // ---- the ring: numbers of event blocks in the order in which they are looked at -------------------------
  reg [3:0] state_q;
  reg of_pc_q;
  (* ram_style = "distributed" *) reg [2:0] ring[0:7];
  reg [2:0] read_q;
  reg [2:0] write_q;
  reg [3:0] held_q;  // how many
  reg [3:0] left_q;  // of them in this round
  reg [2:0] head_q;  // number of the block that is looked at
  reg [7:0] waits_q;  // for data
  reg [7:0] replies_q;  // all is done but the reply
  wire leave = state_q == LEAVE && reply_ready_i;
  wire rotate = state_q == NEXT;
  wire accept = event_valid_i && event_ready_o;

  assign event_ready_o = event_block_valid_i && state_q != LEAVE && !rotate;

  always @(posedge clk_i) begin
    if (accept || rotate) ring[write_q] <= rotate ? head_q : event_block_i[2:0];
    if (!rst_ni) begin
      {read_q, write_q} <= 6'd0;
      held_q <= 4'd0;
    end else begin
      if (accept || rotate) write_q <= write_q + 3'd1;
      if (leave || rotate) read_q <= read_q + 3'd1;
      held_q <= held_q + {{3{leave}}, accept || leave};
    end
    head_q <= ring[read_q];
  end

  // ---- what the event commands are -------------------------------------------------------------------
  localparam WIDTH = 47;
  (* ram_style = "distributed" *) reg [WIDTH-1:0] events[0:7];
  (* ram_style = "distributed" *) reg [7:0] finals[0:7];  // status that a reply will have
  wire [WIDTH-1:0] event_now = events[head_q];
  reg [7:0] status_q;
  wire write_final = state_q == FINISH && !of_pc_q;
  always @(posedge clk_i) begin
    if (accept) begin
      events[event_block_i[2:0]] <= {
        event_write_i, event_board_i, event_first_i, event_count_i, event_from_i, event_tag_i
      };
    end
    if (write_final) finals[head_q] <= status_q;
  end
  wire [7:0] event_board = event_now[45:38];
  wire [15:0] event_first = event_now[37:22];
  wire [5:0] event_count = event_now[21:16];
  wire [4:0] block = of_pc_q ? PC_BLOCK : FIRST_EVENT + {2'd0, head_q};

  assign take_o = state_q == TAKE;
  assign resource_o = of_pc_q ? pc_resource_q : {4'd0, unit_i, event_board};
  assign first_o = of_pc_q ? pc_first_q : event_first;
  assign count_o = of_pc_q ? pc_count_q : {10'd0, event_count};
  assign block_o = block;
  assign write_o = of_pc_q ? pc_write_q : event_now[46];

  // ---- the course ----------------------------------------------------------------------------------
  reg begun_q;
  wire came = came_i[of_pc_q ? 4'd8 : {1'b0, head_q}];
  wire linked = way_i == `FLOW_WAY_LINK || way_i == `FLOW_WAY_PANEL;
  wire sends = state_q == SEND && !sending_i;

  always @(posedge clk_i) begin
    begun_q <= state_q == COPY && !copy_done_i;
    case (state_q)
      IDLE: begin
        of_pc_q <= 1'b1;
        left_q  <= held_q;
        if (start_i) state_q <= PC;
      end
      PC: begin
        if (pc_state_q == PC_EXECUTE) state_q <= TAKE;
        else if (pc_state_q == PC_PAUSE && came) state_q <= CAME;
        else state_q <= EVENT;
      end
      EVENT: begin
        of_pc_q <= 1'b0;
        state_q <= left_q == 4'd0 ? IDLE : LOOK;
      end
      LOOK: begin
        left_q <= left_q - 4'd1;
        if (replies_q[head_q]) state_q <= LEAVE;
        else if (waits_q[head_q]) state_q <= came ? CAME : NEXT;
        else state_q <= TAKE;
      end
      TAKE: state_q <= ROUTE;
      ROUTE: state_q <= ROUTED;
      ROUTED: begin
        status_q <= way_i == `FLOW_WAY_REFUSED ? REFUSED : 8'd0;
        if (held_i) state_q <= of_pc_q ? EVENT : NEXT;
        else if (linked) state_q <= SEND;
        else state_q <= way_i == `FLOW_WAY_LOCAL ? COPY : FINISH;
      end
      COPY: if (copy_done_i) state_q <= FINISH;
      SEND: begin
        if (sends) state_q <= in_place_i || !gives_up_i ? AWAIT : of_pc_q ? EVENT : NEXT;
      end
      // The bit is that of before in the first clock, which SEND has cleared.
      AWAIT: if (came) state_q <= CAME;
      CAME: begin
        status_q <= status_i;
        state_q  <= FINISH;
      end
      FINISH: state_q <= of_pc_q ? EVENT : LEAVE;
      // A reply that the link does not take now is offered again in the next round.
      LEAVE: state_q <= reply_ready_i ? EVENT : NEXT;
      NEXT: state_q <= EVENT;
      default: state_q <= IDLE;
    endcase
    if (!rst_ni || stop_i) state_q <= IDLE;

    if (sends && !of_pc_q) waits_q[head_q] <= 1'b1;
    if (write_final) begin
      waits_q[head_q]   <= 1'b0;
      replies_q[head_q] <= 1'b1;
    end
    if (leave) replies_q[head_q] <= 1'b0;
    if (!rst_ni) {waits_q, replies_q} <= 16'd0;
  end

  assign done_o = state_q == EVENT && left_q == 4'd0;
  assign copy_start_o = state_q == COPY && !begun_q;
  assign send_o = sends;
  assign lock_o = sends && exclusive_i;
  assign free_o = state_q == FINISH;
  assign held_o = state_q == ROUTED && held_i;
  assign failed_o = state_q == FINISH && status_q != 8'd0;
  assign executed_o = write_final;
  assign suspended_o = sends && !of_pc_q && gives_up_i && !in_place_i;

  assign reply_valid_o = state_q == LEAVE;
  assign reply_block_o = block;
  assign reply_write_o = event_now[46];
  assign reply_status_o = finals[head_q];
  assign reply_count_o = event_now[46] || reply_status_o != 8'd0 ? 6'd0 : event_count;
  assign reply_to_o = event_now[15:8];
  assign reply_tag_o = event_now[7:0];

  // ---- registers -------------------------------------------------------------------------------------
  always @(posedge clk_i) begin
    if (pc_begins) pc_write_q <= wdata_i[1];
    if (register_write && pc_waits) begin
      case (addr_i)
        `RUNG_REG_FLOW_PC_RESOURCE: pc_resource_q <= wdata_i;
        `RUNG_REG_FLOW_PC_FIRST: pc_first_q <= wdata_i;
        `RUNG_REG_FLOW_PC_COUNT: pc_count_q <= wdata_i;
        default: ;
      endcase
    end
    if (state_q == FINISH && of_pc_q) pc_status_q <= status_q;
    if (!rst_ni) begin
      pc_state_q  <= PC_WAIT;
      pc_status_q <= 8'd0;
    end else if (pc_begins) begin
      pc_state_q <= PC_EXECUTE;
    end else if (sends && of_pc_q) begin
      pc_state_q <= PC_PAUSE;
    end else if (state_q == FINISH && of_pc_q) begin
      pc_state_q <= PC_WAIT;
    end
  end

  reg [15:0] rdata_q;
  always @(posedge clk_i) begin
    rdata_q <= 16'd0;
    if (sel_register_i && read_i) begin
      case (addr_i)
        `RUNG_REG_FLOW_PC_CONTROL: rdata_q <= {14'd0, pc_state_q};
        `RUNG_REG_FLOW_PC_RESOURCE: rdata_q <= pc_resource_q;
        `RUNG_REG_FLOW_PC_FIRST: rdata_q <= pc_first_q;
        `RUNG_REG_FLOW_PC_COUNT: rdata_q <= pc_count_q;
        `RUNG_REG_FLOW_PC_STATUS: rdata_q <= {8'd0, pc_status_q};
        default: ;
      endcase
    end
  end
  assign rdata_o = rdata_q;

  wire unused = &{1'b0, event_block_i[4:3]};

endmodule

`default_nettype wire
