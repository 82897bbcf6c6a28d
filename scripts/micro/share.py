# SPDX-License-Identifier: Apache-2.0
"""Code made shorter as a whole: functions that are called once stand at their call, and what stands in several
places stands once."""
from __future__ import annotations

from collections import Counter, defaultdict

from micro import depth
from micro.isa import JUMPS, RETURN_DEPTH, Instruction, Label

Code = list[Instruction | Label]
SHORTEST, LONGEST = 2, 24


def inline_once(functions: dict[str, Code], entries: tuple[str, ...]) -> dict[str, Code]:
    """Each function with one call replaces it."""
    functions = dict(functions)
    while True:
        calls = Counter(item.operand for code in functions.values() for item in code
                        if isinstance(item, Instruction) and item.name in ("CALL", "JUMP"))
        once = next((name for name in functions if name not in entries and calls[name] == 1), None)
        if once is None:
            return functions
        body = functions.pop(once)
        for name, code in functions.items():
            at = next((i for i, item in enumerate(code) if isinstance(item, Instruction)
                       and item.name in ("CALL", "JUMP") and item.operand == once), None)
            if at is not None:
                functions[name] = code[:at] + at_its_call(once, body, code[at].name) + code[at + 1:]
                break


def at_its_call(name: str, body: Code, how: str) -> Code:
    """The function's code without its name; its returns go behind it, or are the caller's own."""
    body = [item for item in body if not (isinstance(item, Label) and item.name == name)]
    if how == "JUMP":
        return body
    end = f"{name}.end"
    out: Code = []
    for item in body:
        if isinstance(item, Instruction) and item.name == "RETURN":
            item = Instruction("JUMP", end)
        out.append(item)
    # A call that was made a jump because it ends the function is a call again.
    return restore_calls(out, end) + [Label(end)]


def restore_calls(code: Code, end: str) -> Code:
    """Jumps to functions, which have no dot in their names, as calls and a jump to `end`."""
    out: Code = []
    for item in code:
        if (isinstance(item, Instruction) and item.name == "JUMP" and isinstance(item.operand, str)
                and "." not in item.operand):
            out += [Instruction("CALL", item.operand), Instruction("JUMP", end)]
        else:
            out.append(item)
    return out


def key(item: Instruction) -> tuple[str, object]:
    return (item.name, item.operand)


def windows(code: Code) -> dict[tuple, list[int]]:
    """Sequences of instructions without a jump inside, and where they begin; they may end with one."""
    found: dict[tuple, list[int]] = defaultdict(list)
    for start in range(len(code)):
        sequence: list[tuple[str, object]] = []
        branches = False
        for item in code[start:start + LONGEST]:
            if isinstance(item, Label):
                break
            sequence.append(key(item))
            branches = branches or item.name in ("JZ", "JNZ")
            if len(sequence) >= SHORTEST and (not branches or item.name in ("JUMP", "RETURN")):
                found[tuple(sequence)].append(start)
            if item.name in ("JUMP", "RETURN"):
                break
    return found


def apart(starts: list[int], length: int) -> list[int]:
    """Those that do not overlap."""
    out: list[int] = []
    for start in starts:
        if not out or start >= out[-1] + length:
            out.append(start)
    return out


def gain(sequence: tuple, count: int) -> int:
    """Words saved by one copy instead of `count`; a tail is jumped to, what is no tail called."""
    length = len(sequence)
    if sequence[-1][0] in ("JUMP", "RETURN"):
        return (count - 1) * (length - 1)
    return count * (length - 1) - length - 1


def share(code: Code, routines: int) -> Code:
    """Takes out the best sequence, of equal ones the longest, again and again; not one whose call would be
    one too deep."""
    made = 0
    too_deep: set[tuple] = set()
    while made < routines:
        best, places = max(((sequence, apart(starts, len(sequence)))
                            for sequence, starts in windows(code).items()
                            if len(starts) > 1 and sequence not in too_deep),
                           key=lambda each: (gain(each[0], len(each[1])), len(each[0])), default=((), []))
        if not best or gain(best, len(places)) < 0:  # what gains nothing yet may end alike
            return code
        shorter = take_out(code, best, places, fresh(code))
        if depth.of_code(shorter) > RETURN_DEPTH:
            too_deep.add(best)
            continue
        made += 1
        code = shorter
    return code


def fresh(code: Code) -> str:
    """A name for a sequence that no label has yet."""
    used = {item.name for item in code if isinstance(item, Label)}
    return next(name for name in (f"%{n}.shared" for n in range(1, len(code) + 2)) if name not in used)


def take_out(code: Code, sequence: tuple, places: list[int], name: str) -> Code:
    tail = sequence[-1][0] in ("JUMP", "RETURN")
    body: Code = [Label(name), *(Instruction(n, operand) for n, operand in sequence)]
    if not tail:
        body.append(Instruction("RETURN"))
    out: Code = []
    at = 0
    for place in places:
        out += code[at:place]
        out.append(Instruction("JUMP" if tail else "CALL", name))
        at = place + len(sequence)
    return out + code[at:] + body


__all__ = ["JUMPS", "inline_once", "share"]
