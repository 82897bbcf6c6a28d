# SPDX-License-Identifier: Apache-2.0
"""What is synthesised: each processor in each board top, and how each board's FPGA is driven."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from flow import tools

MPUS = (1, 2, 3)


@dataclass(frozen=True)
class Family:
    """An FPGA family: the tools' options, and what their reports call its cells."""
    name: str
    synth: str                    # the Yosys command with its options
    nextpnr: str
    nextpnr_options: tuple[str, ...]
    utilization: dict[str, str]   # our name -> nextpnr's name of the cell type


@dataclass(frozen=True)
class Board:
    """A board: its FPGA, the constraint file, the configuration of hdl/isa/configs.toml."""
    name: str                     # also the name of the top module
    title: str
    family: Family
    device: tuple[str, ...]       # nextpnr options that name device, package and grade
    constraints: tuple[str, Path] | None   # nextpnr's option and the file; None: any pins
    goal_mhz: int                 # --freq: a little above what is reached
    config: str                   # of the processors; "" for other cores


# abc9 knows the delays of cells and of block RAMs. The static placer gave MPU3, whose block RAMs lie
# all over the chip, a quarter more clock than the default on ECP5, and less on iCE40.
ECP5 = Family("ecp5", "synth_ecp5 -abc9", tools.NEXTPNR_ECP5, ("--placer", "static"),
              {"logic_cells": "TRELLIS_COMB", "block_rams": "DP16KD", "dsps": "MULT18X18D"})
ICE40 = Family("ice40", "synth_ice40 -abc9 -device hx", tools.NEXTPNR_ICE40, (),
               {"logic_cells": "ICESTORM_LC", "block_rams": "ICESTORM_RAM", "dsps": ""})

BOARDS = {
    "ulx3s": Board("ulx3s", "ULX3S, ECP5-85F grade 6", ECP5,
                   ("--85k", "--package", "CABGA381", "--speed", "6"),
                   ("--lpf", tools.ROOT / "constraints" / "ulx3s.lpf"), 120, "ecp5"),
    "hx8k": Board("hx8k", "iCE40-HX8K breakout", ICE40, ("--hx8k", "--package", "ct256"),
                  ("--pcf", tools.ROOT / "constraints" / "hx8k.pcf"), 80, "hx8k"),
}


@dataclass(frozen=True)
class Design:
    """One thing to synthesise, place and route."""
    name: str                     # of its folder under build/pnr
    top: str
    sources: tuple[Path, ...]
    include: tuple[Path, ...]
    parameters: tuple[tuple[str, int], ...]
    board: Board
    ours: bool = True             # False: third-party Verilog, whose warnings are not ours

    @property
    def folder(self) -> Path:
        return tools.BUILD / "pnr" / self.name


def rung_design(mpu: int, board: Board) -> Design:
    """A processor of this project in its board top."""
    hdl = tools.ROOT / "hdl"
    sources = sorted(hdl.glob("*.v")) + sorted((hdl / "core").glob("*.v")) + sorted(
        (hdl / "peripherals").glob("*.v")) + [
        hdl / "boards" / f"{name}.v"
        for name in ("power_on_reset", "serial_link", "ladder_ports", "board_core", board.name)]
    return Design(f"{board.name}-mpu{mpu}", board.name, tuple(sources), (tools.GENERATED, hdl / "core"),
                  (("MPU", mpu),), board)
