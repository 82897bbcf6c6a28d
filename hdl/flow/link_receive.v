// SPDX-License-Identifier: Apache-2.0
// Frames of one side of the link (hdl/isa/flow.toml): checks them, puts what is new into the receive ring, and says
// what answer the neighbour gets. FROM_LOWER: this side is the lower one.
//
// A data frame is
//   taken      with the sequence bit that is due and room in the ring; the answer is TAKEN;
//   a repeat   with the bit of the one before: TAKEN again, and nothing else;
//   FULL       new, but there is no room: it comes again;
//   UNKNOWN    when no START has come since this unit's reset: which bit is due is not known, and the neighbour has to
//              begin anew. Nothing is guessed, so that nothing is doubled.
// After START, a frame without content that has no sequence bit itself and may be repeated, bit 0 is due.
// Anything with a wrong CRC, a bad byte, a pause in it, or a form that cannot be is counted, and dropped with all
// that follows until the line has been idle. That includes frames that come from a unit number that is not on this
// side, or go to one that is: they would go to and fro for ever.
//
// answer_valid_o stays until answer_taken_i; a newer answer takes the place of an older one.
// ack_valid_o is a pulse: the neighbour's answer to what we sent.
`default_nettype none
`include "rung_flow.vh"

module link_receive #(
    parameter integer FROM_LOWER = 0
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [ 3:0] unit_i,
    input  wire        bit_tick_i,
    // UART
    input  wire        line_i,
    input  wire        byte_valid_i,
    input  wire [ 7:0] byte_i,
    input  wire        byte_error_i,
    // receive ring
    output wire        begin_o,
    output wire        write_o,
    output wire [ 6:0] write_index_o,
    output wire [ 7:0] write_data_o,
    output wire        commit_o,
    output wire [ 1:0] commit_class_o,
    input  wire        any_room_i,
    input  wire        request_room_i,
    // sender
    output wire        answer_valid_o,
    output wire [ 7:0] answer_head_o,
    input  wire        answer_taken_i,
    output wire        ack_valid_o,
    output wire [ 1:0] ack_code_o,
    output wire        ack_sequence_o,
    // counters
    output wire [15:0] bad_o,
    output wire [15:0] full_o
);

  localparam [1:0] DATA = `RUNG_LINK_KIND_DATA;
  localparam [1:0] ANSWER = `RUNG_LINK_KIND_ANSWER;
  localparam [1:0] START = `RUNG_LINK_KIND_START;
  localparam [1:0] TAKEN = `RUNG_LINK_ANSWER_TAKEN;
  localparam [1:0] FULL = `RUNG_LINK_ANSWER_FULL;
  localparam [1:0] UNKNOWN = `RUNG_LINK_ANSWER_UNKNOWN;
  localparam [1:0] STARTED = `RUNG_LINK_ANSWER_STARTED;
  localparam [4:0] GAP = `RUNG_LINK_GAP;
  localparam [7:0] READ_REPLY = `RUNG_LINK_TYPE_READ_REPLY;
  localparam [7:0] WRITE = `RUNG_LINK_TYPE_WRITE;
  localparam [7:0] WRITE_REPLY = `RUNG_LINK_TYPE_WRITE_REPLY;
  localparam [7:0] MOST_WORDS = `RUNG_FLOW_BLOCK_WORDS;

  // Numbers of bytes in a frame, from 0.
  localparam [6:0] HEAD = 7'd0;
  localparam [6:0] TO = 7'd1;
  localparam [6:0] FROM = 7'd2;
  localparam [6:0] TYPE = 7'd3;
  localparam [6:0] COUNT = 7'd8;
  localparam [6:0] LAST_OF_CONTROL = 7'd2;
  localparam [6:0] LAST_WITHOUT_WORDS = 7'd10;

  localparam [1:0] FRAME = 2'd0;  // a frame's bytes come, or its head is awaited
  localparam [1:0] CHECK = 2'd1;  // its CRC is ready in some clocks
  localparam [1:0] SKIP = 2'd2;  // until the line is idle

  reg  [ 1:0] state_q;
  reg  [ 6:0] index_q;
  reg  [ 6:0] last_q;  // number of its last byte
  reg  [ 1:0] kind_q;
  reg  [ 2:0] code_q;  // low bits of the head
  reg  [ 2:0] type_q;
  reg         own_q;  // it goes to this unit
  reg         room_q;  // a place was free when it began
  reg         synced_q;  // which sequence bit is due is known
  reg         due_q;
  reg         answer_valid_q;
  reg  [ 7:0] answer_head_q;
  reg  [ 4:0] idle_q;  // bit times that the line has been idle
  reg  [15:0] bad_q;
  reg  [15:0] full_q;

  // ---- the line ----
  wire        idle = idle_q == GAP;

  always @(posedge clk_i) begin
    if (!rst_ni || !line_i) idle_q <= 5'd0;
    else if (bit_tick_i && !idle) idle_q <= idle_q + 5'd1;
  end

  // ---- form ----
  wire        control = kind_q != DATA;
  wire [ 3:0] low = byte_i[3:0];
  wire        words = type_q == WRITE[2:0] || type_q == READ_REPLY[2:0];
  wire        reply = type_q == READ_REPLY[2:0] || type_q == WRITE_REPLY[2:0];
  wire        elsewhere = FROM_LOWER != 0 ? low > unit_i : low < unit_i;
  reg         wrong;

  always @(*) begin
    case (index_q)
      HEAD: begin
        case (byte_i[7:6])
          DATA:    wrong = byte_i[5:1] != 5'd0;
          ANSWER:  wrong = byte_i[5:3] != 3'd0;
          START:   wrong = byte_i[5:0] != 6'd0;
          default: wrong = 1'b1;
        endcase
      end
      TO:      wrong = byte_i[7:4] != 4'd0 || low == 4'd0 || elsewhere;
      FROM:    wrong = low == 4'd0 || !elsewhere || low == unit_i;
      TYPE:    wrong = byte_i == 8'd0 || byte_i > WRITE_REPLY;
      COUNT:   wrong = byte_i > MOST_WORDS || (byte_i == 8'd0 && !reply);
      default: wrong = 1'b0;
    endcase
    if (control && index_q != HEAD) wrong = 1'b0;
  end

  // ---- bytes ----
  wire        framing = state_q == FRAME;
  wire        last = index_q == last_q;
  wire        crc_busy;
  wire [15:0] crc;

  link_crc check (
      .clk_i  (clk_i),
      .start_i(framing && index_q == HEAD),
      .byte_i (framing && byte_valid_i),
      .data_i (byte_i),
      .busy_o (crc_busy),
      .crc_o  (crc)
  );

  wire checked = state_q == CHECK && !crc_busy;
  wire right = checked && crc == 16'd0;
  wire broken = framing && (byte_error_i || (byte_valid_i && wrong) || (idle && index_q != HEAD));

  always @(posedge clk_i) begin
    if (framing && byte_valid_i) begin
      case (index_q)
        HEAD: begin
          {kind_q, code_q} <= {byte_i[7:6], byte_i[2:0]};
          last_q <= byte_i[7:6] == DATA ? LAST_WITHOUT_WORDS : LAST_OF_CONTROL;
          room_q <= any_room_i;
        end
        TO: own_q <= low == unit_i;
        TYPE: type_q <= byte_i[2:0];
        COUNT: if (words) last_q <= LAST_WITHOUT_WORDS + {byte_i[5:0], 1'b0};
        default: ;
      endcase
    end

    if (!rst_ni) begin
      state_q <= SKIP;
      index_q <= HEAD;
      bad_q   <= 16'd0;
    end else begin
      case (state_q)
        FRAME:
        if (broken) begin
          state_q <= SKIP;
        end else if (byte_valid_i) begin
          index_q <= index_q + 7'd1;
          if (index_q != HEAD && last) state_q <= CHECK;
        end
        CHECK:
        if (checked) begin
          state_q <= right ? FRAME : SKIP;
          index_q <= HEAD;
        end
        default:
        if (idle) begin
          state_q <= FRAME;
          index_q <= HEAD;
        end
      endcase
      if (broken || (checked && !right)) bad_q <= bad_q + 16'd1;
    end
  end

  // ---- what becomes of it ----
  wire data_right = right && !control;
  wire repeated = code_q[0] != due_q;
  wire room = room_q && (reply || request_room_i);
  wire take = data_right && synced_q && !repeated && room;
  wire refuse = data_right && synced_q && !repeated && !room;
  wire start = right && kind_q == START;
  wire [1:0] code = !synced_q ? UNKNOWN : refuse ? FULL : TAKEN;

  always @(posedge clk_i) begin
    if (start) answer_head_q <= {ANSWER, 3'd0, STARTED, 1'b0};
    else if (data_right) answer_head_q <= {ANSWER, 3'd0, code, code_q[0]};

    if (start) due_q <= 1'b0;
    else if (take) due_q <= !due_q;

    if (!rst_ni) begin
      synced_q <= 1'b0;
      answer_valid_q <= 1'b0;
      full_q <= 16'd0;
    end else begin
      if (start) synced_q <= 1'b1;
      if (start || data_right) answer_valid_q <= 1'b1;
      else if (answer_taken_i) answer_valid_q <= 1'b0;
      if (refuse) full_q <= full_q + 16'd1;
    end
  end

  assign begin_o = framing && byte_valid_i && index_q == HEAD;
  assign write_o = framing && byte_valid_i && index_q != HEAD && room_q;
  assign write_index_o = index_q - 7'd1;
  assign write_data_o = byte_i;
  assign commit_o = take;
  assign commit_class_o = {own_q, reply};
  assign answer_valid_o = answer_valid_q;
  assign answer_head_o = answer_head_q;
  assign ack_valid_o = right && kind_q == ANSWER;
  assign ack_code_o = code_q[2:1];
  assign ack_sequence_o = code_q[0];
  assign bad_o = bad_q;
  assign full_o = full_q;

endmodule

`default_nettype wire
