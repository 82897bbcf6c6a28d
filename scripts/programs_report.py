#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write reports/programs.md: which real programs run, why the others are refused, and what
instructions beyond contacts and coils cost.

The programs are in ../shared/programs, which is not part of the project; without them there is
nothing to report. Every list that is taken runs 1,000 scans under random inputs on each processor,
beside the reference, and as C; an LDmicro program runs beside its trace (ldmicro_report.py).
"""
from __future__ import annotations

import datetime
import json
import random
import re
import sys
import time
from pathlib import Path

import ldmicro_report
from instruction_costs import (COIL, COPIES, COSTS, FEW_COPIES, TIMER, WITHOUT, copies,
                               large_program)
from rung_program import (BUILD, MPUS, PROGRAMS, ROOT, compiled, first_error, processor, rung,
                          steps_and_clocks)

CORPUS = PROGRAMS / "melsec"
SCANS = 1000
SEED = 2013
LARGE = 20000  # instructions


def write_stimulus(program: Path, file: Path) -> None:
    """Random values for the inputs, and now and then for the words, of a program."""
    trace = rung("run", str(program), "--mpu", "reference", "--state", "--trace", "-").stdout
    devices = json.loads(trace.splitlines()[1])["state"]
    chance = random.Random(SEED)
    lines = []
    for _ in range(SCANS):
        tokens = [f"{name}={chance.randint(0, 1)}" for name in devices
                  if re.fullmatch(r"X\w+", name) and chance.random() < 0.4]
        tokens += [f"{name}={chance.randint(-32768, 32767)}" for name in devices
                   if re.fullmatch(r"[DRW]\w+", name) and chance.random() < 0.05]
        lines.append(" ".join(tokens))
    file.write_text("\n".join(lines) + "\n")


class Timers:
    """How much of the real programs their timers are."""

    count = 0
    steps = 0  # of all programs on MPU2

    @classmethod
    def add(cls, program: Path, steps: int) -> None:
        text = rung("translate", str(program), "--to", "il").stdout
        cls.count += len(re.findall(r"^OUTH? S?T\d", text, re.MULTILINE))
        cls.steps += steps

    @classmethod
    def sentence(cls) -> str:
        each = float(cost(dict((name, template) for name, template, _ in COSTS)[TIMER], COIL, "2",
                          COPIES))
        share = 100 * cls.count * each / cls.steps
        return (f"A timer has no core instruction of its own: the {cls.count} timers of the real programs "
                f"take {share:.0f} % of their {cls.steps} steps on MPU2. One that added, compared and wrote value "
                "and contact at once would need a third operand and a second bit in the instruction, and a compare "
                "behind the adder in EX.")


def program_row(program: Path) -> str:
    result = rung("compile", str(program), "--json")
    if result.returncode == 1:
        return f"| {program.name} | refused | {first_error(result.stderr)} | | | |"
    counts = json.loads(result.stdout)
    stimulus = BUILD / "programs-report.stim"
    write_stimulus(program, stimulus)
    costs = []
    for mpu in MPUS:
        run = rung("run", str(program), "--mpu", mpu, "--stimulus", str(stimulus))
        if run.returncode != 0:
            sys.exit(f"{program.name} on MPU{mpu}:\n{run.stderr}")
        size = json.loads(rung("compile", str(program), "--mpu", mpu, "--json").stdout)
        costs.append(f"{size['steps']} / {size['clocks']}")
        if mpu == "2":
            Timers.add(program, size["steps"])
    return (f"| {program.name} | runs | {counts['instructions']} instructions, dialect "
            f"{counts['dialect']} | {' | '.join(costs)} |")


def cost(template: str, base: str, mpu: str, count: int) -> str:
    """Steps, and clocks where they differ, that one more of it takes among others."""
    with_it = compiled(copies(template, count), mpu)
    without = compiled(copies(base, count), mpu)
    steps, clocks = ((a - b) / count for a, b in zip(with_it, without))
    return steps_and_clocks(steps, clocks)


def cost_row(name: str, template: str, base: str, count: int) -> str:
    return f"| {name} | " + " | ".join(cost(template, base, mpu, count) for mpu in MPUS) + " |"


def compile_times() -> list[str]:
    """Rows: how long a long program takes to compile, the best of five runs."""
    text = large_program(LARGE, SEED)
    rows = []
    for mpu in ("2", "3"):  # MPU1 has no room for it
        best = None
        for _ in range(5):
            start = time.monotonic()
            steps, clocks = compiled(text, mpu)
            took = time.monotonic() - start
            best = took if best is None else min(best, took)
        rows.append(f"| MPU{mpu} | {best:.2f} s | {steps} / {clocks} |")
    return rows


def main() -> int:
    if not CORPUS.is_dir() or not ldmicro_report.CORPUS.is_dir():
        print("skipped: no corpus (../shared/programs/melsec, ../shared/programs/ldmicro)")
        return 0
    programs = sorted(p for p in CORPUS.iterdir() if p.suffix in (".lst", ".esc", ".txt", ".csv"))
    rows = [program_row(program) for program in programs]
    taken = sum("| runs |" in r for r in rows)
    text = "\n".join([
        "# Real programs, and what instructions cost", "",
        f"Made by `make programs` on {datetime.date.today().isoformat()} (configuration ecp5).", "",
        "## Real programs", "",
        f"The lists and exports of `../shared/programs/melsec`, {len(programs)} in all. {taken} run: "
        f"{SCANS} scans under random inputs (seed {SEED}) on MPU1, MPU2 and MPU3, every write, output "
        "and clock as the reference and the compiler have it (the C back end runs the same programs in "
        "`make test`). The others use hardware that this controller does not have, cannot have a "
        "constant scan, or are faulty: the first error of each is shown. Steps and, behind the slash, "
        "clocks of a scan.", "",
        "| program | | | MPU1 | MPU2 | MPU3 |", "|---|---|---|---|---|---|", *rows, "",
        "## What an instruction costs", "",
        f"Steps that one more of it takes: the difference of {COPIES} rungs with it and the same rungs "
        "with `OUT Y` in its place, divided by "
        f"{COPIES}. In brackets clocks, where steps wait for the multiply-divide unit.", "",
        "| | MPU1 | MPU2 | MPU3 |", "|---|---|---|---|",
        *(cost_row(*entry, COPIES) for entry in COSTS), "",
        "## Core instructions that were added, and what they save", "",
        "The same work with the added instruction and written out with the ones that were there before "
        f"(and compares), steps each, {FEW_COPIES} copies. The full multiply-divide unit, the carry, the gathering of bits and "
        "the index register were added because of these differences.", "", Timers.sentence(), "",
        "| | MPU1 | MPU2 | MPU3 |", "|---|---|---|---|",
        *(cost_row(*entry, FEW_COPIES) for entry in WITHOUT), "",
        *ldmicro_report.sections(),
        "## Compile time", "",
        f"A generated program of {LARGE} instructions (scripts/instruction_costs.py, seed {SEED}), all "
        f"passes and their checks included, best of five on this machine ({processor()}).", "",
        "| | time | steps / clocks |", "|---|---|---|", *compile_times(), ""])
    target = ROOT / "reports" / "programs.md"
    temporary = target.with_suffix(".tmp")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(target)
    print(f"wrote reports/programs.md: {taken} of {len(programs)} programs run")
    return 0


if __name__ == "__main__":
    sys.exit(main())
