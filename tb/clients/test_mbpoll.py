# SPDX-License-Identifier: Apache-2.0
"""mbpoll (Debian) on the pseudo-terminal and on the gateway's port."""
from __future__ import annotations

import re
import unittest

from bench import areas, cell, eventually, run

COIL, DISCRETE, INPUT_WORD, WORD = "0", "1", "3", "4"


class Mbpoll(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.device = cls.enterClassContext(cell("--tcp", "0"))

    def mbpoll(self, table: str, address: int, *values: int, count: int = 1, rtu: bool = True):
        line = ["-m", "rtu", "-b", "19200", "-P", "none", self.device.link] if rtu else \
               ["-m", "tcp", "-p", str(self.device.tcp_port), "127.0.0.1"]
        amount = [] if values else ["-c", str(count)]
        return run(["mbpoll", "-0", "-1", "-q", "-o", "10", "-a", "1", "-t", table, "-r", str(address),
                    *amount, *line, *map(str, values)])

    def read(self, table: str, address: int, count: int = 1, rtu: bool = True) -> list[int]:
        done = self.mbpoll(table, address, count=count, rtu=rtu)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = re.findall(r"^\[(\d+)\]:\s+(-?\d+)", done.stdout, re.M)
        self.assertEqual([int(at) for at, _ in found], list(range(address, address + count)), done.stdout)
        return [int(value) for _, value in found]

    def write(self, table: str, address: int, *values: int, rtu: bool = True) -> None:
        done = self.mbpoll(table, address, *values, rtu=rtu)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_every_area(self) -> None:
        for area in areas():
            with self.subTest(area=area.name):
                for table in (WORD, INPUT_WORD) if area.table == "word" else \
                        (COIL, DISCRETE) if area.coils else (DISCRETE,):
                    self.assertEqual(len(self.read(table, area.first, min(8, area.count))),
                                     min(8, area.count))

    def test_write_and_read(self) -> None:
        for rtu in (True, False):
            with self.subTest(rtu=rtu):
                self.write(WORD, 0, 100, rtu=rtu)
                self.write(WORD, 0, 100, 23, rtu=rtu)
                eventually(self, lambda: self.read(WORD, 0, 3, rtu) == [100, 23, 123])
                self.write(COIL, 0, 1, rtu=rtu)
                eventually(self, lambda: self.read(COIL, 0x3301, rtu=rtu) == [1])
                self.write(COIL, 0, 0, 0, rtu=rtu)
                self.assertEqual(self.read(COIL, 0, rtu=rtu), [0])

    def test_exception(self) -> None:
        done = self.mbpoll(WORD, 0x4000)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("Illegal data address", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
