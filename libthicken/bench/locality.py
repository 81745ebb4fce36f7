#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print what regions cost in sheets of different sizes with the same ten dents.

usage: locality.py PROGRAM [--triangles 10000,100000,1000000] [--repeat N]

The dents are too narrow for the thickness, so that the sweep is short below them, and everything around them is
plane. Plan is the time to find the places and what is near them. The last column is the time in regions beside that
in the smallest sheet: what is far from a dent does not take part.
"""

import argparse
import math
import statistics
import tempfile
from array import array
from pathlib import Path

from models import thicken
from ply import write_ply

STEP = 0.25  # mm between neighbours in the sheet
THICKNESS, DEPTH, WIDTH = 1.0, 1.8, 0.7  # mm
APART = 1.8  # mm, between neighbouring dents


def height(x: float, y: float) -> float:
    beside = ((x - (i - 2) * APART) ** 2 + (y - (j - 0.5) * APART) ** 2 for i in range(5) for j in range(2))
    return DEPTH * sum(math.exp(-square / WIDTH**2) for square in beside)


def sheet(triangles: int) -> tuple[array, array]:
    """A square sheet of about so many triangles; its middle is that of any other."""
    half = round(math.sqrt(triangles / 2) / 2)
    n = 2 * half + 1
    side = [STEP * k for k in range(-half, half + 1)]
    positions, corners = array("d"), array("i")
    for x in side:
        for y in side:
            positions.extend((x, y, height(x, y)))
    for i in range(n - 1):
        for a in range(i * n, i * n + n - 1):
            corners.extend((a, a + n, a + n + 1, a, a + n + 1, a + 1))
    return positions, corners


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--triangles", default="10000,100000,1000000")
    parser.add_argument("--repeat", type=int, default=3)
    options = parser.parse_args()
    counts = [int(count) for count in options.triangles.split(",")]
    with tempfile.TemporaryDirectory() as folder:
        models = []
        for count in counts:
            models.append(Path(folder) / f"{count}.ply")
            write_ply(models[-1], *sheet(count))
        out = Path(folder) / "out.ply"
        runs = [[thicken(options.program, model, out, THICKNESS, "--threads", "1") for model in models]
                for _ in range(options.repeat)]  # fmt: skip
    print("| triangles | sweep | plan | regions | total | regions, ratio |\n|---|---|---|---|---|---|")
    smallest = None
    for reports in zip(*runs):
        sweep, plan, regions, total = (statistics.median(report["seconds"][stage] for report in reports)
                                       for stage in ("sweep", "plan", "regions", "total"))  # fmt: skip
        smallest = smallest or regions
        print(f"| {reports[0]['input']['triangles']} | {sweep:.2f} s | {plan:.2f} s | {regions:.2f} s | {total:.2f} s "
              f"| {regions / smallest:.2f} |")  # fmt: skip


if __name__ == "__main__":
    main()
