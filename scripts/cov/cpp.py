# SPDX-License-Identifier: Apache-2.0
"""Lines and branches of our C++, from gcov by way of gcovr."""
from __future__ import annotations

import json
import subprocess
from collections import defaultdict
from pathlib import Path
from typing import Any

from flow import tools

GCOVR = "gcovr"


def version() -> str:
    out = subprocess.run([GCOVR, "--version"], capture_output=True, text=True, check=True).stdout
    return out.splitlines()[0]


def collect(build: Path, target: Path) -> list[dict[str, Any]]:
    """gcovr's files: branches that only an exception takes, and those that cannot be reached, are left out."""
    tools.run([GCOVR, "--root", str(tools.ROOT), "--filter", f"{tools.ROOT}/compiler/", "--exclude-throw-branches",
               "--exclude-unreachable-branches", "--object-directory", str(build), str(build),
               "--json", str(target)], tools.LOGS / "gcovr.log")
    return json.loads(target.read_text())["files"]


def spans(numbers: list[int]) -> str:
    """"3-5, 9" of 3, 4, 5 and 9."""
    parts: list[list[int]] = []
    for number in sorted(set(numbers)):
        if parts and parts[-1][1] == number - 1:
            parts[-1][1] = number
        else:
            parts.append([number, number])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in parts)


def summary(files: list[dict[str, Any]]) -> dict[str, Any]:
    """Numbers by directory, and the holes by file."""
    folders: dict[str, dict[str, int]] = defaultdict(lambda: {"lines": 0, "lines_hit": 0, "branches": 0, "branches_hit": 0})
    holes = []
    for file in files:
        folder = folders[str(Path(file["file"]).parent)]
        missed, partial = [], []
        for line in file["lines"]:
            if line.get("gcovr/noncode"):
                continue
            folder["lines"] += 1
            folder["lines_hit"] += line["count"] > 0
            if line["count"] == 0:
                missed.append(line["line_number"])
            taken = [branch["count"] > 0 for branch in line["branches"]]
            folder["branches"] += len(taken)
            folder["branches_hit"] += sum(taken)
            if line["count"] > 0 and not all(taken):
                partial.append(line["line_number"])
        if missed or partial:
            holes.append({"file": file["file"], "lines": spans(missed), "branches": spans(partial)})
    return {"folders": dict(sorted(folders.items())), "holes": sorted(holes, key=lambda hole: hole["file"])}
