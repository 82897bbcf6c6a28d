# SPDX-License-Identifier: Apache-2.0
"""reports/area-timing.md from area-timing.json and yardsticks.json."""
from __future__ import annotations

from typing import Any

from flow.designs import BOARDS

GOALS_MHZ = {("ulx3s", 1): 110, ("ulx3s", 2): 110, ("ulx3s", 3): 100,
             ("hx8k", 1): 65, ("hx8k", 2): 65, ("hx8k", 3): 65}


def table(head: list[str], rows: list[list[Any]]) -> list[str]:
    """A Markdown table: the first column to the left, the others to the right."""
    return ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1),
            *("| " + " | ".join(str(cell) for cell in row) + " |" for row in rows)]


def us(nanoseconds: float) -> str:
    """A time in microseconds with three figures that mean something."""
    value = nanoseconds / 1000
    return f"{value:.2f}" if value < 10 else f"{value:.1f}" if value < 100 else f"{value:.0f}"


def tools_line(report: dict[str, Any]) -> str:
    return "; ".join(f"{name} {version}" for name, version in report["tools"].items())


def area_section(area: dict[str, Any]) -> list[str]:
    rows = []
    for r in area["results"]:
        rows.append([f"MPU{r['mpu']}, {BOARDS[r['board']].title}", r["logic_cells"],
                     r["flip_flops"], f"{r['block_rams']} of {r['block_rams_available']}",
                     r["dsps"] or "-", f"{r['link_luts']} / {r['link_flip_flops']}"])
    return ["## Area", "",
            "Each processor in its board top (`hdl/boards/`), which keeps all of its ports behind a "
            "serial link of four pins and gives its program a UART and a PWM output. Logic cells are "
            "nextpnr's: on ECP5 a LUT4 or half of a carry pair, on iCE40 a cell of LUT4, carry and "
            "flip-flop. The last column is the share of what stands around the processor, LUT4s "
            "and flip-flops, as far as their names still tell it.", "",
            *table(["", "logic cells", "flip-flops", "block RAMs", "DSPs", "around it"], rows), ""]


def clock_section(area: dict[str, Any]) -> list[str]:
    rows, paths = [], []
    for r in area["results"]:
        name = f"MPU{r['mpu']}, {BOARDS[r['board']].title}"
        fmax, path = r["fmax_mhz"], r["critical_path"]
        goal = GOALS_MHZ[r["board"], r["mpu"]]
        rows.append([name, fmax["min"], f"**{fmax['median']}**", fmax["max"], goal,
                     "yes" if fmax["median"] >= goal else "no"])
        paths.append([name, path["stage"], f"`{path['start']}`", f"`{path['end']}`",
                      path["logic_ns"], path["routing_ns"]])
    return ["## Clock", "",
            f"Routed, MHz, over the seeds {', '.join(map(str, area['seeds']))}.", "",
            *table(["", "min", "median", "max", "goal (median)", "met"], rows), "",
            "What limits the median seed: the stage of the longest path (stages as in "
            "`hdl/README.md`), its ends, and its ns in logic and in routing.", "",
            *table(["", "stage", "from", "to", "logic", "routing"], paths), ""]


def clocks_mhz(area: dict[str, Any]) -> dict[tuple[str, int], float]:
    return {(r["config"], r["mpu"]): r["fmax_mhz"]["median"] for r in area["results"]}


def our_rows(sample: dict[str, Any], mhz: dict[tuple[str, int], float]) -> list[list[Any]]:
    rows = []
    instructions = next(r["instructions"] for r in sample["rung"] if r["fits"])
    for r in sample["rung"]:
        clock = mhz[r["config"], r["mpu"]]
        chip = "ECP5-85F" if r["config"] == "ecp5" else "HX8K"
        clocks = r["clocks"] if r["fits"] else r["steps"]
        time = clocks / clock * 1000
        mark = "" if r["fits"] else ", computed"
        rows.append([f"MPU{r['mpu']}, {chip}{mark}", clock, clocks, us(time), us(time),
                     f"{time / instructions:.1f}"])
    return rows


