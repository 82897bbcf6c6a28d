#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Mutation testing of the processors and the controller: reports/mutation.md and mutation.json.

Faults are drawn in the hardware (mutation/netlist.py), the project's own tests are built with the faulty netlists in
the place of it (tb/mutate) and run once for each fault, and what no test has noticed is proven to be no fault
(mutation/proof.py) or listed, with what tb/mutate/survivors.toml says of it. Exit code 1 if a survivor is neither
proven nor explained; the report is written anyway.
"""
from __future__ import annotations

import argparse
import itertools
import subprocess
import sys

from flow import tools
from mutation import campaign, netlist, proof, report
from mutation.subjects import Subject, subjects

NETLISTS = tools.BUILD / "mutate" / "netlists"


def build(chosen: list[Subject], jobs: int) -> None:
    """The test programs, with all netlists that there are."""
    tools.say("building the tests (log: build/logs/mutate-build.log)")
    targets = sorted({trial.program for subject in chosen for trial in subject.trials})
    rules = campaign.TESTS / "build.ninja"
    # A netlist that was not there before is nothing that the rules would notice.
    if not rules.exists() or any(path.stat().st_mtime > rules.stat().st_mtime for path in NETLISTS.iterdir()):
        tools.run(["cmake", "-G", "Ninja", "-S", "compiler", "-B", str(campaign.TESTS), "-DCMAKE_BUILD_TYPE=Release",
                   f"-DRUNG_MUTANTS={NETLISTS}"], tools.LOGS / "mutate-configure.log")
    tools.run(["cmake", "--build", str(campaign.TESTS), "-j", str(jobs), "--target", *targets],
              tools.LOGS / "mutate-build.log")


def examine(subject: Subject, mutants: list[netlist.Mutant], jobs: int, seconds: float) -> report.Result:
    """Kill or prove the mutants of a subject: the first tests, then the proofs that take no time, as what is proven needs
    no more tests; all tests, then all proofs."""
    seen: dict[int, str] = {}
    proofs: dict[int, proof.Verdict] = {}
    alive, prover = mutants, None
    for trial in subject.trials:
        found = campaign.verdicts(subject, trial, alive, jobs, seconds)
        seen |= {number: by for number, by in found.items() if by}
        alive = [mutant for mutant in alive if mutant.number in found and not found[mutant.number]]
        if alive and prover is None:
            prover = proof.Prover(subject, alive)
            proofs = {mutant.number: verdict for mutant in alive if (verdict := prover.attempt(mutant, 0)).equal}
        alive = [mutant for mutant in alive if mutant.number not in proofs]
        tools.say(f"{subject.name}: {len(seen)} killed, {len(proofs)} proven, {len(alive)} left")
    if prover is not None:
        proofs |= {mutant.number: prover.prove(mutant) for mutant in alive}
    seen |= {number: "" for number in proofs}
    # If there was no time for all: those up to the first one left, as the others are those that take long to kill.
    run = list(itertools.takewhile(lambda mutant: mutant.number in seen, mutants))
    numbers = {mutant.number for mutant in run}
    tools.say(f"{subject.name}: {sum(verdict.equal for verdict in proofs.values())} proven")
    return report.Result(subject, len(mutants), run, {number: by for number, by in seen.items() if number in numbers},
                         {number: verdict for number, verdict in proofs.items() if number in numbers})


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--subject", action="append", default=[], choices=[subject.name for subject in subjects()],
                        help="these only; the report keeps what it has of the others")
    parser.add_argument("--seconds", type=float, default=1e9,
                        help="for each netlist: no test is begun after them, and the report says how many mutants were run")
    options = parser.parse_args()
    chosen = [subject for subject in subjects() if not options.subject or subject.name in options.subject]
    try:
        mutants = {}
        for subject in chosen:
            mutants[subject.name] = netlist.draw(subject, options.seed)
            netlist.write(subject, mutants[subject.name], NETLISTS)
            tools.say(f"{subject.name}: {len(mutants[subject.name])} mutants")
        build(chosen, options.jobs)
        results = [examine(subject, mutants[subject.name], options.jobs, options.seconds) for subject in chosen]
        known = report.explanations()
        unexplained = [line for result in results for line in report.unexplained(result, known)]
        report.write(results, known, options.seed, [subject.name for subject in subjects()])
        tools.say("wrote reports/mutation.md and mutation.json")
    except (tools.FlowError, subprocess.CalledProcessError) as error:
        print(f"mutate: {error}", file=sys.stderr)
        return 1
    for line in unexplained:
        print(line, file=sys.stderr)
    return 1 if unexplained else 0


if __name__ == "__main__":
    sys.exit(main())
