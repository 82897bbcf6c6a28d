# SPDX-License-Identifier: Apache-2.0
"""Random programs in the firmware's C, with the same meaning natively: every result is cast to u16, nothing depends on
the order in which operands are evaluated, loops end, and all that is kept is written out at the end of a poll."""
from __future__ import annotations

import random

MOST_COST = 3000         # statements executed in a call of a function, about
CONSTANTS = (0, 1, 2, 3, 7, 8, 15, 16, 255, 256, 2047, 2048, 2049, 4095, 0x4000, 0x7FFF, 0x8000, 0xFFFE, 0xFFFF)


class Writer:
    """One program. `name` goes before all its names, so that many can stand in one file."""

    def __init__(self, name: str, seed: int, registers: int) -> None:
        self.random = random.Random(seed)
        self.name, self.registers = name, registers   # the bus' first register
        self.scalars = [f"{name}_g{i}" for i in range(self.random.randint(2, 5))]
        self.arrays = {f"{name}_a{i}": self.random.choice((2, 4, 8, 16)) for i in range(2)}
        self.functions: list[tuple[str, int, bool, int]] = []   # name, parameters, gives, cost
        self.lines: list[str] = []
        # of the function being written
        self.locals: list[str] = []
        self.fixed: set[str] = set()       # variables that count a loop
        self.made = self.cost = 0
        self.weight = 1                    # how often a statement here is executed
        self.gives = False
        self.in_loop: list[bool] = []      # of each loop or switch around: continue is possible

    def chance(self, percent: int) -> bool:
        return self.random.randrange(100) < percent

    # ---- expressions: what is `private` uses nothing that a call may change ------------------------
    def constant(self) -> str:
        value = self.random.choice(CONSTANTS) if self.chance(60) else self.random.randrange(1 << 16)
        return f"0x{value:X}" if self.chance(30) else str(value)

    def address(self, private: bool, depth: int) -> str:
        if self.chance(60):
            return str(self.registers + self.random.randrange(120))
        return f"(u16)({self.random.choice((self.registers, 0x2000, 0x3000))} + ({self.plain(private, depth)} & 255))"

    def leaf(self, private: bool) -> str:
        kind = self.random.randrange(10)
        if kind < 3 or (private and not self.locals):
            return self.constant()
        if kind < 6 and self.locals or private:
            return self.random.choice(self.locals)
        if kind < 8:
            return self.random.choice(self.scalars)
        array, size = self.random.choice(list(self.arrays.items()))
        return f"{array}[{self.random.randrange(size)}]"

    def plain(self, private: bool, depth: int) -> str:
        """Without a call."""
        if depth <= 0 or self.chance(15):
            return self.leaf(private)
        kind = self.random.randrange(14)
        one = self.plain(private, depth - 1)
        two = self.plain(private, depth - 1)
        if kind < 4:
            return f"(u16)({one} {self.random.choice('+-&|^')} {two})"
        if kind == 4:
            return f"(u16)({one} << {self.random.randrange(16)})"
        if kind == 5:
            return f"({one} >> {self.random.randrange(16)})"
        if kind == 6:
            return f"(u16)({self.random.choice('~-')}{one})"
        if kind == 7:
            return f"(u16)({one} * {1 << self.random.randrange(8)})"
        if kind == 8 and not private:
            array, size = self.random.choice(list(self.arrays.items()))
            return f"{array}[{one} & {size - 1}]"
        if kind == 9:
            return f"({self.condition(private, depth - 1)} ? {one} : {two})"
        if kind == 10:
            return f"({self.condition(private, depth - 1)})"
        if kind == 11:
            return f"(u16)({one} {self.random.choice('+-&|^')} {self.constant()})"
        if kind == 12:
            return f"({one} & 255)"
        return f"!{one}" if self.chance(30) else self.leaf(private)

    def condition(self, private: bool, depth: int) -> str:
        kind = self.random.randrange(8)
        if depth > 0 and kind < 2:
            return (f"({self.condition(private, depth - 1)}) {self.random.choice(('&&', '||'))} "
                    f"({self.condition(private, depth - 1)})")
        if depth > 0 and kind == 2:
            return f"!({self.condition(private, depth - 1)})"
        if kind == 3:
            return self.plain(private, depth)
        right = self.constant() if self.chance(60) else self.plain(private, depth - 1)
        return f"{self.plain(private, depth)} {self.random.choice(('==', '!=', '<', '<=', '>', '>='))} {right}"

    def call(self, depth: int) -> str | None:
        """A call of what gives a value; io_read if there is nothing else."""
        able = [f for f in self.functions if f[2] and f[3] * self.weight < MOST_COST]
        if not able or self.chance(40):
            return f"io_read({self.address(False, depth)})"
        return self.call_of(self.random.choice(able), depth)

    def call_of(self, function: tuple[str, int, bool, int], depth: int) -> str:
        name, parameters, _, cost = function
        self.cost += cost * self.weight
        if parameters and self.chance(30):  # one argument has a call itself
            at = self.random.randrange(parameters)
            arguments = [self.plain(True, depth) for _ in range(parameters)]
            arguments[at] = self.value(depth - 1)
        else:
            arguments = [self.plain(False, depth) for _ in range(parameters)]
        return f"{name}({', '.join(arguments)})"

    def value(self, depth: int) -> str:
        """At most one call, and then nothing else that it may change."""
        if self.chance(65):
            return self.plain(False, depth)
        call = self.call(depth)
        kind = self.random.randrange(6)
        operator = self.random.choice("+-&|^")
        if kind == 0:
            return f"(u16)({call} {operator} {self.plain(True, depth)})"
        if kind == 1:
            return f"(u16)({self.plain(True, depth)} {operator} {call})"
        if kind == 2:
            return f"({call} >> {self.random.randrange(16)})"
        if kind == 3:
            return f"({self.plain(True, depth)} {self.random.choice(('<', '>=', '==', '!='))} {call})"
        return call

    def test(self) -> str:
        if self.chance(70):
            return self.condition(False, 2)
        one, two = self.call(1), self.call(1)
        operator = self.random.choice(("&&", "||"))
        return f"{one} > {self.constant()} {operator} {two} & {self.constant()}"

    # ---- statements --------------------------------------------------------------------------------
    def line(self, indent: int, text: str) -> None:
        self.lines.append("  " * indent + text)

    def new_local(self) -> str:
        self.made += 1
        return f"v{self.made}"

    def target(self) -> str:
        free = [name for name in self.locals if name not in self.fixed]
        kind = self.random.randrange(10)
        if kind < 5 and free:
            return self.random.choice(free)
        if kind < 8:
            return self.random.choice(self.scalars)
        array, size = self.random.choice(list(self.arrays.items()))
        return f"{array}[{self.random.randrange(size)}]"

    def block(self, indent: int, count: int) -> None:
        known = len(self.locals)
        for _ in range(count):
            self.statement(indent)
        del self.locals[known:]

    def statement(self, indent: int) -> None:
        self.cost += self.weight
        kind = self.random.randrange(20)
        deep = indent > 3
        if kind < 5 or (deep and kind >= 13):
            self.line(indent, f"{self.target()} = {self.value(3)};")
        elif kind < 7:
            operator = self.random.choice(("+=", "-=", "&=", "|=", "^="))
            self.line(indent, f"{self.target()} {operator} {self.plain(False, 2)};")
        elif kind == 7:
            name = self.new_local()
            self.line(indent, f"u16 {name} = {self.value(2)};")
            self.locals.append(name)
        elif kind == 8:
            array, size = self.random.choice(list(self.arrays.items()))
            index = self.plain(True, 2)
            self.line(indent, f"{array}[{index} & {size - 1}] = {self.value(2)};")
        elif kind < 11:
            self.line(indent, f"io_write({self.address(True, 1)}, {self.value(2)});")
        elif kind == 11:
            able = [f for f in self.functions if f[3] * self.weight < MOST_COST]
            if able:
                self.line(indent, self.call_of(self.random.choice(able), 2) + ";")
        elif kind == 12:
            self.line(indent, f"{self.target()}{self.random.choice(('++', '--'))};")
        elif kind < 16:
            self.if_(indent)
        elif kind == 16:
            self.switch(indent)
        elif kind < 19:
            self.loop(indent)
        else:
            self.leave(indent)

    def if_(self, indent: int) -> None:
        self.line(indent, f"if ({self.test()}) {{")
        self.block(indent + 1, self.random.randint(1, 3))
        while self.chance(25):
            self.line(indent, f"}} else if ({self.test()}) {{")
            self.block(indent + 1, self.random.randint(1, 2))
        if self.chance(40):
            self.line(indent, "} else {")
            self.block(indent + 1, self.random.randint(1, 3))
        self.line(indent, "}")

    def leave(self, indent: int) -> None:
        kind = self.random.randrange(3)
        if kind == 0 and self.in_loop:
            self.line(indent, f"if ({self.condition(False, 1)}) break;")
        elif kind == 1 and any(self.in_loop):
            self.line(indent, f"if ({self.condition(False, 1)}) continue;")
        elif indent > 1:
            result = f" {self.plain(False, 2)}" if self.gives else ""
            self.line(indent, f"if ({self.condition(False, 1)}) return{result};")

    def switch(self, indent: int) -> None:
        mask = self.random.choice((3, 7, 255, 0xFFFF))
        self.line(indent, f"switch ({self.value(2)} & {mask}) {{")
        cases = self.random.sample(sorted({*CONSTANTS, *range(6)}), self.random.randint(1, 5))
        default = self.random.randrange(len(cases) * 2)
        self.in_loop.append(False)
        for i, case in enumerate(cases):
            if i == default:
                self.line(indent + 1, "default:")
                self.block(indent + 2, 1)
                self.line(indent + 2, "break;")
            self.line(indent + 1, f"case {case}:")
            if self.chance(80):
                known = len(self.locals)
                self.line(indent + 2, f"{self.target()} = {self.plain(False, 2)};")
                self.if_(indent + 2)
                del self.locals[known:]
            if self.chance(70):
                self.line(indent + 2, "break;")
        self.line(indent + 2, ";")
        self.in_loop.pop()
        self.line(indent, "}")

    def loop(self, indent: int) -> None:
        counter = self.new_local()
        count = self.random.randint(1, 5)
        known = len(self.locals)
        weight, self.weight = self.weight, self.weight * count
        self.locals.append(counter)
        self.fixed.add(counter)
        self.in_loop.append(True)
        kind = self.random.randrange(3)
        if kind == 0:
            self.line(indent, f"for (u16 {counter} = 0; {counter} < {count}; {counter}++) {{")
        elif kind == 1:
            self.line(indent, f"u16 {counter} = {count};")
            self.line(indent, f"while ({counter}) {{")
        else:
            self.line(indent, f"u16 {counter} = {count};")
            self.line(indent, "do {")
        if kind:
            self.line(indent + 1, f"{counter} = {counter} - 1;")
        self.block(indent + 1, self.random.randint(1, 4))
        self.line(indent, f"}} while ({counter});" if kind == 2 else "}")
        self.in_loop.pop()
        self.fixed.discard(counter)
        del self.locals[known:]
        if kind:
            self.locals.append(counter)
        self.weight = weight

    # ---- the whole ---------------------------------------------------------------------------------
    def function(self, name: str, parameters: int, gives: bool, statements: int, static: bool = True) -> None:
        self.locals = [f"p{i}" for i in range(parameters)]
        self.made, self.cost, self.weight, self.gives = 0, 1, 1, gives
        kind = ("static " if static else "") + ("u16" if gives else "void")
        arguments = ", ".join(f"u16 {each}" for each in self.locals) or "void"
        self.line(0, f"{kind} {name}({arguments}) {{")
        self.block(1, statements)
        if gives:
            self.line(1, f"return {self.plain(False, 3) if self.chance(70) else self.value(2)};")
        elif name == "firmware_poll":
            for scalar in self.scalars:
                self.line(1, f"io_write({self.registers + 122}, {scalar});")
            for array, size in self.arrays.items():
                self.line(1, f"for (u16 {array}_k = 0; {array}_k < {size}; {array}_k++) "
                             f"io_write({self.registers + 123}, {array}[{array}_k]);")
        self.line(0, "}")
        if static:
            self.functions.append((name, parameters, gives, self.cost))

    def text(self) -> str:
        self.lines = ["typedef unsigned short u16;", "u16 io_read(u16 address);",
                      "void io_write(u16 address, u16 value);"]
        self.lines += [f"static u16 {name};" for name in self.scalars]
        self.lines += [f"static u16 {name}[{size}];" for name, size in self.arrays.items()]
        for i in range(self.random.randint(1, 4)):
            self.function(f"{self.name}_f{i}", self.random.randrange(4), self.chance(60), self.random.randint(1, 4))
        self.function("firmware_reset", 0, False, self.random.randint(0, 2), static=False)
        self.function("firmware_poll", 0, False, self.random.randint(2, 6), static=False)
        return "\n".join(self.lines) + "\n"


def random_program(name: str, seed: int, registers: int) -> str:
    return Writer(name, seed, registers).text()
