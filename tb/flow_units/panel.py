# SPDX-License-Identifier: Apache-2.0
"""A touch panel as a controller sees it: a Modbus RTU server with a few hundred holding registers. Its delay is the
simulation's, which holds its clock for each answer.

panel.py TTY UNIT"""
from __future__ import annotations

import sys

from pymodbus import FramerType
from pymodbus.datastore import ModbusDeviceContext, ModbusSequentialDataBlock, ModbusServerContext
from pymodbus.server import StartSerialServer

REGISTERS = 512


def main(tty: str, unit: str) -> None:
    # Register n holds 1000 + n at first.
    block = ModbusSequentialDataBlock(1, [1000 + n for n in range(REGISTERS)])
    context = ModbusServerContext(devices={int(unit): ModbusDeviceContext(hr=block)}, single=False)
    StartSerialServer(context, framer=FramerType.RTU, port=tty, baudrate=57600, timeout=0.01)


main(*sys.argv[1:])
