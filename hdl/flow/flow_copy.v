// SPDX-License-Identifier: Apache-2.0
// Carries words between a block of the pool and word devices, one a clock: devices first_i and up or, with
// mapped_i, those that the points first_i and up of the device map are. A point without a device reads 0, and its
// write vanishes. start_i takes what is to be done; done_o is 1 in one clock: for a copy of n words into the
// block the (n + 11)th after it, when they all are there; out of it the (n + 2)th, and the processor may start in the
// second clock after that. put_i: device first_i gets put_data_i; the same holds from the next clock on.
// stop_i: whatever goes on ends.
`default_nettype none

module flow_copy (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        stop_i,
    input  wire        start_i,
    input  wire        put_i,
    input  wire        to_block_i,
    input  wire        mapped_i,
    input  wire [15:0] first_i,
    input  wire [ 5:0] count_i,       // 1 to 32
    input  wire [ 4:0] block_i,
    input  wire [15:0] put_data_i,
    output wire        done_o,
    // pool
    output wire        mem_valid_o,
    output wire        mem_write_o,
    output wire [ 9:0] mem_addr_o,
    output wire [15:0] mem_wdata_o,
    input  wire [15:0] mem_rdata_i,
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
    input  wire [15:0] host_rdata_i
);

  // ---- issue: map and pool are asked ---------------------------------------------------------------
  reg to_block_q;
  reg mapped_q;
  reg [15:0] point_q;
  reg [5:0] left_q;
  reg [5:0] unanswered_q;
  reg [4:0] block_q;
  reg [4:0] index_q;
  wire issue = left_q != 6'd0;
  wire answer;

  always @(posedge clk_i) begin
    if (start_i) begin
      to_block_q <= to_block_i;
      mapped_q <= mapped_i;
      point_q <= first_i;
      block_q <= block_i;
      index_q <= 5'd0;
    end else begin
      if (issue) point_q <= point_q + 16'd1;
      if (to_block_q ? answer : issue) index_q <= index_q + 5'd1;
    end
    if (!rst_ni || stop_i) left_q <= 6'd0;
    else if (start_i) left_q <= count_i;
    else if (issue) left_q <= left_q - 6'd1;
    if (!rst_ni || stop_i) unanswered_q <= 6'd0;
    else if (start_i) unanswered_q <= to_block_i ? count_i : 6'd0;
    else if (answer) unanswered_q <= unanswered_q - 6'd1;
  end

  assign map_read_o  = issue && mapped_q;
  assign map_words_o = 1'b1;
  assign map_point_o = point_q;

  // ---- they answer; the access ------------------------------------------------------------------------
  reg looked_q;
  reg looked_last_q;
  reg [14:0] looked_device_q;
  reg access_q;
  reg access_last_q;
  reg read_q;
  reg write_q;
  reg [14:0] addr_q;
  reg [15:0] data_q;

  always @(posedge clk_i) begin
    looked_q <= rst_ni && !stop_i && issue;
    looked_last_q <= rst_ni && !stop_i && left_q == 6'd1 && !to_block_q;
    looked_device_q <= point_q[14:0];
    access_q <= rst_ni && !stop_i && (put_i || (looked_q && (!mapped_q || map_mapped_i)));
    access_last_q <= rst_ni && !stop_i && looked_last_q;
    read_q <= rst_ni && !stop_i && looked_q && to_block_q;
    write_q <= put_i || !to_block_q;
    addr_q <= put_i ? first_i[14:0] : mapped_q ? map_device_i : looked_device_q;
    data_q <= put_i ? put_data_i : mem_rdata_i;
  end

  assign host_valid_o = access_q;
  assign host_write_o = write_q;
  assign host_words_o = 1'b1;
  assign host_addr_o  = addr_q;
  assign host_data_o  = data_q;

  // ---- answers -------------------------------------------------------------------------------------
  reg [7:0] await_q;
  reg answered_q;
  always @(posedge clk_i) begin
    await_q <= rst_ni && !stop_i ? {await_q[6:0], read_q} : 8'd0;
    answered_q <= rst_ni && !stop_i && answer && unanswered_q == 6'd1;
  end
  assign answer = await_q[7];
  assign done_o = answered_q || access_last_q;

  assign mem_valid_o = answer || (issue && !to_block_q);
  assign mem_write_o = answer;
  assign mem_addr_o  = {block_q, index_q};
  assign mem_wdata_o = host_rdata_i & {16{host_rvalid_i}};

endmodule

`default_nettype wire
