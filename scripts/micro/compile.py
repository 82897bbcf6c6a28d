# SPDX-License-Identifier: Apache-2.0
"""The compiler as a whole, and the ROM as Verilog."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from micro import depth, layout
from micro.assemble import assemble
from micro.front import FirmwareError, parse, preprocess
from micro.isa import RETURN_DEPTH
from micro.statements import generate


@dataclass
class Firmware:
    """Compiled firmware: its code and what it needs."""
    words: list[int]
    ram_words: int
    depth: int               # returns open at most
    listing: list[str]
    places: dict[str, int]   # of variables, by name; a function's as function:name


def compile_text(text: str, name: str, micro: dict[str, int]) -> Firmware:
    """`micro` is [micro] of controller.toml. Raises FirmwareError."""
    unit = parse(text, name)
    functions = generate(unit)
    places, ram_words = layout.place_variables(unit, 0)
    room = micro["ram_words"] - RETURN_DEPTH
    if ram_words > room:
        raise FirmwareError(f"{name}:1:1: error: {ram_words} words of variables, and the RAM has {room}")
    words, listing = assemble(unit, functions, places, micro["rom_words"])
    deep = depth.of_words(words)
    if deep > RETURN_DEPTH:
        raise FirmwareError(f"{name}:1:1: error: calls {deep} deep, and {RETURN_DEPTH} returns are kept")
    return Firmware(words, ram_words, deep, listing, places)


def compile_file(source: Path, include: list[Path], defines: list[str],
                 micro: dict[str, int]) -> Firmware:
    return compile_text(preprocess(source, include, defines), str(source), micro)

