# SPDX-License-Identifier: Apache-2.0
"""The soft cores: where their Verilog comes from and how each is built.

The cores come from PyPI (scripts/requirements.txt) and are never copied into this tree.
"""
from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path

import pythondata_cpu_picorv32
import pythondata_cpu_vexriscv

from flow import tools
from flow.designs import BOARDS, Design

FOLDER = tools.ROOT / "tb" / "yardstick"
PICORV32 = Path(pythondata_cpu_picorv32.data_location)
VEXRISCV = Path(pythondata_cpu_vexriscv.data_location)


@dataclass(frozen=True)
class Core:
    """A soft core in its top of tb/yardstick."""
    name: str
    title: str
    memory: str                # what an access to the RAM takes
    verilog: Path
    top: str
    defines: tuple[str, ...]   # for core_main.c: the caches to empty
    cached: bool

    @property
    def sources(self) -> list[Path]:
        return [self.verilog, FOLDER / f"{self.top}.v", FOLDER / "yard_ram.v",
                FOLDER / "yard_wishbone.v", tools.ROOT / "hdl" / "boards" / "power_on_reset.v"]

    def design(self) -> Design:
        """The core with its RAM, for the FPGA and grade of the ULX3S, on any pins."""
        board = dataclasses.replace(BOARDS["ulx3s"], constraints=None, config="")
        return Design(f"yard-{self.name}", self.top, tuple(self.sources), (), (),
                      board, ours=False)


WISHBONE = "block RAM on Wishbone: one wait clock, then a word a clock in a cache line's burst"

CORES = [
    Core("picorv32", "picorv32, RV32IM (one-clock multiplier, divider, barrel shifter)",
         "block RAM on the look-ahead port: no wait", PICORV32 / "picorv32.v", "yard_picorv32", (),
         False),
    Core("vexriscv", "VexRiscv, plain variant, RV32IM, 4 KB I$ and 4 KB D$", WISHBONE,
         VEXRISCV / "VexRiscv.v", "yard_vexriscv", ("INSTRUCTION_CACHE", "DATA_CACHE"), True),
    Core("vexriscv-lite", "VexRiscv Lite, RV32IM, 2 KB I$, no D$", WISHBONE,
         VEXRISCV / "VexRiscv_Lite.v", "yard_vexriscv", ("INSTRUCTION_CACHE",), True),
]
