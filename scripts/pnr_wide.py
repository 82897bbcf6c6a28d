#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Place and route MPU4 with 8 and 16 slots in its board top; area and clock as a table.

reports/wide-timing.json is written when 8 and 16 slots run with seeds 1 to 5; else the table is only printed.
"""
from __future__ import annotations

import argparse
import datetime
import json
import sys

from flow import area, tools
from flow.designs import WIDE, WIDE_BOARD, wide_design
from flow.place_route import nextpnr_version
from flow.synthesis import yosys_version

ALL_SEEDS = [1, 2, 3, 4, 5]
REPORTED = [8, 16]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--slots", type=int, nargs="+", choices=list(WIDE), default=REPORTED)
    parser.add_argument("--seeds", type=int, nargs="+", default=ALL_SEEDS)
    parser.add_argument("--jobs", type=int, default=1, help="runs of nextpnr at once")
    arguments = parser.parse_args()
    tools.generate_isa_header()
    records = []
    for slots in arguments.slots:
        record = {"slots": slots, **area.measure(wide_design(slots), arguments.seeds, arguments.jobs)}
        records.append(record)
        fmax, path = record["fmax_mhz"], record["critical_path"]
        tools.say(f"MPU4, {slots} slots: {record['logic_cells']} logic cells {record['flip_flops']} FFs "
                  f"{record['block_rams']} RAMs {record['dsps']} DSPs  "
                  f"{fmax['min']} {fmax['median']} {fmax['max']} MHz  {path['start']} -> {path['end']}")
    if sorted(arguments.slots) == REPORTED and sorted(arguments.seeds) == ALL_SEEDS:
        report = {
            "made_by": "make pnr-wide",
            "date": datetime.date.today().isoformat(),
            "tools": {"yosys": yosys_version(),
                      "nextpnr-ecp5": nextpnr_version(WIDE_BOARD.family.nextpnr).removeprefix("nextpnr-")},
            "options": " ".join((WIDE_BOARD.family.synth, *WIDE_BOARD.family.nextpnr_options)),
            "seeds": ALL_SEEDS,
            "results": records,
        }
        tools.write_file(tools.REPORTS / "wide-timing.json", json.dumps(report, indent=1) + "\n")
        tools.say("wrote reports/wide-timing.json")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
