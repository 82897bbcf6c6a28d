# SPDX-License-Identifier: Apache-2.0
"""Area and clock of one design over several seeds, as one record of reports/area-timing.json."""
from __future__ import annotations

import dataclasses
import json
import re
import statistics
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from flow import place_route, stages, synthesis
from flow.designs import Design

FLIP_FLOP = re.compile(r"TRELLIS_FF$|SB_DFF|DFF")
LUT = re.compile(r"(SB_)?LUT4$")


def cells(netlist: Path, top: str) -> dict[str, str]:
    """Name and type of every cell of a flattened netlist."""
    modules = json.loads(netlist.read_text())["modules"]
    return {name: cell["type"] for name, cell in modules[top]["cells"].items()}


def measure(design: Design, seeds: list[int], jobs: int, netlist: Path | None = None) -> dict[str, Any]:
    """Synthesise, unless the netlist is there, place and route with every seed, at most `jobs` at once.
    Clocks in MHz."""
    netlist = netlist or synthesis.synthesise(design)
    with ThreadPoolExecutor(max_workers=jobs) as pool:
        runs = list(pool.map(lambda seed: place_route.place_and_route(design, netlist, seed), seeds))
    runs.sort(key=lambda run: run.fmax_mhz)
    median = runs[(len(runs) - 1) // 2]
    types = cells(netlist, design.top)
    names = design.board.family.utilization

    def used(what: str) -> int:
        return sum(median.used.get(name, 0) for name in names[what])

    link = [kind for name, kind in types.items() if re.search(r"\b(link|power_on_reset|ports)\.", name)]
    return {
        "logic_cells": used("logic_cells"),
        "logic_cells_available": median.available[names["logic_cells"][0]],
        "flip_flops": sum(bool(FLIP_FLOP.match(kind)) for kind in types.values()),
        "block_rams": used("block_rams"),
        "block_rams_available": median.available[names["block_rams"][0]],
        "dsps": used("dsps"),
        "link_luts": sum(bool(LUT.match(kind)) for kind in link),
        "link_flip_flops": sum(bool(FLIP_FLOP.match(kind)) for kind in link),
        "goal_mhz": design.board.goal_mhz,
        "fmax_mhz": {
            "min": round(runs[0].fmax_mhz, 1),
            "median": round(statistics.median(run.fmax_mhz for run in runs), 1),
            "max": round(runs[-1].fmax_mhz, 1),
            "seeds": {str(run.seed): round(run.fmax_mhz, 1)
                      for run in sorted(runs, key=lambda run: run.seed)},
        },
        "critical_path": {"seed": median.seed,
                          **dataclasses.asdict(stages.describe(median.critical_path))},
    }
