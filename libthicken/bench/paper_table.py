#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print Table 1 of the paper with this program's times beside the paper's.

usage: paper_table.py PROGRAM FOLDER [--resolution 128,256] [--only TEXT] [--judge SOLIDCHECK]

FOLDER holds the models as PLY files. Grid is the time of sweep and field, face that of contouring,
shape that of shape optimisation and the exact tests of it; read, check, audit and write come on top.
"""

import argparse
import json
import subprocess
import tempfile
from pathlib import Path

# model, thickness in mean edge lengths (negative: the other side in the paper), and the paper's
# seconds for grid, faces and shape at 128³ and 256³.
MODELS = [
    ("cut_david_helmet_10k8", 2.5, {128: (1.03, 1.16, 1.33), 256: (6.07, 4.93, 5.37)}),
    ("an_pigtail_204", 0.5, {128: (0.310, 0.180, 0.460), 256: (1.87, 0.980, 1.95)}),
    ("cut_face_scan_23k", 2.5, {128: (0.983, 0.499, 0.734), 256: (5.74, 2.06, 2.79)}),
    ("cut_femur_lower_8k9", 2.5, {128: (1.28, 0.552, 0.828), 256: (8.04, 2.52, 3.31)}),
    ("cut_nefertiti_57k", 3.0, {128: (0.954, 0.538, 0.479), 256: (5.15, 1.92, 1.59)}),
    ("cut_igea_face_134k", 3.0, {128: (0.850, 0.654, 0.743), 256: (4.29, 2.21, 2.33)}),
]


def mean_edge(program: str, model: Path) -> float:
    """Mean edge length by the program's own check."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        subprocess.run([program, "check", model, "--report", report], check=True, capture_output=True)
        facts = json.loads(report.read_text())
    facts = facts.get("input", facts)
    return next(facts[key] for key in ("mean_edge_mm", "mean_edge") if key in facts)


def run(program: str, model: Path, thickness: float, resolution: int, judge: str | None) -> str:
    """One row's figures, or the reason why there are none."""
    with tempfile.TemporaryDirectory() as folder:
        out, report = Path(folder) / "out.ply", Path(folder) / "report.json"
        done = subprocess.run(
            [program, model, out, "--thickness", repr(thickness), "--method", "reconstruct",
             "--resolution", str(resolution), "--quiet", "--report", report],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        if done.returncode:
            return done.stderr.strip().splitlines()[-1]
        seconds = json.loads(report.read_text())["seconds"]
        times = (seconds["sweep"] + seconds["field"], seconds["faces"], seconds["shape"])
        row = " ".join(f"{t:7.2f}" for t in times) + f" | {sum(times):7.2f} {seconds['total']:7.2f}"
        if judge:
            verdict = subprocess.run(
                [judge, "thicken", model, out, repr(thickness)], capture_output=True, text=True, check=False
            )
            row += " | ok" if json.loads(verdict.stdout.splitlines()[-1]).get("ok") else " | NOT VALID"
        return row


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--resolution", default="128,256")
    parser.add_argument("--only", default="")
    parser.add_argument("--judge")
    options = parser.parse_args()
    print(f"{'model':24}{'cells':>6} | paper: grid face shape | sum     | here: grid face shape   | sum     whole")
    for name, edges, paper in MODELS:
        if options.only not in name:
            continue
        model = options.folder / f"{name}.ply"
        thickness = float(f"{edges * mean_edge(options.program, model):.6g}")
        for resolution in map(int, options.resolution.split(",")):
            times = paper.get(resolution, (float("nan"),) * 3)
            left = " ".join(f"{t:6.2f}" for t in times) + f"   | {sum(times):6.2f}  "
            print(f"{name:24}{resolution:6} | {left}| "
                  + run(options.program, model, thickness, resolution, options.judge), flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
