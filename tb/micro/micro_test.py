# SPDX-License-Identifier: Apache-2.0
"""C programs on the micro-sequencer and from gcc: the same reads and writes of the bus, in the same order.

usage: micro_test.py MICRO_RUN GENERATED programs    those of programs/
       micro_test.py MICRO_RUN GENERATED random      random ones; RUNG_SEED the first seed, RUNG_COUNT how many
       micro_test.py MICRO_RUN GENERATED depth       as many calls as the return stack holds, and one more
       micro_test.py MICRO_RUN GENERATED errors      what the compiler refuses, and how it says so
       micro_test.py MICRO_RUN GENERATED firmware    the controller's firmware on a bus that answers at random
"""
from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Callable
from dataclasses import dataclass, field
from multiprocessing import Pool
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))

from micro.compile import compile_file, compile_text  # noqa: E402
from micro.front import FirmwareError  # noqa: E402
from micro.isa import RETURN_DEPTH  # noqa: E402
from random_program import random_program  # noqa: E402

MICRO = tomllib.loads((ROOT / "hdl" / "isa" / "controller.toml").read_text())["micro"]
EVENTS, POLLS = 600, 4
MOST_CLOCKS = 30_000_000  # random answers of the bus can send the firmware through loops of 65,536
FIRMWARE = ROOT / "hdl" / "controller" / "micro" / "firmware" / "firmware.c"


@dataclass
class Program:
    name: str
    source: Path
    seed: int
    include: list[Path] = field(default_factory=list)
    defines: list[str] = field(default_factory=list)
    events: int = EVENTS
    polls: int = POLLS


def compiled(program: Program) -> list[int] | str:
    try:
        return compile_file(program.source, program.include, program.defines, MICRO).words
    except FirmwareError as error:
        return str(error)


WORDS: dict[str, list[int] | str] = {}


def compiled_once(program: Program) -> list[int] | str:
    """The same source and definitions are compiled once."""
    key = f"{program.source} {program.defines}"
    if key not in WORDS:
        WORDS[key] = compiled(program)
    return WORDS[key]


def gcc(*arguments: str) -> None:
    # Warnings are about style that random programs do not have.
    subprocess.run(["gcc", "-std=c11", "-w", *arguments], check=True)


def native(folder: Path, programs: list[Program], together: bool) -> dict[str, list[str]]:
    """Events of each program from gcc; `together`: all in one file, as their names differ."""
    listed, objects, text = folder / "programs.inc", [], []
    listed.write_text("".join(f"PROGRAM({p.name}, {p.seed}u)\n" for p in programs))
    for program in programs:
        text += [f"#undef {each}\n#define {each} {program.name}{each.removeprefix('firmware')}\n"
                 for each in ("firmware_reset", "firmware_poll")] + [f'#include "{program.source}"\n']
        if not together or program is programs[-1]:
            unit = folder / f"native_{program.name}.c"
            unit.write_text("".join(text))
            objects.append(str(unit.with_suffix(".o")))
            gcc("-O0" if together else "-O1", *(f"-I{path}" for path in program.include),
                *(f"-D{define}" for define in program.defines), "-c", str(unit), "-o", objects[-1])
            text = []
    gcc("-O1", f'-DPROGRAMS="{listed}"', str(HERE / "native.c"), *objects, "-o", str(folder / "native"))
    return events(subprocess.run([str(folder / "native"), str(programs[0].events), str(programs[0].polls)],
                                 capture_output=True, text=True, check=True).stdout)


def events(text: str) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for line in text.splitlines():
        if line[:2] in ("r ", "w "):
            found[name].append(line)
        else:
            name = line
            found[name] = []
    return found


def compare(run: str, programs: list[Program], together: bool, again: str,
            compiler: Callable[[Program], list[int] | str] | None = None) -> int:
    """How many programs differ. Without a compiler of its own, two processes compile."""
    with tempfile.TemporaryDirectory() as scratch, Pool(2) as pool:
        waiting = None if compiler else pool.map_async(compiled, programs, 4)
        wanted = native(Path(scratch), programs, together)
        words = waiting.get() if waiting else [compiler(program) for program in programs]
        jobs, bad = [], set()
        for program, code in zip(programs, words, strict=True):
            if isinstance(code, str):
                print(f"{program.name}: refused: {code}\n  {again.format(program.seed)}")
                bad.add(program.name)
                continue
            jobs.append(f"{program.name} {program.seed} {len(wanted[program.name])} {MOST_CLOCKS} {len(code)} "
                        + " ".join(f"{word:x}" for word in code))
        done = subprocess.run([run], input="\n".join(jobs), capture_output=True, text=True, check=False)
    got = events(done.stdout)
    print(done.stderr, end="")
    for program in programs:
        mine, right = got.get(program.name, []), wanted[program.name]
        if program.name not in bad and mine != right:
            at = next((i for i, (a, b) in enumerate(zip(mine, right)) if a != b), min(len(mine), len(right)))
            is_, should = ((each[at] if at < len(each) else "missing") for each in (mine, right))
            print(f"{program.name}: event {at} is {is_}, natively {should}\n  {again.format(program.seed)}")
            bad.add(program.name)
    total = sum(len(each) for each in wanted.values())
    print(f"{len(programs)} programs, {total} reads and writes of the bus, {len(bad)} programs differ")
    # A test that compares nothing must not pass.
    return len(bad) + (1 if done.returncode and not bad else 0) + (total == 0)


