#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The hard-wired end: programs as logic (rung translate --to verilog), placed and routed.

Writes reports/hardwired.json and hardwired.md. Needs build/bin/rung and build/bin/rung-samples.
"""
from __future__ import annotations

import argparse
import dataclasses
import datetime
import json
import re
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, Callable

from flow import area, equivalence, hardwired_report, place_route, synthesis, tools
from flow.designs import ECP5, WIDE_BOARD, Design
from flow.place_route import nextpnr_version
from flow.synthesis import yosys_version

RUNG = tools.BUILD / "bin" / "rung"
SAMPLES = tools.BUILD / "bin" / "rung-samples"
FOLDER = tools.BUILD / "hardwired"
TOP = tools.ROOT / "tb" / "hardwired"
# For a clock that it reaches. Router 2 did not end: after twelve rounds 4,000 wires still had two users.
BOARD = dataclasses.replace(WIDE_BOARD, name="hardwired", constraints=("--lpf", tools.ROOT / "constraints" / "hardwired.lpf"),
                            family=ECP5, goal_mhz=45)
WORD = re.compile(r"^(MV|ADD|SUB|MUL|DIV)\b.*$", re.MULTILINE)


def sample(number: int) -> str:
    """A stand-in of the paper's sample, as a list."""
    return subprocess.run([str(SAMPLES), "--sample", str(number), "--seed", "1"],
                          capture_output=True, text=True, check=True).stdout


def bits_only(text: str) -> str:
    """The same rungs with a coil of its own in the place of each word instruction."""
    first = 1 + max(int(n) for n in re.findall(r"\bM(\d+)", text))
    coils = iter(range(first, 100000))
    return WORD.sub(lambda _: f"OUT M{next(coils)}", text)


def programs() -> dict[str, Path]:
    """Name in the report -> list."""
    lists = {"sample1": sample(1)}
    lists["sample1-bits"] = bits_only(lists["sample1"])
    lists |= {"sample2": sample(2), "sample3": sample(3)}
    files = {}
    for name, text in lists.items():
        files[name] = FOLDER / f"{name}.il"
        tools.write_file(files[name], text)
    return files


def translate(listing: Path, path_ns: float | None) -> Path:
    verilog = listing.with_suffix(".v")
    option = [] if path_ns is None else ["--path-ns", str(path_ns)]
    subprocess.run([str(RUNG), "translate", str(listing), "--dialect", "paper", "--to", "verilog",
                    "-o", str(verilog), *option], check=True)
    return verilog


def clocks_of(verilog: Path) -> int:
    """Of a scan: what the module's counter is made for."""
    found = re.search(r"localparam CLOCKS = (\d+);", verilog.read_text())
    return int(found.group(1)) if found else 1


def design_of(name: str, verilog: Path) -> Design:
    """The module with a host that reads and writes every device, as the processors offer it."""
    text = verilog.read_text()
    widths = {port: int(high) + 1 for high, port in
              re.findall(r"^\s+(?:input |output) wire \[(\d+):0\] (\w+)", text, re.MULTILINE)}
    parameters = (("HOST", 1), ("INPUTS", widths["in_i"]), ("CLOCKS", widths["clocks_i"]),
                  ("TICKS", widths["ticks_i"]), ("OUTPUTS", widths["out_o"]), ("STATE", widths["state_o"]))
    sources = (verilog, TOP / "hardwired_top.v", TOP / "hardwired_link.v",
               tools.ROOT / "hdl" / "boards" / "power_on_reset.v")
    return Design(f"hardwired-{name}", "hardwired_top", sources, (), parameters, BOARD, kind="bit")


