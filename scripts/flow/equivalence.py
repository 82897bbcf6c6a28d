# SPDX-License-Identifier: Apache-2.0
"""A proof that a hard-wired program of several clocks does what the same program does in one.

`rung translate --to verilog` twice: with a path so long that a scan is one clock, so that the module is nothing but
the rungs' function between two sets of registers; and as usual, with a counter of clocks, values kept from clock to
clock, outputs that wait. Yosys proves with its SAT solver that both hold the same after every scan: for all
values of inputs, clock relays and ticks, and with any state loaded by the host between two scans, from a reset
on for so many scans. Registers without a reset begin with any value.
"""
from __future__ import annotations

import re
import subprocess
import time
from pathlib import Path
from typing import Any

from flow import tools

RUNG = tools.BUILD / "bin" / "rung"
FOLDER = tools.BUILD / "equivalence"
PORTS = ("in_i", "clocks_i", "ticks_i", "state_i")


def translate(program: Path, name: str, path_ns: float | None) -> str:
    """The module, called `name`."""
    option = [] if path_ns is None else ["--path-ns", str(path_ns)]
    text = subprocess.run([str(RUNG), "translate", str(program), "--to", "verilog", *option], check=True,
                          capture_output=True, text=True).stdout
    return text.replace("rung_program", name)


def clocks_of(text: str) -> int:
    found = re.search(r"localparam CLOCKS = (\d+);", text)
    return int(found.group(1)) if found else 1


def miter(text: str) -> str:
    widths = {name: int(high) + 1 for high, name in
              re.findall(r"^\s+(?:input |output) wire \[(\d+):0\] (\w+)", text, re.MULTILINE)}
    inputs = "".join(f", input wire [{widths[name] - 1}:0] {name}" for name in PORTS)
    shared = "".join(f", .{name}({name})" for name in PORTS)
    def instance(name: str) -> str:
        return (f"  {name} {name} (.clk_i(clk_i), .rst_i(rst_i), .start_i(start), .state_load_i(load){shared},\n"
                f"      .busy_o({name}_busy), .error_o({name}_error), .out_o({name}_out), .state_o({name}_state));\n")

    wires = "".join(f"  wire {name}_busy, {name}_error;\n  wire [{widths['out_o'] - 1}:0] {name}_out;\n"
                    f"  wire [{widths['state_o'] - 1}:0] {name}_state;\n" for name in ("one", "several"))
    return (f"module miter (input wire clk_i, input wire rst_i, input wire load_i{inputs});\n{wires}"
            "  wire load = load_i & ~several_busy;\n  wire start = ~load_i & ~several_busy & ~rst_i;\n"
            f"{instance('one')}{instance('several')}"
            "  reg reset_q;\n  always @(posedge clk_i) reset_q <= reset_q | rst_i;\n"
            "  always @* if (reset_q & ~several_busy) assert ({one_out, one_state, one_error} == "
            "{several_out, several_state, several_error});\nendmodule\n")


def solve(folder: Path, one: str, several: str, scans: int) -> tuple[int, bool]:
    """The clocks looked at, and whether the two are equal in all of them."""
    tools.write_file(folder / "miter.v", one + several + miter(several))
    steps = 2 + scans * (clocks_of(several) + 1)
    # In the first step there is a reset, and in no other.
    resets = " ".join(["-set-at 1 rst_i 1", *(f"-set-at {step} rst_i 0" for step in range(2, steps + 1))])
    tools.write_file(folder / "prove.ys", "\n".join([
        f"read_verilog -sv {folder / 'miter.v'}", "prep -flatten -top miter", "memory_map", "opt -full",
        "chformal -lower",
        f"sat -seq 1 -tempinduct-baseonly -maxsteps {steps} -prove-asserts -set-init reset_q 0 {resets}",
    ]) + "\n")
    log = tools.run([tools.YOSYS, "-s", str(folder / "prove.ys")], tools.LOGS / f"equivalence-{folder.name}.log")
    if "proved base case for" in log:
        return steps, True
    if "model found for base case: FAIL!" in log:
        return steps, False
    raise tools.FlowError(f"{folder}: the solver gives no answer")


def prove(program: Path, scans: int) -> dict[str, Any] | None:
    """Nothing if the program is one clock anyway. Raises FlowError if the two differ, or if the solver does not see
    the difference when a register takes its value a clock too late."""
    one, several = translate(program, "one", 1000.0), translate(program, "several", 4.0)
    if clocks_of(several) == 1 or clocks_of(one) > 1:
        return None
    start = time.monotonic()
    steps, equal = solve(FOLDER / program.stem, one, several, scans)
    if not equal:
        raise tools.FlowError(f"{program}: one clock and several differ: see build/logs/equivalence-{program.stem}.log")
    late = re.sub(r"if \(phase\[1\]\) y", "if (phase[2]) y", several, count=1)
    if late != several and solve(FOLDER / f"{program.stem}-late", one, late, scans)[1]:
        raise tools.FlowError(f"{program}: the solver does not see a value that comes too late")
    return {"program": program.name, "clocks": clocks_of(several), "scans": scans, "steps": steps,
            "fault_found": late != several, "seconds": round(time.monotonic() - start, 1)}
