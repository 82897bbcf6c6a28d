#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fuzz every reader of outside bytes (tb/fuzz) for a time each, and keep the inputs that reach new code.

Each reader starts from its corpus, tb/fuzz/corpus/NAME, and works in build/fuzz/work/NAME until it has used so many
seconds of a processor; then the corpus is reduced to the fewest inputs that reach all that was reached, and to
inputs that are replayed in MOST_REPLAY seconds. An input that makes a reader crash, hang or leak is left in
build/fuzz/faults and named; the exit status is then 1. What was run is in reports/fuzz.json, to which runs add up, and
reports/fuzz.md. Faults found and mended are in tb/fuzz/faults.toml, their inputs in the corpora as fault-NAME.
"""
from __future__ import annotations

import argparse
import datetime
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "fuzz"
CORPUS = ROOT / "tb" / "fuzz" / "corpus"
REPORT = ROOT / "reports" / "fuzz.json"
# What each reader reads, and the most bytes of an input.
READERS: dict[str, dict[str, Any]] = tomllib.loads((ROOT / "tb" / "fuzz" / "readers.toml").read_text(encoding="utf-8"))
# A reader that takes longer than this for one input hangs.
HANG_SECONDS = 20
# Of a reader's whole corpus, with the sanitizers.
MOST_REPLAY = 1.5
# libFuzzer's exit status after the interrupt that ends its time.
INTERRUPTED = 72
TICKS = os.sysconf("SC_CLK_TCK")


def fuzzer(reader: str) -> list[str]:
    faults = BUILD / "faults"
    faults.mkdir(parents=True, exist_ok=True)
    return [str(BUILD / "tb" / "fuzz" / f"fuzz_{reader}"), f"-max_len={READERS[reader]['max_bytes']}",
            f"-timeout={HANG_SECONDS}", f"-artifact_prefix={faults}/{reader}-"]


def cpu_seconds(pid: int) -> float:
    """Of a process that runs; 0 when it has just gone."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / TICKS


def fuzz(reader: str, seconds: int) -> dict[str, Any]:
    """What it did; `fault` names the log if there was one."""
    work = BUILD / "work" / reader
    work.mkdir(parents=True, exist_ok=True)
    log = BUILD / f"{reader}.log"
    used = 0.0
    with log.open("w", encoding="utf-8") as out:
        with subprocess.Popen([*fuzzer(reader), "-print_final_stats=1", f"-dict={ROOT / 'tb' / 'fuzz' / 'words.dict'}",
                               str(work), str(CORPUS / reader)], stdout=out, stderr=out) as run:
            while run.poll() is None:
                used = max(used, cpu_seconds(run.pid))
                if used >= seconds:
                    run.send_signal(signal.SIGINT)  # it prints what it did, and ends well
                time.sleep(0.5)
    text = log.read_text(encoding="utf-8", errors="replace")
    inputs = re.findall(r"number_of_executed_units: (\d+)", text) or re.findall(r"^#(\d+)\s", text, re.MULTILINE)
    cover = re.findall(r"cov: (\d+) ft: (\d+)", text)
    return {"cpu_seconds": round(used), "inputs": int(inputs[-1]) if inputs else 0,
            "edges": int(cover[-1][0]) if cover else 0, "features": int(cover[-1][1]) if cover else 0,
            "fault": str(log) if run.returncode not in (0, INTERRUPTED) else ""}


def merge(reader: str, kept: Path, *sources: Path) -> None:
    kept.mkdir(parents=True, exist_ok=True)
    with (BUILD / f"{reader}-merge.log").open("w", encoding="utf-8") as out:
        subprocess.run([*fuzzer(reader), "-set_cover_merge=1", str(kept), *map(str, sources)], stdout=out, stderr=out, check=True)


def replay_seconds(reader: str, files: list[Path]) -> float:
    start = time.monotonic()
    with (BUILD / f"{reader}-replay.log").open("w", encoding="utf-8") as out:
        subprocess.run([*fuzzer(reader), *map(str, files)], stdout=out, stderr=out, check=True)
    return time.monotonic() - start


