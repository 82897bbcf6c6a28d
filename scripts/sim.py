#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run a ladder program on the three Verilated processors and show what a scan costs on each.

With a golden trace beside the program (NAME.golden for NAME.il) every scan is checked against it;
without one the inputs are random and the reference interpreter runs beside the processor. Clock rates are the medians of
reports/area-timing.json; nothing is placed or routed here.
"""
from __future__ import annotations

import argparse
import json
import random
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RUNG = ROOT / "build" / "bin" / "rung"
EXAMPLE = ROOT / "tb" / "golden" / "programs" / "sorting_conveyor.il"
SCANS_WITHOUT_GOLDEN = 100


def shown(path: Path) -> str:
    """The path as a user would type it."""
    try:
        return str(path.resolve().relative_to(Path.cwd()))
    except ValueError:
        return str(path)


def rung(*arguments: str) -> str:
    """Standard output of rung; what it refuses or finds different ends this program."""
    run = subprocess.run([str(RUNG), *arguments], stdout=subprocess.PIPE, text=True, check=False)
    if run.returncode != 0:
        sys.exit(run.returncode)
    return run.stdout.strip()


def random_stimulus(program: str) -> Path:
    """Inputs that change at random, the same ones every time, for the X devices of the program."""
    trace = rung("run", program, "--mpu", "reference", "--state", "--trace", "-").splitlines()
    inputs = [name for name in json.loads(trace[1])["state"] if name.startswith("X")]
    chance = random.Random(1)
    path = ROOT / "build" / "sim-random.stim"
    path.write_text("".join(
        " ".join(f"{name}={chance.randint(0, 1)}" for name in inputs if chance.random() < 0.3) + "\n"
        for _ in range(SCANS_WITHOUT_GOLDEN)))
    return path


def clocks_mhz(config: str) -> dict[int, float]:
    """Median routed clock of each processor in this configuration; empty without a report."""
    report = ROOT / "reports" / "area-timing.json"
    if not report.exists():
        return {}
    return {r["mpu"]: r["fmax_mhz"]["median"] for r in json.loads(report.read_text())["results"]
            if r["config"] == config}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, default=EXAMPLE)
    parser.add_argument("--config", default="ecp5")
    arguments = parser.parse_args()
    program = shown(arguments.program)
    golden = arguments.program.with_suffix(".golden")
    options = ["--config", arguments.config]
    mhz = clocks_mhz(arguments.config)

    stimulus = None if golden.exists() else random_stimulus(program)

    rows = []
    for mpu in (1, 2, 3):
        target = [*options, "--mpu", str(mpu)]
        counts = json.loads(rung("compile", program, *target, "--json"))
        if golden.exists():
            print(rung("check", program, "--golden", shown(golden), *target))
        else:
            print(rung("run", program, *target, "--stimulus", shown(stimulus)))
        clock = mhz.get(mpu)
        rows.append((f"MPU{mpu}", str(counts["steps"]), str(counts["clocks"]),
                     f"{clock:.1f}" if clock else "-",
                     f"{counts['clocks'] / clock:.2f}" if clock else "-",
                     f"{1000 * counts['clocks'] / clock / counts['instructions']:.1f}"
                     if clock else "-"))
    head = ("", "steps", "clocks a scan", "MHz", "us a scan", "ns an instruction")
    widths = [max(len(row[i]) for row in [head, *rows]) for i in range(len(head))]
    print(f"\n{program}: {counts['instructions']} instructions in {counts['rungs']} rungs, "
          f"configuration {arguments.config}")
    for row in (head, *rows):
        print("  " + "  ".join(cell.rjust(width) for cell, width in zip(row, widths)))
    print("MHz: median routed clock in reports/area-timing.json"
          if mhz else "no reports/area-timing.json yet: `make pnr` makes it")
    return 0


if __name__ == "__main__":
    sys.exit(main())
