// SPDX-License-Identifier: Apache-2.0
// The host's exchange with the devices: one request (controller.toml: exchange_*), all of its points in one
// exchange phase, one a clock. A phase begins with phase_i and lasts points_i + MICRO_EXCHANGE_CLOCKS clocks,
// with a request or without; done_o is 1 in its last clock. A request that comes during a phase waits for the next one.
//
// Writes come first, then reads; a mask write reads its word before it writes. A point goes through the
// device map, or is a device's address itself (raw). A point without a device reads 0, and a write
// of it has no effect. The buffer is the firmware's while no request waits.
`default_nettype none
`include "rung_controller.vh"

module host_exchange #(
    parameter integer ANSWER_CLOCKS = 9  // from access_valid_o to its answer
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    // the firmware's registers and buffer; read data in the clock after the address
    input  wire        write_i,
    input  wire [ 7:0] register_i,
    input  wire        buffer_write_i,
    input  wire [ 7:0] buffer_addr_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] buffer_data_o,
    output wire        busy_o,
    // phase
    input  wire [11:0] points_i,
    input  wire        phase_i,
    output wire        done_o,
    // device map
    output wire [13:0] point_o,
    output wire        word_o,
    input  wire        exists_i,
    input  wire [15:0] address_i,
    // accesses to devices
    output wire        access_valid_o,
    output wire        access_write_o,
    output wire        access_word_o,
    output wire [15:0] access_addr_o,
    output wire [15:0] access_data_o,
    input  wire        answer_valid_i,
    input  wire [15:0] answer_data_i
);

  localparam [7:0] READ_BUFFER = 8'd128;

  // ---- the request ---------------------------------------------------------------------------------
  reg [4:0] control_q;
  reg [15:0] write_first_q, read_first_q;
  reg [11:0] write_count_q, read_count_q;
  reg [15:0] and_q, or_q;
  reg waits_q;  // a request waits for its phase or is under way

  wire has_write = control_q[0] && write_count_q != 12'd0;
  wire has_read = control_q[1] && read_count_q != 12'd0;
  wire words = control_q[2];
  wire raw = control_q[3];
  wire mask = control_q[4];

  always @(posedge clk_i) begin
    if (write_i) begin
      case (register_i)
        `RUNG_REG_EXCHANGE_CONTROL: control_q <= wdata_i[4:0];
        `RUNG_REG_EXCHANGE_WRITE_FIRST: write_first_q <= wdata_i;
        `RUNG_REG_EXCHANGE_WRITE_COUNT: write_count_q <= wdata_i[11:0];
        `RUNG_REG_EXCHANGE_READ_FIRST: read_first_q <= wdata_i;
        `RUNG_REG_EXCHANGE_READ_COUNT: read_count_q <= wdata_i[11:0];
        `RUNG_REG_EXCHANGE_AND: and_q <= wdata_i;
        `RUNG_REG_EXCHANGE_OR: or_q <= wdata_i;
        default: ;
      endcase
    end
  end

  // ---- the phase -----------------------------------------------------------------------------------
  localparam [2:0] IDLE = 3'd0;
  localparam [2:0] MASK_READ = 3'd1;
  localparam [2:0] MASK_WAIT = 3'd2;
  localparam [2:0] WRITE = 3'd3;
  localparam [2:0] READ = 3'd4;
  localparam [2:0] ANSWERS = 3'd5;

  reg active_q;
  reg [11:0] clocks_q;
  reg done_q;
  reg [2:0] state_q;
  reg [11:0] point_q;  // within the list
  reg [11:0] answers_q;  // answers that have come
  wire last_write = point_q + 12'd1 == write_count_q;
  wire last_read = point_q + 12'd1 == read_count_q;
  wire answered = answer_valid_i && (state_q == READ || state_q == ANSWERS);
  wire last_answer = answered && answers_q + 12'd1 == read_count_q;

  always @(posedge clk_i) begin
    if (phase_i) clocks_q <= points_i + `RUNG_MICRO_EXCHANGE_CLOCKS - 12'd2;
    else clocks_q <= clocks_q - 12'd1;
    if (!rst_ni) begin
      active_q <= 1'b0;
      done_q   <= 1'b0;
    end else begin
      if (phase_i) active_q <= 1'b1;
      else if (clocks_q == 12'd0) active_q <= 1'b0;
      done_q <= active_q && clocks_q == 12'd0;
    end

    point_q <= point_q + 12'd1;
    if (answered) answers_q <= answers_q + 12'd1;
    if (!rst_ni) begin
      state_q <= IDLE;
      waits_q <= 1'b0;
    end else begin
      if (write_i && register_i == `RUNG_REG_EXCHANGE_CONTROL) waits_q <= 1'b1;
      case (state_q)
        IDLE: begin
          point_q   <= 12'd0;
          answers_q <= 12'd0;
          if (phase_i && waits_q) begin
            if (mask) state_q <= MASK_READ;
            else if (has_write) state_q <= WRITE;
            else if (has_read) state_q <= READ;
            else waits_q <= 1'b0;
          end
        end
        MASK_READ: state_q <= MASK_WAIT;
        MASK_WAIT: begin
          point_q <= 12'd0;
          if (answer_valid_i) state_q <= WRITE;
        end
        WRITE: begin
          if (last_write) begin
            point_q <= 12'd0;
            state_q <= has_read ? READ : ANSWERS;
          end
        end
        READ: if (last_read) state_q <= ANSWERS;
        default: begin
          // The last write or answer is through when the phase ends.
          if (!active_q) begin
            state_q <= IDLE;
            waits_q <= 1'b0;
          end
        end
      endcase
    end
  end
  assign busy_o = waits_q;
  assign done_o = done_q;

  // ---- points to accesses: the map's and the buffer's answers are there a clock later -------------------
  wire writing = state_q == WRITE;
  wire issue = writing || state_q == READ || state_q == MASK_READ;
  wire [15:0] first = writing || state_q == MASK_READ ? write_first_q : read_first_q;
  wire [15:0] point = first + {4'd0, point_q};
  assign point_o = point[13:0];
  assign word_o  = words;

  reg mapped_valid_q, mapped_write_q;
  reg [15:0] mapped_raw_q;
  reg [3:0] mapped_bit_q;
  reg access_valid_q, access_write_q, access_exists_q;
  reg [15:0] access_addr_q;
  reg [15:0] access_data_q;
  reg [15:0] masked_q;
  wire [15:0] buffer_data;
  wire exists = raw || exists_i;

  always @(posedge clk_i) begin
    mapped_valid_q <= issue && rst_ni;
    mapped_write_q <= writing;
    mapped_raw_q   <= point;
    mapped_bit_q   <= point_q[3:0];
    // A read of a point without a device is made all the same, so that answers come at one pace.
    access_valid_q <= mapped_valid_q && rst_ni && (exists || !mapped_write_q);
    access_write_q <= mapped_write_q;
    access_exists_q <= exists;
    access_addr_q <= raw ? mapped_raw_q : address_i;
    access_data_q <= mask ? masked_q : words ? buffer_data : {15'd0, buffer_data[mapped_bit_q]};
    if (answer_valid_i && state_q == MASK_WAIT) begin
      masked_q <= (answer_data_i & and_q) | (or_q & ~and_q);
    end
  end
  assign access_valid_o = access_valid_q;
  assign access_write_o = access_write_q;
  assign access_word_o  = words;
  assign access_addr_o  = access_addr_q;
  assign access_data_o  = access_data_q;

  // ---- answers into the buffer --------------------------------------------------------------------------
  reg [ANSWER_CLOCKS-1:0] exists_q;  // of the accesses on their way, the youngest lowest
  reg [15:0] gathered_q;  // bits of the word so far, the lowest first
  always @(posedge clk_i) exists_q <= {exists_q[ANSWER_CLOCKS-2:0], access_exists_q};

  wire [15:0] answer = exists_q[ANSWER_CLOCKS-1] ? answer_data_i : 16'd0;
  wire [15:0] gathered = answers_q[3:0] == 4'd0 ? {15'd0, answer[0]} :
      gathered_q | ({15'd0, answer[0]} << answers_q[3:0]);
  wire store = answered && (words || answers_q[3:0] == 4'd15 || last_answer);
  always @(posedge clk_i) if (answered) gathered_q <= gathered;

  // ---- the buffer -----------------------------------------------------------------------------------------
  (* no_rw_check *) reg [15:0] buffer_ram[0:255];
  reg [15:0] buffer_q;
  reg buffer_we_q;
  reg [7:0] buffer_waddr_q;
  reg [15:0] buffer_wdata_q;
  wire [7:0] buffer_raddr = !waits_q ? buffer_addr_i :
      words ? point_q[7:0] : {1'b0, point_q[10:4]};
  always @(posedge clk_i) begin
    buffer_we_q <= waits_q ? store : buffer_write_i;
    buffer_waddr_q <= waits_q ? READ_BUFFER + (words ? answers_q[7:0] : {1'b0, answers_q[10:4]}) :
        buffer_addr_i;
    buffer_wdata_q <= waits_q ? (words ? answer : gathered) : wdata_i;
    if (buffer_we_q) buffer_ram[buffer_waddr_q] <= buffer_wdata_q;
    buffer_q <= buffer_ram[buffer_raddr];
  end
  assign buffer_data   = buffer_q;
  assign buffer_data_o = buffer_q;

endmodule

`default_nettype wire
