# SPDX-License-Identifier: Apache-2.0
"""What a report says of a promise: each check reads one JSON of reports/ and gives (yes or no, a sentence with figures)."""
from __future__ import annotations

import tomllib
from dataclasses import dataclass
from typing import Any, Callable

from flow import tools

FUZZ_SECONDS = 600  # that each reader is to have
SOAK_SCANS = 10_000_000

Verdict = tuple[bool, str]


@dataclass(frozen=True)
class Check:
    report: str    # reports/<report>.json
    made_by: str
    judge: Callable[[dict[str, Any]], Verdict]


def flow_bounds(report: dict[str, Any]) -> Verdict:
    cells = [cell for cell in report["cells"] if cell.get("bound_clocks")]
    over = sum(cell["most_clocks"] > cell["bound_clocks"] for cell in cells)
    nearest = max(cell["most_clocks"] / cell["bound_clocks"] for cell in cells)
    return not over, (f"{sum(cell['inputs'] for cell in cells)} responses in {len(cells)} cells of the experiment, "
                      f"{over} with one beyond the bound; the most is {100 * nearest:.0f} % of its bound")


def flow_ladder(report: dict[str, Any]) -> Verdict:
    cells = [cell for cell in report["cells"] if cell.get("ladder_clocks")]
    clocks = {cell["ladder_clocks"] for cell in cells}
    return bool(cells), f"beside flow tasks too: a ladder of {', '.join(map(str, sorted(clocks)))} clocks in every round of {len(cells)} cells"


def reliability(report: dict[str, Any]) -> Verdict:
    tests = [test for test in report["tests"] if "edges" not in test]
    return bool(tests), f"{len(tests)} tests with full counts pass (reports/reliability.md)"


def reliability_latency(report: dict[str, Any]) -> Verdict:
    tests = [test for test in report["tests"] if "edges" in test]
    over = sum(int(test["most"]) > int(test["bound_most"]) for test in tests)
    return bool(tests) and not over, (f"{sum(int(test['edges']) for test in tests)} edges in {len(tests)} cases, {over} beyond the bound")


def boards(report: dict[str, Any]) -> Verdict:
    rows = report["boards"]
    short = [row["title"] for row in rows if row["fmax_mhz"]["median"] < row["board_mhz"]]
    return not short, "; ".join(f"{row['title']}: {row['fmax_mhz']['median']} MHz of {row['board_mhz']}" for row in rows)


def formal_faults(report: dict[str, Any]) -> Verdict:
    caught = sum(fault["caught"] for fault in report["faults"])
    return caught == len(report["faults"]), f"{caught} of {len(report['faults'])} faults refused by the proofs"


def fuzz(report: dict[str, Any]) -> Verdict:
    ran = report["readers"]
    names = tomllib.loads((tools.ROOT / "tb" / "fuzz" / "readers.toml").read_text(encoding="utf-8"))
    long = [name for name in names if ran.get(name, {"cpu_seconds": 0})["cpu_seconds"] >= FUZZ_SECONDS]
    return len(long) == len(names), (
        f"{len(long)} of {len(names)} readers have had their {FUZZ_SECONDS} s of a processor; {sum(reader['inputs'] for reader in ran.values())} inputs in "
        f"{sum(reader['cpu_seconds'] for reader in ran.values())} s, {sum(reader['faults_found'] for reader in ran.values())} faults found and mended")


def mutation(report: dict[str, Any]) -> Verdict:
    netlists = report["netlists"]
    alive = [mutant for netlist in netlists for mutant in netlist["not_killed"]]
    open_ = [mutant for mutant in alive if not mutant["equal"] and "why" not in mutant]
    run, killed = (sum(netlist[key] for netlist in netlists) for key in ("run", "killed"))
    return not open_, (f"{run} mutants of {', '.join(dict.fromkeys(netlist['design'] for netlist in netlists))}: {killed} killed, "
                       f"{sum(mutant['equal'] for mutant in alive)} proven equivalent, {sum('why' in mutant for mutant in alive)} listed with what "
                       f"they would take, {len(open_)} not looked at")


def soak(report: dict[str, Any]) -> Verdict:
    scans = sum(board["counts"]["scans"] for board in report["boards"].values())
    return scans >= SOAK_SCANS and not report["differences"], (
        f"{scans:,} of {SOAK_SCANS:,} scans on {', '.join(report['boards'])}, {len(report['differences'])} differences")


def gate(report: dict[str, Any]) -> Verdict:
    rows, faults = report["netlists"], report["faults"]
    differences = sum(row["differences"] for row in rows)
    caught, injected = (sum(each[key] for each in faults) for key in ("caught", "injected"))
    text = (f"{', '.join(row['netlist'] for row in rows)}: {sum(row['scans'] for row in rows)} scans of golden programs, {differences} differences; "
            f"{caught} of {injected} flipped bits of look-up tables found")
    if report["not_run"]:
        text += f"; not run: {', '.join(report['not_run'])}"
    return not differences and not report["not_run"], text


def coverage(report: dict[str, Any]) -> Verdict:
    mpus, hardware = report["functional"]["mpus"], (report["hardware"] or {}).get("total")
    text = ", ".join(f"MPU{mpu['mpu']} {mpu['hit']} of {mpu['all']}" for mpu in mpus) + (
        " situations of the pipeline (opcode, operand, distance, slot, gate), the holes are listed by name; ")
    if hardware is None or report["cpp"] is None:
        return False, text + "hardware and C++ are not counted yet"
    folders = report["cpp"]["folders"].values()

    def share(kind: str) -> str:
        return f"{100 * sum(each[f'{kind}_hit'] for each in folders) / sum(each[kind] for each in folders):.1f} %"
    return True, text + "of the hardware " + (
        ", ".join(f"{100 * hardware[kind]['hit'] / hardware[kind]['all']:.1f} % of {kind}s" for kind in ("line", "toggle"))
        + f"; of the C++ {share('lines')} of lines, {share('branches')} of branches")


CHECKS = {
    "flow_bounds": Check("flow", "make flow-report", flow_bounds),
    "flow_ladder": Check("flow", "make flow-report", flow_ladder),
    "reliability": Check("reliability", "make reliability", reliability),
    "reliability_latency": Check("reliability", "make reliability", reliability_latency),
    "boards": Check("boards", "make boards", boards),
    "gate": Check("gate-level", "make test-gate", gate),
    "coverage": Check("coverage", "make cov", coverage),
    "fuzz": Check("fuzz", "make fuzz", fuzz),
    "mutation": Check("mutation", "make mutate", mutation),
    "soak": Check("soak", "make soak", soak),
    "formal_faults": Check("formal", "make formal", formal_faults),
}
