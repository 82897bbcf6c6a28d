#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write reports/area-timing.md from reports/area-timing.json and, if it is there, yardsticks.json."""
from __future__ import annotations

import json
import sys

from flow import area_report, tools


def main() -> int:
    area_file = tools.REPORTS / "area-timing.json"
    yard_file = tools.REPORTS / "yardsticks.json"
    if not area_file.exists():
        print("no reports/area-timing.json: run `make pnr` first", file=sys.stderr)
        return 1
    yard = json.loads(yard_file.read_text()) if yard_file.exists() else None
    tools.write_file(tools.REPORTS / "area-timing.md",
                     area_report.render(json.loads(area_file.read_text()), yard))
    tools.say("wrote reports/area-timing.md")
    return 0


if __name__ == "__main__":
    sys.exit(main())
