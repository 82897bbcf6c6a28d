# SPDX-License-Identifier: Apache-2.0
"""Our own commands (load, info, monitor, force, control; on libmodbus) against `rung device`, with pymodbus
beside them: downloads, what a bad one leaves, power loss."""
from __future__ import annotations

import csv
import tempfile
import unittest
import zlib
from pathlib import Path

from pymodbus import FramerType
from pymodbus.client import ModbusSerialClient
from pymodbus.exceptions import ModbusIOException

from bench import CLOCK, PROGRAMS, RUNG, Device, cell, eventually, holding, run

CELL, CELL_MAP = str(PROGRAMS / "cell.il"), str(PROGRAMS / "cell.toml")
SMALL, HX8K_MAP = str(PROGRAMS / "small.il"), str(PROGRAMS / "small.toml")
PRESS, PRESS_MAP = str(PROGRAMS / "press.il"), str(PROGRAMS / "press.toml")
WINDOW_WORDS = 64
BEGIN, COMMIT = 1, 2  # load_command
SAVE = 6  # command
DONE, WRONG_CRC = 2, 3


class Case(unittest.TestCase):
    open_client: Client | None = None

    def setUp(self) -> None:
        self.scratch = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="rung-clients-")))

    def rung(self, device: Device, command: str, *arguments: str, code: int = 0) -> str:
        patience = [] if "--timeout" in arguments else ["--timeout", "10000"]
        done = run([RUNG, command, *arguments, "--port", device.link, *patience], seconds=120)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def client(self, device: Device, unit: int = 1, seconds: float = 10) -> Client:
        """The test's one client of this kind; an earlier one is closed."""
        if self.open_client:
            self.open_client.close()
        self.open_client = Client(self, device.link, unit, seconds)
        self.addCleanup(self.open_client.close)
        return self.open_client

    def load_file(self, program: str, io_map: str) -> list[int]:
        file = self.scratch / "load"
        done = run([RUNG, "compile", program, "--io", io_map, *CLOCK, "--load-file", str(file)])
        self.assertEqual(done.returncode, 0, done.stderr)
        data = file.read_bytes()
        return [int.from_bytes(data[i:i + 2], "big") for i in range(0, len(data), 2)]


class Client:
    """pymodbus, with the registers by name; every request must be answered and right."""

    def __init__(self, test: Case, port: str, unit: int, seconds: float) -> None:
        self.test, self.unit = test, unit
        self.serial = ModbusSerialClient(port, framer=FramerType.RTU, baudrate=19200, timeout=seconds,
                                         retries=0)
        test.assertTrue(self.serial.connect())
        self.close = self.serial.close

    def read(self, register: str | int, count: int = 1) -> list[int]:
        address = register if isinstance(register, int) else holding(register)
        reply = self.serial.read_holding_registers(address, count=count, device_id=self.unit)
        self.test.assertFalse(reply.isError(), reply)
        return reply.registers

    def read32(self, register: str) -> int:
        low, high = self.read(register, 2)
        return low | high << 16

    def write(self, register: str | int, *words: int) -> None:
        address = register if isinstance(register, int) else holding(register)
        reply = self.serial.write_registers(address, list(words), device_id=self.unit)
        self.test.assertFalse(reply.isError(), reply)

    def scans(self) -> bool:
        """Whether the cell's program is running: it counts its scans in D10."""
        first = self.read(10)
        return self.read(10) != first

    def send_load(self, words: list[int], crc: int) -> int:
        """Downloads by hand; gives the state in which it ends."""
        low_high = lambda value: (value & 0xFFFF, value >> 16)
        self.write("load_length", *low_high(len(words)))
        self.write("load_crc", *low_high(crc))
        self.write("load_command", BEGIN)
        eventually(self.test, lambda: self.read("load_state") == [1])
        for offset in range(0, len(words), WINDOW_WORDS):
            self.write("window_offset", *low_high(offset), *words[offset:offset + WINDOW_WORDS])
        self.write("load_command", COMMIT)
        eventually(self.test, lambda: self.read("load_state") != [1])
        return self.read("load_state")[0]


def crc_of(words: list[int]) -> int:
    return zlib.crc32(b"".join(word.to_bytes(2, "big") for word in words))


