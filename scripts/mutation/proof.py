# SPDX-License-Identifier: Apache-2.0
"""Is a mutant that no test noticed the same hardware?

The mutant runs beside the hardware with the same inputs. What its memories are told is an output like any other, and
what they answer is any value: the same for both as long as they are told and asked the same. Data count where
their valid bit is 1 (MASKS). The proof is by induction over clocks. Assumed: both hold the same in the registers of a
set, and the mutant any value in the others. To show: all outputs are the same, and so are the set's registers in
the next clock. The set begins with all registers and all memories' answers; those for which the solver finds a case
where it is not so leave it, until it finds none, or until an output differs. If that fails, the same is tried
from states only that the hardware has HISTORY clocks after any other; then it is shown too that the set stays
equal from any state while rst_ni is 0, as it is for as many clocks before anything else.
"""
from __future__ import annotations

import functools
import re
from dataclasses import dataclass

from flow import tools
from mutation import graph
from mutation.netlist import BITS, Mutant, apply
from mutation.subjects import Subject

HISTORY = 8                       # clocks; the tests' resets last as long
LIMIT = 20.0                      # seconds of one question to the solver
# Outputs that count where another one is 1: both as patterns, {0} being what stands before, {1} the slot.
MASKS = ((r"(retire|)_?(step|exc|bits|words)_o", "retire_valid_o"), (r"(.*)(bit|word)_(addr|data)_o", "{0}{1}_we_o"),
         (r"(write)_(addr|data)_o", "{0}_valid_o"), (r"(load)_(r)data_o", "load_rvalid_o"),
         (r"(.*\.)write_(addr|data)_i", "{0}write_i"))


@dataclass(frozen=True)
class Verdict:
    equal: bool
    why: str                      # how it was proven; or an output that may differ as far as the solver knows


def machine(subject: Subject, mutants: list[Mutant]) -> graph.Machine:
    """A netlist of these mutants as an and-inverter graph."""
    here = subject.folder.relative_to(tools.ROOT)
    script = subject.folder / "graph.ys"
    kept = " ".join(str(path.relative_to(tools.ROOT)) for path in subject.kept)
    options = f"-DRUNG_RETIRE -I{tools.GENERATED.relative_to(tools.ROOT)} -Ihdl/core -Ihdl/controller -Ihdl/flow"
    outside = " ".join(f"t:{path.stem}" for path in subject.kept)
    tools.write_file(script, "\n".join([
        *([f"read_verilog -lib {options} {kept}"] if kept else []), f"read_rtlil {here}/whole.il", *map(apply, mutants),
        *([f"expose -evert {outside}"] if kept else []),
        "dffunmap", "simplemap", "techmap", "opt_clean", "dffunmap", "aigmap", "setundef -zero", "opt_clean",
        f"write_aiger -ascii -symbols {here}/alive.aag", ""]))
    tools.run([tools.YOSYS, "-q", "-s", str(script)], tools.LOGS / f"mutate-{subject.name}-graph.log")
    return graph.read(subject.folder / "alive.aag")


def mask_of(name: str, outputs: dict[str, int]) -> int | None:
    """The place of the output that says whether this one counts."""
    bare, index = re.fullmatch(r"(.*?)(?:\[(\d+)\])?", name).groups()
    for pattern, mask in MASKS:
        if found := re.fullmatch(pattern, bare):
            valid = mask.format(*found.groups())
            # A bit of it for each slot, of which the others have 16 or 1.
            slot = int(index or 0) // (1 if bare.endswith(("exc_o", "bit_data_o")) else 16)
            return outputs.get(valid, outputs.get(f"{valid}[{slot}]"))
    return None


