# SPDX-License-Identifier: Apache-2.0
"""Code as basic blocks: what every path knows already is not done again, what nothing reads is not stored, and blocks
are put in an order in which few of their jumps are left."""
from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from micro.isa import COMPARES, Instruction, Label

Code = list[Instruction | Label]
Place = tuple[str, int]

LOCALS = "local"          # places of functions' variables, whoever has them: those may share them
ACC: Place = ("acc", 0)
WRITES_RAM = {"STORE", "CLEAR"}
STEPS = {"INC", "DEC"}
SETS_ACC = {"LOAD", "LOADI", "IN", "TEST", "INC", "DEC"}     # without reading it
PURE = {"LOAD", "LOADI", "TEST", "ADD", "SUB", "AND", "OR", "XOR", "ADDI", "SUBI", "ANDI", "ORI", "XORI", "ORH", "SHIFT",
        "NOT", "LOADX"}                        # do nothing else than write it
WRITES_ACC = {"ADD", "SUB", "AND", "OR", "XOR", "ADDI", "SUBI", "ANDI", "ORI", "XORI", "ORH", "SHIFT", "NOT",
              "IN", "INX", "LOADX", "TEST"}
READS_RAM = {"INDEX", "LOAD", "ADD", "SUB", "AND", "OR", "XOR", "EQ", "LTU"}


@dataclass
class Block:
    """Instructions without a jump, but for calls, and how they end: RETURN with no target, JUMP with one,
    BRANCH with two, for 0 and for anything else."""
    name: str
    body: list[Instruction]
    end: str
    targets: list[str] = field(default_factory=list)


def with_places(code: Code, places: dict[str, int]) -> Code:
    """Functions' variables by their places in RAM."""
    out: Code = []
    for item in code:
        if isinstance(item, Instruction) and isinstance(item.operand, tuple) and ":" in item.operand[0]:
            item = Instruction(item.name, (LOCALS, places[item.operand[0]]))
        out.append(item)
    return out


def blocks_of(code: Code) -> list[Block]:
    """Every label begins a block; a jump ends it."""
    names = {item.name for item in code if isinstance(item, Label)}
    made = 0
    blocks: list[Block] = []
    now: Block | None = None
    same: dict[str, str] = {}            # labels of one place
    for item in code:
        if isinstance(item, Label):
            if now is not None and not now.body and not now.end:
                same[item.name] = now.name
                continue
            if now is not None and not now.end:
                now.end, now.targets = "JUMP", [item.name]
            now = Block(item.name, [], "")
            blocks.append(now)
        elif now is None or now.end == "RETURN" or now.end == "JUMP":
            continue                     # nothing reaches it
        elif item.name in ("JZ", "JNZ"):
            made += 1
            while f"%b{made}" in names:
                made += 1
            following = Block(f"%b{made}", [], "")
            now.end = "BRANCH"
            now.targets = [item.operand, following.name] if item.name == "JZ" else [following.name, item.operand]
            now = following
            blocks.append(now)
        elif item.name in ("JUMP", "RETURN"):
            now.end, now.targets = item.name, [item.operand] if item.name == "JUMP" else []
        else:
            now.body.append(item)
    for block in blocks:
        assert block.end, block.name
        block.targets = [same.get(target, target) for target in block.targets]
        for item in block.body:
            if item.name == "CALL":
                item.operand = same.get(item.operand, item.operand)
    return blocks


def tests(block: Block) -> bool:
    """Whether the block's branch goes by the comparison at its end, not by the accumulator."""
    return block.end == "BRANCH" and bool(block.body) and block.body[-1].name in COMPARES


def without_dead_tests(body: list[Instruction], tested: bool) -> list[Instruction]:
    """Without comparisons that nothing goes by: no TEST behind them, and at the end no branch (`tested`) that does.

    They would not only be idle: at the end of a block, a branch by the accumulator would go by them.
    """
    behind = [*(item.name for item in body[1:]), "TEST" if tested else ""]
    return [item for item, following in zip(body, behind) if item.name not in COMPARES or following == "TEST"]