def core_rows(sample: dict[str, Any], cores: dict[str, Any], instructions: int) -> list[list[Any]]:
    rows = []
    for r in sample["cores"]:
        core = cores[r["name"]]
        clock = core["fmax_mhz"]["median"]
        for kind in ("warm", "cold"):
            if kind not in r:
                continue
            name = r["name"] + (f", {kind} cache" if "cold" in r else "")
            time, worst = (r[kind][key] / clock * 1000 for key in ("median", "max"))
            rows.append([f"{name}, ECP5-85F", clock, r[kind]["median"], us(time), us(worst),
                         f"{time / instructions:.1f}"])
    return rows


def speed_section(area: dict[str, Any], yard: dict[str, Any]) -> list[str]:
    mhz = clocks_mhz(area)
    cores = {core["name"]: core for core in yard["cores"]}
    out = ["## Scan time", "",
           "Stand-in programs for the paper's three samples (the originals are not public), seed "
           f"{yard['samples'][0]['seed']}, with pseudo-random inputs in every scan. Times are "
           "clocks by the median routed clock; a Rung processor takes exactly the same clocks in "
           "every scan, so its median is its worst. Programs are compiled in the default mode; "
           "the latching of inputs and the refresh of outputs are in none of the times. *Computed*: the program does not fit the "
           "HX8K's memories; the steps that it would take by the HX8K's clock stand there, without "
           "the clocks in which a processor waits for its multiplier or divider."]
    for sample in yard["samples"]:
        instructions = next(r["instructions"] for r in sample["rung"] if r["fits"])
        host = sample["host"]
        rows = our_rows(sample, mhz) + core_rows(sample, cores, instructions)
        rows.append(["this machine, gcc -O2", "", "", us(host["median_ns"]), us(host["worst_ns"]),
                     f"{host['median_ns'] / instructions:.2f}"])
        out += ["", f"### Sample {sample['sample']}: {instructions} instructions", "",
                *table(["", "MHz", "clocks a scan", "scan, us", "worst scan, us",
                        "ns per instruction"], rows)]
    return out + ["", *yardstick_notes(yard)]


def yardstick_notes(yard: dict[str, Any]) -> list[str]:
    host = yard["host"]
    scans = yard["samples"][0]["host"]["scans"]
    overhead = yard["samples"][0]["host"]["clock_overhead_ns"]
    rows = [[f"{core['name']}: {core['title']}", core["memory"], core["logic_cells"],
             core["flip_flops"], core["dsps"] or "-",
             " / ".join(str(core["fmax_mhz"][key]) for key in ("min", "median", "max"))]
            for core in yard["cores"]]
    return ["### The yardsticks", "",
            "The same program as C (`rung translate --to c`), one call of `PlcCycle()`. All "
            "machines ran the same 500 scans and ended in the same state of all devices.", "",
            "- **Soft cores** with 64 KB of block RAM, in the same ECP5-85F grade 6, placed and "
            "routed by the same tools and options with the seeds "
            f"{', '.join(map(str, yard['seeds']))}, compiled by {yard['tools']['riscv-gcc']}. "
            "Clocks are counted by Verilator between two writes to the bus, their own clocks taken "
            "off. Cold: caches emptied before each scan; warm: scan after scan. Straight-line code "
            "larger than a direct-mapped cache misses on nearly every line, warm or not.",
            f"- **This machine**: {host['cpu']}, {host['compiler']}; {scans} scans timed one by one, "
            f"the {overhead} ns of reading the clock taken off. A desktop core is faster than any "
            "of these processors on average, and its worst scan is not bounded: the worst here is "
            "what happened to be seen, and an interrupt or another program makes it longer.", "",
            *table(["core", "memory", "logic cells", "flip-flops", "DSPs",
                    "MHz min / median / max"], rows), ""]


def render(area: dict[str, Any], yard: dict[str, Any] | None) -> str:
    """The page; without yardsticks it ends after the clocks."""
    out = ["# Area, clock and scan time", "",
           f"Made by `make report` (area and clock alone: `make pnr`). {area['date']}. "
           f"{tools_line(area)}. Options: "
           + ", ".join(f"`{options}`" for options in area["options"].values())
           + ". Nothing here has run on a board.", "",
           *area_section(area), *clock_section(area)]
    if yard:
        out += [*speed_section(area, yard),
                f"Scan times and yardsticks made by `make bench`, {yard['date']}. "
                f"{tools_line(yard)}."]
    return "\n".join(out).rstrip() + "\n"
