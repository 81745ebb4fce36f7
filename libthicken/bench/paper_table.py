#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print Table 1 of the paper with this program's times beside the paper's.

usage: paper_table.py PROGRAM FOLDER [--resolution 128,256] [--only TEXT] [--judge SOLIDCHECK]

FOLDER holds the models as PLY files. Grid is the time of sweep and field, face that of contouring,
shape that of shape optimisation and the exact tests of it; read, check, audit and write come on top.
"""

import tempfile
from pathlib import Path

from models import MODELS, Refused, command_line, reconstruct, surface_facts, table_thickness, verdict


def run(program: str, model: Path, thickness: float, resolution: int, judge: str | None) -> str:
    """One row's figures, or the reason why there are none."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out.ply"
        try:
            seconds = reconstruct(program, model, out, thickness, resolution)["seconds"]
        except Refused as why:
            return str(why)
        times = (seconds["sweep"] + seconds["field"], seconds["faces"], seconds["shape"])
        row = " ".join(f"{t:7.2f}" for t in times) + f" | {sum(times):7.2f} {seconds['total']:7.2f}"
        return row + (f" | {verdict(judge, model, out, thickness)}" if judge else "")


def main() -> None:
    parser = command_line(__doc__, "128,256")
    parser.add_argument("--judge")
    options = parser.parse_args()
    print(f"{'model':24}{'cells':>6} | paper: grid face shape | sum     | here: grid face shape   | sum     whole")
    for name, edges, paper in MODELS:
        if options.only not in name:
            continue
        model = options.folder / f"{name}.ply"
        thickness = table_thickness(surface_facts(options.program, model), edges)
        for resolution in map(int, options.resolution.split(",")):
            times = paper.get(resolution, (float("nan"),) * 3)
            left = " ".join(f"{t:6.2f}" for t in times) + f"   | {sum(times):6.2f}  "
            print(f"{name:24}{resolution:6} | {left}| "
                  + run(options.program, model, thickness, resolution, options.judge), flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
