// SPDX-License-Identifier: Apache-2.0
// What is loaded (hdl/controller/load_spaces.v): each word that is written to load_data goes, in the next clock, to the one space
// that was named, at addresses that count up; nothing else writes any. The processor's spaces are written only while
// idle_i says that no scan is under way, so that no half program ever runs; its length is kept, and given back when it is asked.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"

module load_spaces_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        idle_i,
    input wire        restore_i,
    input wire        sel_register_i,
    input wire [ 7:0] addr_i,
    input wire        write_i,
    input wire [15:0] wdata_i
);

  wire host_valid, io_write, bit_map_write, word_map_write, setup_write;
  wire [ 2:0] host_space;
  wire [19:0] host_addr;
  wire [15:0] host_data, addr, data;
  wire [3:0] flow_write;
  load_spaces load (
      .clk_i           (clk_i),
      .rst_ni          (rst_ni),
      .idle_i          (idle_i),
      .restore_i       (restore_i),
      .host_valid_o    (host_valid),
      .host_space_o    (host_space),
      .host_addr_o     (host_addr),
      .host_data_o     (host_data),
      .io_write_o      (io_write),
      .bit_map_write_o (bit_map_write),
      .word_map_write_o(word_map_write),
      .setup_write_o   (setup_write),
      .flow_write_o    (flow_write),
      .addr_o          (addr),
      .data_o          (data),
      .sel_register_i  (sel_register_i),
      .addr_i          (addr_i),
      .write_i         (write_i),
      .wdata_i         (wdata_i)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  wire write = sel_register_i && write_i;
  reg [1:0] named_q;  // space and address are known
  reg [3:0] space_q;
  reg [19:0] next_q;
  reg loads_q;
  reg known_q;
  reg [3:0] to_q;
  reg [19:0] at_q;
  reg [15:0] word_q;
  reg [15:0] length_q;
  wire load_now = write && addr_i == `RUNG_REG_LOAD_DATA;
  always @* assume (!load_now || !begun_q || named_q == 2'b11);  // space and address come first
  always @* assume (!restore_i || !idle_i);  // as scan_controller.v has them

  always @(posedge clk_i) begin
    if (!begun_q) named_q <= 2'b00;
    else if (write && addr_i == `RUNG_REG_LOAD_SPACE) begin
      named_q[0] <= 1'b1;
      space_q <= wdata_i[3:0];
      next_q[19:16] <= wdata_i[11:8];
    end else if (write && addr_i == `RUNG_REG_LOAD_ADDRESS) begin
      named_q[1]   <= 1'b1;
      next_q[15:0] <= wdata_i;
    end else if (load_now) next_q <= next_q + 20'd1;
    loads_q <= rst_ni && load_now;
    {at_q, word_q} <= {next_q, wdata_i};
    if (!rst_ni) length_q <= 16'd0;
    else if (loads_q && idle_i && space_q == `RUNG_SPACE_LENGTH) length_q <= word_q;
  end

  wire to_processor = loads_q && idle_i && space_q <= `RUNG_SPACE_PORTS;
  wire [7:0] writes = {flow_write, setup_write, word_map_write, bit_map_write, io_write};
  wire [15:0] one = 16'd1 << space_q;
  always @* begin
    if (begun_q) begin
      assert (host_valid == (to_processor || restore_i));
      if (to_processor) begin
        assert ({1'b0, host_space} == space_q && host_addr == at_q && host_data == word_q);
      end
      if (restore_i) assert (host_space == `RUNG_SPACE_LENGTH && host_data == length_q);
      // One space at most, and the one that was named.
      assert (writes == (loads_q ? {one[`RUNG_SPACE_FLOW_SETUP], one[`RUNG_SPACE_FLOW_TASKS],
                                    one[`RUNG_SPACE_FLOW_TRANSFERS], one[`RUNG_SPACE_FLOW_STEPS],
                                    one[`RUNG_SPACE_SETUP], one[`RUNG_SPACE_WORD_MAP],
                                    one[`RUNG_SPACE_BIT_MAP], one[`RUNG_SPACE_IO]} : 8'd0));
      if (loads_q) assert (addr == at_q[15:0] && data == word_q);
    end
  end

  // For the induction.
  (* hierconn *) wire [3:0] \load.space_q ;
  (* hierconn *) wire [19:0] \load.next_q ;
  (* hierconn *) wire \load.valid_q ;
  (* hierconn *) wire [19:0] \load.addr_q ;
  (* hierconn *) wire [15:0] \load.data_q ;
  (* hierconn *) wire [15:0] \load.length_q ;
  always @* begin
    if (begun_q) begin
      assert (\load.valid_q == loads_q && \load.length_q == length_q);
      if (named_q == 2'b11) assert (\load.space_q == space_q && \load.next_q == next_q);
      if (named_q[0]) assert (\load.space_q == space_q && \load.next_q [19:16] == next_q[19:16]);
      if (named_q[1]) assert (\load.next_q [15:0] == next_q[15:0]);
      if (loads_q) assert (named_q == 2'b11 && \load.addr_q == at_q && \load.data_q == word_q);
    end
  end

  always @* begin
    cover (begun_q && host_valid && host_addr == 20'h30002 && host_space == 3'd0);
    cover (begun_q && restore_i && host_data == 16'd77);
  end

endmodule

`default_nettype wire
