# SPDX-License-Identifier: Apache-2.0
"""A design on the standard cells of a process: gates by Yosys and abc, clock by OpenSTA.

Memories (hdl/core/bank_ram.v) are black boxes. The library that this module writes says how long an
access takes and how large they are: assumptions, which the report states.
"""
from __future__ import annotations

import json
import math
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from flow import tools

LIBERTY = Path("/usr/share/qflow/tech/osu018/osu018_stdcells.lib")
STA = "sta"
FOLDER = tools.BUILD / "cells"

# Assumed, of static RAM with one port for reading and one for writing on a process of 0.18 um.
ACCESS_NS = 2.0             # from the clock to the data, at 256 words; more for deep ones
ACCESS_NS_A_DOUBLING = 0.15
SETUP_NS = 0.4
CELL_UM2 = 7.0              # of a bit
AROUND_UM2_A_BIT = 3.0      # decoders, sense amplifiers, drivers
AROUND_UM2 = 10000.0        # of each memory
# Assumed, of the wires, which no layout has given: capacitance of a net by the number of its ends.
WIRE_PF = 0.015
WIRE_PF_AN_END = 0.015
# abc for speed: chains are balanced (if -g), and there are buffers wherever more than 16 ends hang on
# one output.
ABC = "+strash;ifraig;scorr;if,-g,-K,6;strash;dch,-f;map,-B,0.9;topo;buffer,-N,16;upsize;dnsize;stime,-p"


@dataclass(frozen=True)
class Cells:
    """What is measured: a processor by its sources."""
    name: str
    top: str
    sources: tuple[Path, ...]
    include: tuple[Path, ...]
    parameters: tuple[tuple[str, int], ...]


BLACK_BOX = """(* blackbox *)
module bank_ram #(parameter WIDTH = 16, parameter DEPTH = 256, parameter ADDR_BITS = 8,
                  parameter CLEARED = 1) (
  input wire clk_i, input wire read_i, input wire [ADDR_BITS-1:0] read_addr_i,
  output wire [WIDTH-1:0] read_data_o, input wire write_i,
  input wire [ADDR_BITS-1:0] write_addr_i, input wire [WIDTH-1:0] write_data_i);
endmodule
"""


def memory_name(width: int, depth: int) -> str:
    return f"ram_{depth}x{width}"


def access_ns(depth: int) -> float:
    return ACCESS_NS + ACCESS_NS_A_DOUBLING * max(0.0, math.log2(depth / 256))


def memory_um2(width: int, depth: int) -> float:
    return AROUND_UM2 + width * depth * (CELL_UM2 + AROUND_UM2_A_BIT)


def pins(width: int, depth: int) -> str:
    """Of a memory, with their times."""
    def timing(kind: str, rise: float, tables: tuple[str, ...]) -> str:
        values = "".join(f"{table}(scalar) {{ values(\"{rise}\"); }} " for table in tables)
        return f"timing() {{ related_pin : clk_i; timing_type : {kind}; {values}}} "

    check = (timing("setup_rising", SETUP_NS, ("rise_constraint", "fall_constraint"))
             + timing("hold_rising", 0.0, ("rise_constraint", "fall_constraint")))
    delay = timing("rising_edge", access_ns(depth), ("cell_rise", "cell_fall"))
    delay = delay.replace("} }", "} " + "".join(
        f"{slope}(scalar) {{ values(\"0.2\"); }} " for slope in ("rise_transition", "fall_transition")) + "}")
    address = max(1, (depth - 1).bit_length())
    text = "  pin(clk_i) { direction : input; clock : true; capacitance : 0.05; }\n"
    for name in ("read_i", "write_i"):
        text += f"  pin({name}) {{ direction : input; capacitance : 0.02; {check}}}\n"
    for name, bits in (("read_addr_i", address), ("write_addr_i", address), ("write_data_i", width)):
        text += f"  bus({name}) {{ bus_type : b{bits}; direction : input; capacitance : 0.02; {check}}}\n"
    return text + (f"  bus(read_data_o) {{ bus_type : b{width}; direction : output; "
                   f"max_capacitance : 1.0; {delay}}}\n")