def thread(blocks: list[Block], keep: set[str]) -> list[Block]:
    """Without jumps to blocks that only jump, equal branches, and blocks that nothing reaches."""
    named = {block.name: block for block in blocks}
    bare = next((block.name for block in blocks if not block.body and block.end == "RETURN"), None)

    def last(name: str) -> str:
        seen = {name}
        while not named[name].body and named[name].end == "JUMP" and named[name].targets[0] not in seen:
            name = named[name].targets[0]
            seen.add(name)
        return bare if bare and not named[name].body and named[name].end == "RETURN" else name

    for block in blocks:
        block.targets = [last(target) for target in block.targets]
        if block.end == "BRANCH" and block.targets[0] == block.targets[1]:
            if tests(block):
                block.body.pop()
            block.end, block.targets = "JUMP", block.targets[:1]
        if block.end == "JUMP":
            target = named[block.targets[0]]
            if not target.body and target is not block:
                block.end, block.targets = target.end, list(target.targets)
        for item in block.body:
            if item.name == "CALL":
                item.operand = last(item.operand)
        if block.end == "RETURN" and block.body and block.body[-1].name == "CALL":
            block.end, block.targets = "JUMP", [block.body.pop().operand]
    reached: set[str] = set()
    todo = list(keep)
    while todo:
        name = todo.pop()
        if name not in reached:
            reached.add(name)
            todo += named[name].targets
            todo += [item.operand for item in named[name].body if item.name == "CALL"]
    return join([block for block in blocks if block.name in reached], keep)


def join(blocks: list[Block], keep: set[str]) -> list[Block]:
    """A block that only one other ends in becomes part of that."""
    named = {block.name: block for block in blocks}
    uses = Counter(target for block in blocks for target in block.targets)
    uses.update(item.operand for block in blocks for item in block.body if item.name == "CALL")
    gone: set[str] = set()
    for block in blocks:
        if block.name in gone:
            continue
        while block.end == "JUMP":
            target = named[block.targets[0]]
            if uses[target.name] != 1 or target.name in keep or target is block:
                break
            gone.add(target.name)
            block.body = block.body + target.body
            block.end, block.targets = target.end, target.targets
    return [block for block in blocks if block.name not in gone]


# ---- what is known -----------------------------------------------------------------------------------
@dataclass(frozen=True)
class Known:
    """Places that hold what the accumulator holds, its value, and values of places."""
    same: frozenset[Place] = frozenset()
    value: int | None = None
    places: frozenset[tuple[Place, int]] = frozenset()
    copies: frozenset[tuple[Place, Place]] = frozenset()   # local places and what they are copies of

    def meet(self, other: Known) -> Known:
        return Known(self.same & other.same, self.value if self.value == other.value else None,
                     self.places & other.places, self.copies & other.copies)


def with_value(known: Known, value: int) -> Known:
    """The accumulator turns out to hold `value`."""
    places = dict(known.places)
    places.update(dict.fromkeys(known.same, value))
    same = known.same | {place for place, each in places.items() if each == value}
    return Known(frozenset(same), value, frozenset(places.items()), known.copies)


def without(known: Known, lost: set[str | Place]) -> Known:
    """Behind something that writes places, arrays named by their names."""
    def kept(place: Place) -> bool:
        return place not in lost and place[0] not in lost
    return Known(frozenset(p for p in known.same if kept(p)), known.value,
                 frozenset((p, v) for p, v in known.places if kept(p)),
                 frozenset((p, q) for p, q in known.copies if kept(p) and kept(q)))


def written(blocks: list[Block]) -> dict[str, set[str | Place]]:
    """For each function that is called: places that a call may write, arrays by their names."""
    named = {block.name: block for block in blocks}
    own: dict[str, set[str | Place]] = {
        block.name: {item.operand[0] if item.name == "STOREX" else item.operand for item in block.body
                     if item.name in ("STOREX", *WRITES_RAM, *STEPS)} for block in blocks}
    found = {}
    for name in called(blocks):
        seen: set[str] = set()
        todo = [name]
        while todo:
            at = todo.pop()
            if at not in seen:
                seen.add(at)
                todo += named[at].targets
                todo += [item.operand for item in named[at].body if item.name == "CALL"]
        found[name] = set().union(*(own[each] for each in seen))
    return found


