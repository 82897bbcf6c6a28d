// SPDX-License-Identifier: Apache-2.0
// The lasting memory's registers (hdl/controller/keep_port.v): a value that the program hands over waits, unchanged, until the
// firmware says that it is done, and the program is told to wait all that time and after a reset: none is lost.
`default_nettype none
`include "rung_controller.vh"

module keep_port_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        keep_valid_i,
    input wire [ 5:0] keep_index_i,
    input wire [15:0] keep_value_i,
    input wire        sel_register_i,
    input wire [ 7:0] addr_i,
    input wire        read_i,
    input wire        write_i,
    input wire [15:0] wdata_i
);

  wire ready;
  wire [15:0] rdata;
  keep_port port (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .ready_o       (ready),
      .keep_valid_i  (keep_valid_i),
      .keep_index_i  (keep_index_i),
      .keep_value_i  (keep_value_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .write_i       (write_i),
      .wdata_i       (wdata_i),
      .rdata_o       (rdata)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);
  // The program hands over what it may.
  always @* assume (!keep_valid_i || ready);

  reg waits_q;
  reg [21:0] value_q;
  reg open_q;  // the firmware has said that its memory is there
  wire done = sel_register_i && write_i && addr_i == `RUNG_REG_KEEP_DONE;
  always @(posedge clk_i) begin
    if (!rst_ni) {waits_q, open_q} <= 2'b00;
    else begin
      waits_q <= keep_valid_i || (waits_q && !(done && wdata_i[0]));
      if (done) open_q <= wdata_i[0];
    end
    if (keep_valid_i) value_q <= {keep_index_i, keep_value_i};
  end

  reg [2:0] asked_q;
  reg reads_q;
  reg waited_q;
  reg [21:0] before_q;
  always @(posedge clk_i) begin
    reads_q <= begun_q && sel_register_i && read_i;
    asked_q <= {addr_i == `RUNG_REG_KEEP_VALUE, addr_i == `RUNG_REG_KEEP_INDEX,
                addr_i == `RUNG_REG_KEEP_STATUS};
    waited_q <= waits_q;
    before_q <= value_q;
  end
  always @* begin
    if (begun_q) begin
      assert (ready == (open_q && !waits_q));
      if (reads_q && asked_q[0]) assert (rdata == {15'd0, waited_q});
      if (reads_q && waited_q && asked_q[1]) assert (rdata == {10'd0, before_q[21:16]});
      if (reads_q && waited_q && asked_q[2]) assert (rdata == before_q[15:0]);
    end
  end

  // For the induction.
  (* hierconn *) wire \port.ready_q ;
  (* hierconn *) wire \port.wanted_q ;
  (* hierconn *) wire [5:0] \port.index_q ;
  (* hierconn *) wire [15:0] \port.value_q ;
  always @* begin
    if (begun_q) begin
      assert (\port.ready_q == open_q && \port.wanted_q == waits_q);
      if (waits_q) assert ({\port.index_q , \port.value_q } == value_q);
    end
  end

  always @* cover (begun_q && reads_q && waited_q && asked_q[2] && rdata == 16'h1234);

endmodule

`default_nettype wire
