# SPDX-License-Identifier: Apache-2.0
"""What programs_report.py measures: rungs with an instruction, and the rungs to compare them with.

A template is a rung whose {n}, {o}, {a} ... stand for numbers of its own (see copies).
"""
from __future__ import annotations

import random

COPIES = 16
FEW_COPIES = 4  # of what takes hundreds of steps


def copies(template: str, count: int) -> str:
    """A list of `count` times the template, each time with devices of its own."""
    rungs = []
    for n in range(count if template else 0):
        a, b, c = 12 * n, 12 * n + 4, 12 * n + 8
        rungs.append(template.format(
            n=n, o=f"{n:o}", x=f"{16 * n:o}", m=300 + 20 * n, a=a, b=b, c=c, a1=a + 1, b1=b + 1,
            c1=c + 1, r=n % 6))
    return "\n".join([*rungs, "NOP", "END"]) + "\n"


COIL = "LD M{n}\nOUT Y{o}"
NOTHING = "LD M{n}\nOUT Y{o}\nLD M{n}\nOUT M1{n:02}"

TIMER = "timer: OUT T K, 100 ms"
COSTS = [
    ("contact and coil: LD M, OUT Y", COIL + "\nLD M{n}\nOUT M1{n:02}", COIL),
    (TIMER, "LD M{n}\nOUT T{n} K50", COIL),
    ("counter: OUT C K, with its RST", "LD M{n}\nOUT C{n} K50\nLD M1{n:02}\nRST C{n}",
     NOTHING),
    ("32-bit up/down counter: OUT C200 K, with its RST",
     "LD M{n}\nOUT C2{n:02} K50\nLD M1{n:02}\nRST C2{n:02}", NOTHING),
    ("edge contact: LDP for LD", "LDP M{n}\nOUT Y{o}", COIL),
    ("edge coil: PLS for OUT", "LD M{n}\nPLS M1{n:02}", COIL),
    ("pulse form: MOVP", "LD M{n}\nMOVP D{a} D{b}", COIL),
    ("MOV", "LD M{n}\nMOV D{a} D{b}", COIL),
    ("master control: MC, MCR around one rung",
     "LD M{n}\nMC N0 M1{n:02}\nLD M2{n:02}\nOUT Y{o}\nMCR N0", "LD M2{n:02}\nOUT Y{o}"),
    ("state: STL around one output", "STL S{n}\nOUT Y{o}\nRET", COIL),
    ("compare contact: LD= for LD", "LD= D{a} D{b}\nOUT Y{o}", COIL),
    ("32-bit compare contact: LDD> for LD", "LDD> D{a} D{b}\nOUT Y{o}", COIL),
    ("MOV K4X0 D0", "LD M{n}\nMOV K4X{x} D{a}", COIL),
    ("MOV D0 K4M0", "LD M{n}\nMOV D{a} K4M{m}", COIL),
    ("ADD", "LD M{n}\nADD D{a} D{b} D{b}", COIL),
    ("DADD", "LD M{n}\nDADD D{a} D{b} D{b}", COIL),
    ("MUL", "LD M{n}\nMUL D{a} D{b} D{b}", COIL),
    ("DMUL", "LD M{n}\nDMUL D{a} D{b} D{b}", COIL),
    ("DIV", "LD M{n}\nDIV D{a} D{b} D{b}", COIL),
    ("DDIV", "LD M{n}\nDDIV D{a} D{b} D{b}", COIL),
    ("BCD", "LD M{n}\nBCD D{a} D{b}", COIL),
    ("BIN", "LD M{n}\nBIN D{a} D{b}", COIL),
    ("CMP", "LD M{n}\nCMP D{a} D{b} M{m}", COIL),
    ("ROL by 3", "LD M{n}\nROL D{a} K3", COIL),
    ("SFTL, 16 bits by 1", "LD M{n}\nSFTL X{o} M{m} K16 K1", COIL),
    ("indexed MOV D0Z0 D1", "LD M{n}\nMOV D{a}Z0 D{b}", COIL),
    ("CJ over one rung", "LD M{n}\nCJ P{n}\nLD M2{n:02}\nOUT Y{o}\nP{n}",
     "LD M2{n:02}\nOUT Y{o}"),
]

