# SPDX-License-Identifier: Apache-2.0
"""`rung device` as the tests of the clients start it, and what they know of its address map.

Each test starts its own device on a pseudo-terminal (and, where it says so, a port on loopback) and stops it:
nothing is left running, whatever happens."""
from __future__ import annotations

import os
import re
import signal
import subprocess
import tempfile
import threading
import time
import tomllib
import unittest
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(__file__).resolve().parent / "programs"
RUNG = os.environ["RUNG"]
CLOCKS_PER_MS = 250
CLOCK = ["--clock", str(1000 * CLOCKS_PER_MS)]
START_SECONDS = 60
END_SECONDS = 10


@dataclass(frozen=True)
class Area:
    """Addresses of the devices of one kind (hdl/isa/modbus.toml)."""

    name: str
    table: str
    first: int
    count: int
    coils: bool

    @property
    def end(self) -> int:
        return self.first + self.count


def areas(config: str = "ecp5") -> list[Area]:
    table = tomllib.loads((ROOT / "hdl/isa/modbus.toml").read_text())
    counts = tomllib.loads((ROOT / "hdl/isa/configs.toml").read_text())["config"][config]["modbus"]
    return [Area(row["name"], row["table"], row["first"], counts[row["name"]], row.get("coils", True))
            for row in table["area"] if counts[row["name"]]]


def holding(name: str) -> int:
    """Address of one of the controller's own registers."""
    table = tomllib.loads((ROOT / "hdl/isa/controller.toml").read_text())
    return next(row["number"] for row in table["holding"] if row["name"] == name)


class Device:
    """A running `rung device`; as a context it ends with it."""

    def __init__(self, *arguments: str, fast: bool = True) -> None:
        self.directory = tempfile.TemporaryDirectory(prefix="rung-device-")
        self.link = str(Path(self.directory.name) / "plc")
        command = [RUNG, "device", *arguments, "--link", self.link, "--watch"]
        self.process = subprocess.Popen(command + (["--fast"] if fast else []), text=True, bufsize=1,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE)
        self.lines: list[str] = []
        self.errors: list[str] = []
        self._arrived = threading.Condition()
        self._readers = [threading.Thread(target=self._read, args=(stream, lines), daemon=True)
                         for stream, lines in ((self.process.stdout, self.lines),
                                               (self.process.stderr, self.errors))]
        for reader in self._readers:
            reader.start()

    def __enter__(self) -> Device:
        try:
            self.wait_for(r"ready")
        except BaseException:
            self.end()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self.end()

    def _read(self, stream, lines: list[str]) -> None:
        for line in stream:
            with self._arrived:
                lines.append(line.rstrip("\n"))
                self._arrived.notify_all()

    def wait_for(self, pattern: str, since: int = 0, seconds: float = START_SECONDS) -> re.Match:
        """The first line of its output, from number `since` on, in which the pattern is found."""
        deadline = time.monotonic() + seconds
        with self._arrived:
            while True:
                for line in self.lines[since:]:
                    if match := re.search(pattern, line):
                        return match
                left = deadline - time.monotonic()
                if left <= 0 or self.process.poll() is not None and not self._readers[0].is_alive():
                    raise AssertionError(f"no '{pattern}' from rung device: {self.lines[since:]} "
                                         f"{self.errors}")
                self._arrived.wait(min(left, 0.2))

    def tell(self, command: str) -> int:
        """A line for its console; gives the number of the next line of its output."""
        since = len(self.lines)
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()
        return since

    @property
    def tcp_port(self) -> int:
        return int(self.wait_for(r"127\.0\.0\.1:(\d+)").group(1))

    def end(self) -> int:
        """Stops it as a user does; its exit code."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
        try:
            code = self.process.wait(END_SECONDS)
        except subprocess.TimeoutExpired:
            self.process.kill()
            code = self.process.wait()
        for reader in self._readers:
            reader.join(END_SECONDS)
        for stream in (self.process.stdin, self.process.stdout, self.process.stderr):
            stream.close()
        self.directory.cleanup()
        return code


def cell(*more: str, fast: bool = True) -> Device:
    """A device that runs programs/cell.il."""
    return Device(str(PROGRAMS / "cell.il"), "--io", str(PROGRAMS / "cell.toml"), *more, fast=fast)


def run(command: list[str], seconds: float = 30) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, capture_output=True, text=True, timeout=seconds, check=False)


def eventually(test: unittest.TestCase, what, seconds: float = 60) -> None:
    """Repeats `what` until it is true."""
    deadline = time.monotonic() + seconds
    while not what():
        test.assertLess(time.monotonic(), deadline, "it did not happen in time")
        time.sleep(0.02)
