#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Place and route MPU4 in its board top; area, clock, and the time of a source instruction of the paper's Sample 1.

Writes reports/wide-timing.json and wide-timing.md with whatever slots and seeds were asked for, and says which; of other
slots what the same tools have reported stays, with its date.
Needs build/bin/rung and build/bin/rung-samples. A placed seed is kept (build/pnr), so more seeds can be added.
"""
from __future__ import annotations

import argparse
import datetime
import json
import statistics
import subprocess
import sys
from typing import Any

from flow import area, tools
from flow.designs import WIDE, WIDE_BOARD, wide_design
from flow.place_route import nextpnr_version
from flow.synthesis import yosys_version

ALL_SEEDS = [1, 2, 3, 4, 5]
BIN = tools.BUILD / "bin"
TIMING = tools.REPORTS / "wide-timing.json"
GOAL_NS = {8: 0.98, 16: 0.48}  # a source instruction of the mix
DENSITY = 30  # tb/programs/samples.hpp
PROGRAMS = [1, 2, 3, 4, 5]  # stand-ins of Sample 1, by their seeds


def scans(slots: int) -> list[dict[str, Any]]:
    """Instructions and clocks of a scan, input latch and the end of divisions included, of each stand-in of Sample 1."""
    found = []
    folder = tools.BUILD / "wide"
    folder.mkdir(parents=True, exist_ok=True)
    for seed in PROGRAMS:
        listing = folder / f"sample1-{seed}.il"
        listing.write_bytes(subprocess.run([str(BIN / "rung-samples"), "--sample", "1", "--density", str(DENSITY), "--seed", str(seed)],
                                           capture_output=True, check=True).stdout)
        made = json.loads(subprocess.run([str(BIN / "rung"), "compile", str(listing), "--dialect", "paper", "--mpu", "4",
                                          "--slots", str(slots), "--json"], capture_output=True, check=True).stdout)
        found.append({"sample": 1, "seed": seed, "instructions": made["instructions"], "clocks": made["clocks"], "steps": made["steps"]})
    return found


def render(report: dict[str, Any]) -> str:
    lines = ["# MPU4: area, clock, time of an instruction", "",
             f"Made by `make pnr-wide` on {report['date']}: {report['tools']['yosys']}, nextpnr {report['tools']['nextpnr-ecp5']}, ECP5-85F grade 6, "
             f"`{report['options']}`. Stand-ins of the paper's Sample 1 (the mix: contacts, coils, MV, ADD, SUB, MUL, DIV; density {DENSITY}, "
             f"seeds 1 to {len(PROGRAMS)}, median), clocks of a scan with input latch and the ends of DIV, which the tests assert on the RTL.", "",
             "| slots | date | seeds | MHz least | median | most | logic cells | flip-flops | block RAMs | DSPs | clocks a scan | ns a scan | ns an instruction | goal |",
             "|--:|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"]
    for row in report["results"]:
        fmax = row["fmax_mhz"]
        lines.append(f"| {row['slots']} | {row['date']} | {', '.join(fmax['seeds'])} | {fmax['min']} | {fmax['median']} | {fmax['max']} | {row['logic_cells']} | "
                     f"{row['flip_flops']} | {row['block_rams']} | {row['dsps']} | {row['clocks']} | {row['scan_ns']} | **{row['instruction_ns']}** | "
                     f"{row['goal_ns'] or ''} |")
    lines += ["", *(f"Slowest with {row['slots']} slots: `{row['critical_path']['start']}` to `{row['critical_path']['end']}`."
                    for row in report["results"]), ""]
    return "\n".join(lines)


def kept(report: dict[str, Any], slots: list[int]) -> list[dict[str, Any]]:
    """What the last report has of other slots, if it is of the same tools and options."""
    old = json.loads(TIMING.read_text()) if TIMING.exists() else {}
    if any(old.get(key) != report[key] for key in ("tools", "options")):
        return []
    return [{"date": old["date"], **record} for record in old["results"] if record["slots"] not in slots]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--slots", type=int, nargs="+", choices=list(WIDE), default=list(WIDE))
    parser.add_argument("--seeds", type=int, nargs="+", default=ALL_SEEDS)
    parser.add_argument("--jobs", type=int, default=1, help="runs of nextpnr at once")
    arguments = parser.parse_args()
    tools.generate_isa_header()
    today = datetime.date.today().isoformat()
    records = []
    for slots in arguments.slots:
        record = {"slots": slots, "date": today, **area.measure(wide_design(slots), arguments.seeds, arguments.jobs)}
        record["samples"] = scans(slots)
        record["clocks"] = statistics.median(sample["clocks"] for sample in record["samples"])
        record["scan_ns"] = round(1000 * record["clocks"] / record["fmax_mhz"]["median"], 1)
        record["instruction_ns"] = round(record["scan_ns"] / record["samples"][0]["instructions"], 3)
        record["goal_ns"] = GOAL_NS.get(slots)
        records.append(record)
        fmax, path = record["fmax_mhz"], record["critical_path"]
        tools.say(f"MPU4, {slots} slots: {record['logic_cells']} logic cells {record['flip_flops']} FFs "
                  f"{record['block_rams']} RAMs {record['dsps']} DSPs  "
                  f"{fmax['min']} {fmax['median']} {fmax['max']} MHz  {path['start']} -> {path['end']}")
    report = {
        "made_by": "make pnr-wide",
        "date": today,
        "tools": {"yosys": yosys_version(),
                  "nextpnr-ecp5": nextpnr_version(WIDE_BOARD.family.nextpnr).removeprefix("nextpnr-")},
        "options": " ".join((WIDE_BOARD.family.synth, *WIDE_BOARD.family.nextpnr_options)),
        "results": [],
    }
    report["results"] = sorted(records + kept(report, arguments.slots), key=lambda record: record["slots"])
    tools.write_file(TIMING, json.dumps(report, indent=1) + "\n")
    tools.write_file(tools.REPORTS / "wide-timing.md", render(report))
    tools.say("wrote reports/wide-timing.json and wide-timing.md")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
