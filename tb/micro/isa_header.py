#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The micro-sequencer's instruction set as constants for C++.

usage: isa_header.py FILE      writes it
       isa_header.py --page    exit 1 if the table in hdl/controller/micro/README.md is not isa.py's
"""
from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
from micro.isa import JUMPS, MISC, OPCODES, encode, table  # noqa: E402


def constants() -> str:
    names = [name for name in (*OPCODES, *MISC, *JUMPS) if name != "MISC"]
    text = "".join(f"constexpr std::uint16_t k{name} = {encode(name, 0)};\n" for name in names)
    return f"#pragma once\n#include <cstdint>\nnamespace rung::tb::micro {{\n{text}}}\n"


def main() -> int:
    if sys.argv[1:] == ["--page"]:
        page = ROOT / "hdl" / "controller" / "micro" / "README.md"
        if table() in page.read_text():
            return 0
        print(f"{page}: its table of instructions is not that of scripts/micro/isa.py:\n{table()}")
        return 1
    Path(sys.argv[1]).write_text(constants())
    return 0


if __name__ == "__main__":
    sys.exit(main())
