#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write reports/index.html: steps, area, clock, scan time, latency and what else was measured, as plots and tables.

All of it comes from the JSON files beside it, which other targets write; what is not there is left out. The page needs
no other file and no network. A bar's number is in its table too."""
from __future__ import annotations

import base64
import json
import sys
from html import escape
from pathlib import Path

import report_charts as chart
from flow import tools
from report_charts import Bar, table

Json = dict


def sentence(record: Json) -> str:
    """Who made a file, when, with what."""
    names = ", ".join(version if version.lower().startswith(name) else f"{name} {version}"
                      for name, version in record.get("tools", {}).items())
    return f"Made by <code>{record['made_by']}</code> on {record['date']}" + (f" with {names}." if names else ".")


def scan_time(area: Json, yard: Json) -> str:
    """Scan times of the samples: clocks of a scan by the median clock rate."""
    rate = {(row["mpu"], row["config"]): row["fmax_mhz"]["median"] for row in area["results"]}
    core_rate = {core["name"]: core["fmax_mhz"]["median"] for core in yard["cores"]}
    parts, rows = [], []
    for sample in yard["samples"]:
        bars = []
        for run in sample["rung"]:
            if not run["fits"] or (run["mpu"], run["config"]) not in rate:
                continue
            mhz = rate[run["mpu"], run["config"]]
            bars.append(Bar(f"MPU{run['mpu']}, {run['config']}", run["clocks"] / mhz))
            rows.append([sample["sample"], bars[-1].name, run["instructions"], run["steps"], run["clocks"], mhz, f"{bars[-1].value:.2f}"])
        for core in sample["cores"]:
            clocks, mhz = core["warm"]["median"], core_rate[core["name"]]
            bars.append(Bar(core["name"], clocks / mhz, other=True))
            rows.append([sample["sample"], core["name"], "", "", clocks, mhz, f"{bars[-1].value:.2f}"])
        parts.append(f"<h3>Sample {sample['sample']}</h3>" + chart.bars(bars, "us a scan", logarithmic=True))
    head = ["sample", "processor", "instructions", "steps", "clocks a scan", "MHz", "us a scan"]
    return ('<section id="scan"><h2>Scan time</h2><p>A logarithmic scale. Clock rates are medians over seeds; soft cores run the '
            f"compiler's C with their caches warm. {sentence(yard)}</p>" + chart.columns(parts) + table(head, rows) + "</section>")


def steps(yard: Json) -> str:
    """Steps of the samples on the three processors, of the largest configuration."""
    rows, groups = [], []
    for sample in yard["samples"]:
        runs = [run for run in sample["rung"] if run["config"] == "ecp5"]
        groups.append(f"<h3>Sample {sample['sample']}</h3>" + chart.bars([Bar(f"MPU{run['mpu']}", run["steps"]) for run in runs], "steps"))
        rows += [[sample["sample"], f"MPU{run['mpu']}", run.get("instructions", ""), run["steps"], run.get("clocks", "")] for run in runs]
    return ('<section id="steps"><h2>Steps</h2><p>Instruction words that a scan fetches, with all that the hardware can do; with '
            f'<code>--paper</code> they are the paper\'s (<a href="steps.md">steps.md</a>). {sentence(yard)}</p>'
            + chart.columns(groups) + table(["sample", "processor", "instructions", "steps", "clocks a scan"], rows) + "</section>")


def area_and_clock(area: Json) -> str:
    """Processors on two FPGAs."""
    cells = [Bar(f"MPU{row['mpu']}, {row['board']}", row["logic_cells"]) for row in area["results"]]
    rates = [Bar(f"MPU{row['mpu']}, {row['board']}", row["fmax_mhz"]["median"], low=row["fmax_mhz"]["min"], high=row["fmax_mhz"]["max"])
             for row in area["results"]]
    rows = [[f"MPU{row['mpu']}", row["board"], row["logic_cells"], row["flip_flops"], row["block_rams"], row["dsps"],
             row["fmax_mhz"]["min"], row["fmax_mhz"]["median"], row["fmax_mhz"]["max"], row["critical_path"]["stage"]] for row in area["results"]]
    head = ["processor", "board", "logic cells", "flip-flops", "block RAMs", "DSPs", "MHz least", "median", "most", "slowest stage"]
    return (f'<section id="area"><h2>Area and clock of the processors</h2><p>{sentence(area)} A line shows the range over the seeds.</p>'
            + chart.columns(["<h3>Logic cells</h3>" + chart.bars(cells, ""), "<h3>Clock</h3>" + chart.bars(rates, "MHz")])
            + table(head, rows) + "</section>")


