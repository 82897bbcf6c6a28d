#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bitstreams of the controller for boards, under build/bit; prints what each one holds."""
from __future__ import annotations

import argparse
import sys

from flow import bitstream, tools
from flow.designs import PLC_BOARDS


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--board", nargs="+", choices=list(PLC_BOARDS), default=list(PLC_BOARDS))
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3, 4, 5],
                        help="tried in this order until the board's clock is met")
    arguments = parser.parse_args()
    tools.generate_isa_header()
    for name in arguments.board:
        board = PLC_BOARDS[name]
        made = bitstream.build(board, arguments.seeds)
        used, available = made.routed.used, made.routed.available
        kinds = board.family.utilization
        figures = ", ".join(f"{sum(used.get(kind, 0) for kind in kinds[what])} of {available[kinds[what][0]]} {what}"
                            for what in ("logic_cells", "block_rams")).replace("_", " ")
        tools.say(f"{made.file.relative_to(tools.ROOT)}: {made.file.stat().st_size} bytes; {figures}; "
                  f"{made.routed.fmax_mhz:.1f} MHz for {board.goal_mhz} (seed {made.routed.seed})")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except tools.FlowError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
