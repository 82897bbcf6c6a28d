# SPDX-License-Identifier: Apache-2.0
"""A ladder program translated to C and compiled for the soft cores and for the host."""
from __future__ import annotations

import os
import re
from pathlib import Path

from flow import tools
from yardstick.cores import FOLDER, Core

RUNG = tools.BUILD / "bin" / "rung"
RISCV = os.environ.get("RISCV", "riscv64-unknown-elf-")
CC = os.environ.get("CC", "gcc")
RISCV_FLAGS = ["-O2", "-march=rv32im", "-mabi=ilp32", "-ffreestanding", "-nostdlib",
               "-nostartfiles", "-Wl,--no-warn-rwx-segments"]
HOST_FLAGS = ["-O2", "-std=c99"]


def translate(listing: Path, folder: Path) -> Path:
    """The program as C, by this project's own back end."""
    c_file = folder / "program.c"
    tools.run([str(RUNG), "translate", str(listing), "--to", "c", "-o", str(c_file)],
              folder / "translate.log")
    return c_file


def device_counts(c_file: Path) -> list[str]:
    """Compiler options that tell scan_adapter.c how many devices of each kind the program has."""
    text = c_file.read_text()
    options = []
    for kind, macro in (("X", "INPUTS"), ("Y", "OUTPUTS"), ("M", "RELAYS"), ("D", "WORDS")):
        match = re.search(rf"^  u?int\d+_t {kind}\[(\d+)\];", text, re.MULTILINE)
        if not match:
            raise tools.FlowError(f"{c_file}: no array of the {kind} devices")
        options.append(f"-D{macro}={match.group(1)}")
    return options


def for_core(core: Core, c_file: Path) -> Path:
    """The RAM contents with the program and its main, as hexadecimal words for $readmemh."""
    folder = c_file.parent
    elf, binary = folder / f"{core.name}.elf", folder / f"{core.name}.bin"
    tools.run([f"{RISCV}gcc", *RISCV_FLAGS, *(f"-D{name}" for name in core.defines),
               *device_counts(c_file), f"-I{FOLDER}", "-T", str(FOLDER / "core.ld"),
               str(FOLDER / "core_start.S"), str(FOLDER / "core_main.c"),
               str(FOLDER / "scan_adapter.c"), str(c_file), "-lgcc", "-o", str(elf)],
              folder / f"{core.name}-gcc.log")
    tools.run([f"{RISCV}objcopy", "-O", "binary", str(elf), str(binary)],
              folder / f"{core.name}-objcopy.log")
    data = binary.read_bytes()
    data += bytes(-len(data) % 4)
    words = [f"{int.from_bytes(data[i:i + 4], 'little'):08x}" for i in range(0, len(data), 4)]
    ram = folder / f"{core.name}.hex"
    tools.write_file(ram, "\n".join(words) + "\n")
    return ram


def code_bytes(core: Core, c_file: Path) -> int:
    """Bytes of PlcCycle's machine code on a soft core."""
    out = tools.run([f"{RISCV}nm", "-S", str(c_file.with_name(f"{core.name}.elf"))],
                    c_file.parent / f"{core.name}-nm.log")
    match = re.search(r"^\w+ (\w+) T PlcCycle$", out, re.MULTILINE)
    if not match:
        raise tools.FlowError(f"{core.name}: no PlcCycle in the program")
    return int(match.group(1), 16)


def for_host(c_file: Path) -> Path:
    """The timed program for the machine that makes the report."""
    program = c_file.parent / "host"
    tools.run([CC, *HOST_FLAGS, *device_counts(c_file), f"-I{FOLDER}", str(FOLDER / "host_main.c"),
               str(FOLDER / "scan_adapter.c"), str(c_file), "-o", str(program)],
              c_file.parent / "host-gcc.log")
    return program