def step(known: Known, item: Instruction, writes: dict[str, set[str | Place]]) -> tuple[Known, bool]:
    """What is known behind an instruction, and whether the instruction is needed."""
    name, operand = item.name, item.operand
    if name == "LOAD":
        if operand in known.same:
            return known, False
        value = dict(known.places).get(operand)
        if value is not None:
            if value == known.value:
                return with_value(known, value), False
            return with_value(Known(frozenset({operand}), None, known.places, known.copies), value), True
        return Known(frozenset({operand}), None, known.places, known.copies), True
    if name == "LOADI":
        if known.value == operand:
            return known, False
        return with_value(Known(frozenset(), None, known.places, known.copies), operand), True
    if name == "STORE":
        if operand in known.same:
            return known, False
        kept = without(known, {operand})
        copies = {*kept.copies, *((operand, p) for p in kept.same if local(p) and local(operand))}
        places = kept.places if known.value is None else {*kept.places, (operand, known.value)}
        return Known(kept.same | {operand}, known.value, frozenset(places), frozenset(copies)), True
    if name == "CLEAR":
        if (operand, 0) in known.places:
            return known, False
        kept = without(known, {operand})
        same = kept.same | {operand} if kept.value == 0 else kept.same
        return Known(same, kept.value, kept.places | {(operand, 0)}, kept.copies), True
    if name in STEPS:
        kept = without(known, {operand})
        return Known(frozenset({operand}), None, kept.places, kept.copies), True
    if name == "STOREX":
        return without(known, {operand[0]}), True
    if name == "CALL":
        kept = without(known, writes[operand])
        return Known(places=kept.places, copies=kept.copies), True
    if name in WRITES_ACC:
        return Known(frozenset(), None, known.places, known.copies), True
    return known, True


def drop_known(blocks: list[Block], entries: set[str]) -> None:
    """Drops instructions that change nothing; `entries` are reached with anything."""
    named = {block.name: block for block in blocks}
    writes = written(blocks)
    before: dict[str, Known] = {name: Known() for name in entries}
    todo = sorted(entries)
    while todo:
        name = todo.pop()
        block, known = named[name], before[name]
        for item in block.body:
            known, _ = step(known, item, writes)
        for i, target in enumerate(block.targets):
            there = edge(block, known, i)
            new = there if target not in before else before[target].meet(there)
            if target not in before or new != before[target]:
                before[target] = new
                todo.append(target)
    for block in blocks:
        known, tested = before[block.name], tests(block)
        body = []
        for item in block.body:
            if item.name in READS_RAM:
                item.operand = min((q for p, q in known.copies if p == item.operand), default=item.operand)
            if item.name == "STORE" and known.value == 0:
                item = Instruction("CLEAR", item.operand)
            known, needed = step(known, item, writes)
            if needed:
                body.append(item)
        block.body = without_dead_tests(body, tested)
        if block.end == "BRANCH" and known.value is not None and not tested:
            block.end, block.targets = "JUMP", [block.targets[known.value != 0]]


def edge(block: Block, known: Known, which: int) -> Known:
    """What is known on the way to one of a block's targets."""
    if block.end != "BRANCH":
        return known
    if not tests(block):
        return with_value(known, 0) if which == 0 else known
    test = block.body[-1]
    if which == 1 and test.name == "EQI":
        return with_value(known, test.operand)
    if which == 1 and test.name == "LTUI" and test.operand == 1:
        return with_value(known, 0)
    if which == 1 and test.name == "EQ":
        return Known(known.same | {test.operand}, known.value, known.places, known.copies)
    return known


# ---- what is read ------------------------------------------------------------------------------------
def local(place: object) -> bool:
    return isinstance(place, tuple) and place[0] == LOCALS


