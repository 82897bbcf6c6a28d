#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Place and route the processors in their board tops; area and clock as a table.

reports/area-timing.json is written when all processors run on all boards with seeds 1 to 5; else the
table is only printed.
"""
from __future__ import annotations

import argparse
import datetime
import json
import sys
from typing import Any

from flow import area, stages, tools
from flow.designs import BOARDS, MPUS, rung_design
from flow.place_route import nextpnr_version
from flow.synthesis import yosys_version

ALL_SEEDS = [1, 2, 3, 4, 5]


def line(record: dict[str, Any]) -> str:
    fmax, path = record["fmax_mhz"], record["critical_path"]
    return (f"MPU{record['mpu']} {record['board']:6} {record['logic_cells']:6} logic cells "
            f"{record['flip_flops']:5} FFs {record['block_rams']:4} RAMs {record['dsps']:2} DSPs  "
            f"{fmax['min']:6.1f} {fmax['median']:6.1f} {fmax['max']:6.1f} MHz  "
            f"{path['stage']}: {path['start']} -> {path['end']}")


def report(records: list[dict[str, Any]]) -> dict[str, Any]:
    """What reports/area-timing.json holds: the records, and with what they were made."""
    families = [board.family for board in BOARDS.values()]
    return {
        "made_by": "make pnr",
        "date": datetime.date.today().isoformat(),
        "tools": {"yosys": yosys_version(),
                  **{f"nextpnr-{f.name}": nextpnr_version(f.nextpnr).removeprefix("nextpnr-")
                     for f in families}},
        "options": {f.name: " ".join((f.synth, *f.nextpnr_options)) for f in families},
        "seeds": ALL_SEEDS,
        "results": records,
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--mpu", type=int, nargs="+", choices=MPUS, default=list(MPUS))
    parser.add_argument("--board", nargs="+", choices=list(BOARDS), default=list(BOARDS))
    parser.add_argument("--seeds", type=int, nargs="+", default=ALL_SEEDS)
    parser.add_argument("--jobs", type=int, default=2, help="runs of nextpnr at once")
    arguments = parser.parse_args()
    tools.generate_isa_header()
    records = []
    for board in arguments.board:
        for mpu in arguments.mpu:
            record = area.measure(rung_design(mpu, BOARDS[board]), arguments.seeds, arguments.jobs)
            path = record["critical_path"]
            path["stage"] = stages.stage(path["start"], path["end"])
            records.append({"mpu": mpu, "board": board, "config": BOARDS[board].config, **record})
            tools.say(line(records[-1]))
    if (sorted(arguments.mpu) == list(MPUS) and sorted(arguments.board) == sorted(BOARDS)
            and sorted(arguments.seeds) == ALL_SEEDS):
        tools.write_file(tools.REPORTS / "area-timing.json",
                         json.dumps(report(records), indent=1) + "\n")
        tools.say("wrote reports/area-timing.json")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
