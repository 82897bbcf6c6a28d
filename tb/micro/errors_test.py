#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What is not in the language is refused where it stands; the README's table of instructions is isa.py's."""
from __future__ import annotations

import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
try:
    from micro.compile import compile_text
except ImportError:                       # pycparser is the system's
    if sys.executable == "/usr/bin/python3":
        raise
    os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])
from micro.front import FirmwareError  # noqa: E402
from micro.isa import MISC, OPCODES, table  # noqa: E402

MICRO = {"ram_words": 512, "rom_words": 4096}
HEAD = "typedef unsigned short u16; u16 io_read(u16 address); void io_write(u16 address, u16 value);\n"
ENTRIES = "\nvoid firmware_reset(void) { %s }\nvoid firmware_poll(void) { }\n"

# declarations, body of firmware_reset, line:column or line, what the error says
CASES = [
    ("u16 f(u16 n) { return g(n); }\nu16 g(u16 n) { return f(n); }", "f(1);", "", "recursion: firmware_reset -> f -> g -> f"),
    ("u16 f(void) { return f(); }", "f();", "2", "recursion"),
    ("", "u16 a[4];", "3:33", "arrays stand outside"),
    ("", "u16 *p;", "3", "only u16"),
    ("u16 *p;", "", "2", "only u16"),
    ("int n;", "", "2", "only u16"),
    ("u16 g = 5;", "", "2:5", "no initialiser"),
    ("u16 g; u16 g;", "", "2", "stands twice"),
    ("u16 a[n];", "", "2", "constant size"),
    ("u16 g;", "u16 g;", "3", "hides a global"),
    ("", "u16 k; { u16 k; }", "3", "stands twice"),
    ("", "x = 1;", "3", "x is not declared"),
    ("u16 a[4];", "a[4] = 1;", "3", "a has 4 words"),
    ("u16 a[4];", "a = 1;", "3", "a is an array"),
    ("u16 g;", "g[0] = 1;", "3", "no array"),
    ("u16 g;", "g = g / 3;", "3", "operator /"),
    ("u16 g;", "g = g * 3;", "3", "powers of two"),
    ("u16 g;", "g = g << g;", "3", "shifts are by constants"),
    ("u16 g;", "g = g << 16;", "3", "more than 15"),
    ("u16 g;", "g = 1.5;", "3", "whole numbers"),
    ("u16 g;", "g = 1 / 0;", "3", "division by zero"),
    ("", "break;", "3", "break outside"),
    ("", "continue;", "3", "continue outside"),
    ("", "goto end; end: ;", "3", "Goto is not in the language"),
    ("", "return 1;", "3", "no result"),
    ("u16 f(void) { return; }", "f();", "2", "gives a result"),
    ("void f(void) { }", "u16 k = f();", "3", "f gives nothing"),
    ("", "u16 k = io_write(1, 2);", "3", "io_write gives nothing"),
    ("u16 f(u16 n) { return n; }", "f();", "3", "takes 1 arguments"),
    ("", "io_read(1, 2);", "3", "takes 1 arguments"),
    ("", "missing();", "3", "not there"),
    ("long f(void) { return 1; }", "", "2", "gives u16 or nothing"),
    ("void f(u16 *p) { }", "", "2", "parameters are u16"),
    ("struct s { u16 a; };", "", "2", "only u16"),
    ("u16 g;", "switch (g) { case g: ; }", "3", "a case is a constant"),
    ("u16 big[600];", "", "", "600 words of variables, and the RAM has 496"),
    ("u16 g;", "g = ;", "3", ""),
    ("u16 f(u16 n) { return n + 1; }\n" + "\n".join(
        f"u16 f{k}(u16 n) {{ return f{k - 1 if k else ''}(n) + f{k - 1 if k else ''}(n + 1); }}" for k in range(16)),
     "f15(1);", "", "calls 18 deep, and 16 returns are kept"),
    ("", "".join(f"io_write({k % 900}, {k * 977 % 65536}); " for k in range(1800)), "", "words of code, and the ROM has 4096"),
]


def check(declarations: str, body: str, place: str, what: str) -> str | None:
    try:
        compile_text(HEAD + declarations + ENTRIES % body, "t.c", MICRO)
    except FirmwareError as error:
        said = str(error)
        if not said.startswith(f"t.c:{place}:" if place else "") or what not in said:
            return f"{declarations[:60]} {body[:60]}: {said}"
        if place and not re.match(r"t\.c:\d+:\d+", said):
            return f"{said}: no place"
        return None
    return f"{declarations[:60]} {body[:60]}: no error"


def main() -> None:
    wrong = [said for case in CASES if (said := check(*case))]
    readme = (ROOT / "hdl" / "controller" / "micro" / "README.md").read_text()
    if table() not in readme:
        wrong.append("hdl/controller/micro/README.md: its table is not that of scripts/micro/isa.py:\n" + table())
    if len(OPCODES) + len(MISC) < 20:
        wrong.append("no instructions")
    print("\n".join(wrong) or f"{len(CASES)} errors as they should be")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
