# SPDX-License-Identifier: Apache-2.0
"""Which pipeline stage a critical path belongs to, and readable names for its ends.

The RTL puts the stage in the name of every pipeline register (hdl/README.md): a register is named after
the stage that reads it, so a path that ends in an x_ register is work of ID2, the stage before EX.
"""
from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

# Prefixes of the pipeline registers in the order of the stages that read them, and those stages; w_ is
# what EX has computed.
STAGES = {"f1": "IF1", "f2": "IF2", "f3": "IF3", "d1": "ID1", "d2": "ID2", "d3": "ID3", "x": "EX",
          "w": "after EX"}
ORDER = list(STAGES)

# What the tools append to the name of a net to name the cell that drives it.
CELL_SUFFIX = re.compile(
    r"_(TRELLIS_FF|SB_DFF|LUT4|PFUMX|L6MUX21|CCU2C|SB_LUT4|SB_CARRY|MULT18X18D|DP16KD)[A-Z0-9]*_.*$"
    r"|(_LC|_DFFLC|_RAM)$")


@dataclass(frozen=True)
class CriticalPath:
    """A path from clock edge to clock edge; all times in ns."""
    start: str
    end: str
    delay_ns: float
    logic_ns: float
    routing_ns: float


def short_name(cell: str) -> str:
    """A cell's name without the levels that every name has and without the tools' suffixes."""
    name = re.sub(r"^.*?gen_mpu\d\.(core\.(genblk\d+\.)?gen_mpu\d\.mpu\.(core\.)?|core\.)", "", cell)
    name = CELL_SUFFIX.sub("", name)
    name = re.sub(r"_(i|o)$", "", name)
    memory = re.match(r"(.*?)\.words\.[0-9.]+$", name)
    return f"{memory.group(1)} (block RAM)" if memory else name


def prefix_of(name: str) -> str:
    """The stage prefix of the last part of a hierarchical name, or nothing."""
    match = re.match(rf"({'|'.join(STAGES)})_", name.rsplit(".", 1)[-1])
    return match.group(1) if match else ""


def stage(start: str, end: str) -> str:
    """The stage that limits one of our processors, from the short names of a path's ends."""
    if start.startswith("link.") or end.startswith("link."):
        return "serial link of the board top"
    if "load_port" in start:
        return "load port"
    end_prefix, start_prefix = prefix_of(end), prefix_of(start)
    if end_prefix:
        return STAGES[ORDER[max(0, ORDER.index(end_prefix) - 1)]]
    if "(block RAM)" in start:
        return "IF2" if "fetch" in start else "ID2"
    if start_prefix:
        return "EX" if start_prefix == "w" else STAGES[start_prefix]
    if "fetch" in end:
        return "IF1"
    if "sequencer" in end or "sequencer" in start:
        return "ID1"
    return "EX"


def describe(path: list[dict[str, Any]]) -> CriticalPath:
    """A path of nextpnr's report: its ends and its delay in parts."""
    routing = sum(step["delay"] for step in path if step["type"] == "routing")
    total = sum(step["delay"] for step in path)
    return CriticalPath(short_name(path[0]["from"]["cell"]), short_name(path[-1]["to"]["cell"]),
                        round(total, 2), round(total - routing, 2), round(routing, 2))
