# SPDX-License-Identifier: Apache-2.0
"""What ldmicro_report.py measures: rungs with an LDmicro element, and rungs of a typical program.

A template is the lines of a rung between its contact and its coil, whose {n} stands for a number of
its own; {c} is one of the 8 analogue channels.
"""
from __future__ import annotations

import random

FEW = 4
MORE = 16  # copies beyond the first few, which share what is needed once

# Contact and coil alone: what the others are compared with.
PLAIN = ""

COSTS = [
    ("CONTACTS", "CONTACTS X{n} 0"),
    ("CONTACTS, negated", "CONTACTS X{n} 1"),
    ("COIL", "COIL Ra{n} 0 0 0"),
    ("COIL, negated", "COIL Ra{n} 1 0 0"),
    ("COIL, set", "COIL Ra{n} 0 1 0"),
    ("COIL, reset", "COIL Ra{n} 0 0 1"),
    ("PARALLEL of two CONTACTS", "PARALLEL\nCONTACTS X{n} 0\nCONTACTS Ra{n} 0\nEND"),
    ("SHORT", "SHORT"),
    ("OPEN", "OPEN"),
    ("MASTER_RELAY", "MASTER_RELAY"),
    ("OSR", "OSR"),
    ("OSF", "OSF"),
    ("TON", "TON t{n} 500000"),
    ("TOF", "TOF t{n} 500000"),
    ("RTO", "RTO t{n} 500000"),
    ("RES", "RES t{n}"),
    ("CTU", "CTU c{n} 5"),
    ("CTD", "CTD c{n} 5"),
    ("CTC", "CTC c{n} 5"),
    ("EQU, and the other compares", "EQU a{n} b{n}"),
    ("MOVE, of a variable", "MOVE a{n} b{n}"),
    ("MOVE, of a literal", "MOVE a{n} 1234"),
    ("ADD", "ADD a{n} b{n} d{n}"),
    ("SUB", "SUB a{n} b{n} d{n}"),
    ("MUL", "MUL a{n} b{n} d{n}"),
    ("DIV", "DIV a{n} b{n} d{n}"),
    ("SHIFT_REGISTER of 8 stages", "SHIFT_REGISTER s{n}_ 8"),
    ("LOOK_UP_TABLE of 8 rows", "LOOK_UP_TABLE a{n} b{n} 8 0 3 1 4 1 5 9 2 6"),
    ("PIECEWISE_LINEAR of 5 points", "PIECEWISE_LINEAR a{n} b{n} 5 0 0 100 10 200 40 300 90 400 160"),
    ("READ_ADC", "READ_ADC A{c}"),
    ("SET_PWM", "SET_PWM a{n} 1000"),
    ("PERSIST", "PERSIST a{n}"),
    ("UART_SEND", "UART_SEND a{n}"),
    ("UART_RECV", "UART_RECV a{n}"),
    ("FORMATTED_STRING of 8 characters", "FORMATTED_STRING (none) 8 114 117 110 110 105 110 103 33"),
    ("FORMATTED_STRING of a sign and 4 digits", "FORMATTED_STRING a{n} 3 92 45 52"),
]


def file_of(rungs: list[str], cycle_us: int = 10000) -> str:
    """A file with these rungs, each the lines between RUNG and END."""
    return "\n".join(["LDmicro0.1", f"CYCLE={cycle_us}", "CRYSTAL=16000000", "BAUD=9600", "", "PROGRAM",
                      *(f"RUNG\n{rung}\nEND" if rung else "RUNG\nEND" for rung in rungs)]) + "\n"


def copies(template: str, count: int) -> str:
    """A file of `count` rungs with the template, each with devices of its own."""
    rungs = []
    for n in range(count):
        lines = [f"CONTACTS R{n} 0", template.format(n=n, c=n % 8), f"COIL Y{n} 0 0 0"]
        rungs.append("\n".join(line for line in lines if line))
    return file_of(rungs)


def typical(count: int, seed: int) -> str:
    """A stand-in for a real program: mostly contacts and coils, some timers, counters and words."""
    chance = random.Random(seed)

    def bit() -> str:
        kind = chance.random()
        name = f"X{chance.randrange(count // 4)}" if kind < 0.4 else f"R{chance.randrange(count // 2)}"
        return f"CONTACTS {name} {int(chance.random() < 0.3)}"

    def word() -> str:
        return f"v{chance.randrange(count // 8)}"

    middles = [
        (60, lambda n: ""),
        (10, lambda n: f"TON t{n} {chance.randrange(2, 500) * 10000}"),
        (4, lambda n: f"TOF t{n} {chance.randrange(2, 500) * 10000}"),
        (5, lambda n: f"CTU c{n} {chance.randrange(1, 100)}"),
        (3, lambda n: f"CTC c{n} {chance.randrange(1, 100)}"),
        (6, lambda n: f"GRT {word()} {chance.randrange(-100, 1000)}"),
        (4, lambda n: "OSR"),
        (4, lambda n: f"OSR\nADD {word()} {word()} {chance.randrange(1, 10)}"),
        (3, lambda n: f"MOVE {word()} {chance.randrange(0, 1000)}"),
        (1, lambda n: f"MUL {word()} {word()} 3"),
    ]
    rungs = []
    for n in range(count):
        lines = [bit()]
        if chance.random() < 0.4:  # a seal-in
            lines = ["PARALLEL", bit(), f"CONTACTS R{n // 2} 0", "END", bit()]
        elif chance.random() < 0.5:
            lines.append(bit())
        middle = chance.choices([m for _, m in middles], [w for w, _ in middles])[0](n)
        if middle:
            lines.append(middle)
        lines.append(f"COIL {'Y' if n % 3 == 0 else 'R'}{n // 2} 0 0 0")
        rungs.append("\n".join(lines))
    return file_of(rungs)
