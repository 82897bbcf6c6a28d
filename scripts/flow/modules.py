# SPDX-License-Identifier: Apache-2.0
"""Area by module: a design synthesised with its hierarchy kept, and counted.

What Yosys optimises across modules in the real netlist it leaves here, so that the parts come to a little more
than the whole. Names of parameterised modules are cut back to what the source calls them.
"""
from __future__ import annotations

import json
import re
from dataclasses import dataclass
from typing import Any

from flow import synthesis, tools
from flow.designs import Design

KINDS = {"luts": re.compile(r"(SB_)?LUT\d$"), "flip_flops": re.compile(r"TRELLIS_FF$|SB_DFF|DFF"),
         "block_rams": re.compile(r"SB_RAM40|DP16KD|PDPW16KD|(S|SD|SDP|DP)B?X?9?B?$|p?ROM")}


@dataclass(frozen=True)
class Area:
    luts: int = 0
    flip_flops: int = 0
    block_rams: int = 0

    def __add__(self, other: Area) -> Area:
        return Area(self.luts + other.luts, self.flip_flops + other.flip_flops,
                    self.block_rams + other.block_rams)


def plain(module: str) -> str:
    r"""$paramod$hash\name or $paramod\name\P=1 -> name."""
    if not module.startswith("$paramod"):
        return module.removeprefix("\\")
    return module.split("\\")[1]


def netlist(design: Design) -> dict[str, Any]:
    """Modules of the design after synthesis without flattening."""
    file = design.folder / "modules.json"
    stamp = design.folder / "modules.inputs"
    text = synthesis.script(design, file).replace(f"{design.board.family.synth} -top",
                                                  f"{design.board.family.synth} -noflatten -top")
    headers = [header for folder in design.include for header in sorted(folder.glob("*.vh"))]
    want = tools.digest([text, synthesis.yosys_version()], [*design.sources, *headers, *design.data])
    if not tools.up_to_date(stamp, want, [file]):
        tools.say(f"{design.name}: synthesis with its modules kept")
        script = design.folder / "modules.ys"
        tools.write_file(script, text)
        tools.run([tools.YOSYS, "-s", str(script)], tools.LOGS / f"modules-{design.name}.log")
        tools.write_file(stamp, want)
    return json.loads(file.read_text())["modules"]


def measure(design: Design, groups: dict[str, tuple[str, ...]]) -> dict[str, Area]:
    """Area of each group of modules: of their topmost instances with all that is below; "other": the rest."""
    modules = netlist(design)
    group_of = {module: group for group, names in groups.items() for module in names}
    found = {group: Area() for group in (*groups, "other")}

    def walk(module: str, group: str) -> None:
        if group == "other":
            group = group_of.get(plain(module), group)
        for cell in modules[module]["cells"].values():
            kind = cell["type"]
            if kind in modules and not int(modules[kind]["attributes"].get("blackbox", "0"), 2):
                walk(kind, group)
            else:
                found[group] += Area(*(bool(pattern.match(kind)) for pattern in KINDS.values()))

    walk(design.top, "other")
    return found
