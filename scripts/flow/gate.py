# SPDX-License-Identifier: Apache-2.0
"""The processors' netlists as Verilog, for `make test-gate`: what synthesis makes of each processor alone, with the
options that its board's flow has, and the same with LUTs that can be made wrong."""
from __future__ import annotations

import dataclasses
import json
import random
import re
from pathlib import Path

import gen_isa
from flow import tools
from flow.designs import BOARDS, MPUS, WIDE, WIDE_BOARD, Board, Design
from flow.synthesis import synthesise, yosys_version

FOLDER = tools.BUILD / "gate-netlists"
WIDE_SLOTS = 4
FAULTS = 40          # wrong LUTs of one netlist; a byte holds their number
FAULT_SEED = 9
FAULTY = ("hx8k-mpu1",)   # those that are made wrong: the smallest, as each fault runs for long
# Of a LUT: Yosys' name of the cell, of its table and its pins, the table's lowest address bit first
LUTS = {"SB_LUT4": ("LUT_INIT", ("I0", "I1", "I2", "I3"), "O"), "LUT4": ("INIT", ("A", "B", "C", "D"), "Z")}


def designs() -> dict[str, Design]:
    """Netlist's name -> what is synthesised: each processor in each configuration that has a processor of its own."""
    _, configs, _ = gen_isa.load()
    hdl = tools.ROOT / "hdl"
    core = sorted((hdl / "core").glob("*.v"))
    found = {}
    for config in dict.fromkeys(gen_isa.models(configs).values()):
        board = next(board for board in BOARDS.values() if board.config == config)
        for mpu in MPUS:
            parameters = gen_isa.parameters(configs["config"][config], f"mpu{mpu}")
            found[f"{config}-mpu{mpu}"] = design(f"mpu{mpu}", board, f"{config}-mpu{mpu}", parameters,
                                                 [hdl / f"mpu{mpu}.v", *core], (tools.GENERATED, hdl / "core"))
    sources = sorted((hdl / "wide").glob("*.v")) + [hdl / "core" / f"{name}.v" for name in ("alu", "bank_ram", "muldiv")]
    name = f"{WIDE_BOARD.config}-mpu4-{WIDE_SLOTS}"
    found[name] = design("mpu4", WIDE_BOARD, name, WIDE[WIDE_SLOTS], sources, (tools.GENERATED,))
    return found


def design(top: str, board: Board, name: str, parameters: dict[str, int], sources: list[Path],
           include: tuple[Path, ...]) -> Design:
    return Design(name, top, tuple(sources), include, tuple(parameters.items()),
                  dataclasses.replace(board, constraints=None), kind="gate-synthesis")


def verilog(made: Design) -> Path:
    """The netlist as Verilog."""
    netlist = synthesise(made)
    target = FOLDER / f"{made.name}.v"
    stamp = target.with_suffix(".inputs")
    want = tools.digest([yosys_version()], [netlist])
    if not tools.up_to_date(stamp, want, [target]):
        FOLDER.mkdir(parents=True, exist_ok=True)
        script = made.folder / "verilog.ys"
        tools.write_file(script, f"read_json {netlist.relative_to(tools.ROOT)}\n"
                                 f"write_verilog -noattr {target.relative_to(tools.ROOT)}\n")
        tools.run([tools.YOSYS, "-s", str(script)], tools.LOGS / f"gate-{made.name}.log")
        tools.write_file(stamp, want)
    return target


def cells(netlist: Path) -> dict[str, int]:
    """How many there are of each kind."""
    counts: dict[str, int] = {}
    for kind in re.findall(r"^  ([A-Z]\w+) (?:#\($|\S+ \($|\\\S+  \($)", netlist.read_text(), re.MULTILINE):
        counts[kind] = counts.get(kind, 0) + 1
    return dict(sorted(counts.items()))


def with_faults(netlist: Path) -> Path:
    """The netlist with a port `fault_i`: its value n makes one entry of the n-th chosen LUT wrong, 0 none. The entry is
    one that the LUT's constant inputs do not rule out. Beside it, a table of the faults."""
    text = netlist.read_text()
    pattern = re.compile(rf"^  ({'|'.join(LUTS)}) #\(\n    \.\w+\(16'h([0-9a-f]+)\)\n  \) (\S+) +\(\n(.*?)^  \);\n",
                         re.MULTILINE | re.DOTALL)
    found = list(pattern.finditer(text))
    chance = random.Random(FAULT_SEED)
    chosen = sorted(chance.sample(range(len(found)), FAULTS))
    table, parts, end = [], [], 0
    for number, index in enumerate(chosen, 1):
        lut = found[index]
        kind, init, name, body = lut.groups()
        pins = dict(re.findall(r"\.(\w+)\((.*?)\),?\n", body))
        _, inputs, output = LUTS[kind]
        constant = {place: int(pins[pin][-1]) for place, pin in enumerate(inputs) if re.fullmatch(r"1'h[01]", pins[pin])}
        entry = chance.choice([e for e in range(16) if all(e >> place & 1 == value for place, value in constant.items())])
        parts += [text[end:lut.start()],
                  f"  faulty_lut #(.INIT(16'h{init}), .NUMBER({number}), .ENTRY({entry})) {name} (.fault_i(fault_i), "
                  f".in_i({{{', '.join(pins[pin] for pin in reversed(inputs))}}}), .out_o({pins[output]}));\n"]
        end = lut.end()
        table.append({"number": number, "cell": name.lstrip("\\"), "init": init, "entry": entry})
    text = "".join([*parts, text[end:]])
    text = re.sub(r"^(module \w+\()", r"\1fault_i, ", text, count=1, flags=re.MULTILINE)
    text = text.replace("  input clk_i;\n", "  input [7:0] fault_i;\n  input clk_i;\n", 1)
    target = netlist.with_name(f"{netlist.stem}-faults.v")
    if not target.exists() or target.read_text() != text:
        tools.write_file(target, text)
    tools.write_file(target.with_suffix(".json"), json.dumps(table, indent=1) + "\n")
    return target
