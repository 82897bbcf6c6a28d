#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Programs of the micro-sequencer's language for tb/micro: random ones from a seed, and those of programs/. Writes them as
C++ structs, compiled words beside them, and the instruction set as constants.

    generate.py SEED COUNT OUT_DIR
"""
from __future__ import annotations

import os
import random
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "scripts"))
try:
    from micro.compile import compile_text
except ImportError:                       # pycparser is the system's
    if sys.executable == "/usr/bin/python3":
        raise
    os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])
from micro.isa import JUMPS, MISC, OPCODES, encode  # noqa: E402

MICRO = {"registers": 0x300, "ram_words": 512, "rom_words": 4096}
HEAD = "typedef unsigned short u16;\n#ifndef RUNG_NATIVE\nu16 io_read(u16 address);\nvoid io_write(u16 address, u16 value);\n#endif\n"
NUMBERS = [0, 1, 2, 3, 5, 7, 15, 127, 255, 256, 1023, 1024, 2047, 2048, 4096, 0x7FFF, 0x8000, 0xFFF0, 0xFFFE, 0xFFFF]
ARRAYS = {"a": 8, "b": 16}
GLOBALS = ["g0", "g1", "g2", "g3"]


class Program:
    """One random program. Only what C leaves open is avoided: two calls in an expression, a call beside a global, and
    arithmetic of more than 16 bits, which casts cut off."""

    def __init__(self, rng: random.Random) -> None:
        self.rng = rng
        self.functions: list[tuple[str, int, bool]] = []
        self.variables: list[str] = []
        self.fixed: list[str] = []       # variables of loops, read only
        self.names = 0
        self.loops = 0
        self.gives = False

    def pick(self, *choices: object) -> object:
        return self.rng.choice(choices)

    def number(self) -> str:
        value = self.rng.choice(NUMBERS) if self.rng.random() < 0.7 else self.rng.randrange(0x10000)
        return str(value) if self.rng.random() < 0.5 else hex(value)

    def leaf(self, pure: bool) -> str:
        kind = self.rng.random()
        if kind < 0.3:
            return self.number()
        if kind < 0.7 or pure:
            return self.rng.choice([*self.variables, *self.fixed] or ["1"])
        if kind < 0.85:
            return self.rng.choice(GLOBALS)
        name = self.rng.choice(list(ARRAYS))
        return f"{name}[{self.index(name)}]"

    def index(self, name: str) -> str:
        size = ARRAYS[name]
        if self.rng.random() < 0.4:
            return str(self.rng.randrange(size))
        half = size // 2
        inner = self.expression(1, True)
        return str(self.pick(f"({inner}) & {size - 1}", f"(({inner}) & {half - 1}) + {half}",
                             f"{half} + (({inner}) & {half - 1})", f"(({inner}) & {half - 1} | {half}) - {half // 2}"))

    def expression(self, depth: int, pure: bool = False) -> str:
        """pure: constants and variables of the function only."""
        if depth <= 0:
            return self.leaf(pure)
        kind = self.rng.random()
        one = self.expression(depth - 1, pure)
        other = self.expression(depth - 2, pure)
        if kind < 0.40:
            return f"(u16)({one} {self.pick('+', '-', '&', '|', '^')} {other})"
        if kind < 0.50:
            return f"(u16)({one} {self.pick('<<', '>>')} {self.rng.randrange(16)})"
        if kind < 0.55:
            return f"(u16)({one} * {1 << self.rng.randrange(9)})"
        if kind < 0.75:
            return f"({one} {self.pick('==', '!=', '<', '<=', '>', '>=')} {other})"
        if kind < 0.82:
            return f"({one} {self.pick('&&', '||')} {other})"
        if kind < 0.90:
            return f"({one} ? {other} : {self.expression(depth - 2, pure)})"
        if kind < 0.96:
            return f"(u16)({self.pick('~', '-')}({one}))"
        return f"!({one})"

    def call(self, void: bool = False) -> str | None:
        usable = [f for f in self.functions if f[2] or void]
        if self.loops > 1 or not usable:
            return None
        name, count, _ = self.rng.choice(usable)
        return f"{name}({', '.join(self.argument(i) for i in range(count))})"

    def argument(self, at: int) -> str:
        if at == 0 and self.rng.random() < 0.2:
            called = self.call()
            if called:
                return called
        return self.expression(2, True)

    def value(self) -> str:
        """An expression that may call or read something."""
        kind = self.rng.random()
        if kind < 0.25:
            called = self.call()
            if called:
                return str(self.pick(called, f"(u16)({called} {self.pick('+', '-', '^')} {self.leaf(True)})",
                                     f"({self.leaf(True)} {self.pick('<', '>', '==')} {called})"))
        if kind < 0.45:
            return f"io_read({self.address()})"
        return self.expression(3)

    def address(self) -> str:
        return str(self.pick(self.rng.randrange(1024), f"(u16)(({self.expression(1, True)}) & 255) + 512"))

    def target(self) -> str:
        if self.rng.random() < 0.4 and self.variables:
            return self.rng.choice(self.variables)
        if self.rng.random() < 0.5:
            return self.rng.choice(GLOBALS)
        name = self.rng.choice(list(ARRAYS))
        return f"{name}[{self.index(name)}]"

    def fresh(self) -> str:
        self.names += 1
        return f"v{self.names}"

    def block(self, depth: int, count: int) -> str:
        kept = list(self.variables)
        text = "".join(self.statement(depth) for _ in range(self.rng.randint(1, count)))
        self.variables = kept
        return "{\n" + text + "}\n"

    def statement(self, depth: int) -> str:
        kind = self.rng.random()
        if kind < 0.12:
            name = self.fresh()
            text = f"u16 {name} = {self.value()};\n"
            self.variables.append(name)
            return text
        if kind < 0.35:
            target = self.target()
            # a called function may change what an index or another operand reads
            return f"{target} = {self.expression(3) if '[' in target else self.value()};\n"
        if kind < 0.45:
            target = self.target()
            if "[" in target:
                target = self.rng.choice(GLOBALS)
            return str(self.pick(f"{target} = {target} + 1;\n", f"{target} = {target} - 1;\n", f"{target}++;\n", f"--{target};\n",
                                 f"{target} {self.pick('+=', '-=', '&=', '|=', '^=')} {self.expression(2)};\n"))
        if kind < 0.60:
            return f"io_write({self.address()}, {self.expression(2)});\n"
        if kind < 0.66:
            called = self.call(void=True)
            return f"{called};\n" if called else ";\n"
        if depth <= 0:
            return f"io_write(7, {self.leaf(False)});\n"
        if kind < 0.80:
            text = f"if ({self.value()}) {self.block(depth - 1, 3)}"
            return text + (f"else {self.block(depth - 1, 3)}" if self.rng.random() < 0.5 else "")
        if kind < 0.90:
            return self.loop(depth)
        if kind < 0.96:
            return self.switch(depth)
        if self.gives:
            return f"if ({self.expression(1)}) return {self.value()};\n"
        return f"if ({self.expression(1)}) return;\n"

    def loop(self, depth: int) -> str:
        name = self.fresh()
        self.loops += 1
        self.fixed.append(name)
        count = self.rng.randint(1, 4)
        leave = str(self.pick("", f"if ({self.expression(1)}) break;\n", f"if ({self.expression(1)}) continue;\n"))
        body = self.block(depth - 1, 3)[2:]
        first = self.pick("0", str(self.rng.randint(0, 3)), f"({self.expression(1)}) & 1")
        form = self.rng.randrange(4)
        if form == 0:
            text = f"u16 {name};\nfor ({name} = {first}; {name} < {count}; {name} = {name} + 1) {{\n{leave}{body}"
        elif form == 1:
            text = f"u16 {name} = {count};\nwhile ({name}) {{\n{name} = {name} - 1;\n{leave}{body}"
        elif form == 2:
            text = f"u16 {name} = {count};\ndo {{\n{name}--;\n{leave}{body[:-1]} while ({name});\n"
        else:
            text = f"u16 {name};\nfor ({name} = {count}; {name}; {name}--) {{\n{leave}{body}"
        self.loops -= 1
        self.fixed.remove(name)
        return text

    def switch(self, depth: int) -> str:
        cases = self.rng.sample([0, 1, 2, 3, 4, 9, 100, 2046, 5000, 0xFFFF], self.rng.randint(1, 5))
        text = f"switch ({self.pick(self.value(), f'({self.expression(1)}) & 3')}) {{\n"
        for case in cases:
            text += f"case {case}:\n{self.block(depth - 1, 2)}{self.pick('break;', 'break;', '')}\n"
        if self.rng.random() < 0.5:
            text += f"default:\n{self.block(depth - 1, 2)}"
        return text + "}\n"

    def function(self, name: str, count: int, gives: bool) -> str:
        self.names = 0
        self.gives = gives
        self.fixed = []
        self.variables = [f"p{i}" for i in range(count)]
        parameters = ", ".join(f"u16 {each}" for each in self.variables) or "void"
        body = "".join(self.statement(3) for _ in range(self.rng.randint(1, 6)))
        end = f"return {self.value()};\n" if gives else ""
        self.functions.append((name, count, gives))
        return f"static {'u16' if gives else 'void'} {name}({parameters}) {{\n{body}{end}}}\n"

    def text(self) -> str:
        out = HEAD + "".join(f"u16 {name};\n" for name in GLOBALS)
        out += "".join(f"u16 {name}[{size}];\n" for name, size in ARRAYS.items())
        for i in range(self.rng.randint(0, 4)):
            out += self.function(f"f{i}", self.rng.randrange(4), self.rng.random() < 0.7)
        ends = "".join(f"io_write({i}, {each});\n" for i, each in enumerate([*GLOBALS, "a[1]", "a[7]", "b[0]", "b[9]"]))
        for entry in ("firmware_reset", "firmware_poll"):
            body = self.function(entry, 0, False).removeprefix("static ")
            self.functions.pop()
            # the entries end with what the globals hold
            out += body[:-2].replace("return;", "g3 = 1;") + ends + "}\n"
        return out


def constants() -> str:
    """The instruction set as C++."""
    names = [*OPCODES, *MISC, *JUMPS]
    text = "".join(f"constexpr std::uint16_t k{name} = {encode(name, 0)};\n" for name in names if name != "MISC")
    return f"#pragma once\n#include <cstdint>\nnamespace rung::tb::micro {{\n{text}}}\n"


def main() -> None:
    seed, count, out = int(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3])
    out.mkdir(parents=True, exist_ok=True)
    programs = [(path.stem, HEAD + re.sub(r"//.*", "", path.read_text())) for path in sorted((HERE / "programs").glob("*.c"))]
    programs += [(f"seed_{seed + i}", Program(random.Random(seed + i)).text()) for i in range(count)]
    structs, table, listings = [], [], []
    for name, text in programs:
        stripped = text.replace("#ifndef RUNG_NATIVE\n", "").replace("#endif\n", "")
        firmware = compile_text(stripped, f"{name}.c", MICRO)
        native = "\n".join(line for line in text.splitlines() if not line.startswith(("#", "u16 io_read(", "void io_write(", "typedef")))
        structs.append(f"struct {name} : Bus {{\n{native.replace('static ', '')}\n}};\n")
        words = ", ".join(map(str, firmware.words))
        table.append(f'{{"{name}", {{{words}}}, run<{name}>}},\n')
        listings.append(f"==== {name}\n{text}\n" + "\n".join(firmware.listing) + "\n")
    (out / "micro_programs.inc").write_text("".join(structs))
    (out / "micro_table.inc").write_text("".join(table))
    (out / "micro_programs.lst").write_text("".join(listings))
    (out / "micro_isa.hpp").write_text(constants())


if __name__ == "__main__":
    main()
