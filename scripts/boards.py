#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The controller on its boards: bitstreams, area and clock over the seeds, area by module; writes
reports/boards.json and boards.md. Exit 1 if a board is too small,
its clock is missed or a bound of area is passed.
"""
from __future__ import annotations

import argparse
import datetime
import json
import statistics
import sys
import tomllib
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from flow import area, bitstream, boards_report, tools
from flow.designs import PLC_BOARDS, Board, plc_design
from flow.place_route import DoesNotFit, nextpnr_version, place_and_route
from flow.synthesis import synthesise, yosys_version


def measure(name: str, board: Board, seeds: list[int], jobs: int) -> dict[str, Any]:
    """One board's record, with `needs` instead of its figures if it does not fit. Clocks in MHz."""
    design = plc_design(board)
    netlist = synthesise(design)
    toml = tomllib.loads((tools.ROOT / "hdl" / "isa" / "boards.toml").read_text())["board"][name]
    record = {"board": name, "title": board.title, "config": board.config, "mpu": toml["mpu"],
              "board_mhz": board.goal_mhz, "parts": boards_report.parts(design)}
    try:
        with ThreadPoolExecutor(max_workers=jobs) as pool:
            runs = list(pool.map(lambda seed: place_and_route(design, netlist, seed), seeds))
    except DoesNotFit as error:
        tools.say(str(error))
        return {**record, "needs": {kind: list(pair) for kind, pair in error.needs.items()}}
    made = bitstream.build(board, seeds)
    kinds, first = board.family.utilization, made.routed

    def used(what: str) -> int:
        return sum(first.used.get(kind, 0) for kind in kinds[what])

    def available(what: str) -> int:
        return first.available[kinds[what][0]]

    flip_flops = sum(bool(area.FLIP_FLOP.match(kind)) for kind in area.cells(netlist, design.top).values())
    mhz = [run.fmax_mhz for run in runs]
    return {
        **record,
        "logic_cells": used("logic_cells"), "logic_cells_available": available("logic_cells"),
        "flip_flops": flip_flops,
        "block_rams": used("block_rams"), "block_rams_available": available("block_rams"),
        "dsps": used("dsps"),
        "fmax_mhz": {"min": round(min(mhz), 1), "median": round(statistics.median(mhz), 1),
                     "max": round(max(mhz), 1),
                     "seeds": {str(run.seed): round(run.fmax_mhz, 1) for run in runs}},
        "bitstream": {"file": made.file.name, "bytes": made.file.stat().st_size, "seed": first.seed},
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("--jobs", type=int, default=2, help="runs of nextpnr at once")
    arguments = parser.parse_args()
    tools.generate_isa_header()
    records = [measure(name, board, arguments.seeds, arguments.jobs) for name, board in PLC_BOARDS.items()]
    families = [board.family for board in PLC_BOARDS.values()]
    report = {
        "made_by": "make boards",
        "date": datetime.date.today().isoformat(),
        "tools": {"yosys": yosys_version(),
                  **{f"nextpnr-{f.name}": nextpnr_version(f.nextpnr).removeprefix("nextpnr-")
                     for f in families}},
        "options": {f.name: " ".join((f.synth, *f.nextpnr_options)) for f in families},
        "seeds": arguments.seeds,
        "bounds": boards_report.BOUNDS,
        "boards": records,
    }
    tools.write_file(tools.REPORTS / "boards.json", json.dumps(report, indent=1) + "\n")
    tools.write_file(tools.REPORTS / "boards.md", boards_report.render(report))
    tools.say("wrote reports/boards.json and boards.md")
    missed = boards_report.missed(report)
    for text in missed:
        print(text, file=sys.stderr)
    return 1 if missed else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
