# SPDX-License-Identifier: Apache-2.0
"""Run a translated program: on a Verilated soft core, and on the host."""
from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

from flow import tools
from yardstick.cores import FOLDER, Core

VERILATOR = os.environ.get("VERILATOR", "verilator")


def verilate(core: Core) -> Path:
    """The bench of a core as a program; built again only if its sources have changed."""
    folder = tools.BUILD / "yardstick" / f"bench-{core.name}"
    bench, stamp = folder / "bench", folder / "bench.inputs"
    # The warnings of other people's Verilog are not ours to mend.
    command = [VERILATOR, "--cc", "--exe", "--build", "-j", "2", "-O3", "--x-initial", "0",
               "-Wno-lint", "-Wno-fatal", "-DYARD_SIMULATION", "--top-module", core.top,
               "--prefix", "Vyard", "-CFLAGS", "-O2", "-LDFLAGS", "-lfmt", "--Mdir", str(folder), "-o", "bench",
               str(FOLDER / "core_bench.cpp"), *map(str, core.sources)]
    want = tools.digest(command, [FOLDER / "core_bench.cpp", *core.sources])
    if not tools.up_to_date(stamp, want, [bench]):
        tools.say(f"{core.name}: Verilator")
        stamp.unlink(missing_ok=True)
        tools.run(command, tools.LOGS / f"yardstick-{core.name}-verilator.log")
        tools.write_file(stamp, want)
    return bench


def run_core(core: Core, bench: Path, ram: Path) -> dict[str, Any]:
    """Clocks of a scan, the marks' own clocks taken off: {"cold", "warm", "checksum"}."""
    said = json.loads(tools.run([str(bench), f"+ram={ram}"], ram.with_suffix(".log")))
    marks = said["empty"]["min"]
    for kind in ("cold", "warm"):
        for key in ("min", "median", "max"):
            said[kind][key] -= marks
    result = {"checksum": said["checksum"], "marks_clocks": marks, "warm": said["warm"]}
    if core.cached:
        result["cold"] = said["cold"]
    return result


def run_host(program: Path, scans: int) -> dict[str, Any]:
    """Single scans timed one by one on this machine; see host_main.c."""
    return json.loads(tools.run([str(program), str(scans)], program.with_suffix(".log")))
