#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The dashboard: each promise of the design (tb/promises.toml) with its evidence, and the bugs found (tb/bugs.toml).

Reads the results of `make test` (build/test/results.xml), reports/formal.json and the other JSON in reports/; writes
reports/verification.json and verification.md. Exit code 1 if a piece of evidence is not there or says no: the report
is written all the same, and says which.
"""
from __future__ import annotations

import argparse
import datetime
import fnmatch
import json
import re
import sys
import tomllib
import xml.etree.ElementTree as ET
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from flow import tools
from verification import checks, page

TABLES = tools.ROOT / "tb"


@dataclass
class Tests:
    """The tests of one run of ctest: name -> passed, failed or skipped."""
    when: str = ""
    seconds: float = 0
    outcome: dict[str, str] = field(default_factory=dict)

    @staticmethod
    def read(path: Path) -> "Tests":
        suite = ET.parse(path).getroot()
        status = {"run": "passed", "fail": "failed"}
        return Tests(suite.get("timestamp", ""), float(suite.get("time", 0)),
                     {case.get("name", ""): status.get(case.get("status", ""), "skipped") for case in suite.iter("testcase")})


def of_tests(pattern: str, tests: Tests) -> dict[str, Any]:
    found = [outcome for name, outcome in tests.outcome.items() if re.search(pattern, name)]
    passed, failed = found.count("passed"), found.count("failed")
    text = f"{passed} tests pass" if passed > 1 else "1 test passes" if passed else "no test"
    if failed:
        text += f", {failed} FAIL"
    if skipped := found.count("skipped"):
        text += f", {skipped} only in a longer run"
    return {"kind": "tests", "what": pattern, "ok": passed > 0 and not failed, "says": text}


def of_proofs(pattern: str, formal: dict[str, Any]) -> dict[str, Any]:
    found = [proof for proof in formal["proofs"] if fnmatch.fnmatch(proof["name"], pattern)]
    good = [proof for proof in found if proof["verdict"] == "PASS" and proof["cover"] == "PASS"]
    unbounded = sum(proof["mode"] == "prove" for proof in good)
    text = f"{len(good)} proofs" if len(good) != 1 else "1 proof"
    if good:
        text += f", {unbounded} unbounded"
    if len(good) < len(found):
        text += f", {len(found) - len(good)} FAIL"
    return {"kind": "proofs", "what": pattern, "ok": bool(found) and len(good) == len(found), "says": text}


def of_report(name: str) -> dict[str, Any]:
    check = checks.CHECKS[name]
    path = tools.REPORTS / f"{check.report}.json"
    if not path.exists():
        return {"kind": "report", "what": check.report, "ok": False, "says": f"no reports/{path.name}: `{check.made_by}` makes it"}
    ok, text = check.judge(json.loads(path.read_text(encoding="utf-8")))
    return {"kind": "report", "what": check.report, "ok": ok, "says": text}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", type=Path, default=tools.BUILD / "test" / "results.xml", help="JUnit file of ctest")
    arguments = parser.parse_args()
    if not arguments.results.exists():
        raise tools.FlowError(f"no {arguments.results}: `make test` writes it")
    tests = Tests.read(arguments.results)
    formal_path = tools.REPORTS / "formal.json"
    formal = json.loads(formal_path.read_text(encoding="utf-8")) if formal_path.exists() else {"proofs": []}
    rows = []
    for promise in tomllib.loads((TABLES / "promises.toml").read_text(encoding="utf-8"))["promise"]:
        evidence = [*(of_tests(pattern, tests) for pattern in promise.get("tests", [])),
                    *(of_proofs(pattern, formal) for pattern in promise.get("proofs", [])),
                    *(of_report(name) for name in promise.get("reports", []))]
        rows.append({"name": promise["name"], "says": promise["says"], "open": promise["open"],
                     "ok": all(each["ok"] for each in evidence), "evidence": evidence})
    outcomes = list(tests.outcome.values())
    report = {
        "made_by": "make verification", "date": datetime.date.today().isoformat(),
        "tests": {"when": tests.when, "seconds": round(tests.seconds),
                  **{outcome: outcomes.count(outcome) for outcome in ("passed", "failed", "skipped")}},
        "promises": rows,
        "bugs": tomllib.loads((TABLES / "bugs.toml").read_text(encoding="utf-8"))["bug"],
    }
    tools.write_file(tools.REPORTS / "verification.json", json.dumps(report, indent=1) + "\n")
    tools.write_file(tools.REPORTS / "verification.md", page.render(report))
    bad = [f"{row['name']}: {each['what']}: {each['says']}" for row in rows for each in row["evidence"] if not each["ok"]]
    tools.say(f"wrote reports/verification.json and verification.md: {len(rows) - len({line.split(':')[0] for line in bad})} of "
              f"{len(rows)} promises with all of their evidence")
    for line in bad:
        print(f"verification: {line}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