_BITS = "LD M8000\nMOV K0 D{a}\n" + "\n".join(
    f"LD X{bit:o}\nWOR D{{a}} H{1 << bit:X} D{{a}}" for bit in range(16))
# The carry of the low words: the sum is below an operand, both taken without a sign, which the
# signed compare does when the highest bits are turned.
_ADD = ("LD M{n}\nADD D{a} D{b} D{c}\nLD M8000\nWXOR D{c} H8000 D1001\nWXOR D{b} H8000 D1002\n"
        "LD M{n}\nADD D{a1} D{b1} D{c1}\nLD M{n}\nAND< D1001 D1002\nINC D{c1}")
_DIVIDE = ("LD SM400\nDMOV K0 D{c}\nFOR K32\nLD SM400\nDRCL D{a} K1\nDRCL D{c} K1\n"
           "LDD>= D{c} D{b}\nOUT SM700\nD- D{c} D{b} D{c}\nNEXT\nLD SM400\nDRCL D{a} K1")
_SELECT = "LD M8000\n" + "\n".join(f"LD= Z0 K{i}\nMOV D2{i:02} D{{b}}" for i in range(16))

WITHOUT = [
    ("K4X0 into a word, with GET", "LD M8000\nMOV K4X{x} D{a}", ""),
    ("the same bit by bit", _BITS, ""),
    ("32-bit sum, with the carry", "LD M{n}\nDADD D{a} D{b} D{c}", ""),
    ("the same with 16-bit sums and a compare", _ADD, ""),
    ("32-bit division, with the unit", "LD M8000\nDDIV D{a} D{b} D{c}", ""),
    ("the same as 32 restoring steps (unsigned)", _DIVIDE, ""),
    ("indexed read, any of 128 words", "LD M8000\nMOV D200Z0 D{b}", ""),
    ("the same as 16 compares (of 16 words)", _SELECT[len("LD M8000\n"):], ""),
]


def large_program(instructions: int, seed: int) -> str:
    """A list of so many instructions, mixed as in real programs: mostly contacts and coils."""
    chance = random.Random(seed)

    def bit() -> str:
        kind = chance.random()
        if kind < 0.25:
            return f"X{chance.randrange(128):o}"
        return f"M{chance.randrange(1000)}" if kind < 0.9 else f"T{chance.randrange(60)}"

    def word() -> str:
        return f"D{2 * chance.randrange(200)}"

    outputs = [
        (70, lambda: f"OUT M{chance.randrange(1000)}"),
        (6, lambda: f"OUT T{chance.randrange(60)} K{chance.randrange(1, 200)}"),
        (6, lambda: f"MOV {word()} {word()}"),
        (6, lambda: f"ADD {word()} K{chance.randrange(100)} {word()}"),
        (2, lambda: f"SET M{chance.randrange(1000)}"),
        (2, lambda: f"RST M{chance.randrange(1000)}"),
        (2, lambda: f"INCP {word()}"),
        (2, lambda: f"PLS M{chance.randrange(1000)}"),
        (1, lambda: f"MOV K4M{chance.randrange(980)} {word()}"),
        (1, lambda: f"DADD {word()} {word()} {word()}"),
        (1, lambda: f"DIV {word()} {word()} {word()}"),
        (1, lambda: f"OUT Y{chance.randrange(64):o}"),
    ]
    lines: list[str] = []
    while len(lines) < instructions:
        room = instructions - len(lines) - 2
        lines.append(chance.choice(["LD ", "LD ", "LDI "]) + bit())
        for _ in range(min(room, chance.choice([0, 0, 1, 1, 2, 2, 3, 4]))):
            lines.append(chance.choice(["AND ", "ANI ", "OR ", "ORI "]) + bit())
        lines.append(chance.choices([o for _, o in outputs], [w for w, _ in outputs])[0]())
    return "\n".join([*lines, "END"]) + "\n"
