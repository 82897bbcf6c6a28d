#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The headline table of README.md, from reports/area-timing.json, wide-timing.json and yardsticks.json.

usage: headline.py          rewrite the table in README.md
       headline.py --check  exit 1 if README.md does not say what the reports say
"""
from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
BEGIN, END = "<!-- headline: written by `make report` -->\n", "<!-- end of headline -->\n"


def load(name: str) -> dict[str, Any]:
    return json.loads((ROOT / "reports" / name).read_text(encoding="utf-8"))


def our_row(mpu: int, area: dict[str, Any], sample: dict[str, Any]) -> str:
    """One processor: Sample 1 on the ECP5, its clock on both parts, its size."""
    results = {r["config"]: r for r in area["results"] if r["mpu"] == mpu}
    run = next(r for r in sample["rung"] if r["mpu"] == mpu and r["config"] == "ecp5")
    ecp5, hx8k = (results[config]["fmax_mhz"]["median"] for config in ("ecp5", "hx8k"))
    time = run["clocks"] / ecp5
    return (f"| **MPU{mpu}** | {run['steps']} | {run['clocks']} | {ecp5:.0f} | {time:.2f} | "
            f"{1000 * time / run['instructions']:.1f} | {results['ecp5']['logic_cells']} | {hx8k:.0f} |")


def wide_run(result: dict[str, Any]) -> tuple[dict[str, Any], float]:
    """MPU4's run of the same program, which is the stand-in of seed 1, and the microseconds of its scan."""
    run = next(sample for sample in result["samples"] if sample["seed"] == 1)
    return run, run["clocks"] / result["fmax_mhz"]["median"]


def wide_row(result: dict[str, Any]) -> str:
    run, time = wide_run(result)
    mhz = result["fmax_mhz"]["median"]
    return (f"| **MPU4**, {result['slots']} slots | {run['steps']} | {run['clocks']} | {mhz:.0f} | {time:.2f} | "
            f"{1000 * time / run['instructions']:.2f} | {result['logic_cells']} | |")


def wide_seeds(wide: dict[str, Any]) -> str:
    return "; ".join(f"{result['slots']} slots {', '.join(result['fmax_mhz']['seeds'])}" for result in wide["results"])


def core_row(core: dict[str, Any], sample: dict[str, Any], instructions: int) -> str:
    """A soft core in the same ECP5, scan after scan."""
    run = next(r for r in sample["cores"] if r["name"] == core["name"])
    clocks, clock = run["warm"]["median"], core["fmax_mhz"]["median"]
    time = clocks / clock
    return (f"| {core['name']} | | {clocks:.0f} | {clock:.0f} | {time:.1f} | "
            f"{1000 * time / instructions:.0f} | {core['logic_cells']} | |")


def seeds(report: dict[str, Any]) -> str:
    first, last = report["seeds"][0], report["seeds"][-1]
    return f"{first}" if first == last else f"{first} to {last}"


def table() -> str:
    area, wide, yard = load("area-timing.json"), load("wide-timing.json"), load("yardsticks.json")
    sample = yard["samples"][0]
    instructions = next(r["instructions"] for r in sample["rung"] if r["fits"])
    host = sample["host"]
    faster = [f"{result['slots']} slots" for result in wide["results"] if 1000 * wide_run(result)[1] < host["median_ns"]]
    rows = [our_row(mpu, area, sample) for mpu in (1, 2, 3)]
    rows += [wide_row(result) for result in wide["results"]]
    rows += [core_row(core, sample, instructions) for core in yard["cores"]]
    return "\n".join([
        f"| Sample 1, {instructions} instructions | steps | clocks a scan | ECP5 MHz | scan, us | "
        "ns an instruction | logic cells | HX8K MHz |",
        "|---|--:|--:|--:|--:|--:|--:|--:|", *rows, "",
        f"ECP5-85F grade 6, {area['tools']['yosys']}, nextpnr {area['tools']['nextpnr-ecp5']}, "
        f"median of seeds {seeds(area)} (the soft cores {seeds(yard)}; MPU4, {wide['date']}: {wide_seeds(wide)}), {area['date']}. "
        "Logic cells of the processors include serial link, UART and PWM around them; the rest is in [reports/area-timing.md](reports/area-timing.md). A server core "
        f"({yard['host']['cpu']}, gcc -O2) takes {host['median_ns'] / 1000:.2f} us a scan, and the "
        f"worst of {host['scans']} scans took {host['worst_ns'] / 1000:.0f} us: "
        f"{'slower on average than MPU4 with ' + ' or '.join(faster) if faster else 'faster on average'}, and without a bound.", ""])


def main(argv: list[str]) -> int:
    text = README.read_text(encoding="utf-8")
    head, rest = text.split(BEGIN)
    tail = rest.split(END)[1]
    wanted = head + BEGIN + table() + END + tail
    if argv == ["--check"]:
        if text != wanted:
            print("README.md does not say what reports/ say: run scripts/headline.py", file=sys.stderr)
            return 1
        return 0
    temporary = README.with_suffix(".tmp")
    temporary.write_text(wanted, encoding="utf-8")
    temporary.replace(README)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
