# SPDX-License-Identifier: Apache-2.0
"""The table of instructions in hdl/controller/micro/README.md, from the assembler's own.

usage: PYTHONPATH=scripts python3 -m micro.page [--write]    without it: exit 1 if the page is not up to date
"""
from __future__ import annotations

import sys
from pathlib import Path

from micro.isa import JUMPS, MISC, OPCODES, OPERAND_BITS, TARGET_BITS, encode

PAGE = Path(__file__).resolve().parents[2] / "hdl" / "controller" / "micro" / "README.md"
BEGIN, END = "<!-- instructions: python3 -m micro.page --write -->\n", "<!-- end of instructions -->\n"
JUMP_MEANINGS = {"JUMP": "to n", "JZ": "to n if the test, or acc, is 0", "JNZ": "to n if it is not 0",
                 "CALL": "to n; RETURN comes back"}


def table() -> str:
    out = ["| instruction | word | operand | meaning |\n", "|---|---|---|---|\n"]
    for name, (_, operand, meaning) in OPCODES.items():
        if name not in JUMPS and name != "MISC":
            out.append(f"| `{name}` n | `{encode(name, 0):04x}` + n | {operand} | {meaning.replace('|', '&#124;')} |\n")
    for name, (_, meaning) in MISC.items():
        out.append(f"| `{name}` | `{encode(name, 0):04x}` | | {meaning.replace('|', '&#124;')} |\n")
    for name in JUMPS:
        out.append(f"| `{name}` n | `{encode(name, 0):04x}` + n | program | {JUMP_MEANINGS[name]} |\n")
    out.append(f"\nOperands have at most {OPERAND_BITS} bits, places in the program {TARGET_BITS}.\n")
    return "".join(out)


def main() -> int:
    text = PAGE.read_text()
    head, _, rest = text.partition(BEGIN)
    _, found, tail = rest.partition(END)
    if not found:
        print(f"{PAGE}:1:1: error: the marks around the table are not there", file=sys.stderr)
        return 1
    new = head + BEGIN + table() + END + tail
    if sys.argv[1:] == ["--write"]:
        PAGE.write_text(new)
    elif new != text:
        print(f"{PAGE}:1:1: error: the table is not what scripts/micro/isa.py says: "
              "PYTHONPATH=scripts python3 -m micro.page --write", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
