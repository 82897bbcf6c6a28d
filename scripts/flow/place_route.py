# SPDX-License-Identifier: Apache-2.0
"""nextpnr: a design placed and routed with one seed, kept until netlist, options or tool change."""
from __future__ import annotations

import functools
import json
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from flow import tools
from flow.designs import Design


@functools.cache
def nextpnr_version(tool: str) -> str:
    return tools.version(tool)


@dataclass(frozen=True)
class Routed:
    """What one run of nextpnr gave."""
    seed: int
    fmax_mhz: float
    used: dict[str, int]              # nextpnr's cell types
    available: dict[str, int]
    critical_path: list[dict[str, Any]]


def critical_path_of(report: dict[str, Any]) -> list[dict[str, Any]]:
    """The longest path from a clock edge to one of the same clock."""
    inner = [path["path"] for path in report["critical_paths"] if path["from"] == path["to"]]
    if not inner:
        raise tools.FlowError("nextpnr reports no path inside a clock domain")
    return max(inner, key=lambda path: sum(step["delay"] for step in path))


def read_report(path: Path, seed: int) -> Routed:
    """A Routed from nextpnr's report. With several clocks, the slowest counts."""
    report = json.loads(path.read_text())
    fmax = min(clock["achieved"] for clock in report["fmax"].values())
    utilization = report["utilization"]
    return Routed(seed, fmax, {k: v["used"] for k, v in utilization.items()},
                  {k: v["available"] for k, v in utilization.items()}, critical_path_of(report))


class DoesNotFit(tools.FlowError):
    """The device has too little of something: (used, available) by nextpnr's cell types."""

    def __init__(self, design: Design, log: Path, needs: dict[str, tuple[int, int]]) -> None:
        short = ", ".join(f"{used} of {there} {kind}" for kind, (used, there) in needs.items())
        super().__init__(f"{design.name} does not fit {design.board.title}: {short} (all of it: {log})")
        self.needs = needs


def too_much(log: Path) -> dict[str, tuple[int, int]]:
    """What nextpnr's table of utilisation has above 100 %."""
    rows = re.findall(r"^Info:\s+(\w+):\s+(\d+)/\s*(\d+)\s+\d+%$", log.read_text(errors="replace"), re.MULTILINE)
    return {kind: (int(used), int(there)) for kind, used, there in rows if int(used) > int(there)}


def place_and_route(design: Design, netlist: Path, seed: int) -> Routed:
    """Place and route one seed, or take the result of an equal run. DoesNotFit if the device is too small."""
    board = design.board
    tool = board.family.nextpnr
    report = design.folder / f"seed{seed}.json"
    stamp = design.folder / f"seed{seed}.inputs"
    options = [*board.device, *board.family.nextpnr_options, "--freq", str(board.goal_mhz), "--seed", str(seed),
               "--timing-allow-fail"]
    inputs = [netlist]
    if board.constraints:
        option, file = board.constraints
        options += [option + str(file)] if option.endswith("=") else [option, str(file)]
        inputs.append(board.constraints[1])
    else:
        options.append("--lpf-allow-unconstrained")
    results = [report]
    if design.kind == "bit":
        options += [board.family.layout, str(design.layout(seed))]
        results.append(design.layout(seed))
    want = tools.digest([" ".join(options), nextpnr_version(tool)], inputs)
    if not tools.up_to_date(stamp, want, results):
        stamp.unlink(missing_ok=True)
        log = tools.LOGS / f"pnr-{design.name}-seed{seed}.log"
        try:
            tools.run([tool, *options, "--json", str(netlist), "--report", str(report)], log)
        except tools.FlowError as error:
            if needs := too_much(log):
                raise DoesNotFit(design, log, needs) from error
            raise
        tools.write_file(stamp, want)
        routed = read_report(report, seed)
        tools.say(f"{design.name}: seed {seed}: {routed.fmax_mhz:.1f} MHz")
        return routed
    return read_report(report, seed)
