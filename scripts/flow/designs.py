# SPDX-License-Identifier: Apache-2.0
"""What is synthesised: each processor in its board tops, the controller in its own, and how each board's
FPGA is driven."""
from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path

import gen_wide
from flow import tools

MPUS = (1, 2, 3)
WIDE = gen_wide.parameters(gen_wide.load(tools.ROOT / "hdl" / "isa"))  # MPU4 by its slots


@dataclass(frozen=True)
class Family:
    """An FPGA family: the tools' options, and what their reports call its cells."""
    name: str
    synth: str                    # the Yosys command with its options
    nextpnr: str
    nextpnr_options: tuple[str, ...]
    utilization: dict[str, tuple[str, ...]]   # our name -> nextpnr's names of the cell types
    layout: str                   # nextpnr's option for its result, from which the bitstream is packed
    pack: tuple[str, ...]         # the packer; {layout} and {bitstream} stand for files
    suffix: str                   # of a bitstream
    ram_registers: bool = False   # flow/ram_registers.py after Yosys


@dataclass(frozen=True)
class Board:
    """A board top: its FPGA, the constraint file, the configuration of hdl/isa/configs.toml."""
    name: str                     # also the name of the top module
    title: str
    family: Family
    device: tuple[str, ...]       # nextpnr options that name device, package and grade
    constraints: tuple[str, Path] | None   # nextpnr's option and the file (behind a "=": joined); None: any pins
    goal_mhz: int                 # --freq: a little above what is reached
    config: str                   # of the processors; "" for other cores


# abc9 knows the delays of cells and of block RAMs. The static placer gave MPU3, whose block RAMs lie
# all over the chip, a quarter more clock than the default on ECP5, and less on iCE40.
ECP5 = Family("ecp5", "synth_ecp5 -abc9", tools.NEXTPNR_ECP5, ("--placer", "static"),
              {"logic_cells": ("TRELLIS_COMB",), "flip_flops": ("TRELLIS_FF",),
               "block_rams": ("DP16KD",), "dsps": ("MULT18X18D",)},
              "--textcfg", (tools.ECPPACK, "--compress", "{layout}", "{bitstream}"), "bit")
ICE40 = Family("ice40", "synth_ice40 -abc9 -device hx", tools.NEXTPNR_ICE40, (),
               {"logic_cells": ("ICESTORM_LC",), "flip_flops": (), "block_rams": ("ICESTORM_RAM",), "dsps": ()},
               "--asc", (tools.ICEPACK, "{layout}", "{bitstream}"), "bin")
# The flash's pins are the configuration's until mspi_as_gpio gives them to the design.
GW2A = Family("gowin", "synth_gowin -family gw2a", tools.NEXTPNR_GOWIN, (),
              {"logic_cells": ("LUT4",), "flip_flops": ("DFF",), "block_rams": ("BSRAM",), "dsps": ()},
              "--write", (tools.GOWIN_PACK, "--device", "GW2A-18C", "--mspi_as_gpio", "-o", "{bitstream}",
                          "{layout}"), "fs")

ULX3S_85F = ("--85k", "--package", "CABGA381", "--speed", "6")
HX8K_CT256 = ("--hx8k", "--package", "ct256")
TANG_NANO_20K = ("--device", "GW2AR-LV18QN88C8/I7", "--vopt", "family=GW2A-18C")


def constraint(name: str) -> Path:
    return tools.ROOT / "constraints" / name


# The processors' board tops
BOARDS = {
    "ulx3s": Board("ulx3s", "ULX3S, ECP5-85F grade 6", ECP5,
                   ULX3S_85F, ("--lpf", constraint("ulx3s.lpf")), 120, "ecp5"),
    "hx8k": Board("hx8k", "iCE40-HX8K breakout", ICE40, HX8K_CT256,
                  ("--pcf", constraint("hx8k.pcf")), 80, "hx8k"),
}

# MPU4's. Every word that it reads from a block RAM goes into a register. Router 2 is the faster one, but takes detours for
# want of wires, whatever they cost: 8 slots placed for 100 MHz came out with 80, and 16 placed for 87 with 58. Router 1 loses less
# than a tenth.
WIDE_BOARD = Board("ulx3s_wide", "ULX3S, ECP5-85F grade 6", dataclasses.replace(ECP5, ram_registers=True),
                   ULX3S_85F, ("--lpf", constraint("ulx3s_wide.lpf")), 110, "ecp5")

