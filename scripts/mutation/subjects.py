# SPDX-License-Identifier: Apache-2.0
"""What is mutated, and which of the project's tests try to notice."""
from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path

import gen_isa
import gen_wide
from flow import tools

HDL = tools.ROOT / "hdl"


@dataclass(frozen=True)
class Trial:
    """A test program of tb/, and the part of it that runs the subject."""
    program: str                  # its CMake target, and its place below build/mutate/tb
    folder: str
    filter: str                   # GoogleTest's
    environment: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Subject:
    """A module that is mutated with what it holds. `mutated` files are flattened into one netlist; of what they
    instantiate the `kept` files stay as they are, the memories (core/bank_ram.v) among them: a fault in a memory is
    one at its ports."""
    name: str                     # of the model in tb/, or of the file that the netlist stands for
    group: str                    # the report's line
    top: str
    mutated: tuple[Path, ...]
    kept: tuple[Path, ...]
    parameters: tuple[tuple[str, int], ...]
    wanted: int                   # mutants
    trials: tuple[Trial, ...]     # in this order; the last one is all of them

    @property
    def folder(self) -> Path:
        return tools.BUILD / "mutate" / self.name


def files(*patterns: str) -> tuple[Path, ...]:
    """Of hdl/, as glob patterns."""
    return tuple(path for pattern in patterns for path in sorted(HDL.glob(pattern)))


def without(paths: tuple[Path, ...], *names: str) -> tuple[Path, ...]:
    return tuple(path for path in paths if path.name not in names)


RAM = files("core/bank_ram.v")
CORE = without(files("core/*.v"), "bank_ram.v")


def processor(mpu: int, config: str, wanted: int) -> Subject:
    with open(HDL / "isa" / "configs.toml", "rb") as table:
        parameters = gen_isa.parameters(tomllib.load(table)["config"][config], f"mpu{mpu}")
    return Subject(f"{config}_mpu{mpu}", f"MPU{mpu}", f"mpu{mpu}", files(f"mpu{mpu}.v") + CORE, RAM,
                   tuple(parameters.items()), wanted,
                   tuple(Trial("unit_rtl", "unit", f"{suites}/mpu{mpu}_{config}")
                         for suites in (f"*/Opcodes.*/mpu{mpu}_{config}:*/LoadPort.*/mpu{mpu}_{config}:*/Access.Words", "*")))


def wide(slots: int, wanted: int) -> Subject:
    return Subject(f"w{slots}_mpu4", f"MPU4, {slots} slots", "mpu4", files("wide/*.v", "core/alu.v", "core/muldiv.v"), RAM,
                   tuple(gen_wide.parameters(gen_wide.load(HDL / "isa"))[slots].items()), wanted,
                   (Trial("wide_rtl", "wide_rtl", f"*/{(4, 8, 16).index(slots)}"),))


# Of the controller's modules, those with a test of their own.
ALONE = ("rtu_line.v", "host_uart.v", "flash_port.v", "crc32.v", "time_base.v")


def controller() -> list[Subject]:
    def alone(name: str, wanted: int, trial: Trial, parameters: tuple[tuple[str, int], ...] = (),
              kept: tuple[Path, ...] = (), model: str = "") -> Subject:
        return Subject(model or name, "controller", name, files(f"controller/{name}.v"), kept, parameters, wanted, (trial,))

    bus = Subject("controller_bus", "controller", "controller_bus",
                  without(files("controller/*.v"), *ALONE, "controller.v", "controller_core.v"),
                  files(*(f"controller/{name}" for name in ALONE), "flow/*.v", "core/*.v", "peripherals/*.v", "*.v",
                        "boards/ladder_ports.v"),
                  (("CLOCKS_PER_MS", 40),), 850, (Trial("unit_scan", "controller", "-TimeBase.*"),))
    return [bus,
            alone("time_base", 100, Trial("unit_scan", "controller", "TimeBase.*"), (("CLOCKS_PER_MS", 5),)),
            alone("rtu_line", 200, Trial("unit_line", "controller", "*Line*:*Frames*"), kept=RAM),
            alone("host_uart", 50, Trial("unit_line", "controller", "*HostUart*:*Frames*"),
                  kept=files("peripherals/uart_*.v")),
            alone("flash_port", 50, Trial("unit_line", "controller", "FlashPort/0.*"), model="flash_port_1"),
            alone("crc32", 50, Trial("unit_line", "controller", "Crc.*"))]


def subjects() -> list[Subject]:
    """MPU2 with multiplier blocks, the others with sums over many clocks."""
    return [processor(1, "hx8k", 1100), processor(2, "ecp5", 1100), processor(3, "hx8k", 1100), wide(4, 1100),
            *controller()]
