# SPDX-License-Identifier: Apache-2.0
"""Places of variables in RAM: global ones first, then each function's behind those of every function that may be
calling it, so that functions which are never under way together share their words."""
from __future__ import annotations

from micro.front import ENTRIES, INTRINSICS, Unit


def depth_order(unit: Unit) -> list[str]:
    """Functions, callers before those they call."""
    order: list[str] = []

    def visit(name: str) -> None:
        if name in order or name in INTRINSICS:
            return
        for called in sorted(unit.functions[name].calls):
            visit(called)
        order.append(name)

    for entry in ENTRIES:
        visit(entry)
    return order[::-1]


def place_variables(unit: Unit, first: int) -> tuple[dict[str, int], int]:
    """Name -> address, and how many words there are from 0 on."""
    places: dict[str, int] = {}
    next_free = first
    # Arrays last: an index that is out of bounds should not meet a scalar.
    for name, words in sorted(unit.globals.items(), key=lambda each: each[0] in unit.arrays):
        places[name] = next_free
        next_free += words
    base = dict.fromkeys(unit.functions, next_free)
    end = next_free
    for name in depth_order(unit):
        function = unit.functions[name]
        after = base[name] + len(function.locals)
        for i, variable in enumerate(function.locals):
            places[f"{name}:{variable}"] = base[name] + i
        for called in function.calls - set(INTRINSICS):
            base[called] = max(base[called], after)
        end = max(end, after)
    return places, end
