# SPDX-License-Identifier: Apache-2.0
"""The PC beside a controller: one command after the other through its registers, each waited for. Says on its output
what it has seen, a line for each command that went wrong, at the end how many were done.

pc.py TTY UNIT BOARD FIRST COUNT    reads COUNT variables of a board from FIRST on, for ever"""
from __future__ import annotations

import sys
import tomllib
from pathlib import Path

from pymodbus import FramerType
from pymodbus.client import ModbusSerialClient

ROOT = Path(__file__).resolve().parents[2]
FLOW = tomllib.loads((ROOT / "hdl/isa/flow.toml").read_text())
HOLDING = 0xE100  # register n of the flow tasks is holding register HOLDING + n


def register(name: str) -> int:
    return HOLDING + next(row["number"] for row in FLOW["register"] if row["name"] == name)


def command(client: ModbusSerialClient, unit: int, board: int, first: int, count: int) -> list[int] | str:
    """The words that a read command gives, or what went wrong."""
    start = client.write_registers(register("flow_pc_resource"), [unit * 256 + board, first, count, 1])
    if start.isError():
        return f"not taken: {start}"
    while True:
        state = client.read_holding_registers(register("flow_pc_control"), count=2)
        if state.isError():
            return f"no state: {state}"
        if state.registers[0] == 0:
            break
    if state.registers[1]:
        return f"status {state.registers[1]}"
    words = client.read_holding_registers(register("flow_pc_data"), count=count)
    return f"no data: {words}" if words.isError() else words.registers


def main(tty: str, *what: str) -> None:
    client = ModbusSerialClient(tty, framer=FramerType.RTU, baudrate=57600, timeout=300, retries=0)
    client.connect()
    while True:
        got = command(client, *map(int, what))
        print(got if isinstance(got, str) else f"done {got}", flush=True)


main(*sys.argv[1:])
