#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run tb/reliability with its full counts and write reports/reliability.md and .json.

The tests say what they counted (properties of GoogleTest's output); this only puts it into tables. A
report is written only if every test that ran has passed. With --filter the others keep what the report had of them,
with its date.
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
REAL_HZ = 25_000_000
# What GoogleTest says of every test.
OWN = {"name", "file", "line", "status", "result", "timestamp", "time", "classname", "value_param", "failures",
       "date", "commit", "seed"}


def run(shard: int, options: argparse.Namespace) -> list[dict[str, Any]]:
    out = ROOT / "build" / "logs" / f"reliability-{shard}.json"
    out.parent.mkdir(parents=True, exist_ok=True)
    environment = os.environ | {"RUNG_RELIABILITY": "" if options.sample else "full",
                                "RUNG_SEED": str(options.seed), "GTEST_TOTAL_SHARDS": str(options.jobs),
                                "GTEST_SHARD_INDEX": str(shard)}
    with out.with_suffix(".log").open("w") as log:
        subprocess.run([options.program, f"--gtest_output=json:{out}", f"--gtest_filter={options.filter}"],
                       env=environment, stdout=log, stderr=log, check=False)
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


def write(tests: list[dict[str, Any]], command: str) -> None:
    tools = [version("verilator", "--version"), version("g++", "--version")]
    latency = [test for test in tests if "Latency" in test["classname"]]
    others = [test for test in tests if test not in latency]
    text = ["# Reliability of the controller, in simulation", "",
            f"Made by `make reliability` ({command}); {'; '.join(tools)}. The whole controller, RTL and firmware, runs "
            "with a model of its flash; what each test does is in `tb/reliability`. Every test here has passed.", "",
            "| test | what was counted | seed | seconds | date, commit |", "|---|---|---|---|---|"]
    for test in others:
        counted = "; ".join(f"{key.replace('_', ' ')}: {value}" for key, value in test.items() if key not in OWN)
        text.append(f"| {test['classname']}.{test['name']} | {counted} | {test['seed']} | {float(test['time'][:-1]):.0f} | "
                    f"{test['date']}, {test['commit']} |")
    if latency:
        dates = sorted({f"{test['date']}, {test['commit']}" for test in latency})
        text += ["", "## From an input's edge to an output's", "",
                 "Clocks, measured at the pins at random phases and then around the extremes; the bounds are those that "
                 "`rung compile --io` prints. A sample of the filter is 25 clocks here. Microseconds are of a 25 MHz "
                 "clock; samples are stand-ins (tb/golden/README.md) with a rung X177 to Y177 added. "
                 f"{'; '.join(dates)}.", "", *latency_table(latency)]
    (ROOT / "reports" / "reliability.md").write_text("\n".join([*text, ""]), encoding="utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--filter", default="*", help="of GoogleTest: run these tests only")
    parser.add_argument("--sample", action="store_true", help="the counts of `make test` only")
    parser.add_argument("--program", default=str(ROOT / "build" / "bin" / "reliability"))
    options = parser.parse_args()
    with ThreadPoolExecutor(options.jobs) as pool:
        shards = pool.map(lambda n: run(n, options), range(options.jobs))
        ran = [test for shard in shards for test in shard]
    failed = [f"{test['classname']}.{test['name']}" for test in ran if "failures" in test]
    if failed or not ran:
        print(f"failed: {', '.join(failed) or 'no test ran'}; see build/logs/reliability-*.log", file=sys.stderr)
        return 1
    record = ROOT / "reports" / "reliability.json"
    tests = {}
    if options.filter != "*" and record.exists():
        tests = {(test["classname"], test["name"]): test for test in json.loads(record.read_text())["tests"]}
    commit = version("git", "-C", str(ROOT), "describe", "--always", "--dirty")
    for test in ran:
        kept = {key: test[key] for key in test if key not in OWN - {"name", "classname", "time"}}
        tests[test["classname"], test["name"]] = kept | {
            "date": datetime.date.today().isoformat(), "commit": commit, "seed": options.seed}
    command = (f"python3 scripts/reliability.py --jobs {options.jobs}"
               f"{' --sample: the counts of `make test`, not the full ones' if options.sample else ''}")
    everything = [tests[key] for key in sorted(tests, key=lambda key: key[0])]
    record.write_text(json.dumps({"command": command, "tests": everything}, indent=1) + "\n", encoding="utf-8")
    write(everything, command)
    print("wrote reports/reliability.md")
    return 0


if __name__ == "__main__":
    sys.exit(main())
