#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write reports/programs.md: which real lists run, and why the others are refused.

The lists are in ../shared/programs/melsec, which is not part of the project; without them there is
nothing to report. Every list that is taken runs 1,000 scans under random inputs on each processor,
beside the reference.
"""
from __future__ import annotations

import datetime
import json
import random
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RUNG = ROOT / "build" / "bin" / "rung"
CORPUS = ROOT.parent / "shared" / "programs" / "melsec"
STIMULUS = ROOT / "build" / "programs-report.stim"
SCANS = 1000
SEED = 2013


def rung(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(RUNG), *arguments], capture_output=True, text=True, check=False)


def write_stimulus(program: Path) -> None:
    """Random values for the inputs, and now and then for the words, of a program."""
    trace = rung("run", str(program), "--mpu", "reference", "--state", "--trace", "-").stdout
    devices = json.loads(trace.splitlines()[1])["state"]
    chance = random.Random(SEED)
    lines = []
    for _ in range(SCANS):
        tokens = [f"{name}={chance.randint(0, 1)}" for name in devices
                  if name.startswith("X") and chance.random() < 0.4]
        tokens += [f"{name}={chance.randint(-32768, 32767)}" for name in devices
                   if name.startswith("D") and chance.random() < 0.05]
        lines.append(" ".join(tokens))
    STIMULUS.write_text("\n".join(lines) + "\n")


def row(program: Path) -> str:
    compiled = rung("compile", str(program), "--json")
    if compiled.returncode == 1:
        errors = re.findall(r"^.*?:(\d+):\d+: error: (.*)$", compiled.stderr, re.MULTILINE)
        line, why = errors[0]
        more = f"; and {len(errors) - 1} more" if len(errors) > 1 else ""
        return f"| {program.name} | refused | line {line}: {why}{more} | | | |"
    counts = json.loads(compiled.stdout)
    write_stimulus(program)
    steps = []
    for mpu in ("1", "2", "3"):
        run = rung("run", str(program), "--mpu", mpu, "--stimulus", str(STIMULUS))
        if run.returncode != 0:
            sys.exit(f"{program.name} on MPU{mpu}:\n{run.stderr}")
        steps.append(str(json.loads(rung("compile", str(program), "--mpu", mpu, "--json").stdout)
                         ["steps"]))
    return (f"| {program.name} | runs | {counts['instructions']} instructions, dialect "
            f"{counts['dialect']} | {' | '.join(steps)} |")


def main() -> int:
    if not CORPUS.is_dir():
        print("skipped: no corpus (../shared/programs/melsec)")
        return 0
    programs = sorted(p for p in CORPUS.iterdir() if p.suffix in (".lst", ".esc", ".txt"))
    rows = [row(program) for program in programs]
    taken = sum("| runs |" in r for r in rows)
    text = "\n".join([
        "# Real programs", "",
        f"Made by `make programs` on {datetime.date.today().isoformat()}: the plain and step lists of "
        f"`../shared/programs/melsec`, {len(programs)} in all. {taken} run: {SCANS} scans under random "
        f"inputs (seed {SEED}) on MPU1, MPU2 and MPU3, every write, output and clock as the reference "
        "and the compiler have it. The others need more than this version has, and are refused by "
        "instruction and line.", "",
        "| program | | | steps MPU1 | MPU2 | MPU3 |", "|---|---|---|---|---|---|", *rows, ""])
    target = ROOT / "reports" / "programs.md"
    temporary = target.with_suffix(".tmp")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(target)
    print(f"wrote reports/programs.md: {taken} of {len(programs)} lists run")
    return 0


if __name__ == "__main__":
    sys.exit(main())
