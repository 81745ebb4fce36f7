#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time one large surface from the file that is read to the proved solid that is written.

usage: large_surface.py PROGRAM SURFACE.ply --triangles 100000 [--method sweep] [--thickness-percent 1]
                        [--repeat 3] [--blender blender] [--judge SOLIDCHECK] [--keep FOLDER]

SURFACE (binary little-endian PLY) is subdivided to about so many triangles. With --blender the same
surface goes through Blender's Solidify, in alternation, and only the evaluation of the modifier counts:
no reading, no writing, and no proof.
"""

import argparse
import json
import statistics
import subprocess
import tempfile
from pathlib import Path

from models import surface_facts, thicken, verdict
from ply import read_ply, subdivided_to, write_ply

MIB = 1024 * 1024


def solidify(blender: str, surface: Path, thickness: float) -> dict[str, float]:
    """Seconds of Blender's modifier by its modes."""
    script = Path(__file__).with_name("blender_solidify.py")
    done = subprocess.run([blender, "--background", "--factory-startup", "--python-exit-code", "1",
                           "--python", script, "--", surface, repr(thickness)],
                          capture_output=True, text=True, check=True)  # fmt: skip
    return json.loads(next(line for line in done.stdout.splitlines() if line.startswith("{")))


def measure(options: argparse.Namespace, folder: Path) -> None:
    surface, out = folder / "surface.ply", folder / "solid.ply"
    write_ply(surface, *subdivided_to(*read_ply(options.surface), options.triangles))
    facts = surface_facts(options.program, surface)
    thickness = options.thickness_percent / 100 * facts["diagonal_mm"]
    print(f"{options.surface.stem}: {facts['triangles']} triangles, thickness {thickness:.6g}, {options.method}")
    reports, rivals = [], []
    for _ in range(options.repeat):
        reports.append(thicken(options.program, surface, out, thickness, "--method", options.method))
        if options.blender:
            rivals.append(solidify(options.blender, surface, thickness))
    stages = {stage: statistics.median(report["seconds"][stage] for report in reports)
              for stage in reports[0]["seconds"]}  # fmt: skip
    print("seconds: " + ", ".join(f"{stage} {time:.2f}" for stage, time in stages.items()))
    last = reports[-1]
    print(f"peak memory {last['memory']['peak_bytes'] / MIB:.0f} MiB; {last['output']['triangles']} triangles; "
          f"thinnest wall {last['thinnest_wall']['share_of_thickness']:.3f} of the thickness, "
          f"share below 0.9 of it {last['thin_share']:.4f}")  # fmt: skip
    for mode in rivals[0] if rivals else ():
        time = statistics.median(rival[mode] for rival in rivals)
        print(f"Blender, {mode}: {time:.2f} s; total {stages['total'] / time:.2f} times that")
    if options.judge:
        print("judge: " + verdict(options.judge, surface, out, thickness, "--samples", "2000"))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("surface", type=Path)
    parser.add_argument("--triangles", type=int, default=100_000)
    parser.add_argument("--method", default="sweep")
    parser.add_argument("--thickness-percent", type=float, default=1.0, help="of the diagonal")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--blender")
    parser.add_argument("--judge")
    parser.add_argument("--keep", type=Path, help="leave the surface and the solid in this folder")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        if options.keep:
            options.keep.mkdir(parents=True, exist_ok=True)
        measure(options, options.keep or Path(folder))


if __name__ == "__main__":
    main()
