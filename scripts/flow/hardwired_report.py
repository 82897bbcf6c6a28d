# SPDX-License-Identifier: Apache-2.0
"""reports/hardwired.md from hardwired.json."""
from __future__ import annotations

from typing import Any

from flow.area_report import table, tools_line

TITLES = {"sample1": "Sample 1", "sample2": "Sample 2", "sample3": "Sample 3",
          "sample1-bits": "Sample 1, each word instruction a coil"}


def seconds(step: dict[str, float]) -> str:
    return f"{step['wall_s']} ({step['cpu_s']})"


def result_rows(report: dict[str, Any]) -> list[list[Any]]:
    rows = []
    for r in report["results"]:
        fmax = r["fmax_mhz"]
        rows.append([TITLES[r["program"]], r["clocks"], f"{fmax['min']} / {fmax['median']} / {fmax['max']}",
                     r["scan_ns"], f"{r['logic_cells']} ({r['link_luts']})",
                     f"{r['flip_flops']} ({r['link_flip_flops']})", r["dsps"]])
    return rows


def change_rows(report: dict[str, Any]) -> list[list[Any]]:
    rows = []
    for program, steps in report["change"].items():
        named = [steps[key] for key in ("translate", "synthesis", "place_and_route", "pack")]
        rows.append([TITLES[program], *map(seconds, named),
                     f"{sum(s['wall_s'] for s in named):.0f} ({sum(s['cpu_s'] for s in named):.0f})"])
    return rows


def render(report: dict[str, Any]) -> str:
    return "\n".join([
        "# Hard-wired programs", "",
        f"Made by `{report['made_by']}`, {report['date']}. {tools_line(report)}. "
        f"Options: `{report['options']}`. Nothing here has run on a board.", "",
        "Each program is one Verilog module (`rung translate --to verilog`, "
        "[compiler/hardwired](../compiler/hardwired/README.md)), placed and routed for an "
        f"{report['part']} in `tb/hardwired/hardwired_top.v`, scan after scan, with a host that can read every device and write it, "
        "16 bits at a time; that is what the processors offer. The clock is routed, MHz, least / median / most of seeds "
        f"{', '.join(map(str, report['seeds']))}; a scan is its clocks by the median, and every scan takes the same. In brackets: the "
        "share of the shift registers around the module, as far as their names still tell it.", "",
        *table(["", "clocks a scan", "MHz", "scan, ns", "logic cells (around)", "flip-flops (around)", "DSPs"], result_rows(report)), "",
        "## What a change costs", "",
        "From a changed list to a bitstream (one seed), seconds on the wall (of processors) on "
        "this machine, which did other work beside it: the second number is the steadier one. A processor's program "
        "is compiled and downloaded instead, and the processor goes on with the old one meanwhile.", "",
        *table(["", "translate", "synthesis", "place and route", "pack", "together"], change_rows(report)), "",
        "## Several clocks do what one does", "",
        "Yosys' SAT solver proves that the module of several clocks holds the same after every scan as the module of one clock "
        "(`scripts/flow/equivalence.py`): from a reset on, for all inputs, ticks and states that a host may load between two scans. "
        "A register that takes its value a clock too late is found.", "",
        *table(["program", "clocks", "scans", "clocks looked at", "late value found", "s"],
               [[p["program"], p["clocks"], p["scans"], p["steps"], "yes" if p["fault_found"] else "has none", p["seconds"]]
                for p in report["proofs"]]),
        ""])
