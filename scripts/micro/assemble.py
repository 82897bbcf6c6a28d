# SPDX-License-Identifier: Apache-2.0
"""Code with labels to words: shortened where that changes nothing, then placed."""
from __future__ import annotations

from micro.flow import (LOCALS, blocks_of, called, drop_known, drop_stores, explicit, order, thread,
                        with_places)
from micro.front import ENTRIES, FirmwareError, Unit
from micro.isa import (JUMPS, OPCODES, OPERAND_BITS, TARGET_BITS, Instruction, Label, encode)
from micro.share import inline_once, share

Code = list[Instruction | Label]
START = "%start"
MOST_SHARED = 1000
SHARINGS = 2


def start_code() -> Code:
    """What runs after a reset: firmware_reset once, firmware_poll for ever."""
    return [Label(START), Instruction("CALL", "firmware_reset"), Label("%poll"),
            Instruction("CALL", "firmware_poll"), Instruction("JUMP", "%poll")]


def shorten(code: Code) -> Code:
    """Until nothing changes: every block with its jumps."""
    first = {START}
    blocks = thread(blocks_of(code), first)
    before = -1
    while (size := len(explicit(blocks))) != before:
        before = size
        drop_known(blocks, first | called(blocks))
        drop_stores(blocks)
        blocks = thread(blocks, first)
    return explicit(blocks)


def drop_labels(code: Code) -> Code:
    """Without labels that nothing jumps to."""
    wanted = {item.operand for item in code if isinstance(item, Instruction) and item.name in JUMPS}
    return [item for item in code if not isinstance(item, Label) or item.name in wanted]


def assemble(unit: Unit, functions: dict[str, Code], places: dict[str, int],
             rom_words: int) -> tuple[list[int], list[str]]:
    """Words, and a listing of them."""
    functions = inline_once(functions, ENTRIES)
    code: Code = start_code()
    for body in functions.values():
        code += body
    places = {**places, LOCALS: 0}
    code = shorten(with_places(code, places))
    for _ in range(SHARINGS):
        code = explicit(thread(blocks_of(share(code, MOST_SHARED)), {START}))
    code = order(thread(blocks_of(code), {START}), START)
    code = drop_labels(code)
    labels: dict[str, int] = {}
    at = 0
    for item in code:
        if isinstance(item, Label):
            labels[item.name] = at
        else:
            at += 1
    if at > rom_words:
        raise FirmwareError(f"firmware:1:1: error: {at} words of code, and the ROM has {rom_words}")
    words, listing = [], []
    for item in code:
        if isinstance(item, Label):
            listing.append(f"{item.name}:")
            continue
        operand = item.operand
        if item.name in JUMPS:
            operand = labels[operand]
        elif isinstance(operand, tuple):
            operand = (places[operand[0]] + operand[1]) % (1 << OPERAND_BITS - 1)
        words.append(encode(item.name, operand))
        listing.append(f"{len(words) - 1:5}  {words[-1]:04x}  {item}")
    assert at <= 1 << TARGET_BITS and OPCODES
    return words, listing
