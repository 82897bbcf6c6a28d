# SPDX-License-Identifier: Apache-2.0
"""reports/cells.md from cells.json."""
from __future__ import annotations

from typing import Any

from flow.area_report import table, tools_line


def mm2(um2: float) -> str:
    return f"{um2 / 1e6:.2f}"


def memory_text(record: dict[str, Any]) -> str:
    return ", ".join(f"{m['count']} x {m['depth']}x{m['width']}" for m in record["memories"])


def size_rows(report: dict[str, Any]) -> list[list[Any]]:
    return [[r["name"].upper(), r["gates"], r["flip_flops"], r["nand2_equivalents"], mm2(r["cell_um2"]),
             memory_text(r), mm2(r["memory_um2"])] for r in report["results"]]


def clock_rows(report: dict[str, Any]) -> list[list[Any]]:
    rows = []
    for r in report["results"]:
        for wires, title in (("no_wires", "none"), ("assumed_wires", "assumed")):
            path = r["paths"][wires]
            rows.append([r["name"].upper(), title, r["clock_mhz"][wires], path["ns"], f"`{path['start']}`",
                         f"`{path['end']}`"])
    return rows


def scan_rows(report: dict[str, Any]) -> list[list[Any]]:
    rows = []
    for r in report["results"]:
        for s in r["samples"]:
            rows.append([f"{r['name'].upper()}, Sample {s['sample']}", s["clocks"],
                         f"{s['scan_ns']['no_wires'] / 1000:.2f}", f"{s['scan_ns']['assumed_wires'] / 1000:.2f}",
                         f"{s['scan_ns']['assumed_wires'] / s['instructions']:.1f}"])
    return rows


def render(report: dict[str, Any]) -> str:
    a = report["assumed"]
    sizes = ", ".join(f"{name} {value}" for name, value in report["sizes"].items())
    return "\n".join([
        "# The processors on standard cells", "",
        f"Made by `{report['made_by']}`, {report['date']}. {tools_line(report)}. Cells: `{report['liberty']['file']}` "
        f"({report['liberty']['process']}), the Debian package qflow-tech-osu018. MPU1 to MPU3 with {sizes}; "
        "MPU4 with the sizes of hdl/isa/wide.toml, 512 steps among them.", "",
        "## What is measured and what is not", "",
        "Measured: the gates that Yosys and abc choose, their area by the library, and the longest path between two clock "
        "edges by OpenSTA, memories included. Not there: a layout, a clock tree, scan chains, pads, margins for slow "
        "silicon (the library has only the typical corner). So the clocks are upper bounds.", "",
        f"Assumed: memories are black boxes with one port for reading and one for writing: data {a['access_ns']} ns after the "
        f"clock, {a['access_ns_a_doubling']} ns more for each doubling beyond 256 words, set-up {a['setup_ns']} ns, "
        f"{a['cell_um2']} um2 a bit, {a['around_um2_a_bit']} a bit and {a['around_um2']:.0f} each around them. *Assumed wires*: "
        f"{a['wire_pf']} pF and {a['wire_pf_an_end']} pF for each end that a net drives, no resistance; gates were not chosen "
        "again for them, so what a layout would reach lies between the two clocks.", "",
        "## Size", "",
        *table(["", "gates", "of them flip-flops", "NAND2 equivalents", "cells, mm2", "memories, words x bits",
                "memories, mm2, assumed"], size_rows(report)), "",
        "## Clock", "",
        *table(["", "wires", "MHz", "longest path, ns", "from", "to"], clock_rows(report)), "",
        "## Scan time of the samples", "",
        "Clocks of configuration `ecp5`, whose latencies these processors have.", "",
        *table(["", "clocks", "us, no wires", "us, assumed wires", "ns an instruction, assumed wires"],
               scan_rows(report)), ""])
