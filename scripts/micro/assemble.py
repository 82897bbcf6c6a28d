# SPDX-License-Identifier: Apache-2.0
"""Code with labels to words: shortened where that changes nothing, then placed."""
from __future__ import annotations

from micro.front import ENTRIES, FirmwareError, Unit
from micro.isa import (JUMPS, OPCODES, TARGET_BITS, Instruction, Label, encode)
from micro.share import inline_once, share

Code = list[Instruction | Label]
ENDS = ("JUMP", "RETURN")
MOST_SHARED = 1000


def start_code() -> Code:
    """What runs after a reset: firmware_reset once, firmware_poll for ever."""
    return [Instruction("CALL", "firmware_reset"), Label("%poll"),
            Instruction("CALL", "firmware_poll"), Instruction("JUMP", "%poll")]


def shorten(code: Code) -> Code:
    """Jumps to jumps, jumps to the next instruction, what nothing reaches, a LOAD of what was just stored,
    and calls that end a function: until nothing changes."""
    while True:
        shorter = drop_unreached(drop_jumps_to_next(thread(tail_calls(drop_loads(code)))))
        if len(shorter) == len(code) and [str(a) for a in shorter] == [str(a) for a in code]:
            return code
        code = shorter


def next_instruction(code: Code, at: int) -> Instruction | None:
    while at < len(code) and isinstance(code[at], Label):
        at += 1
    return code[at] if at < len(code) else None


def thread(code: Code) -> Code:
    places = {item.name: i for i, item in enumerate(code) if isinstance(item, Label)}
    out: Code = []
    for item in code:
        if isinstance(item, Instruction) and item.name in JUMPS and item.name != "CALL":
            seen = set()
            target = item.operand
            while target not in seen and target in places:
                seen.add(target)
                following = next_instruction(code, places[target])
                if following is None or following.name != "JUMP":
                    break
                target = following.operand
            following = next_instruction(code, places[target]) if target in places else None
            if item.name == "JUMP" and following is not None and following.name == "RETURN":
                item = Instruction("RETURN")
            else:
                item = Instruction(item.name, target)
        out.append(item)
    return out


def drop_jumps_to_next(code: Code) -> Code:
    out: Code = []
    for i, item in enumerate(code):
        if isinstance(item, Instruction) and item.name in ("JUMP", "JZ", "JNZ"):
            at = i + 1
            names = []
            while at < len(code) and isinstance(code[at], Label):
                names.append(code[at].name)
                at += 1
            if item.operand in names:
                continue
        out.append(item)
    return out


def drop_unreached(code: Code) -> Code:
    wanted = {item.operand for item in code if isinstance(item, Instruction) and item.name in JUMPS}
    out: Code = []
    reached = True
    for item in code:
        if isinstance(item, Label):
            if item.name in wanted:
                reached = True
                out.append(item)
        elif reached:
            out.append(item)
            reached = item.name not in ENDS
    return out


def drop_loads(code: Code) -> Code:
    out: Code = []
    for item in code:
        before = out[-1] if out else None
        if (isinstance(item, Instruction) and item.name == "LOAD" and isinstance(before, Instruction)
                and before.name in ("STORE", "LOAD") and before.operand == item.operand):
            continue
        out.append(item)
    return out


def tail_calls(code: Code) -> Code:
    out: Code = []
    for i, item in enumerate(code):
        if isinstance(item, Instruction) and item.name == "CALL":
            following = next_instruction(code, i + 1)
            if following is not None and following.name == "RETURN":
                out.append(Instruction("JUMP", item.operand))
                continue
        out.append(item)
    return out


def order_functions(functions: dict[str, Code]) -> list[str]:
    """A function that another one ends with a jump to follows it, where it can: the jump falls away."""
    left = list(functions)
    order: list[str] = []
    while left:
        name: str | None = left[0]
        while name is not None:
            left.remove(name)
            order.append(name)
            last = [item for item in functions[name] if isinstance(item, Instruction)][-1]
            name = last.operand if last.name == "JUMP" and last.operand in left else None
    return order


def assemble(unit: Unit, functions: dict[str, Code], places: dict[str, int],
             rom_words: int) -> tuple[list[int], list[str]]:
    """Words, and a listing of them."""
    functions = {name: tail_calls(drop_loads(code)) for name, code in functions.items()}
    functions = inline_once(functions, ENTRIES)
    code: Code = start_code()
    for name in order_functions(functions):
        code += functions[name]
    code = shorten(share(shorten(code), MOST_SHARED))
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
            operand = places[operand[0]] + operand[1]
        words.append(encode(item.name, operand))
        listing.append(f"{len(words) - 1:5}  {words[-1]:04x}  {item}")
    assert at <= 1 << TARGET_BITS and OPCODES
    return words, listing