class Story(Case):
    """What starts a controller takes seconds of simulation; these go from one state to the next."""

    def test_from_nothing_to_a_second_program(self) -> None:
        flash = self.scratch / "flash.bin"
        with Device("--flash", str(flash)) as device:
            with self.subTest("no program, then a first one"):
                self.assertIn("no program", self.rung(device, "info"))
                self.rung(device, "load", CELL, "--io", CELL_MAP, *CLOCK)
                client = self.client(device)
                eventually(self, client.scans)
            with self.subTest("program and latched devices survive power loss"):
                self.lose_power(device, client)
            with self.subTest("a second program, unit, baud rate and parity while the first one runs"):
                self.assertTrue(self.client(device).scans())
                self.assertIn("running", self.rung(device, "load", PRESS, "--io", PRESS_MAP, "--unit", "1",
                                                   *CLOCK))
                self.check_press(device)
                self.assertIn("board simulated", self.rung(device, "info", "--unit", "5", "--baud", "9600",
                                                           "--parity", "none"))
            self.assertEqual(device.end(), 0)
        with Device("--flash", str(flash)) as device, self.subTest("the flash was kept"):
            self.check_press(device)

    def check_press(self, device: Device) -> None:
        press = self.client(device, unit=5)
        self.assertEqual(press.read(31), [4711])
        first = press.read(30)
        eventually(self, lambda: press.read(30) != first)

    def lose_power(self, device: Device, client: Client) -> None:
        client.write(600, 4711)  # D600 is one of those that an FX keeps
        client.write(0, 4711)
        saves = client.read("saves")
        client.write("command", SAVE)
        eventually(self, lambda: client.read("saves") != saves)
        device.tell("power off")
        since = device.tell("show")
        device.wait_for("power off", since)
        with self.assertRaises(ModbusIOException, msg="it has no power"):
            self.client(device, seconds=1).serial.read_holding_registers(10)
        since = device.tell("power on")
        device.wait_for("RUN=1", since)
        client = self.client(device)
        eventually(self, client.scans)
        self.assertEqual(client.read(600), [4711])
        self.assertEqual(client.read(0), [0])

    def test_wrong_board_is_refused(self) -> None:
        with Device(SMALL, "--io", HX8K_MAP) as device:
            text = self.rung(device, "load", PRESS, "--io", PRESS_MAP, "--unit", "1", *CLOCK, code=1)
            self.assertIn("error", text)
            eventually(self, self.client(device).scans)


class Commands(Case):
    @classmethod
    def setUpClass(cls) -> None:
        cls.device = cls.enterClassContext(cell())

    def test_read_back_is_what_was_loaded(self) -> None:
        words = self.load_file(CELL, CELL_MAP)
        client = self.client(self.device)
        self.assertEqual(client.read32("program_length"), len(words))
        self.assertEqual(client.read32("program_crc"), crc_of(words))
        back: list[int] = []
        for offset in range(0, len(words), WINDOW_WORDS):
            client.write("window_offset", offset & 0xFFFF, offset >> 16)
            back += client.read("window", min(WINDOW_WORDS, len(words) - offset))
        self.assertEqual(back, words)

    def test_corrupt_download_leaves_the_old_program_running(self) -> None:
        client = self.client(self.device)
        generation = client.read32("program_generation")
        words = self.load_file(CELL, CELL_MAP)
        crc = crc_of(words)
        bad = list(words)
        bad[len(bad) // 2] ^= 0x0400
        self.assertEqual(client.send_load(bad, crc), WRONG_CRC)
        self.assertTrue(client.scans())
        self.assertEqual(client.read32("program_generation"), generation)
        # The same by hand, but right.
        self.assertEqual(client.send_load(words, crc), DONE)
        self.assertGreater(client.read32("program_generation"), generation)
        eventually(self, client.scans)

    def test_info(self) -> None:
        text = self.rung(self.device, "info")
        for part in ("board simulated", "MPU3", "running", "generation"):
            self.assertIn(part, text)

    def test_force_and_release(self) -> None:
        since = len(self.device.lines)
        self.rung(self.device, "force", "Y2=1")
        self.device.wait_for("out2=1", since)
        self.device.wait_for("FORCED=1", since)
        self.rung(self.device, "force", "X0=1")
        self.device.wait_for("out0=1", since)
        listed = self.rung(self.device, "force", "--list")
        self.assertIn("X0", listed)
        self.assertIn("Y2", listed)
        since = len(self.device.lines)
        self.rung(self.device, "force", "--release-all")
        self.device.wait_for("FORCED=0", since)
        self.device.wait_for("out2=0", since)
        self.rung(self.device, "force", "X1=1")
        self.device.wait_for("out0=0", since)
        self.rung(self.device, "force", "X1=release")

    def test_monitor_records_csv(self) -> None:
        file = self.scratch / "record.csv"
        self.rung(self.device, "monitor", "D10", "Y0", "--count", "5", "--interval", "20", "--csv", str(file))
        rows = list(csv.reader(file.read_text().splitlines()))
        self.assertEqual(rows[0], ["time", "D10", "Y0"])
        self.assertEqual(len(rows), 6)
        self.assertGreater(len({row[1] for row in rows[1:]}), 1)

    def test_stop_is_safe_and_run_goes_on(self) -> None:
        since = len(self.device.lines)
        self.assertIn("stopped", self.rung(self.device, "control", "stop"))
        self.device.wait_for("out1=1", since)  # Y1's safe state, by the map
        self.device.wait_for("RUN=0", since)
        since = len(self.device.lines)
        self.assertIn("running", self.rung(self.device, "control", "run", "--timeout", "100000"))
        self.device.wait_for("RUN=1", since)
        self.device.wait_for("out1=0", since)

    def test_nobody_there(self) -> None:
        self.assertIn("error", self.rung(self.device, "info", "--unit", "77", "--timeout", "200", code=1))


if __name__ == "__main__":
    unittest.main()
