// SPDX-License-Identifier: Apache-2.0
// A request of the host, all of its points in one exchange phase: registers exchange_* and the buffer
// exchange_buffer of hdl/isa/controller.toml. A request that is pending when start_i is 1, in the first
// clock of a phase, is carried out in this phase: a point a clock through the device map, writes before reads.
// A phase of points + exchange_clocks clocks is enough; what is not done when the next one starts is cut off.
// restart_i: the phase is given up, and the request begins again with the next one.
// A point without a device reads 0, and its write vanishes. If the processor does not answer (it is held in
// reset), reads give 0. Registers and buffer are not to be touched from a request's start until
// exchange_status says that it is done.
// Bus: select, address and data in the clock of read_i or write_i; rdata_o in the clock after read_i, else 0.
`default_nettype none
`include "rung_controller.vh"

module host_exchange (
    input  wire        clk_i,
    input  wire        rst_ni,
    // scan
    input  wire        start_i,
    input  wire        restart_i,
    // device map
    output wire        map_read_o,
    output wire        map_words_o,
    output wire [15:0] map_point_o,
    input  wire        map_mapped_i,
    input  wire [14:0] map_device_i,
    // devices: the host's side of port_exchange.v, whose answers come in the eighth clock
    output wire        host_valid_o,
    output wire        host_write_o,
    output wire        host_words_o,
    output wire [14:0] host_addr_o,
    output wire [15:0] host_data_o,
    input  wire        host_rvalid_i,
    input  wire [15:0] host_rdata_i,
    // bus
    input  wire        sel_buffer_i,
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o
);

  localparam [7:0] CONTROL = `RUNG_REG_EXCHANGE_CONTROL;
  localparam [7:0] STATUS = `RUNG_REG_EXCHANGE_STATUS;
  localparam [7:0] WRITE_FIRST = `RUNG_REG_EXCHANGE_WRITE_FIRST;
  localparam [7:0] WRITE_COUNT = `RUNG_REG_EXCHANGE_WRITE_COUNT;
  localparam [7:0] READ_FIRST = `RUNG_REG_EXCHANGE_READ_FIRST;
  localparam [7:0] READ_COUNT = `RUNG_REG_EXCHANGE_READ_COUNT;
  localparam [7:0] AND = `RUNG_REG_EXCHANGE_AND;
  localparam [7:0] OR = `RUNG_REG_EXCHANGE_OR;

  // ---- the request -----------------------------------------------------------------------------
  reg pending_q;
  reg with_write_q;
  reg with_read_q;
  reg words_q;
  reg raw_q;  // device addresses
  reg mask_q;
  reg [15:0] write_first_q;
  reg [11:0] write_count_q;
  reg [15:0] read_first_q;
  reg [11:0] read_count_q;
  reg [15:0] and_q;
  reg [15:0] or_q;
  wire done;
  wire register_write = sel_register_i && write_i;

  always @(posedge clk_i) begin
    if (register_write) begin
      case (addr_i)
        CONTROL: begin
          {raw_q, with_read_q, with_write_q} <= {wdata_i[3], wdata_i[1:0]};
          {mask_q, words_q} <= {wdata_i[4], wdata_i[2] || wdata_i[4]};
        end
        WRITE_FIRST: write_first_q <= wdata_i;
        WRITE_COUNT: write_count_q <= wdata_i[11:0];
        READ_FIRST: read_first_q <= wdata_i;
        READ_COUNT: read_count_q <= wdata_i[11:0];
        AND: and_q <= wdata_i;
        OR: or_q <= wdata_i;
        default: ;
      endcase
    end
    if (!rst_ni) pending_q <= 1'b0;
    else if (register_write && addr_i == CONTROL) pending_q <= 1'b1;
    else if (done) pending_q <= 1'b0;
  end

  // ---- its course: points of the write, or the word of a mask write there and back, then the read -------
  localparam [2:0] IDLE = 3'd0;
  localparam [2:0] MASK_READ = 3'd1;
  localparam [2:0] MASK_WAIT = 3'd2;
  localparam [2:0] MASK_WRITE = 3'd3;
  localparam [2:0] WRITE = 3'd4;
  localparam [2:0] READ_SETUP = 3'd5;
  localparam [2:0] READ = 3'd6;
  localparam [2:0] DRAIN = 3'd7;  // answers are on their way

  reg [2:0] state_q;
  reg [15:0] point_q;
  reg [11:0] left_q;  // points of this write or read that are not yet issued
  reg [11:0] index_q;  // of the point in its write
  reg [11:0] unanswered_q;  // of the read
  wire answer;
  wire issue = ((state_q == WRITE || state_q == READ) && left_q != 12'd0) ||
      state_q == MASK_READ || state_q == MASK_WRITE;
  wire issue_write = state_q == WRITE || state_q == MASK_WRITE;
  wire last_issue = left_q[11:1] == 11'd0;
  wire all_answered = state_q == DRAIN && unanswered_q == 12'd0;

  assign done = all_answered || (start_i && state_q != IDLE);

  always @(posedge clk_i) begin
    if (!rst_ni || restart_i || done) begin
      state_q <= IDLE;
    end else begin
      case (state_q)
        IDLE:
        if (start_i && pending_q) state_q <= mask_q ? MASK_READ : with_write_q ? WRITE : READ_SETUP;
        MASK_READ: state_q <= MASK_WAIT;
        MASK_WAIT: if (answer) state_q <= MASK_WRITE;
        MASK_WRITE: state_q <= READ_SETUP;
        WRITE: if (last_issue) state_q <= READ_SETUP;
        READ_SETUP: state_q <= READ;
        READ: if (last_issue) state_q <= DRAIN;
        default: ;
      endcase
    end

    if (state_q == READ_SETUP) begin
      point_q <= read_first_q;
      left_q  <= with_read_q ? read_count_q : 12'd0;
    end else if (state_q == IDLE) begin
      point_q <= write_first_q;
      left_q  <= write_count_q;
      index_q <= 12'd0;
    end else if (state_q == WRITE || state_q == READ) begin
      point_q <= point_q + 16'd1;
      left_q  <= left_q - 12'd1;
      index_q <= index_q + 12'd1;
    end
  end

  assign map_read_o  = issue;
  assign map_words_o = words_q;
  assign map_point_o = point_q;

  // ---- point to access: map and buffer, access --------------------------------------------------
  reg looked_q;  // map and buffer answer
  reg looked_write_q;
  reg looked_mask_q;
  reg [3:0] looked_bit_q;
  reg [14:0] looked_point_q;
  reg access_q;
  reg read_q;
  reg host_write_q;
  reg [14:0] host_addr_q;
  reg [15:0] host_data_q;
  reg [15:0] masked_q;
  wire [15:0] buffer_data;
  wire mapped = raw_q || map_mapped_i;

  always @(posedge clk_i) begin
    if (!rst_ni || restart_i) begin
      looked_q <= 1'b0;
      access_q <= 1'b0;
      read_q   <= 1'b0;
    end else begin
      looked_q <= issue;
      access_q <= looked_q && mapped;
      read_q   <= looked_q && !looked_write_q;
    end
    looked_write_q <= issue_write;
    looked_mask_q <= state_q == MASK_WRITE;
    looked_bit_q <= index_q[3:0];
    looked_point_q <= point_q[14:0];
    host_write_q <= looked_write_q;
    host_addr_q <= raw_q ? looked_point_q : map_device_i;
    if (looked_mask_q) host_data_q <= masked_q;
    else host_data_q <= words_q ? buffer_data : {15'd0, buffer_data[looked_bit_q]};
  end

  assign host_valid_o = access_q;
  assign host_write_o = host_write_q;
  assign host_words_o = words_q;
  assign host_addr_o  = host_addr_q;
  assign host_data_o  = host_data_q;

  // ---- answers, to words of the buffer ----------------------------------------------------------
  reg [7:0] await_q;  // reads on their way
  reg [11:0] got_q;  // answers so far
  reg [15:0] gather_q;  // bits of the word under way
  reg store_q;
  reg [6:0] store_addr_q;
  reg [15:0] store_data_q;
  assign answer = await_q[7];
  wire [15:0] answer_data = host_rdata_i & {16{host_rvalid_i}};
  wire [15:0] bit_at = {15'd0, answer_data[0]} << got_q[3:0];
  wire [15:0] gather = (got_q[3:0] == 4'd0 ? 16'd0 : gather_q) | bit_at;
  wire collect = answer && (state_q == READ || state_q == DRAIN);

  always @(posedge clk_i) begin
    if (!rst_ni || restart_i) await_q <= 8'd0;
    else await_q <= {await_q[6:0], read_q};

    if (answer) masked_q <= (answer_data & and_q) | (or_q & ~and_q);
    if (state_q == READ_SETUP) begin
      got_q <= 12'd0;
      unanswered_q <= with_read_q ? read_count_q : 12'd0;
    end else if (collect) begin
      got_q <= got_q + 12'd1;
      unanswered_q <= unanswered_q - 12'd1;
      gather_q <= gather;
    end

    store_q <= collect && (words_q || got_q[3:0] == 4'd15 || unanswered_q == 12'd1);
    store_addr_q <= words_q ? got_q[6:0] : got_q[10:4];
    store_data_q <= words_q ? answer_data : gather;
  end

  // ---- buffer: written and read by the bus, but in the clocks of an exchange that does ---------------
  wire fetch = state_q == WRITE;
  wire [7:0] fetch_addr = words_q ? index_q[7:0] : index_q[11:4];
  wire buffer_read = sel_buffer_i && read_i;
  wire buffer_write = sel_buffer_i && write_i;

  bank_ram #(
      .WIDTH(16),
      .DEPTH(256),
      .ADDR_BITS(8),
      .CLEARED(0)
  ) buffer (
      .clk_i       (clk_i),
      .read_i      (buffer_read || fetch),
      .read_addr_i (fetch ? fetch_addr : addr_i),
      .read_data_o (buffer_data),
      .write_i     (buffer_write || store_q),
      .write_addr_i(store_q ? {1'b1, store_addr_q} : addr_i),
      .write_data_i(store_q ? store_data_q : wdata_i)
  );

  reg buffer_read_q;
  reg status_q;

  always @(posedge clk_i) begin
    buffer_read_q <= buffer_read;
    status_q <= sel_register_i && read_i && addr_i == STATUS && pending_q;
  end

  assign rdata_o = (buffer_data & {16{buffer_read_q}}) | {15'd0, status_q};

endmodule

`default_nettype wire
