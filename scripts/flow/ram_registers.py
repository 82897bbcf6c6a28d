# SPDX-License-Identifier: Apache-2.0
"""The output registers of ECP5's block RAMs, which Yosys leaves unused.

A DP16KD gives its data some 5.6 ns after the clock edge, or under 1 ns if its own output register is in use. Where all that
leaves a port goes into plain flip-flops and nowhere else, these are what that register is: they are taken
out of the netlist, and the port says OUTREG. Nothing of what the netlist does changes.
"""
from __future__ import annotations

import collections
import json
import re
from pathlib import Path
from typing import Any

Bit = int | str  # a net's number, or a constant
RAM = "DP16KD"
OUTPUT = re.compile(r"DO([AB])\d+$")


def readers(module: dict[str, Any]) -> collections.Counter[Bit]:
    """How many pins of cells and ports of the module read each net."""
    found: collections.Counter[Bit] = collections.Counter()
    for cell in module["cells"].values():
        for pin, bits in cell["connections"].items():
            if cell["port_directions"][pin] != "output":
                found.update(bits)
    for port in module["ports"].values():
        if port["direction"] != "input":
            found.update(port["bits"])
    return found


def plain_registers(module: dict[str, Any]) -> dict[Bit, str]:
    """Flip-flops without enable, set and reset, on the rising edge, by the net that they take."""
    found = {}
    for name, cell in module["cells"].items():
        if cell["type"] != "TRELLIS_FF":
            continue
        kind, pins = cell["parameters"], cell["connections"]
        if kind["CEMUX"].strip() == "1" and kind["CLKMUX"] == "CLK" and pins.get("LSR", ["0"]) == ["0"] and "DI" in pins:
            found[pins["DI"][0]] = name
    return found


def sides(ram: dict[str, Any]) -> list[str]:
    """The ports of a block RAM that have an output register of their own: one for both in its widest shape."""
    return ["AB"] if int(ram["parameters"]["DATA_WIDTH_B"], 2) == 36 else ["A", "B"]


def absorb(module: dict[str, Any]) -> int:
    """Move flip-flops into the block RAMs of a flat netlist; how many."""
    count = readers(module)
    registers = plain_registers(module)
    cells = module["cells"]
    moved = 0
    for ram in [cell for cell in cells.values() if cell["type"] == RAM]:
        pins = ram["connections"]
        for side in sides(ram):
            read = [pin for pin in pins if (match := OUTPUT.match(pin)) and match[1] in side and count[pins[pin][0]]]
            clock, enable = f"CLK{side[-1]}", f"OCE{side[-1]}"
            takers = [registers.get(pins[pin][0]) for pin in read]
            fits = all(name and count[pins[pin][0]] == 1 and cells[name]["connections"]["CLK"] == pins[clock]
                       for pin, name in zip(read, takers))
            if not read or not fits or pins[enable] != ["1"] or ram["parameters"][f"{clock}MUX"] != clock:
                continue
            for pin, name in zip(read, takers):
                pins[pin] = cells.pop(name)["connections"]["Q"]
            for letter in side:
                ram["parameters"][f"REGMODE_{letter}"] = "OUTREG"
                pins[f"OCE{letter}"] = ["1"]
            moved += len(read)
    return moved


def rewrite(netlist: Path, top: str) -> None:
    """The same for a netlist of Yosys in a file."""
    design = json.loads(netlist.read_text())
    absorb(design["modules"][top])
    netlist.write_text(json.dumps(design))
