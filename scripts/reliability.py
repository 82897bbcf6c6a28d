#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run tb/reliability with its full counts and write reports/reliability.md and .json.

The tests say what they counted (properties of GoogleTest's output); this only puts it into tables. A
report is written only if every test has passed.
"""
from __future__ import annotations

import argparse
import datetime
import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "bin" / "reliability"
REAL_HZ = 25_000_000
# What GoogleTest says of every test.
OWN = {"name", "file", "line", "status", "result", "timestamp", "time", "classname", "value_param", "failures"}


def run(shard: int, shards: int, seed: int) -> list[dict[str, Any]]:
    out = ROOT / "build" / "logs" / f"reliability-{shard}.json"
    out.parent.mkdir(parents=True, exist_ok=True)
    environment = os.environ | {"RUNG_RELIABILITY": "full", "RUNG_SEED": str(seed),
                                "GTEST_TOTAL_SHARDS": str(shards), "GTEST_SHARD_INDEX": str(shard)}
    with out.with_suffix(".log").open("w") as log:
        subprocess.run([str(PROGRAM), f"--gtest_output=json:{out}"], env=environment, stdout=log,
                       stderr=log, check=False)
    suites = json.loads(out.read_text())["testsuites"]
    return [test for suite in suites for test in suite["testsuite"] if test["status"] == "RUN"]


def version(*command: str) -> str:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[0]


def us(clocks: int) -> str:
    return f"{1e6 * clocks / REAL_HZ:.2f}"


def latency_table(tests: list[dict[str, Any]]) -> list[str]:
    rows = ["| program | points | period | filter | scan | edges | least | most | bound: least | bound: most | "
            "most, us | bound, us |", "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for test in tests:
        match = re.fullmatch(r"EdgeToEdge/(\w+?)_(\d+)_(free|period)_filter(\d+)", test["name"])
        if match is None:
            raise ValueError(f"{test['name']}: not a test of latency")
        program, points, period, samples = match.groups()
        n = {key: int(value) for key, value in test.items() if key not in OWN}
        rows.append(f"| {program} | {points} | {n['period_clocks'] if period == 'period' else 'free'} | {samples} | "
                    f"{n['scan_clocks']} | {n['edges']} | {n['least']} | {n['most']} | {n['bound_least']} | "
                    f"{n['bound_most']} | {us(n['most'])} | {us(n['bound_most'])} |")
    return rows


def write(tests: list[dict[str, Any]], seed: int, jobs: int) -> None:
    today = datetime.date.today().isoformat()
    command = f"python3 scripts/reliability.py --seed {seed} --jobs {jobs}"
    tools = {"verilator": version("verilator", "--version"), "g++": version("g++", "--version"),
             "commit": version("git", "-C", str(ROOT), "describe", "--always", "--dirty")}
    latency = [test for test in tests if "Latency" in test["classname"]]
    others = [test for test in tests if test not in latency]
    text = ["# Reliability of the controller, in simulation", "",
            f"Made by `make reliability` ({command}) on {today}; {'; '.join(tools.values())}; seed {seed}. The whole "
            "controller, RTL and firmware, runs with a model of its flash; what each test does is in `tb/reliability`, "
            "and all of them passed.", "",
            "| test | what was counted | seconds |", "|---|---|---|"]
    for test in others:
        counted = "; ".join(f"{key.replace('_', ' ')}: {value}" for key, value in test.items() if key not in OWN)
        text.append(f"| {test['classname']}.{test['name']} | {counted} | {float(test['time'][:-1]):.0f} |")
    text += ["", "## From an input's edge to an output's", "",
             "Clocks, measured at the pins at random phases and then around the extremes; the bounds are those that "
             "`rung compile --io` prints. A sample of the filter is 25 clocks here. Microseconds are of a 25 MHz clock; "
             "samples are stand-ins (tb/golden/README.md) with a rung X177 to Y177 added.", "",
             *latency_table(latency), ""]
    reports = ROOT / "reports"
    (reports / "reliability.md").write_text("\n".join(text), encoding="utf-8")
    record = {"date": today, "command": command, "tools": tools, "seed": seed,
              "tests": [{key: test[key] for key in test if key not in OWN - {"name", "classname", "time"}}
                        for test in tests]}
    (reports / "reliability.json").write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    with ThreadPoolExecutor(options.jobs) as pool:
        shards = pool.map(lambda n: run(n, options.jobs, options.seed), range(options.jobs))
        tests = [test for shard in shards for test in shard]
    failed = [f"{test['classname']}.{test['name']}" for test in tests if "failures" in test]
    if failed:
        print(f"failed: {', '.join(failed)}; see build/logs/reliability-*.log", file=sys.stderr)
        return 1
    tests.sort(key=lambda test: test["classname"])
    write(tests, options.seed, options.jobs)
    print("wrote reports/reliability.md")
    return 0


if __name__ == "__main__":
    sys.exit(main())