def test_programs(run: str, _: Path) -> int:
    defines = [f"REGISTERS={MICRO['registers']}"]
    programs = [Program(path.stem, path, 1 + i, [], defines)
                for i, path in enumerate(sorted((HERE / "programs").glob("*.c")))]
    return compare(run, programs, False, "programs/, seed of the bus {}")


def test_random(run: str, _: Path) -> int:
    first = int(os.environ.get("RUNG_SEED", time.time_ns() % 1_000_000_000))
    count = int(os.environ.get("RUNG_COUNT", 100))
    print(f"seeds from {first} on; again: RUNG_SEED={first} RUNG_COUNT={count} python3 {' '.join(sys.argv)}")
    with tempfile.TemporaryDirectory() as scratch:
        programs = []
        for i in range(count):
            name = f"t{i}"
            path = Path(scratch) / f"{name}.c"
            path.write_text(random_program(name, first + i, MICRO["registers"]))
            programs.append(Program(name, path, first + i))
        bad = compare(run, programs, True, f"again: RUNG_SEED={{}} RUNG_COUNT=1 python3 {' '.join(sys.argv)}")
        if bad and count == 1:
            print(programs[0].source.read_text())
        return bad


def chain(depth: int) -> str:
    """Calls `depth` deep, with that of firmware_poll; each twice, so that none stands at its call."""
    text = ["typedef unsigned short u16;\nu16 io_read(u16 address);\nvoid io_write(u16 address, u16 value);\n",
            # The deepest has what is worth sharing, were there a return left for it.
            "static u16 sum;\nstatic void f2(u16 a) {\n",
            "if (a & 1) io_write(5, a);\n".join(
                ["sum = (sum << 1) + a; io_write(3, sum); sum = (sum ^ 0x1234) - a;\n"] * 4), "}\n"]
    for i in range(3, depth + 1):
        text.append(f"static void f{i}(u16 a) {{ if (sum & {1 << i % 16}) {{ f{i - 1}(a + {i}); io_write({i}, a); }}"
                    f" else {{ f{i - 1}(a ^ {i}); sum = sum - a; }} }}\n")
    return "".join(text) + ("void firmware_reset(void) { }\nvoid firmware_poll(void) {\n"
                            f"f{depth}(1); f{depth}(sum); io_write(1, sum); }}\n")


def test_depth(run: str, _: Path) -> int:
    with tempfile.TemporaryDirectory() as scratch:
        programs = []
        for depth in range(2, RETURN_DEPTH + 1):
            path = Path(scratch) / f"deep{depth}.c"
            path.write_text(chain(depth))
            programs.append(Program(path.stem, path, depth))
        bad = compare(run, programs, False, "calls {} deep")
    if not bad:
        deepest = compile_text(chain(RETURN_DEPTH), "deep.c", MICRO).depth
        bad = deepest != RETURN_DEPTH
        print(f"{RETURN_DEPTH} calls are said to be {deepest}")
    try:
        compile_text(chain(RETURN_DEPTH + 1), "deep.c", MICRO)
        print(f"{RETURN_DEPTH + 1} calls deep was not refused")
        bad += 1
    except FirmwareError as error:
        print(f"refused: {error}")
        bad += "deep" not in str(error)
    return bad


def test_errors(_: str, __: Path) -> int:
    """errors/*.c: each has a line with `// error: text` where the error must be, or `// error anywhere: text`."""
    bad = 0
    files = sorted((HERE / "errors").glob("*.c"))
    for path in files:
        lines = path.read_text().splitlines()
        wanted = [(i + 1, m) for i, line in enumerate(lines) if (m := re.search(r"// error( anywhere)?: (.*)", line))]
        assert len(wanted) == 1, path
        line, match = wanted[0]
        try:
            compile_file(path, [], [], MICRO)
            print(f"{path.name}: not refused")
            bad += 1
            continue
        except FirmwareError as error:
            said = str(error)
        place = rf"{re.escape(str(path))}:{r'[0-9]+' if match[1] else line}:[0-9]+: error: "
        if not re.match(place, said) or match[2] not in said:
            print(f"{path.name}: wanted line {line}, \"{match[2]}\"\n  got {said}")
            bad += 1
    print(f"{len(files)} programs refused, {bad} of them not as they should be")
    return bad + (not files)


def test_firmware(run: str, generated: Path) -> int:
    with (ROOT / "hdl" / "isa" / "configs.toml").open("rb") as f:
        configs = tomllib.load(f)["config"]
    bad = 0
    for name in configs:
        for seed in (1, 2, 3):
            program = Program(f"{name}_{seed}", FIRMWARE, seed, [generated, FIRMWARE.parent], [f"RUNG_CONFIG={name}"],
                              20000, 400)
            bad += compare(run, [program], False, "seed of the bus {}", compiled_once)
    return bad


def main() -> int:
    if len(sys.argv) != 4 or f"test_{sys.argv[3]}" not in globals():
        print(__doc__, file=sys.stderr)
        return 2
    return min(1, globals()[f"test_{sys.argv[3]}"](sys.argv[1], Path(sys.argv[2])))


if __name__ == "__main__":
    sys.exit(main())
