#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Netlists of the processors in their board tops, under build/pnr; prints where each one is."""
from __future__ import annotations

import argparse
import sys

from flow import tools
from flow.designs import BOARDS, MPUS, rung_design
from flow.synthesis import synthesise


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--mpu", type=int, nargs="+", choices=MPUS, default=list(MPUS))
    parser.add_argument("--board", nargs="+", choices=list(BOARDS), default=list(BOARDS))
    arguments = parser.parse_args()
    tools.generate_isa_header()
    for board in arguments.board:
        for mpu in arguments.mpu:
            netlist = synthesise(rung_design(mpu, BOARDS[board]))
            tools.say(f"MPU{mpu} {board}: {netlist.relative_to(tools.ROOT)}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
