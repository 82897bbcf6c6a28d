#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The yardsticks: the three samples on our processors, on soft cores in the same FPGA, on this machine.

Writes reports/yardsticks.json. Needs build/bin/rung and build/bin/rung-samples. The timings on this
machine mean something only if it does nothing else: they are taken first.
"""
from __future__ import annotations

import argparse
import datetime
import json
import platform
import re
import subprocess
import sys
from importlib import metadata
from pathlib import Path
from typing import Any

from flow import area, tools
from flow.designs import BOARDS, MPUS
from flow.place_route import nextpnr_version
from flow.synthesis import yosys_version
from yardstick import bench, program
from yardstick.cores import CORES

SAMPLES = (1, 2, 3)
SEEDS = [1, 2, 3, 4, 5]
FOLDER = tools.BUILD / "yardstick"
GENERATOR = tools.BUILD / "bin" / "rung-samples"


def sample_list(sample: int, seed: int) -> Path:
    """A stand-in program of the generator, as a list."""
    folder = FOLDER / f"sample{sample}"
    listing = folder / f"sample{sample}.il"
    text = subprocess.run([str(GENERATOR), "--sample", str(sample), "--seed", str(seed)],
                          capture_output=True, text=True, check=True).stdout
    tools.write_file(listing, text)
    return listing


def compile_for(listing: Path, mpu: int, config: str, slots: int | None = None) -> dict[str, Any]:
    """What `rung compile` counts; of a program that does not fit, the steps that it needs. `slots`: of MPU4."""
    run = subprocess.run([str(program.RUNG), "compile", str(listing), "--mpu", str(mpu), "--config",
                          config, "--json", *([] if slots is None else ["--slots", str(slots)])],
                         capture_output=True, text=True, check=False)
    too_large = re.search(r"needs (\d+) steps; configuration", run.stderr)
    if run.returncode == 1 and too_large:
        return {"fits": False, "steps": int(too_large.group(1))}
    if run.returncode != 0:
        raise tools.FlowError(run.stderr)
    counts = json.loads(run.stdout)
    return {"fits": True, **{key: counts[key] for key in ("instructions", "steps", "clocks")}}


def on_our_processors(listing: Path) -> list[dict[str, Any]]:
    configs = [board.config for board in BOARDS.values()]
    return [{"mpu": mpu, "config": config, **compile_for(listing, mpu, config)}
            for config in configs for mpu in MPUS]


def check_equal(sample: int, checksums: dict[str, int]) -> None:
    """All machines ran the same scans, so all must have ended in the same state."""
    if len(set(checksums.values())) != 1:
        raise tools.FlowError(f"sample {sample}: the machines disagree: {checksums}")


def host_description() -> dict[str, str]:
    cpu = next((line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo", encoding="utf-8")
                if line.startswith("model name")), platform.machine())
    return {"cpu": cpu, "compiler": f"{tools.version(program.CC)}, {' '.join(program.HOST_FLAGS)}"}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sample-seed", type=int, default=1, help="of the stand-in programs")
    parser.add_argument("--scans", type=int, default=200000, help="timed on this machine")
    parser.add_argument("--jobs", type=int, default=2, help="runs of nextpnr at once")
    arguments = parser.parse_args()
    samples = []
    for sample in SAMPLES:
        listing = sample_list(sample, arguments.sample_seed)
        c_file = program.translate(listing, listing.parent)
        tools.say(f"sample {sample}: {arguments.scans} scans on this machine")
        host = bench.run_host(program.for_host(c_file), arguments.scans)
        samples.append({"sample": sample, "seed": arguments.sample_seed, "c_file": c_file,
                        "rung": on_our_processors(listing), "host": host, "cores": []})
    for core in CORES:
        simulation = bench.verilate(core)
        for record in samples:
            tools.say(f"{core.name}: sample {record['sample']}")
            clocks = bench.run_core(core, simulation, program.for_core(core, record["c_file"]))
            record["cores"].append({"name": core.name, **clocks,
                                    "code_bytes": program.code_bytes(core, record["c_file"])})
    for record in samples:
        check_equal(record["sample"], {"host": record["host"].pop("checksum"),
                                       **{c["name"]: c.pop("checksum") for c in record["cores"]}})
        del record["c_file"]
    cores = []
    for core in CORES:
        design = core.design()
        result = area.measure(design, SEEDS, arguments.jobs)
        cores.append({"name": core.name, "title": core.title, "memory": core.memory,
                      **{key: result[key] for key in
                         ("logic_cells", "flip_flops", "block_rams", "dsps", "fmax_mhz")}})
        tools.say(f"{core.name}: {result['fmax_mhz']['median']} MHz")
    report = {
        "made_by": "make bench",
        "date": datetime.date.today().isoformat(),
        "tools": {"yosys": yosys_version(),
                  "nextpnr-ecp5": nextpnr_version(
                      BOARDS["ulx3s"].family.nextpnr).removeprefix("nextpnr-"),
                  "verilator": tools.version(bench.VERILATOR),
                  "riscv-gcc": f"{tools.version(program.RISCV + 'gcc')}, "
                               f"{' '.join(program.RISCV_FLAGS[:3])}",
                  **{package: metadata.version(package) for package in
                     ("pythondata-cpu-picorv32", "pythondata-cpu-vexriscv")}},
        "host": host_description(),
        "seeds": SEEDS,
        "cores": cores,
        "samples": samples,
    }
    tools.write_file(tools.REPORTS / "yardsticks.json", json.dumps(report, indent=1) + "\n")
    tools.say("wrote reports/yardsticks.json")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
