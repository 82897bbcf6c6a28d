# SPDX-License-Identifier: Apache-2.0
"""Yosys: a design's netlist, kept until its sources, the options or Yosys change."""
from __future__ import annotations

import functools
import re
from pathlib import Path

from flow import floorplan, ram_registers, tools
from flow.designs import Design


@functools.cache
def yosys_version() -> str:
    return tools.version(tools.YOSYS)


def script(design: Design, netlist: Path) -> str:
    """The Yosys script of a design. Its paths start at the top of the tree, so that nothing in the
    netlist depends on where the tree lies."""
    def here(path: Path) -> Path:
        return path.relative_to(tools.ROOT)

    include = " ".join(f"-I {here(folder)}" for folder in design.include)
    sources = " ".join(str(here(source)) for source in design.sources)
    lines = [f"read_verilog {include} {sources}"]
    lines += [f"chparam -set {name} {value} {design.top}" for name, value in design.parameters]
    lines += [f"{design.board.family.synth} -top {design.top}",
              f"write_json {here(netlist)}",
              f"tee -o {here(netlist.with_name('stat.txt'))} stat"]
    return "\n".join(lines) + "\n"


IMPLICIT = r"implicitly declared"
UNDRIVEN = r"multiple conflicting drivers|found logic loop|used but has no driver"


def check_log(log: str, ours: bool) -> None:
    """Raise FlowError for what Yosys only warns of and what makes a netlist wrong.

    A misspelt name becomes a new wire without a driver ("implicitly declared"). In our own RTL a signal
    without a driver or with two, or a logic loop, is no better; generated cores have unused wires.
    """
    bad = [line for line in log.splitlines()
           if re.search(f"{IMPLICIT}|{UNDRIVEN}" if ours else IMPLICIT, line)]
    if bad:
        raise tools.FlowError("Yosys warns of what is an error here:\n" + "\n".join(bad[:10]))


def synthesise(design: Design) -> Path:
    """The design's netlist (JSON), made anew only if something that it depends on has changed."""
    netlist = design.folder / "netlist.json"
    stamp = design.folder / "netlist.inputs"
    text = script(design, netlist)
    headers = [header for folder in design.include for header in sorted(folder.glob("*.vh"))]
    passes = [each for each, wanted in ((ram_registers, design.board.family.ram_registers), (floorplan, design.floorplan)) if wanted]
    want = tools.digest([text, yosys_version()], [*design.sources, *headers, *design.data, *(Path(each.__file__) for each in passes)])
    if tools.up_to_date(stamp, want, [netlist]):
        return netlist
    tools.say(f"{design.name}: synthesis")
    design.folder.mkdir(parents=True, exist_ok=True)
    stamp.unlink(missing_ok=True)
    script_file = design.folder / "synth.ys"
    tools.write_file(script_file, text)
    log = tools.run([tools.YOSYS, "-s", str(script_file)],
                    tools.LOGS / f"synth-{design.name}.log")
    check_log(log, design.ours)
    for each in passes:
        each.rewrite(netlist, design.top)
    tools.write_file(stamp, want)
    return netlist
