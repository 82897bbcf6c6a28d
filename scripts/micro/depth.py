# SPDX-License-Identifier: Apache-2.0
"""How deep calls are in finished code, where sharing has made calls that the C text does not have."""
from __future__ import annotations

from micro.isa import JUMPS, TARGET_BITS, Instruction, Label, encode

Steps = list[tuple[str, int]]   # what an instruction does to the program counter, and where to
PLAIN = ("", 0)


def of_code(code: list[Instruction | Label]) -> int:
    """Returns that are open at most."""
    places: dict[str, int] = {}
    at = 0
    for item in code:
        if isinstance(item, Label):
            places[item.name] = at
        else:
            at += 1
    return deepest([(item.name, places[item.operand]) if item.name in JUMPS
                    else (item.name, 0) if item.name == "RETURN" else PLAIN
                    for item in code if isinstance(item, Instruction)])


def of_words(words: list[int]) -> int:
    """The same of what stands in the ROM."""
    names = {number: name for name, number in JUMPS.items()}
    back = encode("RETURN", 0)
    return deepest([(names[word >> TARGET_BITS & 3], word & (1 << TARGET_BITS) - 1) if word >> 14 == 3
                    else ("RETURN", 0) if word == back else PLAIN for word in words])


def deepest(steps: Steps) -> int:
    needs: dict[int, int] = {}

    def need(start: int) -> int:
        """Returns that are open at most while the code from `start` to its RETURNs runs, without its own."""
        if start not in needs:
            seen: set[int] = set()
            waiting, most = [start], 0
            while waiting:
                at = waiting.pop()
                if at in seen or at >= len(steps):
                    continue
                seen.add(at)
                name, target = steps[at]
                if name == "CALL":
                    most = max(most, 1 + need(target))
                elif name in JUMPS:
                    waiting.append(target)
                if name not in ("JUMP", "RETURN"):
                    waiting.append(at + 1)
            needs[start] = most
        return needs[start]

    return max((1 + need(target) for name, target in steps if name == "CALL"), default=0)
