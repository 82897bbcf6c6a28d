#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The processors on standard cells: gates, area, clock, and the samples' scan times.

Writes reports/cells.json and cells.md. Needs build/bin/rung and build/bin/rung-samples.
"""
from __future__ import annotations

import argparse
import datetime
import json
import sys
from typing import Any

from flow import cells, cells_report, tools
from flow.cells import Cells
from flow.designs import WIDE, wide_sources
from flow.synthesis import yosys_version
from yardsticks import compile_for, sample_list

HDL = tools.ROOT / "hdl"
# As large as the largest sample needs; clocks of MUL and DIV as configuration ecp5 has them, so that
# its step counts hold.
SIZES = (("STEPS", 2048), ("BIT_DEVICES", 2048), ("WORD_DEVICES", 1024), ("MUL_DSP", 1))
LATENCIES = (("MUL_LATENCY", 3), ("DIV_LATENCY", 19), ("MUL32_LATENCY", 34), ("DIV32_LATENCY", 37))
SAMPLES = (1, 2, 3)


def processors() -> list[tuple[int, int | None, Cells]]:
    """MPU, slots of MPU4, design."""
    core = tuple(sorted((HDL / "core").glob("*.v")))
    include = (tools.GENERATED, HDL / "core")
    designs: list[tuple[int, int | None, Cells]] = [
        (mpu, None, Cells(f"mpu{mpu}", f"mpu{mpu}", (HDL / f"mpu{mpu}.v", *core), include,
                          SIZES + (LATENCIES if mpu == 1 else LATENCIES[:2]))) for mpu in (1, 2, 3)]
    for slots, parameters in WIDE.items():
        designs.append((4, slots, Cells(f"mpu4-{slots}", "mpu4", tuple(wide_sources()), include, tuple(parameters.items()))))
    return designs


def scans(mpu: int, slots: int | None, clock_mhz: dict[str, float]) -> list[dict[str, Any]]:
    """Clocks and time of the samples, with both clocks."""
    found = []
    for sample in SAMPLES:
        counts = compile_for(sample_list(sample, 1), mpu, "ecp5", slots)
        found.append({"sample": sample, "instructions": counts["instructions"], "clocks": counts["clocks"],
                      "scan_ns": {name: round(1000 * counts["clocks"] / mhz)
                                  for name, mhz in clock_mhz.items()}})
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", nargs="+", help="designs to measure, printed and not written")
    parser.add_argument("--render", action="store_true", help="write cells.md anew from cells.json")
    arguments = parser.parse_args()
    if arguments.render:
        report = json.loads((tools.REPORTS / "cells.json").read_text())
        tools.write_file(tools.REPORTS / "cells.md", cells_report.render(report))
        return 0
    if not cells.LIBERTY.exists():
        raise tools.FlowError(f"no {cells.LIBERTY}: scripts/setup.sh cells installs it")
    tools.generate_isa_header()
    results = []
    for mpu, slots, design in processors():
        if arguments.only and design.name not in arguments.only:
            continue
        record = {"mpu": mpu, **cells.measure(design)}
        tools.say(f"{design.name}: {record['gates']} gates, {record['clock_mhz']} MHz")
        record["samples"] = scans(mpu, slots, record["clock_mhz"])
        results.append(record)
    if arguments.only:
        print(json.dumps(results, indent=1))
        return 0
    report = {
        "made_by": "make cells", "date": datetime.date.today().isoformat(),
        "tools": {"yosys": yosys_version(), "opensta": tools.version(cells.STA).split(" GITDIR")[0]},
        "liberty": {"file": cells.LIBERTY.name, "process": "0.18 um, typical, 1.8 V, 25 C"},
        "assumed": {"access_ns": cells.ACCESS_NS, "access_ns_a_doubling": cells.ACCESS_NS_A_DOUBLING,
                    "setup_ns": cells.SETUP_NS, "cell_um2": cells.CELL_UM2,
                    "around_um2_a_bit": cells.AROUND_UM2_A_BIT, "around_um2": cells.AROUND_UM2,
                    "wire_pf": cells.WIRE_PF, "wire_pf_an_end": cells.WIRE_PF_AN_END},
        "sizes": dict(SIZES), "results": results,
    }
    tools.write_file(tools.REPORTS / "cells.json", json.dumps(report, indent=1) + "\n")
    tools.write_file(tools.REPORTS / "cells.md", cells_report.render(report))
    tools.say("wrote reports/cells.json and cells.md")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
