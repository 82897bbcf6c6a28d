# SPDX-License-Identifier: Apache-2.0
"""What is derived from hdl/isa/flow.toml: part of gen_isa.py.

rung_flow.vh    Verilog: sizes, spaces, registers, frames of the link
rung_flow.hpp   C++: the same as constants in namespace rung::flow
Its constants stand in rung_controller.h too, for the firmware.
"""
import tomllib

GROUPS = {"space": "SPACE", "flow_setup": "FLOW_SETUP", "board_bit": "BOARD_BIT", "status": "FLOW_STATUS",
          "type": "LINK_TYPE", "register": "REG", "holding": "HOLDING"}


def load(isa_dir, controller):
    """The table, checked: its spaces and registers are nobody's in controller.toml."""
    table = tomllib.loads((isa_dir / "flow.toml").read_bytes().decode())
    for group in GROUPS:
        taken = set()
        for row in controller.get(group, []) + table[group]:
            places = range(row["number"], row["number"] + row.get("count", row.get("words", 1)))
            assert taken.isdisjoint(places), f"{group} {row['name']}: number is taken"
            taken.update(places)
    return table


def numbers(table):
    """(name, number) of every constant, without prefix."""
    out = []
    for group, prefix in GROUPS.items():
        for row in table[group]:
            out.append((f"{prefix}_{row['name']}", row["number"]))
            if "count" in row:
                out.append((f"{prefix}_{row['name']}_count", row["count"]))
    for group in ("flow", "clocks", "link"):
        out += [(f"{group}_{key}", value) for key, value in table[group].items()]
    return out


def verilog(table, notice):
    out = [f"// SPDX-License-Identifier: Apache-2.0\n// {notice}",
           "`ifndef RUNG_FLOW_VH\n`define RUNG_FLOW_VH\n"]
    out += [f"`define RUNG_{name.upper()} {value}" for name, value in numbers(table)]
    return "\n".join(out + ["\n`endif\n"])


def cpp(table, notice):
    out = [f"// SPDX-License-Identifier: Apache-2.0\n// {notice}", "#pragma once\n", "namespace rung::flow {\n"]
    out += [f"inline constexpr int {name.lower()} = {value};" for name, value in numbers(table)]
    return "\n".join(out + ["\n}  // namespace rung::flow\n"])
