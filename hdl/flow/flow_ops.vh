// SPDX-License-Identifier: Apache-2.0
// Operations of flow_tasks.v; ways of flow_route.v.
`ifndef FLOW_OPS_VH
`define FLOW_OPS_VH

`define FLOW_OP_PEEK 4'd0
`define FLOW_OP_START 4'd1
`define FLOW_OP_STOP 4'd2
`define FLOW_OP_TAKE 4'd3
`define FLOW_OP_END 4'd4
`define FLOW_OP_FREE 4'd5
`define FLOW_OP_WAIT 4'd6
`define FLOW_OP_PAUSE 4'd7
`define FLOW_OP_COME 4'd8
`define FLOW_OP_INIT 4'd9
`define FLOW_OP_GO 4'd10
`define FLOW_OP_ASK 4'd11

`define FLOW_WAY_REFUSED 2'd0
`define FLOW_WAY_LOCAL 2'd1
`define FLOW_WAY_PANEL 2'd2
`define FLOW_WAY_LINK 2'd3

`endif
