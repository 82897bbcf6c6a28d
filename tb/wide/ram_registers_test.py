# SPDX-License-Identifier: Apache-2.0
"""Which flip-flops behind a block RAM become its output register (scripts/flow/ram_registers.py), and which must not."""
from __future__ import annotations

import copy
import sys
import unittest
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from flow import ram_registers

CLOCK = 2
PLAIN = {"CEMUX": "1 ", "CLKMUX": "CLK", "GSR": "DISABLED", "LSRMUX": "LSR", "REGSET": "RESET"}


def flip_flop(taken: int, given: int, clock: int = CLOCK, **parameters: str) -> dict[str, Any]:
    pins = {"CLK": [clock], "DI": [taken], "LSR": ["0"], "Q": [given]}
    return {"type": "TRELLIS_FF", "parameters": PLAIN | parameters, "connections": pins,
            "port_directions": {pin: "output" if pin == "Q" else "input" for pin in pins}}


def block_ram(width: int, given: dict[str, int]) -> dict[str, Any]:
    pins: dict[str, list[int | str]] = {"CLKA": [CLOCK], "CLKB": [CLOCK], "OCEA": ["0"], "OCEB": ["1"]}
    pins |= {pin: [bit] for pin, bit in given.items()}
    return {"type": "DP16KD", "connections": pins,
            "parameters": {"CLKAMUX": "CLKA", "CLKBMUX": "CLKB", "DATA_WIDTH_B": f"{width:032b}",
                           "REGMODE_A": "NOREG", "REGMODE_B": "NOREG"},
            "port_directions": {pin: "output" if pin.startswith("DO") else "input" for pin in pins}}


def module(width: int = 18, outputs: tuple[str, str] = ("DOB0", "DOB1")) -> dict[str, Any]:
    """A block RAM, two bits of it into flip-flops, and these out of the module."""
    return {"ports": {"q": {"direction": "output", "bits": [20, 21]}},
            "cells": {"ram": block_ram(width, {outputs[0]: 10, outputs[1]: 11, "DOB7": 12}),
                      "q0": flip_flop(10, 20), "q1": flip_flop(11, 21)}}


class Absorb(unittest.TestCase):
    def refused(self, changed: dict[str, Any]) -> None:
        """Nothing at all is changed: half a port cannot be registered."""
        before = copy.deepcopy(changed)
        self.assertEqual(ram_registers.absorb(changed), 0)
        self.assertEqual(changed, before)

    def test_plain_registers_move_into_the_ram(self) -> None:
        moved = module()
        self.assertEqual(ram_registers.absorb(moved), 2)
        self.assertEqual(list(moved["cells"]), ["ram"])
        ram = moved["cells"]["ram"]
        self.assertEqual((ram["connections"]["DOB0"], ram["connections"]["DOB1"]), ([20], [21]))
        self.assertEqual((ram["parameters"]["REGMODE_A"], ram["parameters"]["REGMODE_B"]), ("NOREG", "OUTREG"))

    def test_the_widest_shape_reads_through_both_ports(self) -> None:
        moved = module(36, ("DOA3", "DOB1"))
        self.assertEqual(ram_registers.absorb(moved), 2)
        ram = moved["cells"]["ram"]
        self.assertEqual((ram["parameters"]["REGMODE_A"], ram["parameters"]["REGMODE_B"]), ("OUTREG", "OUTREG"))
        self.assertEqual((ram["connections"]["OCEA"], ram["connections"]["OCEB"]), (["1"], ["1"]))
        half = module(36, ("DOA3", "DOB1"))
        half["cells"]["q0"] = flip_flop(10, 20, CEMUX="CE")
        self.refused(half)

    def test_a_bit_that_something_else_reads_too(self) -> None:
        for reader in ("port", "cell"):
            read = module()
            if reader == "port":
                read["ports"]["early"] = {"direction": "output", "bits": [11]}
            else:
                read["cells"]["q2"] = flip_flop(11, 22)
            with self.subTest(reader):
                self.refused(read)

    def test_registers_with_more_than_a_clock(self) -> None:
        for name, register in {"enable": flip_flop(11, 21, CEMUX="CE"), "falling edge": flip_flop(11, 21, CLKMUX="INV"),
                               "another clock": flip_flop(11, 21, clock=3)}.items():
            other = module()
            other["cells"]["q1"] = register
            with self.subTest(name):
                self.refused(other)
        reset = module()
        reset["cells"]["q1"]["connections"]["LSR"] = [30]
        self.refused(reset)

    def test_a_bit_that_no_register_takes(self) -> None:
        look_up = module()
        look_up["cells"]["q1"] = {"type": "LUT4", "parameters": {}, "connections": {"A": [11], "Z": [21]},
                                  "port_directions": {"A": "input", "Z": "output"}}
        self.refused(look_up)

    def test_a_ram_whose_register_is_not_enabled(self) -> None:
        gated = module()
        gated["cells"]["ram"]["connections"]["OCEB"] = [31]
        self.refused(gated)


if __name__ == "__main__":
    unittest.main()
