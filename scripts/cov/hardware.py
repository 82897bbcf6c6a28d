# SPDX-License-Identifier: Apache-2.0
"""Lines, branches and toggles of the hardware, from Verilator's counters (tb/harness/model_coverage.hpp)."""
from __future__ import annotations

import os
import re
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from typing import Iterable

from flow import tools

# A toggle point counts changes in either direction, of all instances: two are the least that it takes to
# go there and back.
ENOUGH = {"line": 1, "branch": 1, "toggle": 2}


@dataclass(frozen=True)
class Point:
    kind: str     # line, branch, toggle
    file: str     # from the top of the tree
    line: int
    column: int
    name: str     # of a toggle: the signal with its bit; else block, if, else, case, ...


def read(files: Iterable[Path]) -> dict[Point, int]:
    """All points of our hardware and their counts, added up."""
    counts: dict[Point, int] = defaultdict(int)
    for file in files:
        for line in file.read_text(encoding="latin-1").splitlines():
            if not line.startswith("C '"):
                continue
            text, count = line[3:].rsplit("' ", 1)
            keys = dict(pair.split("\2", 1) for pair in text.split("\1") if "\2" in pair)
            path = Path(os.path.normpath(keys["f"]))
            if not path.is_relative_to(tools.ROOT / "hdl"):
                continue
            kind = keys["page"].split("/")[0].removeprefix("v_")
            counts[Point(kind, str(path.relative_to(tools.ROOT)), int(keys["l"]), int(keys["n"]), keys["o"])] += int(count)
    return dict(counts)


def covered(point: Point, count: int) -> bool:
    return count >= ENOUGH[point.kind]


def ranges(numbers: Iterable[int]) -> str:
    """"7:4, 1" of 7, 6, 5, 4 and 1."""
    parts: list[list[int]] = []
    for number in sorted(set(numbers), reverse=True):
        if parts and parts[-1][-1] == number + 1:
            parts[-1].append(number)
        else:
            parts.append([number])
    return ", ".join(str(part[0]) if len(part) == 1 else f"{part[0]}:{part[-1]}" for part in parts)


def names(points: Iterable[Point]) -> list[str]:
    """Holes by file:line: of one signal or one line together."""
    signals: dict[tuple[str, int, str], list[int]] = defaultdict(list)
    lines: dict[tuple[str, int], list[str]] = defaultdict(list)
    for point in points:
        if point.kind == "toggle":
            match = re.fullmatch(r"(.*)\[(\d+)\]", point.name)
            base, bit = (match.group(1), [int(match.group(2))]) if match else (point.name, [])
            signals[point.file, point.line, base] += bit
        else:
            lines[point.file, point.line].append(point.name)
    found = [(file, line, f"never changed: {base}{f'[{ranges(bits)}]' if bits else ''}") for (file, line, base), bits in signals.items()]
    found += [(file, line, f"never run: {', '.join(sorted(set(what)))}") for (file, line), what in lines.items()]
    return [f"{file}:{line}: {what}" for file, line, what in sorted(found)]
