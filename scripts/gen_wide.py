# SPDX-License-Identifier: Apache-2.0
"""What is derived from hdl/isa/wide.toml: part of gen_isa.py.

rung_wide.vh     Verilog: opcodes, layout, distances; sizes as RUNG_WIDE_W8_SLOTS and so on
wide_table.inc   C++: the same, for compiler/wide/machine.hpp
"""
import tomllib
from pathlib import Path

GROUPS = ("layout", "near", "distance", "scan")
SIZES = ("slots", "units", "arity", "rows", "word_rows", "steps", "dividers")


def load(isa_dir: Path) -> dict:
    """The table, checked: codes are of one instruction each and fit."""
    table = tomllib.loads((isa_dir / "wide.toml").read_bytes().decode())
    codes = [op["code"] for op in table["op"]]
    assert len(set(codes)) == len(codes), "a code stands twice"
    assert max(codes) < 1 << table["layout"]["op_bits"], "a code does not fit"
    for name, config in table["config"].items():
        assert set(config) == set(SIZES), f"{name}: sizes are {SIZES}"
        assert config["steps"] <= min(config["rows"], config["word_rows"]), f"{name}: steps are rows"
    return table


def numbers(table: dict) -> list[tuple[str, int]]:
    return [(f"{group}_{key}", value) for group in GROUPS for key, value in table[group].items()]


def parameters(table: dict) -> dict[int, dict[str, int]]:
    """Of hdl/wide/mpu4.v, by its slots, where they differ."""
    return {config["slots"]: {"SLOTS": config["slots"], "WORD_ADDR": (config["word_rows"] - 1).bit_length(),
                              "DIVIDERS": config["dividers"]} for config in table["config"].values()}


def cmake(table: dict) -> str:
    """As options of Verilator."""
    sizes = parameters(table)
    out = [f"set(RUNG_WIDE_SLOTS {' '.join(map(str, sizes))})"]
    out += [f"set(RUNG_WIDE_{slots}_PARAMETERS {' '.join(f'-G{name}={value}' for name, value in of.items())})"
            for slots, of in sizes.items()]
    return "\n".join(out) + "\n"


def verilog(table: dict, notice: str) -> str:
    out = [f"// SPDX-License-Identifier: Apache-2.0\n// {notice}",
           "`ifndef RUNG_WIDE_VH\n`define RUNG_WIDE_VH\n"]
    out += [f"`define RUNG_WIDE_OP_{op['name']} 5'd{op['code']}" for op in table["op"]]
    out += [f"`define RUNG_WIDE_{name.upper()} {value}" for name, value in numbers(table)]
    out += [f"`define RUNG_WIDE_{name.upper()}_{size.upper()} {config[size]}"
            for name, config in table["config"].items() for size in SIZES]
    return "\n".join(out + ["\n`endif\n"])


def cpp(table: dict, notice: str) -> str:
    out = [f"// SPDX-License-Identifier: Apache-2.0\n// {notice}\n// Define the three macros, include; they are gone afterwards."]
    for op in table["op"]:
        out.append(f"RUNG_WIDE_OP({op['name'].capitalize()}, \"{op['name']}\", {op['code']})")
    out += [f"RUNG_WIDE_NUMBER({name}, {value})" for name, value in numbers(table)]
    for name, config in table["config"].items():
        out.append(f"RUNG_WIDE_CONFIG(\"{name}\", {', '.join(str(config[size]) for size in SIZES)})")
    out += [f"#undef RUNG_WIDE_{macro}" for macro in ("OP", "NUMBER", "CONFIG")]
    return "\n".join(out) + "\n"
