#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Functional coverage of the processors: run coverage_functional, write reports/coverage.md and coverage.json (`make cov`)."""
from __future__ import annotations

import argparse
import datetime
import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from flow import tools

RESULTS = tools.BUILD / "coverage"


def share(hit: int, of: int) -> str:
    return f"{hit:,} of {of:,} ({100 * hit / of:.1f} %)"


def render(report: dict[str, Any]) -> str:
    lines = ["# Coverage: the pipeline's situations", "",
             f"Made by {report['made_by']} on {report['date']} in {report['seconds']} s on a shared machine, with "
             f"{report['verilator']}.", "",
             "A situation is opcode x slot x gate (none, always, open, shut) x operand x where the operand comes from: a constant, N0, the "
             "memory, or a write 1 to 5 steps before, of the same or the other slot, carried out or stopped by its gate; a write of "
             "the other slot in the step itself; for ix, whether it was set just before. They are counted over what retires on the RTL, in "
             f"{report['programs']} random programs of {report['steps']} steps (seeds from 1 on) in each configuration, each checked "
             "against the step model, and in the golden programs. What cannot be is left out by the rules of `FunctionalCoverage::can_be` "
             "(`tb/coverage/functional.hpp`); a situation that comes up against them fails the test.", "",
             "| processor | scans of random programs | of golden programs | situations reached |", "|---|--:|--:|---|"]
    lines += [f"| MPU{each['mpu']} | {each['random_scans']:,} | {each['golden_scans']:,} | {share(each['hit'], each['all'])} |"
              for each in report["mpus"]]
    lines += ["", "## By opcode", "", "| opcode | " + " | ".join(f"MPU{each['mpu']}" for each in report["mpus"]) + " |",
              "|---|" + "--:|" * len(report["mpus"])]
    opcodes = sorted({opcode for each in report["mpus"] for opcode in each["opcodes"]})
    for opcode in opcodes:
        counts = [each["opcodes"].get(opcode) for each in report["mpus"]]
        lines.append(f"| {opcode} | " + " | ".join(f"{count['hit']} of {count['all']}" if count else "" for count in counts) + " |")
    holes = [hole for each in report["mpus"] for hole in each["holes"]]
    lines += ["", f"## Holes: {len(holes)}", "", *(f"- {hole}" for hole in holes)]
    return "\n".join(lines) + "\n"


def write(counts: dict[str, Any], made_by: str, seconds: float) -> None:
    verilator = subprocess.run(["verilator", "--version"], capture_output=True, text=True, check=True).stdout
    report = {"made_by": made_by, "date": datetime.date.today().isoformat(), "seconds": seconds,
              "verilator": " ".join(verilator.split()[:2]), **counts}
    tools.write_file(tools.REPORTS / "coverage.json", json.dumps(report, indent=1) + "\n")
    tools.write_file(tools.REPORTS / "coverage.md", render(report))
    tools.say("wrote reports/coverage.md and coverage.json")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("test", type=Path, help="coverage_functional")
    parser.add_argument("--programs", type=int, default=2000)
    parser.add_argument("--counted", type=float, metavar="SECONDS",
                        help="no run: TEST is the functional.json that one has left, which took so long")
    arguments = parser.parse_args()
    if arguments.counted is not None:
        write(json.loads(arguments.test.read_text()), "`coverage_functional` by hand", arguments.counted)
        return 0
    RESULTS.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()
    code = subprocess.run([str(arguments.test.resolve()), "--gtest_brief=1"], check=False,
                          env={**os.environ, "RUNG_PROGRAMS": str(arguments.programs), "RUNG_COVERAGE": str(RESULTS)}).returncode
    if code != 0:
        raise tools.FlowError("coverage_functional failed")
    counts = json.loads((RESULTS / "functional.json").read_text())
    write(counts, f"`make cov COUNT={counts['programs']}`", round(time.monotonic() - start, 1))
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
