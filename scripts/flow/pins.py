# SPDX-License-Identifier: Apache-2.0
"""The controller's board tops against their constraints and against hdl/isa/boards.toml.

Every bit of every port has one pin, no pin is used twice, and behind the pin of an input or output stands the
name that boards.toml gives it, which is what an I/O map names; configuration, processor and clock agree.
"""
from __future__ import annotations

import re
import sys
import tomllib
from pathlib import Path

from flow import tools
from flow.designs import PLC_BOARDS, Board

sys.path.insert(0, str(tools.ROOT / "scripts"))
from gen_controller import expand  # noqa: E402

PORT = re.compile(r"^\s*(?:input|output)\s+wire\s+(?:\[\s*(\d+):0\]\s*)?(\w+)", re.MULTILINE)
# port, pin, name behind it; of each format
PIN = {".lpf": re.compile(r'^LOCATE COMP "([^"]+)" SITE "(\w+)";(?:\s*#\s*(\w+)$)?', re.MULTILINE),
       ".pcf": re.compile(r"^set_io (?:-pullup yes )?(\S+) (\w+)(?:\s*#\s*(\w+)$)?", re.MULTILINE),
       ".cst": re.compile(r'^IO_LOC "([^"]+)" (\w+);(?:\s*//\s*(\w+)$)?', re.MULTILINE)}
# a port that also needs a line with its electrical options
OPTIONS = {".lpf": re.compile(r'^IOBUF PORT "([^"]+)" .*;$', re.MULTILINE),
           ".cst": re.compile(r'^IO_PORT "([^"]+)" .*;$', re.MULTILINE)}
CLOCK_MHZ = {".lpf": re.compile(r'^FREQUENCY PORT "clk_\w+" ([\d.]+) MHZ;$', re.MULTILINE),
             ".pcf": re.compile(r"^set_frequency clk_\w+ ([\d.]+)$", re.MULTILINE)}


def repeated(values: list[str]) -> list[str]:
    return sorted({value for value in values if values.count(value) > 1})


def ports(verilog: str) -> dict[str, int]:
    """Width of each port."""
    header = re.sub(r"//.*", "", verilog[verilog.index("\nmodule "):verilog.index(");")])
    return {name: int(high or 0) + 1 for high, name in PORT.findall(header)}


def check_pins(top: str, constraints: str, suffix: str) -> list[str]:
    """What is wrong between a top and its constraints."""
    bits = [name if width == 1 else f"{name}[{bit}]"
            for name, width in ports(top).items() for bit in range(width)]
    placed = PIN[suffix].findall(constraints)
    names, pins = [name for name, _, _ in placed], [pin for _, pin, _ in placed]
    found = [f"{bit}: no pin" for bit in bits if bit not in names]
    found += [f"{name}: no such port bit" for name in names if name not in bits]
    found += [f"{name}: placed twice" for name in repeated(names)]
    found += [f"pin {pin}: used twice" for pin in repeated(pins)]
    if suffix in OPTIONS:
        options = OPTIONS[suffix].findall(constraints)
        found += [f"{bit}: no electrical options" for bit in bits if bit not in options]
        found += [f"{name}: options twice" for name in repeated(options)]
        found += [f"{name}: options of no port bit" for name in options if name not in bits]
    return found


def check_names(board: dict, constraints: str, suffix: str) -> list[str]:
    """What is wrong between constraints and a board of boards.toml."""
    behind = {port: name for port, _, name in PIN[suffix].findall(constraints) if name}
    want = {f"in_i[{i}]": name for i, name in enumerate(expand(board["inputs"]))}
    want |= {f"out_o[{i}]": name for i, name in enumerate(expand(board["outputs"]))}
    want |= {"pwm_o": board["pwm"][0], "tx_o": board["uart"][0]}
    return [f"{port}: {behind.get(port, 'nothing')} stands behind its pin, boards.toml has {want.get(port)}"
            for port in sorted(want.keys() | behind.keys()) if behind.get(port) != want.get(port)]


def check_top(name: str, board: dict, clock_hz: int, top: str, constraints: str, suffix: str) -> list[str]:
    """What is wrong between a top and a board of boards.toml."""
    config = board["config"].upper()
    wanted = [f".MPU({board['mpu']})", f"`RUNG_{config}_MAP", f"`RUNG_BOARD_{name.upper()}",
              f"`RUNG_{config}_MPU{board['mpu']}", f".CLOCK_HZ(`RUNG_{config}_CLOCK_HZ)"]
    found = [f"the top has no {text}" for text in wanted if text not in top]
    if not re.search(rf"\bclk_{clock_hz // 1_000_000}mhz_i\b", top):
        found.append(f"no clock of {clock_hz} Hz, which configs.toml has for {board['config']}")
    if suffix in CLOCK_MHZ and [float(mhz) * 1e6 for mhz in CLOCK_MHZ[suffix].findall(constraints)] != [clock_hz]:
        found.append(f"the constraints' clock is not {clock_hz} Hz")
    widths = ports(top)
    for port, key in (("in_i", "inputs"), ("out_o", "outputs")):
        if widths.get(port) != len(expand(board[key])):
            found.append(f"{port}: {widths.get(port)} bits, boards.toml has {len(expand(board[key]))} {key}")
    return found


def check_board(name: str, plc: Board, boards: dict, configs: dict) -> list[str]:
    """All findings of one board, with the file that has to change."""
    top_file = tools.ROOT / "hdl" / "boards" / f"{plc.name}.v"
    assert plc.constraints
    pin_file: Path = plc.constraints[1]
    top, constraints, board = top_file.read_text(), pin_file.read_text(), boards[name]
    clock_hz = configs[board["config"]]["clock_hz"]
    here = check_top(name, board, clock_hz, top, constraints, pin_file.suffix)
    there = check_pins(top, constraints, pin_file.suffix) + check_names(board, constraints, pin_file.suffix)
    return ([f"{top_file.relative_to(tools.ROOT)}: {text}" for text in here]
            + [f"{pin_file.relative_to(tools.ROOT)}: {text}" for text in there])


def check() -> list[str]:
    isa = tools.ROOT / "hdl" / "isa"
    boards = tomllib.loads((isa / "boards.toml").read_text())["board"]
    configs = tomllib.loads((isa / "configs.toml").read_text())["config"]
    found = [text for name, plc in PLC_BOARDS.items() for text in check_board(name, plc, boards, configs)]
    return found + [f"hdl/isa/boards.toml: {name}: no top" for name in boards
                    if name not in PLC_BOARDS and name != "simulated"]
