#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickens surfaces at a gap, and measures and judges what comes of it.

usage: gap_surfaces.py PROGRAM JUDGE COUNT [FOLDER]

COUNT surfaces, spread over those of FOLDER, get a gap of 1 % of their diagonal and a thickness of 2 %. One line each,
then the sum:

    ok          the gap surface passes `thicken check`; 99 % of its area away from the rim is within 1 % of the gap from
                the surface, at the middles of its triangles and of their edges; and the judge finds the solid ok,
                judged against the gap surface
    refused     with its reason
    wrong       what was found; the exit status is 1 then
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
from thicken import native, read_mesh

GAP, THICKNESS = 0.01, 0.02  # of the diagonal
SECONDS = 1800
NEAR, ENOUGH = 0.01, 0.99


def share_at(gap: float, surface: Path, at_gap: Path) -> float:
    """The share of the gap surface's area, away from the rim of the surface, that is within NEAR of the gap from it."""
    points, triangles = read_mesh(at_gap)
    a, b, c = points[triangles.T]
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    inner, near = 0.0, 0.0
    for places in ((a + b + c) / 3, (a + b) / 2, (b + c) / 2, (c + a) / 2):
        found = native.load().closest_points(*read_mesh(surface), places)
        away = ~found["on_rim"].astype(bool)
        inner += area[away].sum()
        near += area[away & (np.abs(found["distance"] - gap) <= NEAR * gap)].sum()
    return near / inner if inner else 0.0


def result_of(program: str, judge: str, surface: Path, folder: Path) -> tuple[str, str]:
    """The first word of the line, and the rest of it."""
    diagonal = float(np.linalg.norm(np.ptp(read_mesh(surface)[0], axis=0)))
    gap, thickness = GAP * diagonal, THICKNESS * diagonal
    solid, at_gap, report = (folder / name for name in ("solid.ply", "gap.ply", "report.json"))
    made = subprocess.run([program, surface, solid, "--thickness", repr(thickness), "--gap", repr(gap), "--gap-surface", at_gap,
                           "--report", report, "--quiet"], capture_output=True, text=True, timeout=SECONDS)  # fmt: skip
    if made.returncode != 0:
        return "refused", (made.stderr.splitlines() or [f"status {made.returncode}"])[-1]
    facts = json.loads(report.read_text())["gap"]
    checked = subprocess.run([program, "check", at_gap, "--quiet"], capture_output=True, text=True)
    share = share_at(gap, surface, at_gap)
    judged = subprocess.run([judge, "thicken", at_gap, solid, repr(thickness), "--samples", "20000", "--side", "negative"],
                            capture_output=True, text=True)  # fmt: skip
    verdict = json.loads(judged.stdout.strip().splitlines()[-1])
    told = (f"{100 * share:.2f} % within 1 %, least {facts['least_mm'] / gap:.3f} of the gap, no room at "
            f"{100 * facts['short_share']:.2f} %, {facts['surface']['triangles']} triangles, "
            f"left out {facts['left_out_mm2'] / facts['surface']['area_mm2']:.2g}")  # fmt: skip
    wrong = [what for what, is_so in (("check", checked.returncode != 0), ("distance", share < ENOUGH),
                                      ("judge: " + judged.stdout[-300:], not verdict.get("ok"))) if is_so]  # fmt: skip
    return ("wrong", f"{', '.join(wrong)}; {told}") if wrong else ("ok", told)


def main() -> int:
    program, judge, count = sys.argv[1], sys.argv[2], int(sys.argv[3])
    folder = Path(sys.argv[4]) if len(sys.argv) > 4 else Path(__file__).resolve().parents[3] / "shared" / "data" / "open"
    surfaces = sorted(folder.glob("*.ply"))
    numbers = {"ok": 0, "refused": 0, "wrong": 0}
    for i in range(count):
        surface = surfaces[i * len(surfaces) // count]
        with tempfile.TemporaryDirectory() as work:
            word, rest = result_of(program, judge, surface, Path(work))
        numbers[word] += 1
        print(f"{word:8} {surface.stem}: {rest}", flush=True)
    print(", ".join(f"{number} {word}" for word, number in numbers.items()))
    return 1 if numbers["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
