#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fuzz the readers of files (tb/fuzz) for a time each, and keep the inputs that reach new code.

Each reader starts from its corpus, tb/fuzz/corpus/NAME, and works in build/fuzz/work/NAME; at the
end the corpus is reduced to the fewest inputs that reach all that was reached. An input that makes
a reader crash, hang or leak is left in build/fuzz/faults and named; the exit status is then 1.
"""
from __future__ import annotations

import argparse
import datetime
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "fuzz"
CORPUS = ROOT / "tb" / "fuzz" / "corpus"
READERS = ("list", "csv", "ld", "comments", "stimulus", "trace", "image", "ldmicro_trace", "bytecode",
           "io_map", "load_file", "flow")
# A reader that takes longer than this for one input of MAX_BYTES hangs.
HANG_SECONDS = 10
MAX_BYTES = 4096


def fuzzer(reader: str) -> list[str]:
    faults = BUILD / "faults"
    faults.mkdir(parents=True, exist_ok=True)
    return [str(BUILD / "tb" / "fuzz" / f"fuzz_{reader}"), f"-max_len={MAX_BYTES}",
            f"-timeout={HANG_SECONDS}", f"-artifact_prefix={faults}/{reader}-"]


def fuzz(reader: str, seconds: int) -> str:
    """What to report; a line that begins with FAULT for a fault."""
    work = BUILD / "work" / reader
    work.mkdir(parents=True, exist_ok=True)
    log = BUILD / f"{reader}.log"
    with log.open("w") as out:
        run = subprocess.run([*fuzzer(reader), f"-max_total_time={seconds}", "-print_final_stats=1",
                              f"-dict={ROOT / 'tb' / 'fuzz' / 'words.dict'}", str(work),
                              str(CORPUS / reader)], stdout=out, stderr=out, check=False)
    text = log.read_text(errors="replace")
    if run.returncode != 0:
        return f"FAULT {reader}: see {log}"
    runs = re.search(r"number_of_executed_units: (\d+)", text)
    return f"{reader}: {runs.group(1) if runs else '?'} inputs in {seconds} s, no fault"


def reduce(reader: str) -> None:
    """The corpus as the fewest inputs that reach what old corpus and this run reached together."""
    kept = BUILD / "kept" / reader
    if kept.exists():
        shutil.rmtree(kept)
    kept.mkdir(parents=True)
    with (BUILD / f"{reader}-reduce.log").open("w") as out:
        subprocess.run([*fuzzer(reader), "-set_cover_merge=1", str(kept), str(CORPUS / reader),
                        str(BUILD / "work" / reader)], stdout=out, stderr=out, check=True)
    shutil.rmtree(CORPUS / reader)
    shutil.copytree(kept, CORPUS / reader)


def write_report(seconds: int, jobs: int, reports: list[str]) -> None:
    """reports/fuzz.md, when all readers took part."""
    text = "\n".join([
        "# Fuzzing of the readers", "",
        f"Made by `make fuzz SECONDS={seconds} JOBS={jobs}` on {datetime.date.today().isoformat()}: libFuzzer "
        f"with the address and undefined-behaviour sanitizers, {seconds} s a reader, {jobs} at a time. The "
        "inputs worth keeping are in `tb/fuzz/corpus` and are read again in every `make test`.", "",
        *(f"- {report}" for report in reports), ""])
    target = ROOT / "reports" / "fuzz.md"
    temporary = target.with_suffix(".tmp")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(target)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=int, default=600, help="for each reader")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--reader", action="append", choices=READERS, help="only this one")
    options = parser.parse_args()
    readers = options.reader or READERS
    with ThreadPoolExecutor(options.jobs) as pool:
        reports = list(pool.map(lambda reader: fuzz(reader, options.seconds), readers))
    for report in reports:
        print(report)
    if any(report.startswith("FAULT") for report in reports):
        sys.exit(1)
    for reader in readers:
        reduce(reader)
        files = list((CORPUS / reader).iterdir())
        print(f"{reader}: corpus of {len(files)} inputs, "
              f"{sum(file.stat().st_size for file in files)} bytes")
    if tuple(readers) == READERS:
        write_report(options.seconds, options.jobs, reports)


if __name__ == "__main__":
    main()
