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
from flow.designs import BOARDS, Board, Design
from flow.place_route import nextpnr_version
from flow.synthesis import yosys_version

RUNG = tools.BUILD / "bin" / "rung"
SAMPLES = tools.BUILD / "bin" / "rung-samples"
FOLDER = tools.BUILD / "hardwired"
TOP = tools.ROOT / "tb" / "hardwired"
ULX3S = BOARDS["ulx3s"]
PARTS: dict[str, Board] = {
    "25k": dataclasses.replace(ULX3S, title="ECP5-25k grade 6", constraints=None, config="",
                               device=("--25k", "--package", "CABGA256", "--speed", "6")),
    "85k": dataclasses.replace(ULX3S, title="ECP5-85F grade 6", constraints=None, config=""),
}
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


def design_of(name: str, verilog: Path, part: str, host: bool) -> Design:
    text = verilog.read_text()
    widths = {port: int(high) + 1 for high, port in
              re.findall(r"^\s+(?:input |output) wire \[(\d+):0\] (\w+)", text, re.MULTILINE)}
    parameters = (("HOST", int(host)), ("INPUTS", widths["in_i"]), ("CLOCKS", widths["clocks_i"]),
                  ("TICKS", widths["ticks_i"]), ("OUTPUTS", widths["out_o"]),
                  ("STATE", widths["state_o"]))
    sources = (verilog, TOP / "hardwired_top.v", TOP / "hardwired_link.v",
               tools.ROOT / "hdl" / "boards" / "power_on_reset.v")
    return Design(f"{name}{'-host' if host else ''}{'-85k' if part == '85k' else ''}", "hardwired_top", sources, (), parameters,
                  PARTS[part], kind="hardwired")


def timed(step: Callable[[], Any]) -> dict[str, float]:
    """Seconds of the clock on the wall and of processors, of a step's programs."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    step()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return {"wall_s": round(time.monotonic() - start, 1),
            "cpu_s": round(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, 1)}


def change(name: str, listing: Path) -> dict[str, Any]:
    """What it takes from a changed list to a bitstream: nothing of an earlier run is used."""
    verilog = translate(listing, None)
    design = dataclasses.replace(design_of(f"change-{name}", verilog, "25k", False), kind="bit")
    shutil.rmtree(design.folder, ignore_errors=True)
    family = design.board.family
    bitstream = design.folder / "program.bit"
    files = {"{layout}": str(design.layout(1)), "{bitstream}": str(bitstream)}
    pack = [files.get(word, word) for word in family.pack]
    netlist = design.folder / "netlist.json"
    return {"translate": timed(lambda: translate(listing, None)),
            "synthesis": timed(lambda: synthesis.synthesise(design)),
            "place_and_route": timed(lambda: place_route.place_and_route(design, netlist, 1)),
            "pack": timed(lambda: tools.run(pack, tools.LOGS / f"pack-{design.name}.log")),
            "bitstream_bytes": bitstream.stat().st_size}


def measure(name: str, verilog: Path, part: str, host: bool, seeds: list[int], jobs: int) -> dict[str, Any]:
    design = design_of(name, verilog, part, host)
    record = {"program": name, "part": part, "host": host, "clocks": clocks_of(verilog)}
    # Both parts get the same netlist.
    netlist = synthesis.synthesise(design_of(name, verilog, "25k", host))
    try:
        record.update(fits=True, **area.measure(design, seeds, jobs, netlist))
    except place_route.DoesNotFit as error:
        record.update(fits=False, needs=error.needs)
        tools.say(f"{name} {part}: does not fit")
        return record
    fmax = record["fmax_mhz"]["median"]
    record["scan_ns"] = round(1000 * record["clocks"] / fmax, 1)
    tools.say(f"{design.name}, {part}: {record['logic_cells']} cells, {record['clocks']} clocks at {fmax} MHz: "
              f"{record['scan_ns']} ns a scan")
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
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("--jobs", type=int, default=2, help="runs of nextpnr at once")
    parser.add_argument("--only", nargs="+", metavar="PROGRAM", help="of sample1, sample1-bits, sample2, sample3")
    parser.add_argument("--explore", type=float, nargs="+", metavar="NS",
                        help="only print Sample 1 with these values of --path-ns")
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
    if arguments.explore:
        for path_ns in arguments.explore:
            verilog = translate(files["sample1"], path_ns)
            named = verilog.rename(FOLDER / f"sample1-{path_ns}ns.v")
            measure(f"sample1-{path_ns}ns", named, "25k", True, arguments.seeds, arguments.jobs)
        return 0
    report: dict[str, Any] = {
        "made_by": "make hardwired",
        "date": datetime.date.today().isoformat(),
        "tools": {"yosys": yosys_version(),
                  "nextpnr-ecp5": nextpnr_version(ULX3S.family.nextpnr).removeprefix("nextpnr-")},
        "options": f"{ULX3S.family.synth} {' '.join(ULX3S.family.nextpnr_options)}",
        "parts": {part: board.title for part, board in PARTS.items()},
        "seeds": arguments.seeds,
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
        for part, host in (("25k", True), ("85k", True), ("25k", False)):
            report["results"].append(measure(name, verilog, part, host, arguments.seeds, arguments.jobs))
        report["change"][name] = change(name, listing)
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
