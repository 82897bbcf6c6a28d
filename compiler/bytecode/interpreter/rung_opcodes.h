/* SPDX-License-Identifier: Apache-2.0 */
/* The byte code's instructions, the one list behind writer, interpreter, listing and page:
 * RUNG_OPCODE(name, code, operands, effect, meaning). No include guard: it is read several times.
 *
 * operands, a letter each:
 *   b B  a bit device, read or written       w W  a word device, read or written (no constant)
 *   n    a bit number, 0 to 15, one byte     s    a distance in bytes
 *   a A  a window of bits or words: its first device, then how many there are
 *   t    the same of words that are only read: constants, too
 *   c    a count from 1 on, one byte; the letter behind it stands so many times
 * effect, on the result r and the stacks:
 *   .    none: it may stand behind IF         r   uses or changes r
 *   ( )  pushes on or pops the block stack   [ ] = pushes on, pops or reads the branch stack
 */
RUNG_OPCODE(END, 0, "", "r", "the scan ends; the last instruction, and only there")
RUNG_OPCODE(LD, 1, "b", "r", "r <- b")
RUNG_OPCODE(LDI, 2, "b", "r", "r <- not b")
RUNG_OPCODE(AND, 3, "b", "r", "r <- r and b")
RUNG_OPCODE(ANI, 4, "b", "r", "r <- r and not b")
RUNG_OPCODE(OR, 5, "b", "r", "r <- r or b")
RUNG_OPCODE(ORI, 6, "b", "r", "r <- r or not b")
RUNG_OPCODE(BLD, 7, "b", "(", "push r on the block stack; r <- b")
RUNG_OPCODE(BLDI, 8, "b", "(", "push r on the block stack; r <- not b")
RUNG_OPCODE(ANB, 9, "", ")", "r <- r and the popped top of the block stack")
RUNG_OPCODE(ORB, 10, "", ")", "r <- r or the popped top of the block stack")
RUNG_OPCODE(POP, 11, "", ")", "r <- the popped top of the block stack")
RUNG_OPCODE(INV, 12, "", "r", "r <- not r")
RUNG_OPCODE(MPS, 13, "", "[", "push r on the branch stack")
RUNG_OPCODE(MRD, 14, "", "=", "r <- the top of the branch stack")
RUNG_OPCODE(MPP, 15, "", "]", "r <- the popped top of the branch stack")
RUNG_OPCODE(OUT, 16, "B", "r", "B <- r")
RUNG_OPCODE(SET, 17, "B", "r", "if r is 1: B <- 1")
RUNG_OPCODE(RST, 18, "B", "r", "if r is 1: B <- 0")
RUNG_OPCODE(IF, 19, "s", "r", "if r is 0: go on s bytes behind this instruction")
RUNG_OPCODE(ON, 20, "B", ".", "B <- 1")
RUNG_OPCODE(OFF, 21, "B", ".", "B <- 0")
RUNG_OPCODE(MOV, 22, "wW", ".", "W <- w")
RUNG_OPCODE(ADD, 23, "wwW", ".", "W <- w + w, with wrap")
RUNG_OPCODE(SUB, 24, "wwW", ".", "W <- w - w, with wrap")
RUNG_OPCODE(WAND, 25, "wwW", ".", "W <- w and w, bit by bit")
RUNG_OPCODE(WOR, 26, "wwW", ".", "W <- w or w, bit by bit")
RUNG_OPCODE(WXOR, 27, "wwW", ".", "W <- w exclusive-or w, bit by bit")
RUNG_OPCODE(ROL, 28, "wwW", ".", "W <- the first w rotated left by the low four bits of the second")
RUNG_OPCODE(MINU, 29, "wwW", ".", "W <- the smaller w, unsigned")
RUNG_OPCODE(ADD32, 30, "wwwwWW", ".", "32 bits, the low word first each time: W W <- w w + w w")
RUNG_OPCODE(SUB32, 31, "wwwwWW", ".", "the same: W W <- w w - w w")
RUNG_OPCODE(MUL, 32, "wwcW", ".", "W... <- the words, 2 at most, of w * w, signed, lowest first")
RUNG_OPCODE(DIV, 33, "wwcW", ".",
            "W... <- quotient, remainder of w / w, signed, towards 0; by 0: nothing is written and "
            "the error flag goes on; -2^15 / -1 is -2^15, remainder 0")
RUNG_OPCODE(MUL32, 34, "wwwwcW", ".", "W... <- the words, 4 at most, of w w * w w, signed")
RUNG_OPCODE(DIV32, 35, "wwwwcW", ".", "W... <- two words of quotient, two of remainder; as DIV")
RUNG_OPCODE(EQ, 36, "wwB", ".", "B <- w = w")
RUNG_OPCODE(LT, 37, "wwB", ".", "B <- w < w, signed")
RUNG_OPCODE(LTU, 38, "wwB", ".", "B <- w < w, unsigned")
RUNG_OPCODE(LT32, 39, "wwwwB", ".", "B <- w w < w w, signed")
RUNG_OPCODE(TB, 40, "wnB", ".", "B <- bit n of w")
RUNG_OPCODE(GATHER, 41, "cbW", ".", "W <- the bits b..., 16 at most, the first in bit 0")
RUNG_OPCODE(LOADW, 42, "wtW", ".", "W <- word w of the window; 0 outside of it; w is unsigned")
RUNG_OPCODE(STOREW, 43, "wAw", ".", "word w of the window <- the second w; nothing outside of it")
RUNG_OPCODE(LOADB, 44, "waB", ".", "B <- bit w of the window; 0 outside of it")
RUNG_OPCODE(SETB, 45, "wa", ".", "bit w of the window <- 1; nothing outside of it")
RUNG_OPCODE(RSTB, 46, "wa", ".", "bit w of the window <- 0; nothing outside of it")
