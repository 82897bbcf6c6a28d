# SPDX-License-Identifier: Apache-2.0
"""Where MPU4's block RAMs and multipliers stand on an ECP5-85F, as BEL attributes in the netlist.

With 16 slots they are 160 of the chip's 208 block RAMs, so most of those are in use wherever they stand, and which of
them belongs to which slot decides how long the wires are. nextpnr's placers leave that to chance: the logic gathers near the pins,
and two thirds of the wire lead to memories far away, more than the router finds room for. Here two slots and the
word unit beside them have a piece of a row of block RAMs of their own, and the multiplier next to it; the placer puts
the logic around them. What the netlist does is not changed.
"""
from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from flow.tools import FlowError

RAM, MULTIPLIER = "DP16KD", "MULT18X18D"
SLOT = re.compile(r"g_slot\[(\d+)\]")
# The memories of a slot, side by side in this order, so that what works together is near.
MEMORIES = (r"\.bits\.g_operand", r"\.memory\.", r"\.words\.s1\.", r"\.words\.s2\.", r"\.words\.keep\.")

# Columns of block RAMs: 13 groups of four, nine columns from one group to the next, and two more in the middle of the chip.
GROUPS, MIDDLE = 13, 7


def column(group: int) -> int:
    """The left one of a group."""
    return 4 + 9 * group + (2 if group >= MIDDLE else 0)


HALVES = (range(MIDDLE), range(MIDDLE, GROUPS))
# Of each half the group below whose middle the multiplier is.
CENTRES = (4, 9)
# Row of block RAMs, half, row of multipliers and the number there, of slots 0 and 1, 2 and 3, and so on. Units 0 and 1, which
# have dividers, stand where the rows are far apart.
PIECES = ((22, 0, 10, 0), (46, 0, 34, 0), (22, 1, 10, 0), (46, 1, 34, 0), (70, 0, 58, 0), (70, 1, 58, 0),
          (82, 0, 58, 5), (82, 1, 58, 5))


def ram_bels(piece: int) -> list[str]:
    """The block RAMs of a piece, from the middle of the chip outwards."""
    row, half, _, _ = PIECES[piece]
    found = [f"X{column(group) + 2 * k}/Y{row}/EBR{k}" for group in HALVES[half] for k in range(4)]
    return found[::-1] if half == 0 else found


def multiplier_bel(piece: int) -> str:
    _, half, row, number = PIECES[piece]
    return f"X{column(CENTRES[half]) + number}/Y{row}/MULT18_{number}"


def slot(name: str) -> int:
    found = SLOT.search(name)
    if not found:
        raise FlowError(f"{name} is in no slot of MPU4: it has no place in the floor plan")
    return int(found[1])


def order(name: str) -> tuple[int, int, str]:
    """Of a block RAM in its piece: the slot with the word unit first, as it has most of them."""
    for k, memory in enumerate(MEMORIES):
        if re.search(memory, name):
            return slot(name) % 2, k, name
    raise FlowError(f"{name}: a block RAM that the floor plan does not know")


def place(module: dict[str, Any]) -> int:
    """Gives each block RAM and multiplier of a flat netlist its place; how many."""
    pieces: dict[int, list[str]] = {}
    placed = {}
    for name, cell in module["cells"].items():
        if cell["type"] == RAM:
            pieces.setdefault(slot(name) // 2, []).append(name)
        elif cell["type"] == MULTIPLIER:
            placed[name] = multiplier_bel(slot(name) // 2)
    for piece, names in pieces.items():
        bels = ram_bels(piece)
        if len(names) > len(bels):
            raise FlowError(f"slots {2 * piece} and {2 * piece + 1} have {len(names)} block RAMs, their piece of the floor plan {len(bels)}")
        placed |= dict(zip(sorted(names, key=order), bels))
    for name, bel in placed.items():
        module["cells"][name].setdefault("attributes", {})["BEL"] = bel
    return len(placed)


def rewrite(netlist: Path, top: str) -> None:
    """The same for a netlist of Yosys in a file."""
    design = json.loads(netlist.read_text())
    place(design["modules"][top])
    netlist.write_text(json.dumps(design))
