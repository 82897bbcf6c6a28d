# SPDX-License-Identifier: Apache-2.0
"""The built `rung` and this machine, as the reports ask them."""
from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
RUNG = BUILD / "bin" / "rung"
PROGRAMS = ROOT.parent / "shared" / "programs"  # no part of the project
MPUS = ("1", "2", "3")


def rung(*arguments: str, text: str | None = None) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(RUNG), *arguments], input=text, capture_output=True, text=True,
                          check=False)


def first_error(messages: str) -> str:
    """The first error of a refused program, and how many more there are."""
    errors = re.findall(r"^.*?:(\d+):\d+: error: (.*)$", messages, re.MULTILINE)
    line, why = errors[0]
    more = f"; and {len(errors) - 1} more" if len(errors) > 1 else ""
    return f"line {line}: {why}{more}"


def compiled(text: str, mpu: str, *options: str) -> tuple[int, int]:
    """Steps and clocks of a program."""
    result = rung("compile", "-", "--mpu", mpu, "--json", *options, text=text)
    if result.returncode != 0:
        sys.exit(result.stderr)
    counts = json.loads(result.stdout)
    return counts["steps"], counts["clocks"]


def steps_and_clocks(steps: float, clocks: float) -> str:
    """Of a cost: clocks only where they differ."""
    return f"{steps:.1f}" if abs(steps - clocks) < 0.05 else f"{steps:.1f} ({clocks:.1f})"


def processor() -> str:
    """What this machine calls its processor."""
    found = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text(encoding="utf-8"))
    return found.group(1) if found else "unknown"