def wide(record: Json) -> str:
    """MPU4 by its slots."""
    times = [Bar(f"MPU4, {row['slots']} slots", row["instruction_ns"]) for row in record["results"]]
    rates = [Bar(f"MPU4, {row['slots']} slots", row["fmax_mhz"]["median"], low=row["fmax_mhz"]["min"], high=row["fmax_mhz"]["max"])
             for row in record["results"]]
    rows = [[row["slots"], ", ".join(row["fmax_mhz"]["seeds"]), row["logic_cells"], row["block_rams"], row["dsps"], row["clocks"],
             row["fmax_mhz"]["median"], row["scan_ns"], row["instruction_ns"], row["goal_ns"] or ""] for row in record["results"]]
    head = ["slots", "seeds", "logic cells", "block RAMs", "DSPs", "clocks a scan", "MHz median", "ns a scan", "ns an instruction", "goal"]
    return (f'<section id="wide"><h2>The wide processor</h2><p>Sample 1 with its input latch (<a href="wide-timing.md">wide-timing.md</a>). {sentence(record)}</p>'
            + chart.columns(["<h3>An instruction of the source</h3>" + chart.bars(times, "ns"), "<h3>Clock</h3>" + chart.bars(rates, "MHz")])
            + table(head, rows) + "</section>")


def boards(record: Json) -> str:
    """The controller on its boards, by its parts."""
    stacks, rows = [], []
    for board in record["boards"]:
        parts = {name: part["luts"] for name, part in board["parts"].items()}
        stacks.append((board["title"], parts))
        fmax = board["fmax_mhz"]
        rows.append([board["title"], f"MPU{board['mpu']}", board["logic_cells"], board["logic_cells_available"], board["flip_flops"],
                     board["block_rams"], board["board_mhz"], fmax["min"], fmax["median"], fmax["max"]])
    head = ["board", "processor", "logic cells", "of", "flip-flops", "block RAMs", "board MHz", "MHz least", "median", "most"]
    return (f'<section id="boards"><h2>The controller on its boards</h2><p>{sentence(record)} LUTs by part of the design.</p>'
            + chart.stacks(stacks) + table(head, rows) + "</section>")


def latency(record: Json) -> str:
    """From input edge to output edge: what was measured within what the compiler bounds."""
    tests = [test for test in record["tests"] if "bound_most" in test]
    ranges, rows = [], []
    for test in tests:
        name = test["name"].split("/")[-1].replace("_", " ")
        low, high = int(test["least"]), int(test["most"])
        ranges.append(chart.Range(name, low, high, int(test["bound_least"]), int(test["bound_most"])))
        rows.append([name, test["scan_clocks"], test["period_clocks"], test["edges"], test["bound_least"], low, high, test["bound_most"]])
    head = ["program, points, period, filter", "clocks of a scan", "of a period", "edges", "bound least", "least", "most", "bound most"]
    date = tests[0]["date"] if tests else ""
    return (f'<section id="latency"><h2>From input edge to output edge</h2><p>Clocks. A frame is what the compiler bounds, a bar what was '
            f'measured in the Verilated controller. Made by <code>make reliability</code> on {date}.</p>'
            + chart.ranges(ranges) + table(head, rows) + "</section>")