# The controller's board tops. The clock is the board's: nothing is won by a faster one.
PLC_BOARDS = {
    "ulx3s": Board("plc_ulx3s", "ULX3S, ECP5-85F grade 6", ECP5, ULX3S_85F,
                   ("--lpf", constraint("plc_ulx3s.lpf")), 25, "ecp5"),
    "hx8k": Board("plc_hx8k", "iCE40-HX8K breakout", ICE40, HX8K_CT256,
                  ("--pcf", constraint("plc_hx8k.pcf")), 12, "hx8k"),
    "tangnano20k": Board("plc_tangnano20k", "Tang Nano 20K, GW2AR-18", GW2A, TANG_NANO_20K,
                         ("--vopt=cst=", constraint("plc_tangnano20k.cst")), 27, "gw2a"),
}


@dataclass(frozen=True)
class Design:
    """One thing to synthesise, place and route."""
    name: str                     # of its folder
    top: str
    sources: tuple[Path, ...]
    include: tuple[Path, ...]
    parameters: tuple[tuple[str, int], ...]
    board: Board
    ours: bool = True             # False: third-party Verilog, whose warnings are not ours
    kind: str = "pnr"             # folder under build
    data: tuple[Path, ...] = ()   # files that the Verilog reads
    floorplan: bool = False       # flow/floorplan.py after Yosys

    @property
    def folder(self) -> Path:
        return tools.BUILD / self.kind / self.name

    def layout(self, seed: int) -> Path:
        """What nextpnr made of a seed, for the packer."""
        return self.folder / f"seed{seed}.layout"


def rung_design(mpu: int, board: Board) -> Design:
    """A processor of this project in its board top."""
    hdl = tools.ROOT / "hdl"
    sources = sorted(hdl.glob("*.v")) + sorted((hdl / "core").glob("*.v")) + sorted(
        (hdl / "peripherals").glob("*.v")) + [
        hdl / "boards" / f"{name}.v"
        for name in ("power_on_reset", "serial_link", "ladder_ports", "board_core", board.name)]
    return Design(f"{board.name}-mpu{mpu}", board.name, tuple(sources), (tools.GENERATED, hdl / "core"),
                  (("MPU", mpu),), board)


def wide_sources() -> list[Path]:
    """MPU4, and what it shares with the others."""
    hdl = tools.ROOT / "hdl"
    return sorted((hdl / "wide").glob("*.v")) + [hdl / "core" / f"{name}.v" for name in ("alu", "bank_ram", "muldiv")]


def wide_design(slots: int) -> Design:
    """MPU4 with so many slots in its board top."""
    boards = tools.ROOT / "hdl" / "boards"
    sources = wide_sources() + [boards / f"{name}.v" for name in ("power_on_reset", "serial_link", WIDE_BOARD.name)]
    return Design(f"{WIDE_BOARD.name}-{slots}", WIDE_BOARD.name, tuple(sources), (tools.GENERATED,),
                  tuple(WIDE[slots].items()), WIDE_BOARD, floorplan=slots == 16)


def plc_design(board: Board) -> Design:
    """The controller in a board top of its own."""
    hdl = tools.ROOT / "hdl"
    folders = [hdl, hdl / "core", hdl / "peripherals", hdl / "controller", hdl / "flow"]
    sources = [source for folder in folders for source in sorted(folder.glob("*.v"))]
    sources += sorted((hdl / "controller" / "micro").glob("*.v")) + [
        hdl / "boards" / f"{name}.v" for name in ("power_on_reset", "ladder_ports", board.name)]
    return Design(board.name, board.name, tuple(sources),
                  (tools.GENERATED, hdl / "core", hdl / "flow"), (), board, kind="bit")


def flow_tasks_design() -> Design:
    """The hardware of flow tasks alone, which has more ports than the FPGA has pins."""
    hdl = tools.ROOT / "hdl"
    board = Board("flow_block", "ECP5-85F grade 6, out of context", ECP5, (*ULX3S_85F, "--out-of-context"), None,
                  100, "ecp5")
    others = ("core/bank_ram", "controller/host_uart", "peripherals/uart_rx", "peripherals/uart_tx")
    sources = [*sorted((hdl / "flow").glob("*.v")), *(hdl / f"{name}.v" for name in others)]
    return Design(board.name, board.name, tuple(sources), (tools.GENERATED, hdl / "flow"), (), board)
