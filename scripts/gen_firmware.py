# SPDX-License-Identifier: Apache-2.0
"""The micro-sequencer's ROM, rung_micro_rom.vh, and its depths, rung_micro_rom_words.vh, from the firmware: part of
gen_isa.py. It is compiled anew only when the firmware, the tables or the compiler have changed."""
import hashlib
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FIRMWARE = ROOT / "hdl" / "controller" / "micro" / "firmware"
ROM_STEP = 256     # words that a ROM's depth is a multiple of
COMPILER = ROOT / "scripts" / "micro"
MAIN = """
import json, sys
from pathlib import Path
from micro.compile import compile_file
from micro.front import FirmwareError
job = json.load(sys.stdin)
try:
    made = {name: compile_file(Path(job["source"]), [Path(job["include"])],
                               [f"RUNG_CONFIG={name}"], job["micro"]) for name in job["ids"]}
except FirmwareError as error:
    sys.exit(str(error))
json.dump({name: {"words": f.words, "ram_words": f.ram_words, "depth": f.depth, "listing": f.listing}
           for name, f in made.items()}, sys.stdout)
"""


def fingerprint(out):
    """Of everything that the ROM depends on."""
    h = hashlib.sha256()
    for path in sorted([*FIRMWARE.glob("*.c"), *COMPILER.glob("*.py"), Path(__file__),
                        out / "rung_controller.h"]):
        h.update(path.name.encode() + path.read_bytes())
    return h.hexdigest()


def compiled(out, tables):
    """Configuration -> words, ram_words, depth, listing. The interpreter is the system's, which has pycparser
    (Debian python3-pycparser), whatever runs this."""
    import json  # noqa: PLC0415
    job = {"source": str(FIRMWARE / "firmware.c"), "include": str(out), "ids": tables["ids"],
           "micro": tables["control"]["micro"]}
    python = sys.executable
    try:
        import pycparser  # noqa: F401, PLC0415
    except ImportError:
        python = "/usr/bin/python3"
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "scripts")}
    run = subprocess.run([python, "-c", MAIN], input=json.dumps(job), env=environment,
                         capture_output=True, text=True, check=False)
    if run.returncode:
        sys.exit(run.stderr.strip())
    return json.loads(run.stdout)


def write_rom(out, tables, notice):
    rom, mark = out / "rung_micro_rom.vh", f"// {fingerprint(out)}\n"
    depths = out / "rung_micro_rom_words.vh"
    if depths.exists() and rom.exists() and rom.read_text().startswith(mark):
        return
    text = [mark, f"// {notice}\n"]
    deep = "0"
    for name, firmware in compiled(out, tables).items():
        text.append(f"// {name}: {len(firmware['words'])} words, {firmware['ram_words']} words of RAM, "
                    f"calls {firmware['depth']} deep\n")
        size = -(-len(firmware["words"]) // ROM_STEP) * ROM_STEP
        deep = f"CONFIG_ID == {tables['ids'][name]} ? {size} : {deep}"
        words = firmware["words"] + [0] * (size - len(firmware["words"]))
        text.append(f"if (CONFIG_ID == {tables['ids'][name]}) begin : gen_{name}\n  initial begin\n")
        text += [f"    rom[{i}] = 16'h{word:04x};\n" for i, word in enumerate(words)]
        text.append("  end\nend\n")
        (out / f"firmware_{name}.lst").write_text("\n".join(firmware["listing"]) + "\n")
    depths.write_text(
        f"// {notice}\n  localparam integer FIRMWARE_WORDS = {deep};\n")
    temporary = rom.with_suffix(".tmp")
    temporary.write_text("".join(text))
    os.replace(temporary, rom)
