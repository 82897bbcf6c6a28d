# SPDX-License-Identifier: Apache-2.0
"""reports/coverage.md from what scripts/coverage.py has collected."""
from __future__ import annotations

from typing import Any


def share(hit: int, of: int) -> str:
    return f"{hit:,} of {of:,}" + (f" ({100 * hit / of:.1f} %)" if of else "")


def hardware(data: dict[str, Any]) -> list[str]:
    lines = ["## Hardware", "",
             "Verilator's counters, added up over all instances and parameters of a module. A toggle is one bit of a signal; it counts "
             "if it changed at least twice. What is excluded is not counted as missing, and stands below.", "",
             "| file | lines | branches | toggles | excluded |", "|---|---|---|---|--:|"]
    for file, counts in data["files"].items():
        cells = " | ".join(share(counts[kind]["hit"], counts[kind]["all"]) for kind in ("line", "branch", "toggle"))
        lines.append(f"| {file} | {cells} | {counts['excluded'] or ''} |")
    total = data["total"]
    lines += ["| **all** | " + " | ".join(share(total[kind]["hit"], total[kind]["all"]) for kind in ("line", "branch", "toggle")) +
              f" | {total['excluded']} |", "", "Excluded:", "", "| file | what | points | reason |", "|---|---|--:|---|"]
    lines += [f"| {each['file']} | {', '.join(each['kinds'])}: `{each['name'].replace('|', chr(92) + '|')}` | {each['points']} | {each['reason']} |"
              for each in data["exclusions"]]
    lines += ["", f"Holes, {len(data['holes'])} places:", "", *(f"- {hole}" for hole in data["holes"])]
    return lines


def functional(data: dict[str, Any]) -> list[str]:
    lines = ["## The pipeline's situations", "",
             "Opcode x slot x gate (none, always, open, shut) x operand x where it comes from: a constant, N0, the memory, or a write "
             "1 to 5 steps before, of the same or the other slot, carried out or stopped by its gate; a write of the other slot in "
             "the step itself; for ix, whether it was set just before. Counted over what retires (`tb/coverage/functional.hpp`, with the rules "
             f"of what cannot be), in {data['programs']} random programs of {data['steps']} steps in each configuration and in the golden programs.",
             "", "| processor | scans, random | golden | situations reached |", "|---|--:|--:|---|"]
    lines += [f"| MPU{each['mpu']} | {each['random_scans']:,} | {each['golden_scans']:,} | {share(each['hit'], each['all'])} |"
              for each in data["mpus"]]
    lines += ["", "| opcode | " + " | ".join(f"MPU{each['mpu']}" for each in data["mpus"]) + " |",
              "|---|" + "--:|" * len(data["mpus"])]
    opcodes = sorted({opcode for each in data["mpus"] for opcode in each["opcodes"]})
    for opcode in opcodes:
        counts = [each["opcodes"].get(opcode) for each in data["mpus"]]
        lines.append(f"| {opcode} | " + " | ".join(f"{count['hit']} of {count['all']}" if count else "" for count in counts) + " |")
    holes = [hole for each in data["mpus"] for hole in each["holes"]]
    return lines + ["", *([f"Holes, {len(holes)}:", "", *(f"- {hole}" for hole in holes)] if holes else ["No holes."])]


def cpp(data: dict[str, Any]) -> list[str]:
    lines = ["## C++", "", "gcov's counters of `compiler/`, without branches that only an exception takes.", "",
             "| folder | lines | branches |", "|---|---|---|"]
    lines += [f"| {folder} | {share(count['lines_hit'], count['lines'])} | {share(count['branches_hit'], count['branches'])} |"
              for folder, count in data["folders"].items()]
    lines += ["", "Holes: lines that never run, and lines of whose branches not all are taken.", "",
              "| file | lines | lines with such branches |", "|---|---|---|"]
    return lines + [f"| {hole['file']} | {hole['lines']} | {hole['branches']} |" for hole in data["holes"]]


def render(report: dict[str, Any]) -> str:
    tools = ", ".join(report["tools"].values())
    lines = ["# Coverage", "", f"Made by `make cov` on {report['date']} with {tools}. Run were, those but `coverage_functional` in a build with counters: "
             f"{', '.join(f'`{name}` ({seconds} s)' for name, seconds in report['programs'].items())}. "
             "These are tests of `make test`, some with fewer random programs; without what runs for long and reaches little else: random "
             "lists in lockstep, plants, several units, pymodbus, reliability, the browser. So what is called missing here may run there. "
             "Coverage says what ran, not that it was checked."]
    for name, part in (("functional", functional), ("hardware", hardware), ("cpp", cpp)):
        lines += ["", *(part(report[name]) if report[name] else [f"## Not counted yet: {name}", "", "Not all of its programs have run."])]
    return "\n".join(lines) + "\n"
