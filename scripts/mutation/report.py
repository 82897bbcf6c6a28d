# SPDX-License-Identifier: Apache-2.0
"""reports/mutation.md and mutation.json: counts, what noticed the mutants, and every survivor.

A run of some netlists replaces what the report says of them and keeps the others, with their dates.
"""
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
RECORD = tools.REPORTS / "mutation.json"
Explanation = dict[str, str]
Record = dict[str, Any]


@dataclass(frozen=True)
class Result:
    subject: Subject
    drawn: int
    mutants: list[Mutant]         # those that were run
    seen: dict[int, str]          # by mutant what noticed it; "" for nothing
    proofs: dict[int, Verdict]    # of those that nothing noticed

    def survivors(self) -> list[Mutant]:
        return [mutant for mutant in self.mutants if mutant.number in self.proofs and not self.proofs[mutant.number].equal]


def table(name: str) -> list[Explanation]:
    """Of tb/mutate/survivors.toml."""
    with open(SURVIVORS, "rb") as file:
        return tomllib.load(file).get(name, [])


def explanations() -> list[Explanation]:
    return table("survivor")


def holes() -> list[str]:
    rows = ["| mutant | why no test noticed it | test |", "|---|---|---|"]
    return rows + [f"| {entry['mutant']} | {entry['why']} | {entry['test']} |" for entry in table("hole")]


@functools.cache
def source(file: str) -> list[str]:
    return (tools.ROOT / file).read_text(encoding="utf-8").splitlines()


def explained(mutant: Mutant, known: list[Explanation]) -> Explanation | None:
    """The entry of survivors.toml that is about this mutant: one of its places is a line that contains `line`, in file
    `in`, and its description matches `what`, if they say so."""
    lines = [(file, source(file)[int(line) - 1]) for file, line in (place.split(":") for place in mutant.places)]
    for entry in known:
        for file, text in lines or [("?", "")]:
            if (entry.get("in", file) == file and entry.get("line", "") in text
                    and re.search(entry.get("what", ""), mutant.describe())):
                return entry
    return None


def unexplained(result: Result, known: list[Explanation]) -> list[str]:
    return [f"{mutant.place}: {result.subject.name}:{mutant.number}: {mutant.describe()}: no test notices it, "
            f"{result.proofs[mutant.number].why}; write a test, or say in tb/mutate/survivors.toml what it would take"
            for mutant in result.survivors() if explained(mutant, known) is None]


def record(result: Result, known: list[Explanation], seed: int) -> Record:
    alive = []
    for mutant in result.mutants:
        if (verdict := result.proofs.get(mutant.number)) is None:
            continue
        entry = None if verdict.equal else explained(mutant, known)
        alive.append({"number": mutant.number, "place": mutant.place, "places": mutant.places, "what": mutant.describe(), "equal": verdict.equal,
                      "proof": verdict.why, **({"why": entry["why"], "takes": entry["takes"]} if entry else {})})
    trial = result.subject.trials[-1]
    return {"netlist": result.subject.name, "design": result.subject.group, "date": datetime.date.today().isoformat(),
            "seed": seed, "parameters": dict(result.subject.parameters), "tests": [trial.program, trial.filter],
            "drawn": result.drawn, "run": len(result.mutants), "killed": sum(bool(seen) for seen in result.seen.values()),
            "killed_by": dict(collections.Counter(seen for seen in result.seen.values() if seen).most_common()),
            "not_killed": alive}


def counts(records: list[Record]) -> list[str]:
    rows = ["| design | drawn | run | killed | proven equivalent | listed |", "|---|--:|--:|--:|--:|--:|"]
    for design in dict.fromkeys(each["design"] for each in records):
        some = [each for each in records if each["design"] == design]
        alive = [mutant for each in some for mutant in each["not_killed"]]
        equal = sum(mutant["equal"] for mutant in alive)
        rows.append(f"| {design} | {sum(each['drawn'] for each in some)} | {sum(each['run'] for each in some)} | "
                    f"{sum(each['killed'] for each in some)} | {equal} | {len(alive) - equal} |")
    return rows