def live_before(block: Block, live: set[Place], reads: dict[str, set[Place]]) -> set[Place]:
    """Places that are read behind the block's beginning, the accumulator among them."""
    live = set(live)
    if block.end == "RETURN" or block.end == "BRANCH" and not tests(block):
        live.add(ACC)
    for item in reversed(block.body):
        if item.name in SETS_ACC:
            live.discard(ACC)
        elif item.name == "CALL":
            live.discard(ACC)
        elif item.name not in ("INDEX", "CLEAR"):
            live.add(ACC)
        if item.name == "CALL":
            live |= reads.get(item.operand, set())
        elif item.name in WRITES_RAM:
            live.discard(item.operand)
        elif item.name in (*READS_RAM, *STEPS) and local(item.operand):
            live.add(item.operand)
    return live


def drop_stores(blocks: list[Block]) -> None:
    """Stores into local variables that nothing reads any more."""
    live: dict[str, set[Place]] = {block.name: set() for block in blocks}
    changed = True
    while changed:
        changed = False
        for block in reversed(blocks):
            after = set().union(*(live[target] for target in block.targets))
            before = live_before(block, after, live)
            if before != live[block.name]:
                live[block.name] = before
                changed = True
    for block in blocks:
        now = live_before(Block("", [], block.end), set().union(*(live[target] for target in block.targets)), live)
        tested = tests(block)
        if tested and not any(ACC in live[target] for target in block.targets):
            now.discard(ACC)
        body = []
        for item in reversed(block.body):
            if item.name in PURE and ACC not in now:
                continue
            if item.name in WRITES_RAM and local(item.operand) and item.operand not in now:
                continue
            if item.name in STEPS and local(item.operand) and item.operand not in now and ACC not in now:
                continue
            now = live_before(Block("", [item], ""), now, live)
            body.append(item)
        block.body = without_dead_tests(body[::-1], tested)


def called(blocks: list[Block]) -> set[str]:
    return {item.operand for block in blocks for item in block.body if item.name == "CALL"}


# ---- the order ---------------------------------------------------------------------------------------
def order(blocks: list[Block], first: str) -> Code:
    """Blocks as code, as many as can be right behind one that ends in them."""
    behind = without_rings(matching(blocks, first))
    taken = {first, *behind.values()}
    named = {block.name: block for block in blocks}
    code: Code = []
    starts = [first, *(block.name for block in blocks if block.name not in taken)]
    for name in starts:
        at: str | None = name
        while at is not None:
            block, following = named[at], behind.get(at)
            code += [Label(at), *block.body, *ending(block, following)]
            at = following
    return code


def matching(blocks: list[Block], first: str) -> dict[str, str]:
    """Block -> the one that follows it, for as many as possible (Kuhn's algorithm)."""
    targets = {block.name: block.targets for block in blocks}
    before: dict[str, str] = {}

    def place(name: str, seen: set[str]) -> bool:
        for target in targets[name]:
            if target == first or target == name or target in seen:
                continue
            seen.add(target)
            if target not in before or place(before[target], seen):
                before[target] = name
                return True
        return False

    for name in sorted(targets, key=lambda each: len(targets[each])):
        place(name, set())
    return {name: target for target, name in before.items()}


def without_rings(behind: dict[str, str]) -> dict[str, str]:
    """A ring of blocks is opened somewhere."""
    behind = dict(behind)
    done: set[str] = set()
    for name in list(behind):
        path: list[str] = []
        at: str | None = name
        while at is not None and at not in done:
            done.add(at)
            path.append(at)
            at = behind.get(at)
        if at is not None and at in path:
            del behind[at]
    return behind


def ending(block: Block, following: str | None) -> Code:
    if block.end == "RETURN":
        return [Instruction("RETURN")]
    if block.end == "JUMP":
        return [] if block.targets[0] == following else [Instruction("JUMP", block.targets[0])]
    zero, other = block.targets
    if zero == following:
        return [Instruction("JNZ", other)]
    rest: Code = [] if other == following else [Instruction("JUMP", other)]
    return [Instruction("JZ", zero), *rest]


def explicit(blocks: list[Block]) -> Code:
    """Blocks as code in which every block ends with all of its jumps."""
    code: Code = []
    for block in blocks:
        code += [Label(block.name), *block.body, *ending(block, None)]
    return code
