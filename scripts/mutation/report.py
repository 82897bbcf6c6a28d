# SPDX-License-Identifier: Apache-2.0
"""reports/mutation.md and mutation.json: counts, what noticed the mutants, and every survivor."""
from __future__ import annotations

import collections
import datetime
import functools
import json
import re
import tomllib
from dataclasses import dataclass
from typing import Any

from flow import tools
from flow.synthesis import yosys_version
from mutation.netlist import Mutant
from mutation.proof import HISTORY, Verdict
from mutation.subjects import Subject

SURVIVORS = tools.ROOT / "tb" / "mutate" / "survivors.toml"
Explanation = dict[str, str]


@dataclass(frozen=True)
class Result:
    subject: Subject
    drawn: int
    mutants: list[Mutant]         # those that were run
    seen: dict[int, str]          # by mutant what noticed it; "" for nothing
    proofs: dict[int, Verdict]    # of those that nothing noticed

    def survivors(self) -> list[Mutant]:
        return [mutant for mutant in self.mutants if mutant.number in self.proofs and not self.proofs[mutant.number].equal]


def explanations() -> list[Explanation]:
    with open(SURVIVORS, "rb") as file:
        return tomllib.load(file).get("survivor", [])


@functools.cache
def source(file: str) -> list[str]:
    return (tools.ROOT / file).read_text(encoding="utf-8").splitlines()


def explained(mutant: Mutant, known: list[Explanation]) -> Explanation | None:
    """The entry of survivors.toml that is about this mutant: one of its places is a line that contains `line`, in file
    `in`, and its description matches `what`, if they say so."""
    for entry in known:
        for place in mutant.places:
            file, line = place.split(":")
            if (entry.get("in", file) == file and entry.get("line", "") in source(file)[int(line) - 1]
                    and re.search(entry.get("what", ""), mutant.describe())):
                return entry
    return None


def unexplained(result: Result, known: list[Explanation]) -> list[str]:
    return [f"{mutant.place}: {result.subject.name}:{mutant.number}: {mutant.describe()}: no test notices it, "
            f"{result.proofs[mutant.number].why}, and tb/mutate/survivors.toml says nothing of it"
            for mutant in result.survivors() if explained(mutant, known) is None]


def counts(results: list[Result]) -> list[str]:
    rows = ["| design | drawn | run | killed | proven equivalent | listed |", "|---|--:|--:|--:|--:|--:|"]
    for group in dict.fromkeys(result.subject.group for result in results):
        some = [result for result in results if result.subject.group == group]
        killed = sum(bool(seen) for result in some for seen in result.seen.values())
        proven = sum(verdict.equal for result in some for verdict in result.proofs.values())
        rows.append(f"| {group} | {sum(result.drawn for result in some)} | {sum(len(result.mutants) for result in some)} | "
                    f"{killed} | {proven} | {sum(len(result.survivors()) for result in some)} |")
    return rows


def parts(results: list[Result]) -> list[str]:
    rows = ["| netlist | parameters | tests | run | killed first by |", "|---|---|---|--:|---|"]
    for result in results:
        suites = collections.Counter(re.sub(r"/\w+$| \(.*$", "", seen) for seen in result.seen.values() if seen)
        first = ", ".join(f"{name} {count}" for name, count in suites.most_common(8))
        others = len(suites) - 8
        parameters = ", ".join(f"{name} {value}" for name, value in result.subject.parameters) or "its own defaults"
        trial = result.subject.trials[-1]
        tests = f"`{trial.program}` {trial.filter.replace('*', chr(92) + '*')}"
        rows.append(f"| {result.subject.name} | {parameters} | {tests} | {len(result.mutants)} | {first}"
                    f"{f', {others} more' if others > 0 else ''} |")
    return rows


def listed(results: list[Result], known: list[Explanation]) -> list[str]:
    rows = ["| where | netlist:number | what is changed | what it is | what it would take |", "|---|---|---|---|---|"]
    for result in results:
        for mutant in sorted(result.survivors(), key=lambda mutant: mutant.place):
            entry = explained(mutant, known) or {"why": "not looked at", "takes": "to be looked at"}
            rows.append(f"| {mutant.place} | {result.subject.name}:{mutant.number} | {mutant.describe()} | {entry['why']} | "
                        f"{entry['takes']} |")
    return rows


def record(result: Result, known: list[Explanation]) -> dict[str, Any]:
    survivors = []
    for mutant in result.mutants:
        if (verdict := result.proofs.get(mutant.number)) is None:
            continue
        entry = None if verdict.equal else explained(mutant, known)
        survivors.append({"number": mutant.number, "places": mutant.places, "what": mutant.describe(), "equal": verdict.equal,
                          "proof": verdict.why, **({"why": entry["why"], "takes": entry["takes"]} if entry else {})})
    return {"netlist": result.subject.name, "design": result.subject.group, "parameters": dict(result.subject.parameters),
            "drawn": result.drawn, "run": len(result.mutants), "killed": sum(bool(seen) for seen in result.seen.values()),
            "killed_by": dict(collections.Counter(seen for seen in result.seen.values() if seen).most_common()),
            "not_killed": survivors}


def write(results: list[Result], known: list[Explanation], seed: int) -> None:
    date = datetime.date.today().isoformat()
    verilator = tools.version("verilator")
    equal = [(result, mutant) for result in results for mutant in result.mutants
             if mutant.number in result.proofs and result.proofs[mutant.number].equal]
    places = collections.Counter(mutant.place.split(":")[0] for _, mutant in equal)
    text = [
        "# Mutation testing", "",
        f"Made by `make mutate` on {date}: {yosys_version()}, {verilator}, seed {seed}. A mutant is the hardware with one fault: "
        "one bit of an input or output of a cell, an instance or a flip-flop is stuck at 0 or 1, inverted, or inverted while "
        "another bit of it is 0 or 1. Yosys draws them evenly over the lines of the source, the signals and their bits; left out "
        "are faults of the clock and of what is there for the tests alone (`RUNG_RETIRE`), and the inside of the memories, whose "
        "ports take part.", "",
        "A mutant is killed if a test of `make test` fails: the test programs of tb/, unchanged, are linked with a model of "
        "the mutated netlist and run until the first test fails, crashes or does not end. What the tests of the "
        "processors compare: every retired instruction with its step, accumulator and write, the clocks of a scan, the error "
        "flag, the write port, and all devices read back (tb/unit, tb/wide_rtl); of the controller, pins, registers and phases "
        "(tb/controller).", "", *counts(results), "",
        "## What killed them", "", *parts(results), "",
        "## Proven equivalent", "",
        f"By induction over clocks (scripts/mutation/proof.py; yices-sat): outputs, and what the memories are told and asked, are "
        f"the same in every clock, whatever the inputs; for some, from the first clock of a reset of {HISTORY} clocks on. "
        f"By file: {', '.join(f'{file} {count}' for file, count in places.most_common()) or 'none'}. Each is in mutation.json.", "",
        "## Survivors", "",
        "Neither killed nor proven: every one of them, with what was found by looking at it.", "", *listed(results, known), ""]
    tools.write_file(tools.REPORTS / "mutation.md", "\n".join(text))
    tools.write_file(tools.REPORTS / "mutation.json", json.dumps(
        {"made_by": "make mutate", "date": date, "seed": seed, "tools": {"yosys": yosys_version(), "verilator": verilator},
         "netlists": [record(result, known) for result in results]}, indent=1) + "\n")