def parts(records: list[Record]) -> list[str]:
    rows = ["| netlist | parameters | tests | run | killed first by | date, seed |", "|---|---|---|--:|---|---|"]
    for each in records:
        suites: collections.Counter[str] = collections.Counter()
        for test, count in each["killed_by"].items():
            suites[re.sub(r"/\w+$| \(.*$", "", test)] += count
        first = ", ".join(f"{name} {count}" for name, count in suites.most_common(8))
        parameters = ", ".join(f"{name} {value}" for name, value in each["parameters"].items()) or "its own defaults"
        tests = f"`{each['tests'][0]}` {each['tests'][1]}".replace("*", "\\*")
        rows.append(f"| {each['netlist']} | {parameters} | {tests} | {each['run']} | {first}"
                    f"{f', {len(suites) - 8} more' if len(suites) > 8 else ''} | {each['date']}, {each['seed']} |")
    return rows


def listed(records: list[Record]) -> list[str]:
    rows = ["| where | netlist:number | what is changed | what it is | what it would take |", "|---|---|---|---|---|"]
    for each in records:
        for mutant in sorted(each["not_killed"], key=lambda mutant: mutant["place"]):
            if not mutant["equal"]:
                rows.append(f"| {mutant['place']} | {each['netlist']}:{mutant['number']} | {mutant['what']} | "
                            f"{mutant.get('why', 'not looked at')} | {mutant.get('takes', 'to be looked at')} |")
    return rows if len(rows) > 2 else ["None."]


def write(results: list[Result], known: list[Explanation], seed: int, order: list[str]) -> None:
    """The report; `order` has the names of all netlists that there are."""
    kept = json.loads(RECORD.read_text(encoding="utf-8"))["netlists"] if RECORD.exists() else []
    records = {each["netlist"]: each for each in kept} | {result.subject.name: record(result, known, seed) for result in results}
    all_of = [records[name] for name in order if name in records]
    missing = [name for name in order if name not in records]
    verilator = tools.version("verilator")
    places = collections.Counter(mutant["place"].split(":")[0] for each in all_of for mutant in each["not_killed"]
                                 if mutant["equal"])
    text = [
        "# Mutation testing", "",
        f"Made by `make mutate` with {yosys_version()} and {verilator}. A mutant is the hardware with one fault: "
        "one bit of an input or output of a cell, an instance or a register is stuck at 0 or 1, inverted, or inverted while "
        "another bit is 0 or 1. Yosys draws them evenly over the lines of the source, the signals and their bits; left out "
        "are faults of the clock and of what is there for the tests alone (`RUNG_RETIRE`), and the inside of the memories, whose "
        "ports take part. They come in an order by chance, so that the first part of them, if not all were run, is a sample.", "",
        "A mutant is killed if a test of `make test` fails: the test programs of tb/, unchanged, are linked with a model of "
        "the mutated netlist and run until the first test fails, crashes or does not end. What the tests of the "
        "processors compare: every retired instruction with its step, accumulator and write, the clocks of a scan, the error "
        "flag, the write port, and all devices read back (tb/unit, tb/wide_rtl); of the controller, pins, registers and phases "
        "(tb/controller).", "", *counts(all_of), "",
        *([f"Not run yet: {', '.join(missing)}.", ""] if missing else []),
        "## What killed them", "", *parts(all_of), "",
        "## Proven equivalent", "",
        f"By induction over clocks (scripts/mutation/proof.py; yices-sat): outputs, and what the memories are told and asked, are "
        f"the same in every clock, whatever the inputs; for some, from the first clock of a reset of {HISTORY} clocks on. "
        f"By file: {', '.join(f'{file} {count}' for file, count in places.most_common()) or 'none'}. Each is in mutation.json.", "",
        "## Survivors", "",
        "Neither killed nor proven: every one of them, with what was found by looking at it.", "", *listed(all_of), "",
        "## Holes that mutants have shown", "",
        "No test noticed these when they were first run; the test was written because of them.", "", *holes(), ""]
    tools.write_file(tools.REPORTS / "mutation.md", "\n".join(text))
    tools.write_file(RECORD, json.dumps(
        {"made_by": "make mutate", "tools": {"yosys": yosys_version(), "verilator": verilator}, "netlists": all_of}, indent=1) + "\n")
