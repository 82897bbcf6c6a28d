#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the hardware of flow tasks costs, area, clock and clocks: appended to the report of `make flow-report`.

flow_cost.py MARKDOWN JSON"""
from __future__ import annotations

import argparse
import json
import sys
import tomllib
from pathlib import Path
from typing import Any

from flow import area, modules, tools
from flow.area_report import table
from flow.designs import flow_tasks_design
from flow.place_route import nextpnr_version
from flow.synthesis import yosys_version

PARTS = {
    "scheduler": ("flow_scheduler",),
    "temporary storage": ("flow_pool",),
    "link": ("link",),
    "panel's Modbus client": ("panel_client",),
}
# What people ask for first, and which of [clocks] it is
SHOWN = {
    "switch to the next task, beside its routine": ("switch",),
    "suspend: a request is sent, the task waits": ("suspend",),
    "resume: data have come, n words go to their devices": ("resume", "copy"),
}


def shown(head: list[str], rows: list[list[Any]]) -> str:
    return "\n".join(table(head, rows)) + "\n"


def clocks_of(names: tuple[str, ...], clocks: dict[str, int]) -> str:
    total = sum(clocks[name] for name in names)
    return f"{total} + {clocks['copy_word']}n" if "copy" in names else str(total)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("page", type=Path)
    parser.add_argument("data", type=Path)
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("--jobs", type=int, default=2, help="runs of nextpnr at once")
    arguments = parser.parse_args()
    tools.generate_isa_header()
    design = flow_tasks_design()
    whole = area.measure(design, arguments.seeds, arguments.jobs)
    parts = modules.measure(design, PARTS)
    clocks = tomllib.loads((tools.ROOT / "hdl" / "isa" / "flow.toml").read_text())["clocks"]
    fmax = whole["fmax_mhz"]
    rows = [[part, each.luts, each.flip_flops, each.block_rams] for part, each in parts.items()]
    text = f"""
## Cost

Area of each part on an ECP5 (LUT4 after synthesis with the modules kept):

{shown(["part", "LUT4", "flip-flops", "block RAMs"], rows)}
All of it together, flattened and routed alone on {design.board.title}: {whole["logic_cells"]} logic cells of
{whole["logic_cells_available"]}, {whole["block_rams"]} block RAMs of {whole["block_rams_available"]}; {fmax["median"]} MHz (median of seeds
{", ".join(fmax["seeds"])}: {", ".join(str(mhz) for mhz in fmax["seeds"].values())}). {yosys_version()}, {nextpnr_version(design.board.family.nextpnr)}.
The figures above are for a processor at 100 MHz; at another clock their clocks take that much longer. With a processor and the
controller around it, at the board's clock: [boards.md](boards.md).

Clocks at the most, whatever the number of tasks, as the bound has them ([flow.toml](../hdl/isa/flow.toml)); the exact ones of
every case are in [hdl/flow/README.md](../hdl/flow/README.md), and a test asserts each:

{shown(["what", "clocks"], [[what, clocks_of(names, clocks)] for what, names in SHOWN.items()])}"""
    tools.write_file(arguments.page, arguments.page.read_text().rstrip("\n") + "\n" + text.rstrip("\n") + "\n")
    data = json.loads(arguments.data.read_text())
    data["cost"] = {"whole": whole, "clocks": clocks,
                    "parts": {part: vars(each) for part, each in parts.items()}}
    tools.write_file(arguments.data, json.dumps(data, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
