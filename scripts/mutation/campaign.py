# SPDX-License-Identifier: Apache-2.0
"""The tests of a subject run once for each mutant, until the first one fails."""
from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from flow import tools
from mutation.netlist import Mutant
from mutation.subjects import Subject, Trial

TESTS = tools.BUILD / "mutate-tests"
KILLED_BY_TIME = "no end within the time limit"


def program(trial: Trial) -> Path:
    return TESTS / "tb" / trial.folder / trial.program


def run(subject: Subject, number: int, trial: Trial, limit: float) -> str:
    """What noticed the mutant: a test, a crash, the time limit; nothing if all tests pass."""
    environment = {**os.environ, **dict(trial.environment), "RUNG_MUTANT": f"{subject.name}:{number}"}
    try:
        done = subprocess.run([str(program(trial)), f"--gtest_filter={trial.filter}", "--gtest_fail_fast"],
                              env=environment, capture_output=True, text=True, errors="replace", timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return KILLED_BY_TIME
    if done.returncode == 0:
        if not re.search(r"\[  PASSED  \] [1-9]", done.stdout):
            raise tools.FlowError(f"{trial.program}: no test is called {trial.filter}")
        return ""
    failed = re.search(r"\[  FAILED  \] ([\w./]+)", done.stdout)
    if failed:
        return failed.group(1)
    started = re.findall(r"\[ RUN      \] ([\w./]+)", done.stdout)
    name = signal.Signals(-done.returncode).name if done.returncode < 0 else f"exit {done.returncode}"
    return f"{started[-1] if started else trial.program} ({name})"


def verdicts(subject: Subject, trial: Trial, mutants: list[Mutant], jobs: int, seconds: float) -> dict[int, str]:
    """By mutant what of a trial noticed it, "" for nothing; after so many seconds no more are begun. What is known of the
    same program is kept, so that a campaign that was stopped goes on where it was."""
    record = subject.folder / f"verdicts-{subject.trials.index(trial)}.json"
    want = tools.digest([str(trial), (subject.folder / "netlist.v").read_text(encoding="utf-8")], [program(trial)])
    known: dict[str, str] = {}
    if record.exists():
        stored = json.loads(record.read_text(encoding="utf-8"))
        known = stored["verdicts"] if stored["of"] == want else {}
    end = time.monotonic() + seconds
    start = time.monotonic()
    if seen := run(subject, 0, trial, 600):
        raise tools.FlowError(f"{subject.name}: {trial.program} fails without a mutant: {seen}")
    limit = 30 + 20 * (time.monotonic() - start)
    left = [mutant for mutant in mutants if str(mutant.number) not in known]
    step = 25 * jobs
    for first in range(0, len(left), step):
        if time.monotonic() > end:
            break
        some = left[first:first + step]
        with ThreadPoolExecutor(jobs) as pool:
            for mutant, seen in zip(some, pool.map(lambda mutant: run(subject, mutant.number, trial, limit), some)):
                known[str(mutant.number)] = seen
        tools.write_file(record, json.dumps({"of": want, "verdicts": known}, indent=0) + "\n")
        tools.say(f"{subject.name}: {len(known)} mutants run, {sum(not seen for seen in known.values())} not noticed")
    return {mutant.number: known[str(mutant.number)] for mutant in mutants if str(mutant.number) in known}
