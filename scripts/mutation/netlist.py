# SPDX-License-Identifier: Apache-2.0
"""The mutants of a subject, and one netlist that can be any of them.

Yosys draws faults evenly over lines of the source, signals and bits, one fault each: an input or output of a cell, an
instance or a flip-flop stuck at 0 or 1, inverted, or inverted while another bit of it is 0 or 1. All of them are in
one netlist; the register rung_mutant, which asks tb/mutate/mutant.cpp at the start, says which one is active.
"""
from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from flow import tools
from flow.synthesis import yosys_version
from mutation.subjects import Subject

BITS = 16
SPARE = 1.6                       # drawn for one that is wanted: some of them are filtered out
FAULT = {"inv": "inverted", "const0": "stuck at 0", "const1": "stuck at 1", "cnot0": "inverted while bit {} is 0",
         "cnot1": "inverted while bit {} is 1"}


@dataclass(frozen=True)
class Mutant:
    number: int
    command: str                  # what Yosys makes it with, without number
    mode: str
    cell: str
    port: str
    bit: int
    control: int                  # the other bit of cnot0 and cnot1
    wire: str
    wire_bit: int
    places: tuple[str, ...]       # file:line of the cell, then of the wire

    @property
    def place(self) -> str:
        return self.places[0] if self.places else "?"

    def describe(self) -> str:
        """The fault: a signal with a name, or a port of a cell; a register is one too."""
        kinds = [kind for kind in re.findall(r"\$([a-z_]+)\$", self.cell) if kind != "auto"]
        cell = kinds[-1] if kinds else "register" if "$" in self.cell else self.cell.lstrip("\\")
        port = f"{cell}.{self.port.lstrip(chr(92))}[{self.bit}]"
        wire = f"`{self.wire}[{self.wire_bit}]` at {port}" if self.wire else port
        return f"{wire} {FAULT[self.mode].format(self.control)}"


def read_script(subject: Subject) -> str:
    """Yosys commands that give the netlist without a fault, flat but for what is kept."""
    def here(paths: tuple[Path, ...]) -> str:
        return " ".join(str(path.relative_to(tools.ROOT)) for path in paths)

    options = f"-DRUNG_RETIRE -I{tools.GENERATED.relative_to(tools.ROOT)} -Ihdl/core -Ihdl/controller -Ihdl/flow"
    kept = f"read_verilog -lib {options} {here(subject.kept)}\n" if subject.kept else ""
    parameters = "".join(f" -chparam {name} {value}" for name, value in subject.parameters)
    return (f"{kept}read_verilog {options} {here(subject.mutated)}\nhierarchy -top {subject.top}{parameters}\n"
            f"proc\nflatten\nopt -full\nwreduce\nopt_clean\nrename -top {subject.top}\ndelete t:$scopeinfo\n")


def parse(line: str, number: int) -> Mutant:
    command = re.sub(r"-ctrl \S+ \d+ \d+ ", "", line.strip())

    def value(option: str, otherwise: str = "") -> str:
        found = re.search(rf" -{option} (\S+)", command)
        return found.group(1) if found else otherwise

    # Last the cell's, of which the last one is the innermost: the wire's come before them.
    places = [re.sub(r"\.\d+-.*$", "", place) for place in re.findall(r" -src (\S+)", command)]
    places = [place.split(".v:")[0] + ".v:" + place.split(".v:")[1].split(".")[0] for place in places if ".v:" in place]
    return Mutant(number, command, value("mode"), value("cell"), value("port"), int(value("portbit", "0")),
                  int(value("ctrlbit", "0")), value("wire"), int(value("wirebit", "0")),
                  tuple(dict.fromkeys(reversed(places))))


def retire_lines(path: Path) -> set[int]:
    """Lines that are there for the tests alone."""
    lines, inside, found = path.read_text(encoding="utf-8").splitlines(), False, set()
    for number, line in enumerate(lines, 1):
        if line.startswith("`ifdef RUNG_RETIRE"):
            inside = True
        elif line.startswith("`else") or line.startswith("`endif"):
            inside = False
        if inside:
            found.add(number)
    return found


