# SPDX-License-Identifier: Apache-2.0
"""`rung view --text` in a real terminal, tmux: what its keys do, and what a user then sees."""
from __future__ import annotations

import itertools
import os
import subprocess
import time
import unittest
from pathlib import Path

RUNG = os.environ["RUNG"]
PROGRAM = Path(__file__).resolve().parent / "programs" / "motor.il"
SECONDS = 20
NUMBERS = itertools.count()  # a server that is ending still has its socket: each has one of its own


class Terminal:
    """A tmux server of its own, with one window that runs `rung view --text`."""

    def __init__(self, *arguments: str) -> None:
        self.socket = f"rung-{os.getpid()}-{next(NUMBERS)}"
        self.tmux("new-session", "-d", "-x", "100", "-y", "30", " ".join([RUNG, "view", "--text", *arguments]) + "; echo ended $?; sleep 60")

    def __enter__(self) -> Terminal:
        return self

    def __exit__(self, *_: object) -> None:
        subprocess.run(["tmux", "-L", self.socket, "kill-server"], check=False, capture_output=True)

    def tmux(self, *arguments: str) -> str:
        run = subprocess.run(["tmux", "-L", self.socket, "-f", "/dev/null", *arguments], check=False, capture_output=True, text=True)
        if run.returncode != 0:
            raise AssertionError(f"tmux {arguments[0]}: exit {run.returncode}: {run.stderr}")
        return run.stdout

    def keys(self, *keys: str) -> None:
        self.tmux("send-keys", *keys)

    def screen(self) -> str:
        return self.tmux("capture-pane", "-p")

    def sees(self, text: str) -> str:
        """The screen, once it has this text."""
        end = time.monotonic() + SECONDS
        while time.monotonic() < end:
            screen = self.screen()
            if text in screen:
                return screen
            time.sleep(0.05)
        raise AssertionError(f"no {text!r} on the screen:\n{self.screen()}")


class TextView(unittest.TestCase):
    def test_toggle_and_scan(self) -> None:
        with Terminal(str(PROGRAM)) as terminal:
            terminal.sees("scan 0")
            screen = terminal.sees("A motor that holds itself")
            self.assertIn("] [", screen)
            terminal.keys("x", "X0", "Enter")
            terminal.keys("Space")
            screen = terminal.sees("scan 1")
            self.assertRegex(screen, r"1 \|====\] \[=====\+===\]/\[=====\+=+\( \)=====\|")

    def test_real_time_and_break(self) -> None:
        with Terminal(str(PROGRAM)) as terminal:
            terminal.keys("b", "Y1", "Enter")
            terminal.keys("x", "X0", "Enter")
            terminal.keys("r")
            screen = terminal.sees("Y1 went from 0 to 1 in scan 50")
            self.assertIn("paused", screen)
            self.assertIn("TN0=5", screen)

    def test_set_force_and_find(self) -> None:
        with Terminal(str(PROGRAM)) as terminal:
            terminal.keys("=", "D1=12", "Enter")
            terminal.keys("!", "Y3=1", "Enter")
            terminal.sees("!Y3=1")
            terminal.keys("/", "D0", "Enter")
            self.assertIn("D1=12", terminal.sees("D0: rung 4"))
            terminal.keys("x", "Q9", "Enter")
            terminal.sees("Q9: the program has no such device")

    def test_leaves_the_terminal_as_it_was(self) -> None:
        with Terminal(str(PROGRAM)) as terminal:
            terminal.sees("scan 0")
            terminal.keys("q")
            screen = terminal.sees("ended 0")
            self.assertNotIn("] [", screen)

    def test_without_a_terminal(self) -> None:
        run = subprocess.run([RUNG, "view", "--text", str(PROGRAM), "--scans", "3"], check=True, capture_output=True, text=True)
        self.assertIn("; A motor that holds itself", run.stdout)
        self.assertNotIn("\x1b", run.stdout)
        self.assertTrue(all(len(line) <= 80 for line in run.stdout.splitlines()))


if __name__ == "__main__":
    unittest.main()
