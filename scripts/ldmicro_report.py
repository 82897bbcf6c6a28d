# SPDX-License-Identifier: Apache-2.0
"""The sections on LDmicro programs of reports/programs.md: the files of ../shared/programs/ldmicro,
what each element costs, and how fast C and byte code are on this machine."""
from __future__ import annotations

import json
from pathlib import Path

import engine_speed
from ldmicro_costs import COSTS, FEW, MORE, PLAIN, copies
from rung_program import MPUS, PROGRAMS, compiled, first_error, processor, rung, steps_and_clocks

CORPUS = PROGRAMS / "ldmicro"


def corpus() -> list[Path]:
    """The programs: samples/NAME/prog.ld, probes/NAME.ld, random/NNN/prog.ld."""
    return [*sorted(CORPUS.glob("samples/*/prog.ld")), *sorted(CORPUS.glob("probes/*.ld")),
            *sorted(CORPUS.glob("random/*/prog.ld"))]


def name_of(program: Path) -> str:
    inside = program.relative_to(CORPUS)
    return str(inside.parent if program.name == "prog.ld" else inside.with_suffix(""))


def stimulus_and_trace(program: Path) -> tuple[Path, Path]:
    if program.name == "prog.ld":
        return program.with_name("stim.txt"), program.with_name("trace.txt")
    return program.with_suffix(".stim"), program.with_suffix(".trace")


def as_traced(program: Path) -> str:
    """Whether all processors do in every scan what LDmicro's own trace says."""
    stimulus, trace = stimulus_and_trace(program)
    verdict = "as traced"
    for mpu in MPUS:
        check = rung("check", str(program), "--golden", str(trace), "--stimulus", str(stimulus), "--mpu", mpu)
        if check.returncode != 0:
            said = (check.stdout + check.stderr).strip().splitlines()
            return f"differs on MPU{mpu}: {said[0] if said else 'no message'}"
        if "stopped here (a division by zero)" in check.stderr:
            verdict = "as traced, up to a division by zero"
    return verdict


def program_row(program: Path) -> str:
    costs, counts = [], {}
    for mpu in MPUS:
        result = rung("compile", str(program), "--mpu", mpu, "--json")
        if result.returncode != 0:
            return f"| {name_of(program)} | refused: {first_error(result.stderr)} | | | | | |"
        counts = json.loads(result.stdout)
        costs.append(f"{counts['steps']} / {counts['clocks']}")
    return (f"| {name_of(program)} | {as_traced(program)} | {counts['instructions']} | "
            f"{counts['lookups']} | {' | '.join(costs)} |")


def slope(template: str, mpu: str) -> tuple[float, float]:
    """Steps and clocks of one more rung with it, behind the first few."""
    more = compiled(copies(template, FEW + MORE), mpu, "--dialect", "ldmicro")
    few = compiled(copies(template, FEW), mpu, "--dialect", "ldmicro")
    return (more[0] - few[0]) / MORE, (more[1] - few[1]) / MORE


def cost_rows() -> list[str]:
    plain = {mpu: slope(PLAIN, mpu) for mpu in MPUS}
    rows = ["| rung of one contact and one coil | "
            + " | ".join(steps_and_clocks(*plain[mpu]) for mpu in MPUS) + " |"]
    for name, template in COSTS:
        costs = []
        for mpu in MPUS:
            steps, clocks = slope(template, mpu)
            costs.append(steps_and_clocks(steps - plain[mpu][0], clocks - plain[mpu][1]))
        rows.append(f"| {name} | {' | '.join(costs)} |")
    return rows


def sections() -> list[str]:
    programs = corpus()
    rows = [program_row(program) for program in programs]
    refused = sum("| refused: " in row for row in rows)
    return [
        "## LDmicro programs", "",
        f"The files of `../shared/programs/ldmicro`, {len(programs)} in all; {len(programs) - refused} run on the "
        "three processors under their stimuli, each value of each scan compared with the trace of LDmicro's own "
        "simulator (`rung check`). Elements, look-ups, and steps and, behind the slash, clocks of a scan.", "",
        "| program | | elements | look-ups | MPU1 | MPU2 | MPU3 |", "|---|---|---|---|---|---|---|", *rows, "",
        "## Cost of each LDmicro element in steps on each processor", "",
        f"What it adds to a rung of one contact and one coil: the difference of {FEW + MORE} such rungs with it and "
        f"{FEW}, divided by {MORE}, less the same of rungs without it. In brackets clocks, where steps wait for the "
        "multiply-divide unit.", "",
        "| | MPU1 | MPU2 | MPU3 |", "|---|---|---|---|", *cost_rows(), "",
        "## C and byte code on this machine", "",
        *engine_speed.section(processor()), ""]
