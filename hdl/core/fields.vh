// SPDX-License-Identifier: Apache-2.0
// Where the fields of one slot's instruction are (hdl/isa/README.md, "Layout"). Included inside a
// module that has the parameters LOOKUP (1: MPU2 and MPU3, 0: MPU1), BIT_ADDR and WORD_ADDR (bits of
// a device number); each uses some of these (Verilator's waiver files do not reach included files).
// verilator lint_off UNUSEDPARAM
localparam OPERAND_BITS = LOOKUP != 0 ? BIT_ADDR + 1 : BIT_ADDR;

// sources
localparam RS_AT = `RUNG_WORD_BITS;
localparam B_AT = BIT_ADDR + 1;
localparam BIT_SOURCE_BITS = 2 * (BIT_ADDR + 1);
localparam WORD_SOURCE_BITS = RS_AT + WORD_ADDR;

// destination: c or rd. MPU1's only bit operand, which is also what it writes, stands here.
localparam DEST_AT = BIT_SOURCE_BITS > WORD_SOURCE_BITS ? BIT_SOURCE_BITS : WORD_SOURCE_BITS;
localparam DEST_BITS = OPERAND_BITS > WORD_ADDR ? OPERAND_BITS : WORD_ADDR;
localparam A_AT = LOOKUP != 0 ? 0 : DEST_AT;

// tail
localparam U_AT = DEST_AT + DEST_BITS;
localparam KIND_AT = U_AT + 1;
localparam ROW_AT = U_AT;
localparam WORD_TAIL_BITS = 1 + `RUNG_KIND_BITS;
localparam ROW_BITS = LOOKUP != 0 ? `RUNG_ROW_BITS : 0;
localparam TAIL_BITS = ROW_BITS > WORD_TAIL_BITS ? ROW_BITS : WORD_TAIL_BITS;

localparam OP_AT = U_AT + TAIL_BITS;
localparam SLOT_BITS = OP_AT + `RUNG_OP_BITS;
// verilator lint_on UNUSEDPARAM
