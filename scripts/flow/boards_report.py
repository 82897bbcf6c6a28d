# SPDX-License-Identifier: Apache-2.0
"""reports/boards.md from boards.json, and the bounds of area that it states."""
from __future__ import annotations

import dataclasses
from typing import Any

from flow import modules, tools
from flow.area_report import table, tools_line
from flow.designs import Design

# Parts of a board top and their modules; those inside another part count there
PARTS = {
    "processor": ("processor",),
    "micro-sequencer, its program and its RAM": tuple(
        sorted(file.stem for file in (tools.ROOT / "hdl" / "controller" / "micro").glob("*.v"))),
    "host line: UART, RTU frames, CRC-16": ("host_uart", "rtu_line"),
    "host exchange and device map": ("host_exchange", "device_map"),
    "scan: phases, list of inputs and outputs, time, filters, pins": (
        "scan_controller", "scan_statistics", "setup_registers", "load_spaces", "io_list", "time_base",
        "input_pins", "input_filter", "run_switch", "output_pins", "adc_select", "pwm_entry", "keep_port"),
    "device ports: exchange, UART, PWM": ("ladder_ports", "port_exchange", "uart_rx", "uart_tx", "pwm"),
    "flash port, CRC-32": ("flash_port", "crc32"),
    "flow tasks": ("flow_block",),
    "converter": ("max11123",),
}
NOT_EVERYWHERE = ("flow tasks", "converter")  # the boards without them are right
SERVER = tuple(PARTS)[1:4]
# Most LUTs of the Modbus server (micro-sequencer, host line, exchange and map) and of the sequencer alone
BOUNDS = {"micro-sequencer": 750, "Modbus server": 2000}


def parts(design: Design) -> dict[str, dict[str, int]]:
    """Area of each part, and "other"."""
    return {part: dataclasses.asdict(area) for part, area in modules.measure(design, PARTS).items()}


def server(record: dict[str, Any]) -> dict[str, int]:
    """LUTs of what BOUNDS names."""
    luts = {part: area["luts"] for part, area in record["parts"].items()}
    return {"micro-sequencer": luts[SERVER[0]], "Modbus server": sum(luts[part] for part in SERVER)}


def shortage(record: dict[str, Any]) -> str:
    return ", ".join(f"{used} of {there} {kind}" for kind, (used, there) in record["needs"].items())


def missed(report: dict[str, Any]) -> list[str]:
    """What is not as it should be."""
    found = []
    for record in report["boards"]:
        if "needs" in record:
            found.append(f"{record['board']}: does not fit: {shortage(record)}")
        elif record["fmax_mhz"]["min"] < record["board_mhz"]:
            found.append(f"{record['board']}: {record['fmax_mhz']['min']} MHz, the board has {record['board_mhz']}")
        for what, luts in server(record).items():
            if luts > report["bounds"][what]:
                found.append(f"{record['board']}: the {what} takes {luts} LUTs, at most {report['bounds'][what]} "
                             "are wanted")
        found += [f"{record['board']}: no instance of \"{part}\": PARTS of boards_report.py has other names"
                  for part in PARTS if part not in NOT_EVERYWHERE and not any(record["parts"][part].values())]
    found += [f"no board has an instance of \"{part}\": PARTS of boards_report.py has other names" for part in NOT_EVERYWHERE
              if not any(any(record["parts"][part].values()) for record in report["boards"])]
    return found


def render(report: dict[str, Any]) -> str:
    rows = []
    for r in report["boards"]:
        if "needs" in r:
            rows.append([f"{r['title']}, MPU{r['mpu']}", f"**does not fit: {shortage(r)}**", *["-"] * 6,
                         r["board_mhz"], "no", "-"])
            continue
        fmax = r["fmax_mhz"]
        rows.append([f"{r['title']}, MPU{r['mpu']}", f"{r['logic_cells']} of {r['logic_cells_available']}",
                     r["flip_flops"], f"{r['block_rams']} of {r['block_rams_available']}", r["dsps"] or "-",
                     fmax["min"], f"**{fmax['median']}**", fmax["max"], r["board_mhz"],
                     "yes" if fmax["min"] >= r["board_mhz"] else "no", r["bitstream"]["bytes"]])
    out = ["# The controller on its boards", "",
           f"Made by `make boards`. {report['date']}. {tools_line(report)}. Options: "
           + ", ".join(f"`{options}`" for options in report["options"].values())
           + ". Nothing here has run on a board.", "",
           "Each board's own clock is the goal of place and route, over the seeds "
           f"{', '.join(map(str, report['seeds']))}; the board is met if all of them do. Logic cells are nextpnr's: on "
           "ECP5 a LUT4 or half of a carry pair, on iCE40 a cell of LUT4, carry and flip-flop, on Gowin a LUT4 or a bit "
           "of an adder. Block RAMs hold 16, 4 and 18 Kbit. The bitstream is the file that `make bit` writes; Gowin's "
           "is text, a character a bit.", "",
           *table(["", "logic cells", "flip-flops", "block RAMs", "DSPs", "MHz min", "median", "max", "board's",
                   "met", "bitstream, bytes"], rows), "",
           "## Where the area goes", "",
           "LUTs / flip-flops / block RAMs of each part, from a synthesis that keeps the modules apart: the sum is "
           "a little more than above, where Yosys works across them.", ""]
    names = [r["board"] for r in report["boards"]]
    rows = [[part, *("{luts} / {flip_flops} / {block_rams}".format(**r["parts"][part]) for r in report["boards"])]
            for part in (*PARTS, "other")]
    out += [*table(["", *names], rows), ""]
    rows = [[what, *(server(r)[what] for r in report["boards"]), bound]
            for what, bound in report["bounds"].items()]
    out += ["The Modbus server is the sequencer with the host line and the exchange. `make boards` fails if one of "
            "these is passed:", "",
            *table(["LUTs", *names, "at most"], rows), ""]
    return "\n".join(out).rstrip() + "\n"
