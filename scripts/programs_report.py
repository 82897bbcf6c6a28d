#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write reports/programs.md: which real programs run, why the others are refused, and what
instructions beyond contacts and coils cost.

The programs are in ../shared/programs/melsec, which is not part of the project; without them there
is nothing to report. Every program that is taken runs 1,000 scans under random inputs on each
processor, beside the reference, and as C.
"""
from __future__ import annotations

import datetime
import json
import random
import re
import subprocess
import sys
from pathlib import Path

from instruction_costs import COPIES, COSTS, FEW_COPIES, WITHOUT, copies

ROOT = Path(__file__).resolve().parent.parent
RUNG = ROOT / "build" / "bin" / "rung"
CORPUS = ROOT.parent / "shared" / "programs" / "melsec"
BUILD = ROOT / "build"
SCANS = 1000
SEED = 2013
MPUS = ("1", "2", "3")


def rung(*arguments: str, text: str | None = None) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(RUNG), *arguments], input=text, capture_output=True, text=True,
                          check=False)


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


def program_row(program: Path) -> str:
    compiled = rung("compile", str(program), "--json")
    if compiled.returncode == 1:
        errors = re.findall(r"^.*?:(\d+):\d+: error: (.*)$", compiled.stderr, re.MULTILINE)
        line, why = errors[0]
        more = f"; and {len(errors) - 1} more" if len(errors) > 1 else ""
        return f"| {program.name} | refused | line {line}: {why}{more} | | | |"
    counts = json.loads(compiled.stdout)
    stimulus = BUILD / "programs-report.stim"
    write_stimulus(program, stimulus)
    costs = []
    for mpu in MPUS:
        run = rung("run", str(program), "--mpu", mpu, "--stimulus", str(stimulus))
        if run.returncode != 0:
            sys.exit(f"{program.name} on MPU{mpu}:\n{run.stderr}")
        result = json.loads(rung("compile", str(program), "--mpu", mpu, "--json").stdout)
        costs.append(f"{result['steps']} / {result['clocks']}")
    return (f"| {program.name} | runs | {counts['instructions']} instructions, dialect "
            f"{counts['dialect']} | {' | '.join(costs)} |")


def compiled(text: str, mpu: str) -> tuple[int, int]:
    """Steps and clocks of a list."""
    result = rung("compile", "-", "--mpu", mpu, "--json", text=text)
    if result.returncode != 0:
        sys.exit(f"{result.stderr}{text}")
    counts = json.loads(result.stdout)
    return counts["steps"], counts["clocks"]


def cost(template: str, base: str, mpu: str, count: int) -> str:
    """Steps, and clocks where they differ, that one more of it takes among others."""
    with_it = compiled(copies(template, count), mpu)
    without = compiled(copies(base, count), mpu)
    steps, clocks = ((a - b) / count for a, b in zip(with_it, without))
    return f"{steps:.1f}" if abs(steps - clocks) < 0.05 else f"{steps:.1f} ({clocks:.1f})"


def cost_row(name: str, template: str, base: str, count: int) -> str:
    return f"| {name} | " + " | ".join(cost(template, base, mpu, count) for mpu in MPUS) + " |"


def main() -> int:
    if not CORPUS.is_dir():
        print("skipped: no corpus (../shared/programs/melsec)")
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
        "the index register were added because of these differences.", "",
        "| | MPU1 | MPU2 | MPU3 |", "|---|---|---|---|",
        *(cost_row(*entry, FEW_COPIES) for entry in WITHOUT), ""])
    target = ROOT / "reports" / "programs.md"
    temporary = target.with_suffix(".tmp")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(target)
    print(f"wrote reports/programs.md: {taken} of {len(programs)} programs run")
    return 0


if __name__ == "__main__":
    sys.exit(main())
