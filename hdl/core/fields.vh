// SPDX-License-Identifier: Apache-2.0
// Where the fields of one slot's instruction are (hdl/isa/README.md, "Layout"). Included inside a
// module that has the parameters LOOKUP (1: MPU2 and MPU3, 0: MPU1), BIT_ADDR and WORD_ADDR (bits of
// a device number); each uses some of these (Verilator's waiver files do not reach included files).
// verilator lint_off UNUSEDPARAM
localparam OPERAND_BITS = BIT_ADDR + 1;
localparam C_AT = 0;
localparam B_AT = OPERAND_BITS;
localparam A_AT = LOOKUP != 0 ? 2 * OPERAND_BITS : 0;
localparam ROW_AT = 3 * OPERAND_BITS;
localparam BIT_U_AT = LOOKUP != 0 ? ROW_AT : BIT_ADDR;
localparam BIT_FORMAT_BITS = LOOKUP != 0 ? ROW_AT + `RUNG_ROW_BITS : OPERAND_BITS;

localparam RS_AT = `RUNG_WORD_BITS;
localparam RD_AT = RS_AT + WORD_ADDR;
localparam KIND_AT = RD_AT + WORD_ADDR;
localparam WORD_U_AT = KIND_AT + `RUNG_KIND_BITS;
localparam WORD_FORMAT_BITS = WORD_U_AT + 1;

localparam OP_AT = BIT_FORMAT_BITS > WORD_FORMAT_BITS ? BIT_FORMAT_BITS : WORD_FORMAT_BITS;
localparam SLOT_BITS = OP_AT + `RUNG_OP_BITS;
// verilator lint_on UNUSEDPARAM
