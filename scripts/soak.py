#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Soak the controller (tb/soak): chunks of some thousand scans, a seed each, until so many scans or minutes are done.

A chunk is one process of build/bin/rung-soak BOARD SEED SCANS, which can be replayed by the same words. Its result is a line
of build/soak/chunks.jsonl as soon as it has ended; a run goes on behind the seeds of reports/soak.json. The first
difference ends the run with exit status 1. What was run is added up in reports/soak.json and reports/soak.md.
"""
from __future__ import annotations

import argparse
import datetime
import json
import os
import queue
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "bin" / "rung-soak"
CHUNKS = ROOT / "build" / "soak" / "chunks.jsonl"
REPORT = ROOT / "reports" / "soak.json"
GOAL = 10_000_000
Chunk = dict[str, Any]
MEANING = {
    "scans": "scans, all outputs of each compared with the reference's, in the one clock in which they may change",
    "output_changes": "changes of an output pin, each of them expected in its clock",
    "scans_with_glitches": "scans with inputs that tremble after they were latched",
    "answers": "polls, whose answers were what one scan between request and answer left behind",
    "writes": "writes, which took effect once, between two scans",
    "broken_frames": "broken frames (bits, lengths, noise, errors of the line), which had no answer and no effect",
    "downloads": "programs downloaded and run, each a random one",
    "broken_downloads": "downloads broken off, the program before ran on",
    "refused_downloads": "downloads with a wrong CRC or a wrong bit, refused, the program before ran on",
    "cut_downloads": "resets and power cuts in a download or behind it",
    "cut_commits_old": "in a commit, with the old program there afterwards",
    "cut_commits_new": "in a commit, with the new one",
    "resets": "of all these, resets", "power_cuts": "and power cuts",
    "trips": "watchdogs that had to trip, in a program's first scan", "stops": "STOP by command", "switched": "STOP and RUN by the switch",
    "statistics": "times that least, most and last clocks of a scan were those of the compiler, and no scan late",
    "clocks": "clocks simulated",
}


def chunk(board: str, seed: int, scans: int) -> Chunk:
    with subprocess.Popen([PROGRAM, board, str(seed), str(scans)], stdout=subprocess.PIPE, text=True) as run:
        assert run.stdout is not None
        text = run.stdout.read()
        _, status, usage = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
    try:
        found: Chunk = json.loads(text)
    except json.JSONDecodeError:
        found = {"board": board, "seed": seed, "difference": f"exit status {run.returncode}"}
    return found | {"cpu_seconds": round(usage.ru_utime + usage.ru_stime, 1), "date": datetime.date.today().isoformat()}


def write(done: dict[str, Any]) -> None:
    by_board: dict[str, Any] = done["boards"]
    scans = sum(row["counts"]["scans"] for row in by_board.values())
    done["scans"], done["goal"] = scans, GOAL
    rows = ["| what | " + " | ".join(by_board) + " | all |", "|---|" + "--:|" * (len(by_board) + 1)]
    for key, meaning in MEANING.items():
        values = [row["counts"].get(key, 0) for row in by_board.values()]
        rows.append(f"| {meaning} | " + " | ".join(f"{value:,}" for value in values) + f" | {sum(values):,} |")
    seeds = "; ".join(f"{board}: seeds 1 to {row['last_seed']}, {row['chunks']} chunks, {row['cpu_seconds'] / 60:.1f} minutes "
                      f"of a processor, {row['counts']['scans'] / max(row['cpu_seconds'], 1):,.0f} scans a second" for board, row in by_board.items())
    text = "\n".join([
        "# Soak of the controller, in simulation", "",
        f"Made by `make soak`, last on {done['date']} ({done['tool']}). The whole controller, RTL and firmware, with the MPU of its "
        "board, runs random programs (short ones: 1 to 6 networks and two for the marks, of all families of instructions; "
        "free running or with a period, a watchdog of exactly the compiled clocks) that a client swaps in by downloads while it "
        "polls and writes without a pause; beside it, at the pins and at the line, the reference interpreter (`tb/soak`).", "",
        f"**{scans:,} scans of {GOAL:,}; differences: {len(done['differences'])}.**", "", *rows, "",
        f"{seeds}. A chunk is replayed by `build/bin/rung-soak BOARD SEED {done['scans_of_a_chunk']}`.", "",
        *(f"- difference: `rung-soak {one['board']} {one['seed']} {done['scans_of_a_chunk']}`: {one['difference']}"
          for one in done["differences"]), ""])
    for path, content in ((REPORT.with_suffix(".md"), text), (REPORT, json.dumps(done, indent=1) + "\n")):
        temporary = path.with_suffix(".tmp")
        temporary.write_text(content, encoding="utf-8")
        temporary.replace(path)


def add(done: dict[str, Any], one: Chunk) -> None:
    row = done["boards"].setdefault(one["board"], {"chunks": 0, "last_seed": 0, "cpu_seconds": 0.0, "counts": {"scans": 0}})
    row["chunks"] += 1
    row["last_seed"] = max(row["last_seed"], one["seed"])
    row["cpu_seconds"] = round(row["cpu_seconds"] + one["cpu_seconds"], 1)
    for key, value in one["counts"].items():
        row["counts"][key] = row["counts"].get(key, 0) + value
    done["date"] = one["date"]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scans", type=int, default=GOAL, help="of the report, all runs together")
    parser.add_argument("--minutes", type=float, default=1e9, help="no new chunk begins after them")
    parser.add_argument("--chunk", type=int, default=50_000, help="scans of a chunk")
    parser.add_argument("--jobs", type=int, default=2)
    # The larger board is some times slower: every other chunk would be most of the time.
    parser.add_argument("--boards", nargs="+", default=["hx8k"] * 7 + ["simulated"], help="of the chunks, in turn")
    parser.add_argument("--anew", action="store_true", help="a new report, from seed 1 on")
    options = parser.parse_args()
    done: dict[str, Any] = {"boards": {}, "differences": []}
    if REPORT.exists() and not options.anew:
        done = json.loads(REPORT.read_text(encoding="utf-8"))
        if done["scans_of_a_chunk"] != options.chunk:
            sys.exit(f"reports/soak.json has chunks of {done['scans_of_a_chunk']} scans: --chunk, or --anew")
    done["scans_of_a_chunk"] = options.chunk
    done["tool"] = subprocess.run(["verilator", "--version"], capture_output=True, text=True, check=True).stdout.strip()
    CHUNKS.parent.mkdir(parents=True, exist_ok=True)
    end = time.monotonic() + 60 * options.minutes
    seeds = {board: done["boards"].get(board, {}).get("last_seed", 0) for board in options.boards}
    started = sum(seeds.values())
    lock = threading.Lock()
    results: queue.Queue[Chunk | None] = queue.Queue()
    stop = threading.Event()

    def work() -> None:
        nonlocal started
        while not stop.is_set() and time.monotonic() < end:
            with lock:
                board = options.boards[started % len(options.boards)]
                started += 1
                seeds[board] += 1
                seed = seeds[board]
            results.put(chunk(board, seed, options.chunk))
        results.put(None)

    workers = [threading.Thread(target=work) for _ in range(options.jobs)]
    for worker in workers:
        worker.start()
    running = len(workers)
    while running:
        one = results.get()
        if one is None:
            running -= 1
            continue
        with CHUNKS.open("a", encoding="utf-8") as out:
            out.write(json.dumps(one) + "\n")
        if one["difference"]:
            done["differences"].append({key: one[key] for key in ("board", "seed", "difference", "date")})
            stop.set()
            print(f"DIFFERENCE: rung-soak {one['board']} {one['seed']} {options.chunk}: {one['difference']}", flush=True)
            if not done["boards"]:
                sys.exit(1)
        else:
            add(done, one)
        write(done)
        print(f"{one['board']} seed {one['seed']}: {one.get('counts', {}).get('scans', 0)} scans in {one['cpu_seconds']:.0f} s of a processor; "
              f"{done['scans']} of {options.scans}", flush=True)
        if done["scans"] >= options.scans:
            stop.set()
    sys.exit(1 if done["differences"] else 0)


if __name__ == "__main__":
    main()
