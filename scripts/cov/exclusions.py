# SPDX-License-Identifier: Apache-2.0
"""What is left out of coverage, each with its reason: tb/coverage/exclusions.toml."""
from __future__ import annotations

import fnmatch
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from cov.hardware import Point

KINDS = ("line", "branch", "toggle")


@dataclass
class Exclusion:
    file: str             # a pattern of paths
    kinds: tuple[str, ...]
    name: re.Pattern[str]  # of a toggle: all of the signal's name, without its bit; else all of the source line, trimmed
    reason: str
    points: list[Point] = field(default_factory=list)  # that it has left out


def load(path: Path) -> list[Exclusion]:
    table = tomllib.loads(path.read_text(encoding="utf-8"))
    found = []
    for entry in table.get("exclude", []):
        kinds = tuple(entry["kinds"])
        assert set(kinds) <= set(KINDS) and entry["reason"].strip(), entry
        found.append(Exclusion(entry["file"], kinds, re.compile(entry["name"]), entry["reason"]))
    return found


def apply(exclusions: list[Exclusion], root: Path, holes: list[Point]) -> list[Point]:
    """The holes that no exclusion explains; each exclusion keeps those that it does."""
    sources: dict[str, list[str]] = {}
    left = []
    for point in holes:
        if point.kind == "toggle":
            name = re.sub(r"(\[\d+\])+$", "", point.name)
        else:
            lines = sources.setdefault(point.file, (root / point.file).read_text(encoding="utf-8").splitlines())
            name = lines[point.line - 1].strip()
        for exclusion in exclusions:
            if point.kind in exclusion.kinds and fnmatch.fnmatch(point.file, exclusion.file) and exclusion.name.fullmatch(name):
                exclusion.points.append(point)
                break
        else:
            left.append(point)
    return left