def memory_library(memories: set[tuple[int, int]]) -> str:
    """Liberty of these memories, and of the wires that are assumed."""
    widths = {w for w, _ in memories} | {max(1, (d - 1).bit_length()) for _, d in memories}
    text = ("library(rung_memories) {\n  delay_model : table_lookup;\n  time_unit : \"1ns\";\n"
            "  voltage_unit : \"1V\";\n  current_unit : \"1uA\";\n  pulling_resistance_unit : \"1kohm\";\n"
            "  capacitive_load_unit (1,pf);\n"
            "  slew_lower_threshold_pct_rise : 20;\n  slew_upper_threshold_pct_rise : 80;\n"
            "  slew_lower_threshold_pct_fall : 20;\n  slew_upper_threshold_pct_fall : 80;\n"
            "  input_threshold_pct_rise : 50;\n  input_threshold_pct_fall : 50;\n"
            "  output_threshold_pct_rise : 50;\n  output_threshold_pct_fall : 50;\n"
            "  wire_load(\"assumed\") { resistance : 0; capacitance : 1; area : 0; "
            f"slope : {WIRE_PF_AN_END}; fanout_length(1, {WIRE_PF + WIRE_PF_AN_END}); }}\n")
    for bits in sorted(widths):
        text += (f"  type(b{bits}) {{ base_type : array; data_type : bit; bit_width : {bits}; "
                 f"bit_from : {bits - 1}; bit_to : 0; downto : true; }}\n")
    for width, depth in sorted(memories):
        text += (f"  cell({memory_name(width, depth)}) {{ area : {memory_um2(width, depth):.0f};\n"
                 f"{pins(width, depth)}  }}\n")
    return text + "}\n"


def synthesis_script(cells: Cells, folder: Path) -> str:
    include = " ".join(f"-I{path}" for path in cells.include)
    sources = " ".join(str(s) for s in cells.sources if s.name != "bank_ram.v")
    lines = [f"read_verilog {folder / 'black_box.v'}", f"read_verilog {include} {sources}"]
    if cells.parameters:
        lines.append("chparam " + " ".join(f"-set {k} {v}" for k, v in cells.parameters) + f" {cells.top}")
    lines += [f"synth -flatten -noabc -top {cells.top}", "opt -full", "rename -wire t:$_*DFF*", f"dfflibmap -liberty {LIBERTY}",
              f"abc -liberty {LIBERTY} -constr {folder / 'abc.constr'} -script {ABC}", "opt_clean -purge",
              f"tee -q -o {folder / 'stat.json'} stat -json -liberty {LIBERTY}",
              f"write_json {folder / 'netlist.json'}"]
    return "\n".join(lines) + "\n"


def memories_of(netlist: dict[str, Any], top: str) -> dict[tuple[int, int], int]:
    """Width and depth of each memory, and how many there are of it."""
    found: dict[tuple[int, int], int] = {}
    for cell in netlist["modules"][top]["cells"].values():
        if cell["type"] == "bank_ram":
            size = (int(cell["parameters"]["WIDTH"], 2), int(cell["parameters"]["DEPTH"], 2))
            found[size] = found.get(size, 0) + 1
    return found


def rename_script(folder: Path, memories: set[tuple[int, int]]) -> str:
    lines = [f"read_json {folder / 'netlist.json'}"]
    for width, depth in memories:
        lines += [f"select -set here t:bank_ram r:WIDTH={width} %i r:DEPTH={depth} %i",
                  f"setparam -unset WIDTH -unset DEPTH -unset ADDR_BITS -unset CLEARED "
                  f"-type {memory_name(width, depth)} @here"]
    return "\n".join(lines + [f"write_verilog -noattr -noexpr {folder / 'netlist.v'}"]) + "\n"


def timing_script(cells: Cells, folder: Path, wires: bool) -> str:
    return "\n".join([
        f"read_liberty {LIBERTY}", f"read_liberty {folder / 'memories.lib'}",
        f"read_verilog {folder / 'netlist.v'}", f"link_design {cells.top}",
        "create_clock -name clk -period 10 [get_ports clk_i]",
        *(["set_wire_load_model -name assumed"] if wires else []),
        "report_checks -path_delay max -format full -digits 3",
        "exit"]) + "\n"


