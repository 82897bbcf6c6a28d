#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run the tests of build/cov, and coverage_functional of build/release, and write reports/coverage.md and coverage.json, for `make cov`.

usage: coverage.py targets                          print what it runs of build/cov, to be built first
       coverage.py run [--jobs N] [--programs N]    run them, write the reports
       coverage.py report                           write the reports from the last run's counts: hardware and C++ if all have run

Exit code 1 if a test fails, or if an exclusion of tb/coverage/exclusions.toml leaves nothing out; then no report is written.
"""
from __future__ import annotations

import argparse
import concurrent.futures
import datetime
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from cov import cpp, exclusions, hardware, report
from flow import tools

BUILD = tools.BUILD / "cov"
RESULTS = tools.BUILD / "cov-results"
EXCLUSIONS = tools.ROOT / "tb" / "coverage" / "exclusions.toml"
# Counts what retires, which takes no counters of its own: the fast build will do.
FUNCTIONAL = tools.BUILD / "bin" / "coverage_functional"
# Folder under tb, program -> what its environment has besides: the long ones first
PROGRAMS: dict[str, dict[str, str]] = {
    "compiler/unit_compiler": {},
    "unit/unit_rtl": {},
    "passes/cli_test": {},
    "peripherals/unit_peripherals": {},
    "golden/golden_test": {},
    "controller/unit_line": {},
    "firmware/unit_firmware_ecp5": {},
    "flow_compile/flow_compile_test": {},
    "wide/wide_random": {"RUNG_COUNT": "100"},
    "host/client_test": {},
    "link/unit_link": {},
    "flowchart/unit_flowchart": {},
    "flow/flow_test": {},
    "controller/unit_scan": {},
    "link/unit_panel": {},
    "hardwired/hardwired_agree": {},
    "hardwired/hardwired_verilog": {},
    "hardwired/hardwired_exhaustive": {},
    "passes/passes_test": {},
    "wide_rtl/wide_rtl": {},
    "wide/wide_corpus": {},
    "bytecode/bytecode_programs": {},
    "bytecode/unit_bytecode": {},
    "view/view_power": {},
    "view/view_session": {},
    "host/host_test": {},
    "prove/prove_corpus": {},
    "prove/prove_faults": {"RUNG_COUNT": "20"},
    "device/unit_device": {},
    "controller/unit_plc_board": {},
    "controller/unit_simulated": {},
    "boards/unit_boards": {},
    "agree/agree_random": {"RUNG_COUNT": "100"},
    "agree/agree_ldmicro_random": {"RUNG_COUNT": "100"},
    "agree/agree_ldmicro_c_corpus": {},
    "fuzz/fuzz_replay": {},
}


def run(program: Path, environment: dict[str, str]) -> float:
    """Seconds. Raises FlowError if a test of it fails."""
    log = tools.LOGS / f"cov-{program.name}.log"
    start = time.monotonic()
    with open(log, "w", encoding="utf-8") as out:
        code = subprocess.run([str(program), "--gtest_brief=1"], cwd=program.parent, stdout=out,
                              stderr=subprocess.STDOUT, check=False,
                              env={**os.environ, **environment, "RUNG_COVERAGE": str(RESULTS)}).returncode
    if code != 0:
        raise tools.FlowError(f"{program.name} failed (log: {log})")
    seconds = round(time.monotonic() - start, 1)
    tools.say(f"{program.name}: {seconds} s")
    return seconds


def run_all(jobs: int, programs: int) -> None:
    shutil.rmtree(RESULTS, ignore_errors=True)
    RESULTS.mkdir(parents=True)
    tools.LOGS.mkdir(parents=True, exist_ok=True)
    for counts in BUILD.rglob("*.gcda"):
        counts.unlink()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        functional = pool.submit(run, FUNCTIONAL, {"RUNG_PROGRAMS": str(programs)})
        rest = pool.map(run, (BUILD / "tb" / name for name in PROGRAMS), PROGRAMS.values())
        seconds = {name.split("/")[-1]: taken for name, taken in zip([str(FUNCTIONAL), *PROGRAMS], [functional.result(), *rest])}
    tools.write_file(RESULTS / "seconds.json", json.dumps(seconds))


def of_hardware() -> dict[str, Any]:
    """Counts by file and in all, exclusions and holes. Raises FlowError for an exclusion that leaves nothing out."""
    counts = hardware.read(sorted(RESULTS.glob("*.dat")))
    holes = [point for point, count in counts.items() if not hardware.covered(point, count)]
    table = exclusions.load(EXCLUSIONS)
    left = set(exclusions.apply(table, tools.ROOT, holes))
    if idle := [f"{entry.file}: {entry.name.pattern}" for entry in table if not entry.points]:
        raise tools.FlowError(f"{EXCLUSIONS}: these leave nothing out: {', '.join(idle)}")
    excluded = {point for entry in table for point in entry.points}

    def numbers(points: list[hardware.Point]) -> dict[str, Any]:
        rest = [point for point in points if point not in excluded]
        found: dict[str, Any] = {"excluded": len(points) - len(rest)}
        for kind in hardware.ENOUGH:
            of_kind = [point for point in rest if point.kind == kind]
            found[kind] = {"all": len(of_kind), "hit": sum(point not in left for point in of_kind)}
        return found

    files = sorted({point.file for point in counts})
    return {"files": {file: numbers([point for point in counts if point.file == file]) for file in files},
            "total": numbers(list(counts)),
            "exclusions": [{"file": each.file, "kinds": each.kinds, "name": each.name.pattern, "reason": each.reason,
                            "points": len(each.points)} for each in table],
            "holes": hardware.names(left)}


def write() -> None:
    verilator = subprocess.run(["verilator", "--version"], capture_output=True, text=True, check=True).stdout
    seconds = json.loads((RESULTS / "seconds.json").read_text())
    all_run = all(name.split("/")[1] in seconds for name in PROGRAMS)
    made: dict[str, Any] = {
        "made_by": "make cov", "date": datetime.date.today().isoformat(),
        "tools": {"verilator": " ".join(verilator.split()[:2]), "gcovr": cpp.version()},
        "programs": seconds,
        "functional": json.loads((RESULTS / "functional.json").read_text()),
        "hardware": of_hardware() if all_run else None,
        "cpp": cpp.summary(cpp.collect(BUILD, RESULTS / "gcovr.json")) if all_run else None}
    tools.write_file(tools.REPORTS / "coverage.json", json.dumps(made, indent=1) + "\n")
    tools.write_file(tools.REPORTS / "coverage.md", report.render(made))
    tools.say("wrote reports/coverage.md and coverage.json")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("targets", "run", "report"))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--programs", type=int, default=2000, help="random ones, of coverage_functional")
    arguments = parser.parse_args()
    if arguments.what == "targets":
        print(" ".join(program.split("/")[1] for program in PROGRAMS))
        return 0
    if arguments.what == "run":
        run_all(arguments.jobs, arguments.programs)
    write()
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