class Prover:
    def __init__(self, subject: Subject, mutants: list[Mutant]) -> None:
        self.machine = machine(subject, mutants)
        self.scratch = subject.folder / "question.cnf"
        names = self.machine.input_names
        self.choice = {names.index(f"rung_mutant[{bit}]"): bit for bit in range(BITS)}
        self.reset = names.index("rst_ni")
        places = {name: place for place, name in enumerate(self.machine.output_names)}
        self.masks = [mask_of(name, places) for name in self.machine.output_names]
        # By output the memory that it asks; by input the one that answers there.
        self.asks = [self.memory(name, r"read_i|read_addr_i") for name in self.machine.output_names]
        self.answers = [self.memory(name, "read_data_o") for name in names]

    @staticmethod
    def memory(name: str, ports: str) -> str:
        found = re.fullmatch(rf"(.*)\.(?:{ports})(?:\[\d+\])?", name)
        return found.group(1) if found else ""

    def inputs(self, functions: graph.Graph, reset: int | None = None) -> list[int]:
        """Of the hardware without a mutant: free variables."""
        values = [0 if place in self.choice else functions.variable() for place in range(len(self.machine.inputs))]
        if reset is not None:
            values[self.reset] = reset
        return values

    def mutated(self, functions: graph.Graph, inputs: list[int], number: int, other: set[str]) -> list[int]:
        """The same of a mutant, some of whose memories answer something else."""
        return [number >> self.choice[place] & 1 if place in self.choice
                else functions.variable() if self.answers[place] in other else value for place, value in enumerate(inputs)]

    def masked(self, functions: graph.Graph, outputs: list[int]) -> list[int]:
        return [value if mask is None else functions.conjunction(value, outputs[mask])
                for value, mask in zip(outputs, self.masks)]

    @functools.cache
    def start(self, history: int, reset: int | None) -> tuple[graph.Graph, list[int], list[int], tuple[list[int], list[int]]]:
        """The hardware: registers as they are so many clocks after any state, inputs, and what the next clock makes."""
        functions = graph.Graph()
        registers = [functions.variable() for _ in self.machine.registers]
        for _ in range(history):
            registers = functions.clock(self.machine, self.inputs(functions), registers)[1]
        inputs = self.inputs(functions, reset)
        return functions, registers, inputs, functions.clock(self.machine, inputs, registers)

    def unequal(self, number: int, history: int, equal: set[int], other: set[str],
                reset: int | None) -> tuple[set[int], set[int]] | None:
        """Registers of the set, and outputs, that differ in a case that the solver has found."""
        this = self.machine
        functions, registers, inputs, right = self.start(history, reset)
        others = [value if place in equal else functions.variable() for place, value in enumerate(registers)]
        wrong = functions.clock(this, self.mutated(functions, inputs, number, other), others)
        pairs: list[tuple[int, int]] = []
        meaning: list[tuple[bool, int]] = []
        for is_output, (a, b) in ((True, (self.masked(functions, right[0]), self.masked(functions, wrong[0]))),
                                  (False, (right[1], wrong[1]))):
            for place, pair in enumerate(zip(a, b)):
                if pair[0] != pair[1] and (self.asks[place] not in other if is_output else place in equal):
                    pairs.append(pair)
                    meaning.append((is_output, place))
        if not pairs:
            return set(), set()
        found = functions.differ(pairs, self.scratch, LIMIT)
        if found is None:
            return None
        return ({meaning[place][1] for place in found if not meaning[place][0]},
                {meaning[place][1] for place in found if meaning[place][0]})

    def attempt(self, mutant: Mutant, history: int) -> Verdict:
        equal = set(range(len(self.machine.registers)))
        other: set[str] = set()   # memories that are asked something else
        rounds = [(history, None), (0, 0)] if history else [(0, None)]
        done = 0                  # rounds that the set has passed as it is
        while done < len(rounds):
            clocks, reset = rounds[done]
            found = self.unequal(mutant.number, clocks, equal, other, reset)
            if found is None:
                return Verdict(False, f"no answer in {LIMIT:.0f} s")
            registers, outputs = found
            seen = sorted(self.machine.output_names[place] for place in outputs if not self.asks[place])
            if seen:
                return Verdict(False, f"the solver sees a difference at {', '.join(seen[:3])}")
            equal -= registers
            other |= {self.asks[place] for place in outputs}
            done = 0 if registers or outputs else done + 1
        free = len(self.machine.registers) - len(equal)
        return Verdict(True, f"induction{f' after {history} clocks' if history else ''}"
                             f"{f', {free} register bits differ that nothing sees' if free else ''}")

    def ask(self, functions: graph.Graph, right: list[int], wrong: list[int], value: list[int], otherwise: list[int]) -> list[int]:
        """Inputs of the next clock: what the memories answer. If a memory is asked the same in two runs, it answers the
        same as in the first one, `value`, and what it answers in the second otherwise, `otherwise`."""
        same: dict[str, int] = {}
        for place, memory in enumerate(self.asks):
            if memory:
                differs = functions.exclusive(right[place], wrong[place])
                same[memory] = functions.conjunction(same.get(memory, 1), differs ^ 1)
        return [functions.choose(same[self.answers[place]], value[place], other) if self.answers[place] else value[place]
                for place, other in enumerate(otherwise)]

    def window(self, mutant: Mutant, reset: bool) -> Verdict:
        """The fault is forgotten: HISTORY clocks after it nothing of it is left, and until then no output has differed.

        Three runs from one state with the same inputs: the hardware, the mutant, and the mutant from the second clock on.
        To show: the outputs of the first two are the same in all clocks, and the last two end in the same state. By
        that, the mutant is always where it would be if it had been the hardware until HISTORY clocks ago. In
        reset, from any state at all: the first two end in the same state."""
        functions, registers, inputs, clock = self.start(0 if reset else HISTORY, 0 if reset else None)
        this = self.machine
        states = [registers, registers, registers]
        sights = [inputs, inputs, inputs]
        pairs: list[tuple[int, int]] = []
        names: list[str] = []
        for step in range(HISTORY + 1):
            number = mutant.number
            runs = [functions.clock(this, sights[0], states[0]) if step else clock,
                    functions.clock(this, self.mutated(functions, sights[1], number, set()), states[1]),
                    functions.clock(this, self.mutated(functions, sights[2], number if step else 0, set()), states[2])]
            a, b = (self.masked(functions, run[0]) for run in runs[:2])
            for place, pair in enumerate(zip(a, b)):
                if pair[0] != pair[1] and not self.asks[place]:
                    pairs.append(pair)
                    names.append(this.output_names[place])
            right = self.inputs(functions, 0 if reset else None)
            fresh = [functions.variable() if memory else 0 for memory in self.answers]
            second = self.ask(functions, runs[0][0], runs[1][0], right, fresh)
            fresh = [functions.variable() if memory else 0 for memory in self.answers]
            third = self.ask(functions, runs[0][0], runs[2][0], right,
                             self.ask(functions, runs[1][0], runs[2][0], second, fresh))
            sights, states = [right, second, third], [run[1] for run in runs]
        end = (states[0], states[1], sights[0], sights[1]) if reset else (states[1], states[2], sights[1], sights[2])
        for name, pair in zip(this.register_names + this.input_names, zip(end[0] + end[2], end[1] + end[3])):
            if pair[0] != pair[1]:
                pairs.append(pair)
                names.append(name)
        found = functions.differ(pairs, self.scratch, LIMIT) if pairs else set()
        if found is None:
            return Verdict(False, f"no answer in {LIMIT:.0f} s")
        if found:
            return Verdict(False, f"the solver sees a difference at {', '.join(sorted({names[place] for place in found})[:3])}")
        return Verdict(True, f"forgotten within {HISTORY} clocks")

    def prove(self, mutant: Mutant) -> Verdict:
        """What attempt(mutant, 0) has not proven."""
        forgotten = self.window(mutant, False)
        if forgotten.equal:
            forgotten = self.window(mutant, True)
        return forgotten if forgotten.equal else self.attempt(mutant, HISTORY)
