# SPDX-License-Identifier: Apache-2.0
"""How fast translated C and interpreted byte code run LDmicro programs on this machine."""
from __future__ import annotations

import datetime
import os
import re
import subprocess
import sys
from pathlib import Path

from ldmicro_costs import typical
from rung_program import BUILD, PROGRAMS, ROOT, RUNG

CC = os.environ.get("CC", "gcc")
FLAGS = ["-O2", "-std=c99", "-Wall", "-Wextra", "-Werror"]
SOURCES = ROOT / "tb" / "yardstick"
INTERPRETER = ROOT / "compiler" / "bytecode" / "interpreter"
FOLDER = BUILD / "engine-speed"
RUN_NS = 20e6  # one run of the eleven takes at least this long
STAND_IN = 200  # rungs
SEED = 2013
REAL = ("c_demo", "swatch1", "ctu_ctd_ctc", "integers")

# What hooks give that C programs call (compiler/backends), by its place in `answers`; the others
# give the first one.
ANSWERS = {"PlcUartReady": 1, "PlcUartReceive": 2}


def call(*command: str | Path) -> str:
    run = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{run.stdout}{run.stderr}")
    return run.stdout


def hook(prototype: str, inputs: list[str]) -> str:
    """A definition for a prototype of the translated file."""
    kind, name, parameters = re.fullmatch(r"(\w+) (\w+)\((.*)\)", prototype).groups()
    if name.startswith("PlcInput_"):
        inputs.append(name)
        return f"static inline {prototype} {{ return inputs_now >> {(len(inputs) - 1) % 32} & 1; }}"
    taken = [parameter.split()[-1] for parameter in parameters.split(", ") if parameter != "void"]
    if kind == "void":
        return f"static inline {prototype} {{ sink += (uint32_t)({' + '.join(taken)}); }}"
    unused = "".join(f"(void){parameter}; " for parameter in taken)
    return f"static inline {prototype} {{ {unused}return ({kind})answers[{ANSWERS.get(name, 0)}]; }}"


def engine_of(c_file: Path) -> str:
    """The translated program with its hooks, as an engine of tb/yardstick/engine.h."""
    text = c_file.read_text(encoding="utf-8")
    declared = re.search(r"/\* Hooks \*/\n(.*?)\n\n", text + "\n", re.DOTALL)
    prototypes = re.findall(r"^(\w+ Plc\w+\(.*?\));", declared.group(1) if declared else "", re.MULTILINE)
    inputs: list[str] = []
    return "\n".join([
        '#include "engine.h"',
        "static uint32_t inputs_now;", "static volatile uint32_t sink;",
        "static volatile int16_t answers[] = {0, 1, -1};",
        *(hook(prototype, inputs) for prototype in prototypes),
        f'#include "{c_file.name}"',
        "int engine_start(const char *file) { (void)file; (void)inputs_now; (void)sink; (void)answers; PlcReset(); return 0; }",
        "void engine_scan(uint32_t inputs) { inputs_now = inputs; PlcCycle(); }", ""])


def median_ns(program: Path, *arguments: Path) -> float:
    """Nanoseconds a scan, the median of eleven runs."""
    first = float(call(program, "1000", *arguments))
    return float(call(program, str(max(1000, int(RUN_NS / first))), *arguments))


def c_engine(program: Path, folder: Path) -> Path:
    c_file = folder / "program.c"
    call(*rung_command("translate", program, "--to", "c", "-o", c_file))
    (folder / "engine.c").write_text(engine_of(c_file), encoding="utf-8")
    call(CC, *FLAGS, "-I", SOURCES, SOURCES / "engine_main.c", folder / "engine.c", "-o", folder / "c")
    return folder / "c"


def vm_engine() -> Path:
    program = FOLDER / "vm"
    call(CC, *FLAGS, "-I", SOURCES, "-I", INTERPRETER, SOURCES / "engine_main.c", SOURCES / "engine_vm.c",
         *sorted(INTERPRETER.glob("*.c")), "-o", program)
    return program


def rung_command(*arguments: str | Path) -> list[str | Path]:
    return [RUNG, *arguments]


def programs() -> list[tuple[str, Path]]:
    stand_in = FOLDER / "typical.ld"
    stand_in.write_text(typical(STAND_IN, SEED), encoding="utf-8")
    folder = PROGRAMS / "ldmicro" / "samples"
    real = [(name, folder / name / "prog.ld") for name in REAL]
    return [*((name, path) for name, path in real if path.is_file()),
            (f"typical rungs (scripts/ldmicro_costs.py, {STAND_IN} rungs, seed {SEED})", stand_in)]


def section(processor: str) -> list[str]:
    """The lines of the report."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    interpreter = vm_engine()
    rows = []
    for name, path in programs():
        folder = FOLDER / re.sub(r"\W.*", "", name)
        folder.mkdir(exist_ok=True)
        rungs = len(re.findall(r"^\s*RUNG", path.read_text(encoding="latin-1"), re.MULTILINE))
        file = folder / "program.rbc"
        call(*rung_command("translate", path, "--to", "bytecode", "-o", file))
        in_c = median_ns(c_engine(path, folder))
        in_vm = median_ns(interpreter, file)
        rows.append(f"| {name} | {rungs} | {in_c:.0f} | {in_c / rungs:.2f} | {in_vm:.0f} | {in_vm / rungs:.1f} | "
                    f"{file.stat().st_size} |")
    version = call(CC, "--version").splitlines()[0]
    return [
        f"Nanoseconds a scan and a rung under random inputs, the median of eleven runs, on {processor}, "
        f"{datetime.date.today().isoformat()}; {version}, {' '.join(FLAGS[:2])}. The C is `rung translate --to c`, with "
        "hooks that the compiler can inline; the byte code is `--to bytecode`, run by the interpreter of "
        "compiler/bytecode with its peripherals served (rung_io_scan). Inputs are set in both.", "",
        "| program | rungs | C, ns a scan | a rung | byte code, ns a scan | a rung | bytes |",
        "|---|---|---|---|---|---|---|", *rows]