def flow_tasks(record: Json) -> str:
    """Responses of flow tasks, sampled in every round, below the bound that the compiler prints; of each number of tasks the worst scenario."""
    us_a_clock = 0.01  # the report's 100 MHz
    ranges, rows = [], []
    for cell in record["cells"]:
        rows.append([cell["mode"], cell["scenario"], cell["tasks"], cell["inputs"], f"{cell['least_ms']:.4f}", f"{cell['most_ms']:.4f}",
                     cell["most_clocks"], cell.get("bound_clocks") or ""])
    for tasks in sorted({cell["tasks"] for cell in record["cells"]}):
        cells = [cell for cell in record["cells"] if cell["mode"] == "sampled" and cell["tasks"] == tasks]
        ranges.append(chart.Range(f"{tasks} task{'s' if tasks > 1 else ''}", min(cell["least_clocks"] for cell in cells) * us_a_clock,
                                  max(cell["most_clocks"] for cell in cells) * us_a_clock, 0, max(cell["bound_clocks"] for cell in cells) * us_a_clock))
    head = ["mode", "scenario", "tasks", "inputs", "ms least", "most", "clocks most", "bound"]
    return ('<section id="flow"><h2>Flow tasks</h2><p>Microseconds from an input\'s edge to the output\'s at 100 MHz, beside a ladder of '
            f'{record["cells"][0]["ladder_clocks"]} clocks, inputs sampled in every round; a frame is the printed bound. Made by <code>make flow-report</code> on '
            f'{record["date"]} (<a href="flow.md">flow.md</a>).</p>' + chart.ranges(ranges) + table(head, rows) + "</section>")


def standard_cells(record: Json) -> str:
    """The processors on a standard-cell process."""
    gates = [Bar(row["name"], row["nand2_equivalents"]) for row in record["results"]]
    rates = [Bar(row["name"], row["clock_mhz"]["assumed_wires"], high=row["clock_mhz"]["no_wires"], low=row["clock_mhz"]["assumed_wires"])
             for row in record["results"]]
    rows = [[row["name"], row["gates"], row["flip_flops"], row["nand2_equivalents"], row["clock_mhz"]["assumed_wires"], row["clock_mhz"]["no_wires"]]
            for row in record["results"]]
    head = ["processor", "gates", "flip-flops", "NAND2 equivalents", "MHz, assumed wires", "MHz, no wires"]
    return (f'<section id="cells"><h2>On standard cells</h2><p>{escape(record["liberty"]["process"])}, memories as black boxes with an assumed access time, '
            f'clock by static timing (<a href="cells.md">cells.md</a>). {sentence(record)} A line ends at the clock without wires.</p>'
            + chart.columns(["<h3>NAND2 equivalents</h3>" + chart.bars(gates, ""), "<h3>Clock</h3>" + chart.bars(rates, "MHz")])
            + table(head, rows) + "</section>")


def tradeoff(picture: Path) -> str:
    """The chart of `make tradeoff`, in the page as it is."""
    data = base64.b64encode(picture.read_bytes()).decode()
    return ('<section id="tradeoff"><h2>The whole trade</h2><p>Sample 1 on everything we have, beside soft cores and a server core '
            '(<a href="tradeoff.md">tradeoff.md</a> has the numbers).</p>'
            f'<img alt="ns a scan, worst ns a scan, area, time to change a program" src="data:image/svg+xml;base64,{data}"></section>')


def read(name: str) -> Json | None:
    file = tools.REPORTS / f"{name}.json"
    return json.loads(file.read_text()) if file.exists() else None


def page() -> str:
    area, yard, board, reliability = read("area-timing"), read("yardsticks"), read("boards"), read("reliability")
    flow, cells, wider = read("flow"), read("cells"), read("wide-timing")
    sections = []
    if area and yard:
        sections.append(scan_time(area, yard))
    if yard:
        sections.append(steps(yard))
    if area:
        sections.append(area_and_clock(area))
    if wider:
        sections.append(wide(wider))
    if board:
        sections.append(boards(board))
    if reliability:
        sections.append(latency(reliability))
    if flow:
        sections.append(flow_tasks(flow))
    if cells:
        sections.append(standard_cells(cells))
    if (tools.REPORTS / "tradeoff.svg").exists():
        sections.append(tradeoff(tools.REPORTS / "tradeoff.svg"))
    return chart.document("Rung: reports", sections)


def main() -> int:
    output = Path(sys.argv[1]) if len(sys.argv) > 1 else tools.REPORTS / "index.html"
    tools.write_file(output, page())
    tools.say(f"wrote {output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