def reduce(reader: str) -> None:
    """The corpus as the fewest inputs that reach what the old one and this run reached together; without the
    largest of them where it would take too long to replay. Those of faults stay."""
    kept = BUILD / "kept" / reader
    if kept.exists():
        shutil.rmtree(kept)
    merge(reader, kept, CORPUS / reader, BUILD / "work" / reader)
    files = sorted(kept.iterdir(), key=lambda file: file.stat().st_size)
    while len(files) > 20 and replay_seconds(reader, files) > MOST_REPLAY:
        files = files[:len(files) * 3 // 4]
    for old in (CORPUS / reader).iterdir():
        if not old.name.startswith("fault-"):
            old.unlink()
    for file in files:
        shutil.copy(file, CORPUS / reader / file.name)


def faults_of(reader: str) -> list[dict[str, Any]]:
    table = tomllib.loads((ROOT / "tb" / "fuzz" / "faults.toml").read_text(encoding="utf-8"))
    return [fault for fault in table.get("fault", []) if fault["reader"] == reader]


def record(reader: str, run: dict[str, Any]) -> None:
    """Adds a run to reports/fuzz.json."""
    report = json.loads(REPORT.read_text(encoding="utf-8")) if REPORT.exists() else {"readers": {}}
    clang = subprocess.run(["clang++", "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]
    report["tool"] = f"libFuzzer of {clang}, address and undefined-behaviour sanitizers"
    report["made_by"] = "make fuzz"
    before = report["readers"].get(reader, {"cpu_seconds": 0, "inputs": 0})
    files = list((CORPUS / reader).iterdir())
    report["readers"][reader] = {
        "what": READERS[reader]["what"],
        "cpu_seconds": before["cpu_seconds"] + run["cpu_seconds"], "inputs": before["inputs"] + run["inputs"],
        "edges": run["edges"], "features": run["features"],
        "corpus_inputs": len(files), "corpus_bytes": sum(file.stat().st_size for file in files),
        "faults_found": len(faults_of(reader)), "last_run": datetime.date.today().isoformat()}
    write(report)


def write(report: dict[str, Any]) -> None:
    rows = ["| reader | what it reads | CPU, s | inputs | edges covered | corpus, inputs | bytes | faults found | last run |",
            "|---|---|--:|--:|--:|--:|--:|--:|---|"]
    faults = []
    for name, at in READERS.items():
        found = faults_of(name)
        faults += [f"- {name}: {fault['what']} {fault['mended']}" for fault in found]
        row = report["readers"].get(name)
        if row is None:
            rows.append(f"| {name} | {at['what']} | 0 | | | | | {len(found) or ''} | never |")
            continue
        row["faults"] = found
        rows.append(f"| {name} | {row['what']} | {row['cpu_seconds']} | {row['inputs']:,} | {row['edges']:,} | "
                    f"{row['corpus_inputs']} | {row['corpus_bytes']:,} | {row['faults_found']} | {row['last_run']} |")
    total = sum(row["cpu_seconds"] for row in report["readers"].values())
    text = "\n".join([
        "# Fuzzing of the readers of outside bytes", "",
        f"Made by `make fuzz`: {report['tool']}. Seconds are those of a processor, of all runs since the reader was "
        f"written, {total / 3600:.1f} hours together. Verilated readers (rtu_line, link, panel, controller) are covered in the C++ "
        "that Verilator makes, without the sanitizers. What each reader checks is at its source in `tb/fuzz`; the inputs "
        "worth keeping are in `tb/fuzz/corpus` and are read again in every `make test`.", "",
        *rows, "", *([report["earlier"], ""] if "earlier" in report else []), "## Faults found", "",
        *(faults or ["None since 2026-11-23, when this list began."]), ""])
    for path, content in ((REPORT.with_suffix(".md"), text), (REPORT, json.dumps(report, indent=1) + "\n")):
        temporary = path.with_suffix(".tmp")
        temporary.write_text(content, encoding="utf-8")
        temporary.replace(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=int, default=600, help="of a processor, for each reader")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--reader", action="append", choices=tuple(READERS), help="only this one")
    options = parser.parse_args()
    readers = options.reader or list(READERS)
    failed = False
    with ThreadPoolExecutor(options.jobs) as pool:
        for reader, run in zip(readers, pool.map(lambda reader: fuzz(reader, options.seconds), readers)):
            if run["fault"]:
                print(f"FAULT {reader}: see {run['fault']}")
                failed = True
                continue
            reduce(reader)
            record(reader, run)
            print(f"{reader}: {run['inputs']} inputs in {run['cpu_seconds']} s of a processor, no fault", flush=True)
    if failed:
        sys.exit(1)


if __name__ == "__main__":
    main()
