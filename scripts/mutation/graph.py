# SPDX-License-Identifier: Apache-2.0
"""And-inverter graphs: a netlist in AIGER's text format, functions in which equal parts are one, and a SAT solver.

A literal is twice a node's number, plus 1 if it is inverted; 0 is false and 1 true, as in AIGER.
"""
from __future__ import annotations

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

from flow import tools

YICES_SAT = os.environ.get("YICES_SAT", str(tools.VENV_BIN / "yices-sat"))


@dataclass(frozen=True)
class Machine:
    """What one clock of a netlist computes: of inputs and registers the outputs and the registers' next values."""
    inputs: list[int]
    registers: list[int]
    following: list[int]
    outputs: list[int]
    ands: list[tuple[int, int, int]]
    input_names: list[str]
    register_names: list[str]
    output_names: list[str]
    size: int                     # of an array with a place for each node


def read(path: Path) -> Machine:
    """A file of Yosys' write_aiger -ascii -symbols."""
    lines = path.read_text(encoding="utf-8").splitlines()
    count, inputs, latches, outputs, ands = (int(word) for word in lines[0].split()[1:6])
    rows = [[int(word) for word in line.split()] for line in lines[1:1 + inputs + latches + outputs + ands]]
    names: dict[str, str] = {}
    for line in lines[1 + inputs + latches + outputs + ands:]:
        if line == "c":
            break
        key, name = line.split(" ", 1)
        names[key] = name.split(" ")[0]
    at = inputs + latches
    return Machine([row[0] for row in rows[:inputs]], [row[0] for row in rows[inputs:at]], [row[1] for row in rows[inputs:at]],
                   [row[0] for row in rows[at:at + outputs]],
                   sorted((row[0], row[1], row[2]) for row in rows[at + outputs:]),
                   [names.get(f"i{n}", f"input {n}") for n in range(inputs)],
                   [names.get(f"l{n}", f"register {n}") for n in range(latches)],
                   [names.get(f"o{n}", f"output {n}") for n in range(outputs)], count + 1)


class Graph:
    """Functions of free variables."""

    def __init__(self) -> None:
        self.operands: list[tuple[int, int] | None] = [None]   # by node; None: a variable, or the constant 0
        self.known: dict[tuple[int, int], int] = {}

    def variable(self) -> int:
        self.operands.append(None)
        return 2 * (len(self.operands) - 1)

    def conjunction(self, a: int, b: int) -> int:
        if a > b:
            a, b = b, a
        if a == 0 or a == b ^ 1:
            return 0
        if a == 1 or a == b:
            return b
        found = self.known.get((a, b))
        if found is None:
            self.operands.append((a, b))
            found = self.known[a, b] = 2 * (len(self.operands) - 1)
        return found

    def exclusive(self, a: int, b: int) -> int:
        return self.conjunction(self.conjunction(a, b) ^ 1, self.conjunction(a ^ 1, b ^ 1) ^ 1)

    def choose(self, condition: int, yes: int, no: int) -> int:
        if yes == no:
            return yes
        return self.conjunction(self.conjunction(condition, yes) ^ 1, self.conjunction(condition ^ 1, no) ^ 1) ^ 1

    def clock(self, machine: Machine, inputs: list[int], registers: list[int]) -> tuple[list[int], list[int]]:
        """Outputs and the registers' next values."""
        value = [0] * machine.size
        for node, literal in zip(machine.inputs + machine.registers, inputs + registers):
            value[node >> 1] = literal
        conjunction = self.conjunction
        for node, a, b in machine.ands:
            value[node >> 1] = conjunction(value[a >> 1] ^ (a & 1), value[b >> 1] ^ (b & 1))
        return ([value[literal >> 1] ^ (literal & 1) for literal in machine.outputs],
                [value[literal >> 1] ^ (literal & 1) for literal in machine.following])

    def differ(self, pairs: list[tuple[int, int]], scratch: Path, limit: float) -> set[int] | None:
        """Which of the pairs are unequal in some one case that a solver has found: none of them if there is no such
        case. None if the solver has no answer within `limit` seconds."""
        cone, stack = set(), [literal >> 1 for pair in pairs for literal in pair]
        while stack:
            node = stack.pop()
            if node in cone:
                continue
            cone.add(node)
            if (operands := self.operands[node]) is not None:
                stack += [operands[0] >> 1, operands[1] >> 1]
        names = {node: place for place, node in enumerate(sorted(cone | {0}), 1)}

        def name(literal: int) -> int:
            return -names[literal >> 1] if literal & 1 else names[literal >> 1]

        clauses = [f"{-names[0]} 0"]
        for node in cone:
            if (operands := self.operands[node]) is not None:
                y, a, b = names[node], name(operands[0]), name(operands[1])
                clauses += [f"{-y} {a} 0", f"{-y} {b} 0", f"{y} {-a} {-b} 0"]
        some = []
        for place, (a, b) in enumerate(pairs, len(names) + 1):
            x, y = name(a), name(b)
            clauses += [f"{-place} {x} {y} 0", f"{-place} {-x} {-y} 0"]
            some.append(str(place))
        clauses.append(" ".join([*some, "0"]))
        tools.write_file(scratch, f"p cnf {len(names) + len(pairs)} {len(clauses)}\n" + "\n".join(clauses) + "\n")
        try:
            done = subprocess.run([YICES_SAT, "-m", str(scratch)], capture_output=True, text=True, timeout=limit, check=False)
        except subprocess.TimeoutExpired:
            return None
        words = done.stdout.split()
        if "unsat" in words:
            return set()
        if "sat" not in words:
            raise tools.FlowError(f"{YICES_SAT}: {(done.stdout + done.stderr)[-200:]}")
        true = {int(word) for word in words if word.isdigit()}

        def holds(literal: int) -> bool:
            return (names[literal >> 1] in true) != bool(literal & 1)

        return {place for place, (a, b) in enumerate(pairs) if holds(a) != holds(b)}
