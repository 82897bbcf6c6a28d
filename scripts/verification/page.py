# SPDX-License-Identifier: Apache-2.0
"""reports/verification.md from what scripts/verification.py has gathered."""
from __future__ import annotations

from typing import Any

# A pattern of tests, readable in a table
CLEAN = str.maketrans("", "", "^$\\")


def source(each: dict[str, Any]) -> str:
    if each["kind"] == "report":
        return f"[{each['what']}]({each['what']}.md)"
    return f"`{each['what'].translate(CLEAN).replace('|', '&#124;')}`"


def evidence(each: dict[str, Any]) -> str:
    text = f"{source(each)}: {each['says']}"
    return text if each["ok"] else f"**{text}**"


def render(report: dict[str, Any]) -> str:
    tests = report["tests"]
    whole = sum(row["ok"] for row in report["promises"])
    lines = ["# What is promised, and how we know", "",
             f"Made by `make verification` on {report['date']}: {whole} of {len(report['promises'])} promises have all of their evidence. The tests are those of one "
             f"`make test`: {tests['passed']} passed, {tests['failed']} failed, {tests['skipped']} are for longer runs, {tests['seconds']} s ({tests['when']}). "
             "Proofs are of [formal.md](formal.md); the other reports say how and when they were made. What is bold is missing. The table is `tb/promises.toml`.", "",
             "| promise | evidence | what it does not show |", "|---|---|---|"]
    for row in report["promises"]:
        lines.append(f"| **{row['name']}.** {row['says']} | {'<br>'.join(map(evidence, row['evidence']))} | {row['open']} |")
    lines += ["", "## Bugs, and what found them", "", f"{len(report['bugs'])} of those worth telling; the table is `tb/bugs.toml`.", "",
              "| where | what | found by |", "|---|---|---|"]
    lines += [f"| {bug['where']} | {bug['what']} | {bug['found_by']} |" for bug in report["bugs"]]
    return "\n".join([*lines, ""])
