// SPDX-License-Identifier: Apache-2.0
// Registers load_* of hdl/isa/controller.toml: a write of load_data becomes, in the next clock, a write of a
// space. Spaces 0 to 5 go to the processor's port while idle_i is 1, and are lost otherwise. The length of
// the program is also kept: what a reset of the processor takes away, restore_i gives back.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"

module load_spaces (
    input  wire        clk_i,
    input  wire        rst_ni,
    // scan
    input  wire        idle_i,
    input  wire        restore_i,
    // the processor's port
    output wire        host_valid_o,
    output wire [ 2:0] host_space_o,
    output wire [19:0] host_addr_o,
    output wire [15:0] host_data_o,
    // the controller's spaces
    output wire        io_write_o,
    output wire        bit_map_write_o,
    output wire        word_map_write_o,
    output wire        setup_write_o,
    output wire [ 3:0] flow_write_o,      // steps lowest, transfers, tasks, setup
    output wire [15:0] addr_o,
    output wire [15:0] data_o,
    // bus
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i
);

  localparam [7:0] SPACE = `RUNG_REG_LOAD_SPACE;
  localparam [7:0] ADDRESS = `RUNG_REG_LOAD_ADDRESS;
  localparam [7:0] DATA = `RUNG_REG_LOAD_DATA;
  localparam [3:0] LENGTH = `RUNG_SPACE_LENGTH;
  localparam [3:0] PORTS = `RUNG_SPACE_PORTS;
  localparam [3:0] IO = `RUNG_SPACE_IO;
  localparam [3:0] BIT_MAP = `RUNG_SPACE_BIT_MAP;
  localparam [3:0] WORD_MAP = `RUNG_SPACE_WORD_MAP;
  localparam [3:0] SETUP = `RUNG_SPACE_SETUP;
  localparam [3:0] FLOW_STEPS = `RUNG_SPACE_FLOW_STEPS;
  localparam [3:0] FLOW_TRANSFERS = `RUNG_SPACE_FLOW_TRANSFERS;
  localparam [3:0] FLOW_TASKS = `RUNG_SPACE_FLOW_TASKS;
  localparam [3:0] FLOW_SETUP = `RUNG_SPACE_FLOW_SETUP;

  reg [3:0] space_q;
  reg [19:0] next_q;  // address of the next write
  reg valid_q;
  reg [19:0] addr_q;
  reg [15:0] data_q;
  reg [15:0] length_q;
  wire register_write = sel_register_i && write_i;
  wire port_write = valid_q && idle_i && space_q <= PORTS;

  always @(posedge clk_i) begin
    if (register_write) begin
      case (addr_i)
        SPACE: {next_q[19:16], space_q} <= {wdata_i[11:8], wdata_i[3:0]};
        ADDRESS: next_q[15:0] <= wdata_i;
        DATA: next_q <= next_q + 20'd1;
        default: ;
      endcase
    end
    valid_q <= rst_ni && register_write && addr_i == DATA;
    addr_q  <= next_q;
    data_q  <= wdata_i;

    if (!rst_ni) length_q <= 16'd0;
    else if (port_write && space_q == LENGTH) length_q <= data_q;
  end

  assign host_valid_o = port_write || restore_i;
  assign host_space_o = restore_i ? LENGTH[2:0] : space_q[2:0];
  assign host_addr_o = addr_q;
  assign host_data_o = restore_i ? length_q : data_q;
  assign io_write_o = valid_q && space_q == IO;
  assign bit_map_write_o = valid_q && space_q == BIT_MAP;
  assign word_map_write_o = valid_q && space_q == WORD_MAP;
  assign setup_write_o = valid_q && space_q == SETUP;
  assign flow_write_o[0] = valid_q && space_q == FLOW_STEPS;
  assign flow_write_o[1] = valid_q && space_q == FLOW_TRANSFERS;
  assign flow_write_o[2] = valid_q && space_q == FLOW_TASKS;
  assign flow_write_o[3] = valid_q && space_q == FLOW_SETUP;
  assign addr_o = addr_q[15:0];
  assign data_o = data_q;

endmodule

`default_nettype wire
