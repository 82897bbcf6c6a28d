# SPDX-License-Identifier: Apache-2.0
"""Where MPU4's block RAMs and multipliers are put (scripts/flow/floorplan.py), and what it refuses."""
from __future__ import annotations

import re
import sys
import unittest
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from flow import floorplan
from flow.tools import FlowError

# As Yosys calls them, of a slot with a word unit and of one without.
BITS = [f"bits.g_operand[{k}].operand.rows.words.0.0" for k in range(3)]
EVEN = BITS + [f"memory.words.0.{k}" for k in range(3)] + [f"g_unit.words.{side}.rows.words.0.{k}" for side in ("s1", "s2") for k in range(4)] + [
    "g_unit.words.keep.rows.words.0.0"]
ODD = BITS + [f"memory.words.0.{k}" for k in range(2)]


def module(slots: int) -> dict[str, Any]:
    cells: dict[str, Any] = {"logic": {"type": "LUT4"}}
    for slot in range(slots):
        for name in ODD if slot % 2 else EVEN:
            cells[f"mpu.g_slot[{slot}].slot.{name}"] = {"type": "DP16KD", "attributes": {"src": "somewhere"}}
        if slot % 2 == 0:
            cells[f"mpu.g_slot[{slot}].slot.g_unit.words.multiplier.product"] = {"type": "MULT18X18D"}
    return {"cells": cells}


def bels(made: dict[str, Any]) -> dict[str, str]:
    return {name: cell["attributes"]["BEL"] for name, cell in made["cells"].items() if "BEL" in cell.get("attributes", {})}


class Floorplan(unittest.TestCase):
    def test_each_has_a_place_of_its_own(self) -> None:
        for slots in (4, 8, 16):
            made = module(slots)
            with self.subTest(slots):
                self.assertEqual(floorplan.place(made), slots * 10 + slots // 2)
                found = bels(made)
                self.assertEqual(len(set(found.values())), slots * 10 + slots // 2)
                self.assertNotIn("logic", found)
                self.assertEqual({cell["attributes"].get("src") for cell in made["cells"].values() if cell["type"] == "DP16KD"}, {"somewhere"})

    def test_places_that_the_chip_has(self) -> None:
        """Its rows, and in them the columns that nextpnr's placements of this design have shown."""
        made = module(16)
        floorplan.place(made)
        columns = {4 + 9 * group + 2 * k + 2 * (group > 6) for group in range(13) for k in range(4)}
        for name, bel in bels(made).items():
            x, y, kind, number = re.fullmatch(r"X(\d+)/Y(\d+)/(EBR|MULT18_)(\d)", bel).groups()
            with self.subTest(name):
                self.assertIn(int(y), (22, 46, 70, 82) if kind == "EBR" else (10, 34, 58))
                if kind == "EBR":
                    self.assertIn(int(x), columns)

    def test_what_works_together_is_near(self) -> None:
        made = module(16)
        floorplan.place(made)
        pieces: dict[int, list[tuple[int, int]]] = {}
        for name, bel in bels(made).items():
            x, y = map(int, re.match(r"X(\d+)/Y(\d+)/EBR", bel).groups()) if "EBR" in bel else (None, None)
            if x is not None:
                pieces.setdefault(floorplan.slot(name) // 2, []).append((x, y))
        for piece, places in pieces.items():
            with self.subTest(piece):
                self.assertEqual(len({y for _, y in places}), 1)
                self.assertLess(max(x for x, _ in places) - min(x for x, _ in places), 50)

    def test_more_than_there_is_room_for(self) -> None:
        made = module(2)
        for k in range(30):
            made["cells"][f"mpu.g_slot[0].slot.memory.words.1.{k}"] = {"type": "DP16KD"}
        with self.assertRaisesRegex(FlowError, "slots 0 and 1 have 50 block RAMs, their piece of the floor plan 28"):
            floorplan.place(made)

    def test_a_block_ram_that_belongs_nowhere(self) -> None:
        for name, why in (("mpu.log.words.0.0", "in no slot"), ("mpu.g_slot[3].slot.cache.0", "does not know")):
            with self.subTest(name), self.assertRaisesRegex(FlowError, why):
                floorplan.place({"cells": {name: {"type": "DP16KD"}}})


if __name__ == "__main__":
    unittest.main()