def timed(step: Callable[[], Any]) -> dict[str, float]:
    """Seconds of the clock on the wall and of processors, of a step's programs."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    step()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return {"wall_s": round(time.monotonic() - start, 1),
            "cpu_s": round(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, 1)}


def change(listing: Path, design: Design, seed: int) -> dict[str, Any]:
    """What it takes from a changed list to a bitstream: nothing of an earlier run is used. Kept until the result is another."""
    netlist, kept = design.folder / "netlist.json", design.folder / "change.json"
    of = tools.digest([str(design.parameters), *BOARD.family.nextpnr_options], list(design.sources))
    if kept.exists() and (steps := json.loads(kept.read_text())).pop("of") == of:
        return steps
    shutil.rmtree(design.folder, ignore_errors=True)
    bitstream = design.folder / "program.bit"
    pack = [part.format(layout=design.layout(seed), bitstream=bitstream) for part in BOARD.family.pack]
    steps = {"translate": timed(lambda: translate(listing, None)),
             "synthesis": timed(lambda: synthesis.synthesise(design)),
             "place_and_route": timed(lambda: place_route.place_and_route(design, netlist, seed)),
             "pack": timed(lambda: tools.run(pack, tools.LOGS / f"pack-{design.name}.log")),
             "bitstream_bytes": bitstream.stat().st_size}
    tools.write_file(kept, json.dumps({**steps, "of": of}))
    return steps


def measure(name: str, design: Design, clocks: int, seeds: list[int], jobs: int) -> dict[str, Any]:
    record = {"program": name, "clocks": clocks, **area.measure(design, seeds, jobs)}
    fmax = record["fmax_mhz"]["median"]
    record["scan_ns"] = round(1000 * clocks / fmax, 1)
    tools.say(f"{design.name}: {record['logic_cells']} cells, {clocks} clocks at {fmax} MHz: {record['scan_ns']} ns a scan")
    return record


# Small enough for the proof; sorting_conveyor takes the solver minutes.
PROVED = ("bottle_counter", "elevator", "traffic_light", "step_ladder", "master_control")


def proofs(scans: int) -> list[dict[str, Any]]:
    """That programs of several clocks are those of one."""
    found = []
    for name in PROVED:
        program = tools.ROOT / "tb" / "golden" / "programs" / f"{name}.il"
        proof = equivalence.prove(program, scans)
        if proof is not None:
            tools.say(f"{name}: {proof['clocks']} clocks are one, {scans} scans, {proof['seconds']} s")
            found.append(proof)
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, nargs="+", default=[1],
                        help="Sample 1 takes half an hour each")
    parser.add_argument("--jobs", type=int, default=2, help="runs of nextpnr at once")
    parser.add_argument("--only", nargs="+", metavar="PROGRAM", help="of sample1, sample1-bits, sample2, sample3")
    parser.add_argument("--prove", type=int, metavar="SCANS", help="only prove programs of several clocks")
    parser.add_argument("--render", action="store_true", help="write hardwired.md anew from hardwired.json")
    arguments = parser.parse_args()
    if arguments.render:
        report = json.loads((tools.REPORTS / "hardwired.json").read_text())
        tools.write_file(tools.REPORTS / "hardwired.md", hardwired_report.render(report))
        return 0
    files = programs()
    if arguments.prove:
        proofs(arguments.prove)
        return 0
    report: dict[str, Any] = {
        "made_by": "make hardwired",
        "date": datetime.date.today().isoformat(),
        "tools": {"yosys": yosys_version(),
                  "nextpnr-ecp5": nextpnr_version(BOARD.family.nextpnr).removeprefix("nextpnr-")},
        "options": f"{BOARD.family.synth} {' '.join(BOARD.family.nextpnr_options)}",
        "part": "ECP5-85F grade 6", "seeds": arguments.seeds,
        "results": [], "change": {}, "proofs": [],
    }

    def write() -> None:
        tools.write_file(tools.REPORTS / "hardwired.json", json.dumps(report, indent=1) + "\n")
        tools.write_file(tools.REPORTS / "hardwired.md", hardwired_report.render(report))

    # What is done is written at once: all of it takes an hour on two processors.
    for name, listing in files.items():
        if arguments.only and name not in arguments.only:
            continue
        verilog = translate(listing, None)
        design = design_of(name, verilog)
        report["change"][name] = change(listing, design, arguments.seeds[0])
        report["results"].append(measure(name, design, clocks_of(verilog), arguments.seeds, arguments.jobs))
        write()
    report["proofs"] = proofs(2)
    write()
    tools.say("wrote reports/hardwired.json and hardwired.md")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
