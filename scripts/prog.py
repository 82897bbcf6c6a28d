#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Load a board with its bitstream (openFPGALoader): into its flash, from where it starts at power-up, or
with --sram into the FPGA until power is off. --dry-run prints the commands and stops before the cable.

Exit 1, with what to do, if there is no bitstream, no board or no permission.
"""
from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys

from flow import bitstream, tools
from flow.designs import PLC_BOARDS

LOADER = os.environ.get("OPENFPGALOADER", "")
LOADER_BOARDS = {"ulx3s": "ulx3s", "hx8k": "ice40_generic", "tangnano20k": "tangnano20k"}
USB = {"ulx3s": "its FT231X (0403:6015) at connector US1",
       "hx8k": "its FT2232H (0403:6010)",
       "tangnano20k": "its BL616 (0403:6010)"}
ANOTHER_USER = re.compile(r"permission|access denied|LIBUSB_ERROR_ACCESS|inappropriate permissions|: -4 ", re.I)
NO_CABLE = re.compile(r"device not found|unable to open ftdi|no such device|claim cable|cable", re.I)


def loader() -> str:
    """openFPGALoader of build/venv, where it is a file of a package, or OPENFPGALOADER."""
    if LOADER:
        return LOADER
    found = sorted((tools.VENV_BIN.parent / "lib").glob("python*/site-packages/openfpgaloader/bin/openFPGALoader"))
    if not found:
        raise tools.FlowError("no openFPGALoader in build/venv: run `scripts/setup.sh prog`, or set OPENFPGALOADER")
    return str(found[0])


def known(tool: str, board: str) -> None:
    """FlowError if openFPGALoader does not run or does not know the board."""
    run = subprocess.run([tool, "--list-boards"], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise tools.FlowError(f"{tool} does not run: {(run.stdout + run.stderr).strip()}")
    if not re.search(rf"^{re.escape(board)}\s", run.stdout, re.MULTILINE):
        raise tools.FlowError(f"{tool} does not know the board {board}: a newer one is needed")


def detect(tool: str, name: str) -> None:
    """FlowError, with what to do, if the board does not answer."""
    run = subprocess.run([tool, "-b", LOADER_BOARDS[name], "--detect"], capture_output=True, text=True,
                         check=False)
    said = (run.stdout + run.stderr).strip()
    if run.returncode == 0 and not NO_CABLE.search(run.stderr):
        return
    title = PLC_BOARDS[name].title
    if ANOTHER_USER.search(said):
        what = (f"{title}: no permission for {USB[name]}. Add openFPGALoader's udev rules (99-openfpgaloader.rules) "
                "and yourself to the group plugdev, or run this as root")
    elif NO_CABLE.search(said):
        what = (f"{title}: not found on USB. Plug in {USB[name]}, "
                "and take it from a virtual machine or container that keeps it")
    else:
        what = f"{title}: does not answer"
    raise tools.FlowError(f"{what}.\nopenFPGALoader: " + "\n                ".join(said.splitlines()))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--board", choices=list(PLC_BOARDS), required=True)
    parser.add_argument("--sram", action="store_true")
    parser.add_argument("--dry-run", action="store_true")
    arguments = parser.parse_args()
    name = arguments.board
    file = bitstream.path(PLC_BOARDS[name])
    if not file.exists():
        raise tools.FlowError(f"no {file.relative_to(tools.ROOT)}: run `make bit BOARD={name}` first")
    tool = loader()
    known(tool, LOADER_BOARDS[name])
    command = [tool, "-b", LOADER_BOARDS[name], "-m" if arguments.sram else "-f", str(file)]
    tools.say(" ".join(["prog:", "openFPGALoader", *command[1:-1], str(file.relative_to(tools.ROOT))]))
    if arguments.dry_run:
        return 0
    detect(tool, name)
    if subprocess.run(command, check=False).returncode != 0:
        raise tools.FlowError("openFPGALoader failed (see above); the board may hold a part of the bitstream: "
                              "load it again")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
