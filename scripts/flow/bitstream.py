# SPDX-License-Identifier: Apache-2.0
"""A controller from sources to a bitstream under build/bit."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from flow import place_route, synthesis, tools
from flow.designs import Board, plc_design


@dataclass(frozen=True)
class Bitstream:
    file: Path
    routed: place_route.Routed


def path(board: Board) -> Path:
    return tools.BUILD / "bit" / f"{board.name}.{board.family.suffix}"


def build(board: Board, seeds: list[int]) -> Bitstream:
    """The bitstream of the first seed that meets the board's clock; FlowError if none does."""
    design = plc_design(board)
    netlist = synthesis.synthesise(design)
    reached = []
    for seed in seeds:
        routed = place_route.place_and_route(design, netlist, seed)
        reached.append(routed.fmax_mhz)
        if routed.fmax_mhz < board.goal_mhz:
            continue
        file, stamp = path(board), design.folder / "bitstream.inputs"
        layout = design.layout(seed)
        want = tools.digest(board.family.pack, [layout])
        if not tools.up_to_date(stamp, want, [file]):
            stamp.unlink(missing_ok=True)
            command = [part.format(layout=layout, bitstream=file) for part in board.family.pack]
            tools.run(command, tools.LOGS / f"pack-{design.name}.log")
            tools.write_file(stamp, want)
        return Bitstream(file, routed)
    raise tools.FlowError(f"{design.name}: {max(reached):.1f} MHz with the best of the seeds "
                          f"{', '.join(map(str, seeds))}, the board has {board.goal_mhz} MHz")