def for_tests_only(mutant: Mutant, lines: dict[str, set[int]]) -> bool:
    return any(int(place.split(":")[1]) in lines.get(place.split(":")[0], ()) for place in mutant.places)


def made(script: Path, text: str, sources: list[Path], results: list[Path]) -> None:
    """Run a Yosys script unless its results are those of the same script, sources and Yosys."""
    stamp = script.with_suffix(".inputs")
    want = tools.digest([text, yosys_version()], sources)
    if tools.up_to_date(stamp, want, results):
        return
    stamp.unlink(missing_ok=True)
    tools.write_file(script, text)
    tools.run([tools.YOSYS, "-s", str(script)], tools.LOGS / f"mutate-{script.parent.name}-{script.stem}.log")
    tools.write_file(stamp, want)


def draw(subject: Subject, seed: int) -> list[Mutant]:
    """The mutants, numbered from 1. Left out: faults of the clock, and of what is there for the tests alone."""
    tools.generate_isa_header()
    subject.folder.mkdir(parents=True, exist_ok=True)
    here = subject.folder.relative_to(tools.ROOT)
    script = subject.folder / "draw.ys"
    text = (read_script(subject) + f"write_rtlil {here}/whole.il\n"
            f"mutate -list {int(subject.wanted * SPARE)} -seed {seed} -o {here}/drawn.txt {subject.top}\n")
    made(script, text, [*subject.mutated, *subject.kept, *sorted(tools.GENERATED.glob("*.vh"))],
         [subject.folder / "whole.il", subject.folder / "drawn.txt"])
    lines = {str(path.relative_to(tools.ROOT)): retire_lines(path) for path in subject.mutated}
    drawn = [parse(line, 0) for line in (subject.folder / "drawn.txt").read_text(encoding="utf-8").splitlines()]
    mutants = [mutant for mutant in drawn if mutant.mode != "none" and mutant.port.lstrip("\\") not in ("CLK", "clk_i")
               and "$meminit" not in mutant.cell and not for_tests_only(mutant, lines)]
    # They come in an order by chance: any first part of them is even too.
    return [parse(mutant.command, number) for number, mutant in enumerate(mutants[:subject.wanted], 1)]


def apply(mutant: Mutant) -> str:
    return mutant.command.replace("mutate ", f"mutate -ctrl rung_mutant {BITS} {mutant.number} ", 1)


def write(subject: Subject, mutants: list[Mutant], folder: Path) -> None:
    """NAME.v in `folder`, in which any of the mutants can be chosen, and NAME.txt (tb/mutate/mutated.cmake)."""
    here = subject.folder.relative_to(tools.ROOT)
    script = subject.folder / "netlist.ys"
    lines = [
        f"read_rtlil {here}/whole.il", *map(apply, mutants),
        # A fault drives one bit of a signal from others of it: no loop, but Verilator would take it for one, and be slow.
        f"delete -input {subject.top}/w:rung_mutant", "splitnets -driver", "opt_clean",
        f"write_verilog -noattr {here}/netlist.v", ""]
    made(script, "\n".join(lines), [subject.folder / "whole.il"], [subject.folder / "netlist.v"])
    text = (subject.folder / "netlist.v").read_text(encoding="utf-8")
    text, found = re.subn(
        rf"^  wire \[{BITS - 1}:0\] rung_mutant;$",
        f"  reg [{BITS - 1}:0] rung_mutant;\n  import \"DPI-C\" function int rung_mutant_number(input string netlist);\n"
        f"  initial rung_mutant = rung_mutant_number(\"{subject.name}\");", text, flags=re.MULTILINE)
    if found != 1:
        raise tools.FlowError(f"{subject.name}: the netlist has no rung_mutant")
    names = "".join(f"{path.relative_to(tools.ROOT)}\n" for path in subject.mutated)
    for file, content in ((folder / f"{subject.name}.v", text), (folder / f"{subject.name}.txt", names)):
        if not file.exists() or file.read_text(encoding="utf-8") != content:
            tools.write_file(file, content)