def critical_path(report: str) -> dict[str, Any]:
    """Start, end and length of the longest path from register to register in OpenSTA's report."""
    start, end = (re.search(rf"^{what}: (\S+)", report, re.MULTILINE) for what in ("Startpoint", "Endpoint"))
    slack = re.search(r"^\s+(-?[\d.]+)\s+slack", report, re.MULTILINE)
    if not (start and end and slack) or re.search("^Error", report, re.MULTILINE):
        raise tools.FlowError("OpenSTA finds an error or no path:\n" + report[:1500])
    # Behind the register's name stands the kind of its flip-flop.
    names = [found.group(1).split("$")[0].removeprefix("core.") for found in (start, end)]
    return {"start": names[0], "end": names[1], "ns": round(10 - float(slack.group(1)), 3)}


def measure(cells: Cells) -> dict[str, Any]:
    """Gates, area and clock."""
    folder = FOLDER / cells.name
    folder.mkdir(parents=True, exist_ok=True)
    tools.write_file(folder / "black_box.v", BLACK_BOX)
    tools.write_file(folder / "abc.constr", "set_driving_cell BUFX2\nset_load 0.03 [all_outputs]\n")
    tools.write_file(folder / "synth.ys", synthesis_script(cells, folder))
    tools.say(f"{cells.name}: synthesis")
    tools.run([tools.YOSYS, "-q", "-s", str(folder / "synth.ys")], tools.LOGS / f"cells-{cells.name}.log")
    netlist = json.loads((folder / "netlist.json").read_text())
    memories = memories_of(netlist, cells.top)
    tools.write_file(folder / "memories.lib", memory_library(set(memories)))
    tools.write_file(folder / "rename.ys", rename_script(folder, set(memories)))
    tools.run([tools.YOSYS, "-q", "-s", str(folder / "rename.ys")],
              tools.LOGS / f"cells-{cells.name}-rename.log")
    # OpenSTA does not read `wire signed`, and in a netlist it means nothing.
    verilog = folder / "netlist.v"
    tools.write_file(verilog, re.sub(r"^(\s*wire) signed ", r"\1 ", verilog.read_text(), flags=re.MULTILINE))
    paths = {}
    for name, wires in (("no_wires", False), ("assumed_wires", True)):
        script = folder / f"{name}.tcl"
        tools.write_file(script, timing_script(cells, folder, wires))
        report = tools.run([STA, "-no_splash", "-exit", str(script)],
                           tools.LOGS / f"cells-{cells.name}-{name}.log")
        paths[name] = critical_path(report)
    types: dict[str, int] = {}
    for cell in netlist["modules"][cells.top]["cells"].values():
        types[cell["type"]] = types.get(cell["type"], 0) + 1
    types.pop("bank_ram", None)
    area = cell_areas()
    return {
        "name": cells.name,
        "gates": sum(types.values()),
        "flip_flops": sum(n for kind, n in types.items() if kind.startswith("DFF")),
        "nand2_equivalents": round(sum(area[k] * n for k, n in types.items()) / area["NAND2X1"]),
        "cell_um2": round(sum(area[kind] * n for kind, n in types.items())),
        "memories": [{"width": w, "depth": d, "count": n, "um2": round(memory_um2(w, d)),
                      "access_ns": round(access_ns(d), 2)} for (w, d), n in sorted(memories.items())],
        "memory_um2": round(sum(memory_um2(w, d) * n for (w, d), n in memories.items())),
        "paths": paths,
        "clock_mhz": {name: round(1000 / path["ns"], 1) for name, path in paths.items()},
    }


def cell_areas() -> dict[str, float]:
    text = LIBERTY.read_text()
    return {name: float(area) for name, area in
            re.findall(r"^cell \((\w+)\) \{.*?\barea : ([\d.]+);", text, re.MULTILINE | re.DOTALL)}
