#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The whole trade on one chart: reports/tradeoff.md and tradeoff.svg.

Everything comes from JSON in reports/ that other targets have written, and from scripts/commercial.json; a design
whose JSON is not there is left out, with a note. The times of a change are measured here, into
reports/change.json, when build/bin/rung is there.
"""
from __future__ import annotations

import datetime
import json
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
REPORTS = ROOT / "reports"
RUNG = ROOT / "build" / "bin" / "rung"
SAMPLES = ROOT / "build" / "bin" / "rung-samples"
SAMPLE = 1


@dataclass(frozen=True)
class Row:
    """A design with Sample 1. None: it has no such figure."""
    name: str
    scan_ns: float
    worst_ns: float
    area: int | None           # logic cells of an ECP5
    change_s: float | None
    note: str


def load(name: str) -> dict[str, Any] | None:
    path = REPORTS / name
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def fastest(command: list[str]) -> float:
    """Seconds of a command: the least of five."""
    times = []
    for _ in range(5):
        start = time.monotonic()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        times.append(time.monotonic() - start)
    return round(min(times), 3)


def measure_change() -> None:
    """From a changed list to what a machine runs, for Sample 1: reports/change.json."""
    folder = ROOT / "build" / "tradeoff"
    folder.mkdir(parents=True, exist_ok=True)
    listing, c_file = folder / "sample1.il", folder / "sample1.c"
    listing.write_bytes(subprocess.run([str(SAMPLES), "--sample", "1", "--seed", "1"], check=True,
                                       capture_output=True).stdout)
    compile_ = [str(RUNG), "compile", str(listing), "-o", str(folder / "sample1.img"), "--mpu"]
    seconds = {f"mpu{mpu}": fastest([*compile_, str(mpu)]) for mpu in (1, 2, 3)}
    seconds |= {f"mpu4-{slots}": fastest([*compile_, "4", "--slots", str(slots)]) for slots in (4, 8, 16)}
    translate = fastest([str(RUNG), "translate", str(listing), "--to", "c", "-o", str(c_file)])
    for name, compiler in (("gcc", ["gcc", "-O2", "-std=c99"]),
                           ("riscv", ["riscv64-unknown-elf-gcc", "-O2", "-march=rv32im", "-mabi=ilp32",
                                      "-ffreestanding"])):
        try:
            compiled = fastest([*compiler, "-c", str(c_file), "-o", str(folder / f"{name}.o")])
        except FileNotFoundError:
            continue
        seconds[name] = round(translate + compiled, 3)
    report = {"made_by": "make tradeoff", "date": datetime.date.today().isoformat(),
              "what": "seconds from a changed list (Sample 1) to an image or object file, least of five",
              "seconds": seconds}
    (REPORTS / "change.json").write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")


def processor_rows(seconds: dict[str, float], notes: list[str]) -> list[Row]:
    area, yard, wide = load("area-timing.json"), load("yardsticks.json"), load("wide-timing.json")
    rows = []
    if area is None or yard is None:
        notes.append("MPU1 to MPU3, the soft cores and this machine: `make pnr` and `make bench` have not run")
        return rows
    sample = next(s for s in yard["samples"] if s["sample"] == SAMPLE)
    for mpu in (1, 2, 3):
        place = next(r for r in area["results"] if r["mpu"] == mpu and r["config"] == "ecp5")
        run = next(r for r in sample["rung"] if r["mpu"] == mpu and r["config"] == "ecp5")
        scan = 1000 * run["clocks"] / place["fmax_mhz"]["median"]
        rows.append(Row(f"MPU{mpu}", scan, scan, place["logic_cells"], seconds.get(f"mpu{mpu}"),
                        "compile; then a download, while it runs"))
    for r in sorted(wide["results"], key=lambda r: r["slots"]) if wide else []:
        run = next(s for s in r["samples"] if s["sample"] == SAMPLE)
        scan = 1000 * run["clocks"] / r["fmax_mhz"]["median"]
        rows.append(Row(f"MPU4, {r['slots']} slots", scan, scan, r["logic_cells"], seconds.get(f"mpu4-{r['slots']}"),
                        "compile; then a download"))
    if wide is None:
        notes.append("MPU4: `make pnr-wide` has not run")
    rows += hardwired_rows(notes)
    for core in yard["cores"]:
        run = next(r for r in sample["cores"] if r["name"] == core["name"])
        phases = [run[phase] for phase in ("warm", "cold") if phase in run]
        mhz = core["fmax_mhz"]["median"]
        rows.append(Row(core["name"], 1000 * run["warm"]["median"] / mhz,
                        1000 * max(phase["max"] for phase in phases) / mhz, core["logic_cells"],
                        seconds.get("riscv"), "translate, compile; then a download"))
    host = sample["host"]
    rows.append(Row("gcc -O2, this machine", host["median_ns"], host["worst_ns"], None, seconds.get("gcc"),
                    f"{yard['host']['cpu']}; worst of {host['scans']} scans; translate, compile"))
    return rows


def hardwired_rows(notes: list[str]) -> list[Row]:
    report = load("hardwired.json")
    if report is None:
        notes.append("hard-wired: `make hardwired` has not run")
        return []
    rows = []
    for program, title in (("sample1", "hard-wired"), ("sample1-bits", "hard-wired, bits only")):
        found = [r for r in report["results"] if r["program"] == program]
        if not found:
            notes.append(f"{title}: it is not in reports/hardwired.json")
            continue
        steps = report["change"][program]
        change = sum(step["cpu_s"] for step in steps.values() if isinstance(step, dict))
        rows.append(Row(title, found[0]["scan_ns"], found[0]["scan_ns"], found[0]["logic_cells"], change,
                        "translate, synthesis, place and route, pack (seconds of a processor); then a new bitstream"))
    return rows


def number(value: float | None) -> str:
    if value is None:
        return ""
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"


def page(rows: list[Row], notes: list[str]) -> str:
    head = ["| Sample 1, ECP5-85F grade 6 | ns a scan | worst ns a scan | worst / usual | logic cells | "
            "s to change the program | which is |", "|---|--:|--:|--:|--:|--:|---|"]
    lines = [f"| {r.name} | {number(r.scan_ns)} | {number(r.worst_ns)} | {r.worst_ns / r.scan_ns:.3g} | "
             f"{'' if r.area is None else r.area} | {number(r.change_s)} | {r.note} |" for r in rows]
    quoted = json.loads((ROOT / "scripts" / "commercial.json").read_text(encoding="utf-8"))
    makers = [f"| {cpu['name']} | {cpu['ns']} | {cpu['quoted_as']} | {cpu['source']} |" for cpu in quoted["cpus"]]
    return "\n".join([
        "# The whole trade", "",
        f"Made by `make tradeoff`, {datetime.date.today().isoformat()}, from the reports beside it, which name their tools, seeds "
        "and dates. One program, the stand-in of the paper's Sample 1 (1,425 instructions), on everything we have: from one "
        "instruction at a time to logic of its own, beside soft cores in the same FPGA and a server core.", "",
        "![ns a scan, worst ns a scan, area, time to change a program](tradeoff.svg)", "",
        *head, *lines, "",
        "A processor's and hard-wired logic's worst scan is its every scan. The refresh of outputs is in none of the times, the latching "
        "of inputs only in MPU4's. Logic cells of the processors include the serial link of their board tops, those "
        "of hard-wired programs the shift registers around them, and a host that reads and writes every device. "
        "Downloads are in none of the times of a change.", "",
        *(["Left out: " + "; ".join(notes) + ".", ""] if notes else []),
        "## What makers quote", "",
        "One bit instruction, from the makers' own papers; a scan is more than its bit instructions, so these stand in no "
        "column above.", "",
        "| | ns | quoted as | source |", "|---|--:|---|---|", *makers, ""])


DARK = """<style>@media (prefers-color-scheme: dark) {
 [style*="fill: #1a1a1a"] { fill: #e8e8e8 !important; }
 [style*="stroke: #1a1a1a"] { stroke: #e8e8e8 !important; }
}</style>"""


def chart(rows: list[Row], path: Path) -> None:
    """Four columns of bars, each with a logarithmic scale of its own."""
    import matplotlib
    matplotlib.use("svg")
    from matplotlib import pyplot
    ink = "#1a1a1a"   # what DARK turns into a light colour
    pyplot.rcParams.update({"svg.fonttype": "none", "font.family": "sans-serif", "svg.hashsalt": "rung",
                            "text.color": ink, "axes.labelcolor": ink, "axes.edgecolor": ink, "xtick.color": ink,
                            "ytick.color": ink})
    columns = (("ns a scan", [r.scan_ns for r in rows]), ("worst ns a scan", [r.worst_ns for r in rows]),
               ("logic cells", [r.area for r in rows]), ("s to change the program", [r.change_s for r in rows]))
    figure, axes = pyplot.subplots(1, 4, sharey=True, figsize=(13, 0.42 * len(rows) + 1.1))
    colours = ["#d08a20" if r.name.startswith("hard") else "#3f8fd0" if r.name.startswith("MPU") else "#8a8f98"
               for r in rows]
    for axis, (title, values) in zip(axes, columns):
        known = [value for value in values if value]
        axis.set_xscale("log")
        axis.set_title(title, fontsize=11)
        if known:
            axis.set_xlim(min(known) / 3, max(known) * 12)
            axis.barh(range(len(rows)), [value or 0 for value in values], color=colours, height=0.7)
        for i, value in enumerate(values):
            if value:
                axis.text(value * 1.15, i, number(value), va="center", fontsize=9)
        for side in ("top", "right"):
            axis.spines[side].set_visible(False)
        axis.tick_params(labelsize=9)
    axes[0].set_yticks(range(len(rows)), [r.name for r in rows])
    axes[0].invert_yaxis()
    figure.tight_layout()
    figure.savefig(path, transparent=True, metadata={"Date": None})
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("<defs>", DARK + "\n <defs>", 1), encoding="utf-8")


def main() -> int:
    notes: list[str] = []
    if RUNG.exists() and SAMPLES.exists():
        measure_change()
    change = load("change.json")
    if change is None:
        notes.append("times of a change of the processors: build/bin/rung is not there")
    rows = processor_rows(change["seconds"] if change else {}, notes)
    if not rows:
        print("nothing to show: run `make report` first", file=sys.stderr)
        return 1
    chart(rows, REPORTS / "tradeoff.svg")
    (REPORTS / "tradeoff.md").write_text(page(rows, notes), encoding="utf-8")
    print("wrote reports/tradeoff.md and tradeoff.svg")
    return 0


if __name__ == "__main__":
    sys.exit(main())
