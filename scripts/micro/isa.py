# SPDX-License-Identifier: Apache-2.0
"""The micro-sequencer's instructions, as hdl/controller/micro/micro_sequencer.v executes them.

A word is 11 and a 2-bit kind with 12 bits of program address, or a 5-bit opcode below 24 with an 11-bit operand.

EQ, EQI, LTU and LTUI leave acc as it is: JZ and JNZ behind them, with only JUMP, CALL and RETURN between, go by the
test; behind anything else by acc.
"""
from __future__ import annotations

from dataclasses import dataclass

COMPARES = ("EQ", "LTU", "EQI", "LTUI")
JUMPS = {"JUMP": 0, "JZ": 1, "JNZ": 2, "CALL": 3}

# Two instructions of one opcode: the second has the operand's highest bit set.
HALF = 32
# name -> (opcode, what the operand is, meaning)
OPCODES = {
    "LOAD": (0, "ram", "acc = ram[n]"),
    "STORE": (1, "ram", "ram[n] = acc"),
    "ADD": (2, "ram", "acc = acc + ram[n]"),
    "SUB": (3, "ram", "acc = acc - ram[n]"),
    "AND": (4, "ram", "acc = acc & ram[n]"),
    "OR": (5, "ram", "acc = acc | ram[n]"),
    "XOR": (6, "ram", "acc = acc ^ ram[n]"),
    "EQ": (7, "ram", "test = acc == ram[n]"),
    "LTU": (8, "ram", "test = acc < ram[n], unsigned"),
    "LOADX": (9, "index", "acc = ram[n + acc]"),
    "STOREX": (9 | HALF, "index", "ram[n + x] = acc"),
    "LOADI": (10, "number", "acc = n"),
    "ADDI": (11, "number", "acc = acc + n"),
    "SUBI": (12, "number", "acc = acc - n"),
    "ANDI": (13, "number", "acc = acc & n"),
    "ORI": (14, "number", "acc = acc | n"),
    "XORI": (15, "number", "acc = acc ^ n"),
    "EQI": (16, "number", "test = acc == n"),
    "LTUI": (17, "number", "test = acc < n, unsigned"),
    "ORH": (18, "number", "acc = acc | n << 11, the low 5 bits of n"),
    "SHIFT": (19, "number", "acc = acc << n, if bit 4 of n is set >> (n & 15); a clock more for each bit"),
    "INDEX": (20, "variable", "x = ram[n]"),
    "CLEAR": (20 | HALF, "variable", "ram[n] = 0"),
    "IN": (21, "register", "acc = bus[n]"),
    "OUT": (21 | HALF, "register", "bus[n] = acc"),
    "INC": (22, "variable", "acc = ram[n] = ram[n] + 1"),
    "DEC": (22 | HALF, "variable", "acc = ram[n] = ram[n] - 1"),
    "MISC": (23, "misc", "see below"),
}
MISC = {
    "SETX": (0, "x = acc"),
    "NOT": (1, "acc = ~acc"),
    "RETURN": (2, "back behind the last CALL that has not returned"),
    "INX": (3, "acc = bus[acc]"),
    "OUTX": (4, "bus[x] = acc"),
    "TEST": (5, "acc = test, 1 or 0"),
}
OPERAND_BITS = 11
MOST = (1 << OPERAND_BITS) - 1
TARGET_BITS = 12
RETURN_DEPTH = 16


@dataclass
class Instruction:
    """One instruction; `operand` is a number, a variable's name with an offset, or a label."""
    name: str
    operand: int | str | tuple[str, int] = 0

    def __str__(self) -> str:
        operand = self.operand
        if isinstance(operand, tuple):
            operand = operand[0] + (f"+{operand[1]}" if operand[1] else "")
        bare = self.name in MISC
        return self.name if bare else f"{self.name} {operand}"


@dataclass
class Label:
    """A place in the code."""
    name: str


def encode(name: str, operand: int) -> int:
    """The word of an instruction whose operand is a number."""
    if name in JUMPS:
        assert 0 <= operand < 1 << TARGET_BITS, (name, operand)
        return 0xC000 | JUMPS[name] << TARGET_BITS | operand
    if name in MISC:
        return OPCODES["MISC"][0] << OPERAND_BITS | MISC[name][0]
    opcode = OPCODES[name][0]
    high = OPERAND_BITS - 1
    halved = any(other[0] == opcode ^ HALF for other in OPCODES.values())
    assert 0 <= operand < 1 << (high if halved else OPERAND_BITS), (name, operand)
    return (opcode % HALF) << OPERAND_BITS | opcode // HALF << high | operand


def table() -> str:
    """The instructions as the README has them."""
    rows = ["| Instruction | Word | Does |", "|---|---|---|"]
    for name, (_, kind, meaning) in OPCODES.items():
        if name != "MISC":
            rows.append(f"| {name} n | {encode(name, 0):04x} | {meaning} |")
    rows += [f"| {name} | {encode(name, 0):04x} | {meaning} |" for name, (_, meaning) in MISC.items()]
    meanings = {"JUMP": "to t", "JZ": "to t if acc, or the test, is 0", "JNZ": "to t if it is not", "CALL": "to t, until RETURN"}
    rows += [f"| {name} t | {encode(name, 0):04x} | {meanings[name]} |" for name in JUMPS]
    return "\n".join(rows) + "\n"
