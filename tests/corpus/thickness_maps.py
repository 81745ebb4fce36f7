#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickens surfaces of a folder with smooth maps of the thickness, and has the judge look at every solid.

usage: thickness_maps.py PROGRAM FOLDER --judge JUDGE [--count 20] [--percent 2] [-- OPTION...]

The factor of a vertex is 2 to the sine of its place along a direction: between 0.5 and 2, once up and down over the
surface. Direction and phase are drawn by the name of the surface, the same in every run. The thickness is --percent
of the diagonal, and what follows `--` goes to the program. A line a surface, then medians and the largest; the exit
status is 1 unless all solids are right.
"""

from __future__ import annotations

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path
from typing import Callable

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
from thicken import read_mesh

FIGURES = ("missing_fraction", "shell_short_p99", "shell_over_p99", "excess_mitred_fraction", "triangle_ratio")
SECONDS = 300


def factors_of(name: str, points: np.ndarray) -> np.ndarray:
    rng = np.random.default_rng(zlib.crc32(name.encode()))
    way = rng.normal(size=3)
    along = points @ (way / np.linalg.norm(way))
    return 2.0 ** np.sin(2 * np.pi * (along / np.linalg.norm(np.ptp(points, axis=0)) + rng.random()))


def write_mapped(path: Path, points: np.ndarray, triangles: np.ndarray, factors: np.ndarray) -> None:
    vertex = np.rec.fromarrays([*points.T, factors], dtype=[(n, "<f8") for n in ("x", "y", "z", "factor")])
    face = np.empty(len(triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    face["count"], face["corners"] = 3, triangles
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    header += [f"property double {name}" for name in vertex.dtype.names]
    header += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header", ""]
    path.write_bytes("\n".join(header).encode() + vertex.tobytes() + face.tobytes())


def thickness_of(points: np.ndarray, percent: float) -> float:
    return float(f"{percent / 100 * np.linalg.norm(np.ptp(points, axis=0)):.6g}")


def judged(
    asked: argparse.Namespace, surface_of: tuple[np.ndarray, np.ndarray], r: float, factors: np.ndarray, options: list[str]
) -> dict[str, object]:
    """What the judge says of the solid that the program makes with `options`, where r times the factors is asked for."""
    with tempfile.TemporaryDirectory() as folder:
        surface, solid = Path(folder, "surface.ply"), Path(folder, "solid.ply")
        write_mapped(surface, *surface_of, factors)
        command = [asked.program, surface, solid, "--thickness", repr(r), "--quiet", *options, *asked.options]
        begin = time.monotonic()
        run = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS)
        seconds = time.monotonic() - begin
        if run.returncode != 0:
            return {"ok": False, "error": run.stderr.strip(), "seconds": seconds}
        command = [asked.judge, "thicken", surface, solid, repr(r), "--samples", "20000", "--map", "factor"]
        told = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS).stdout
        return {**json.loads(told.splitlines()[-1]), "seconds": seconds}


def judge_mapped(asked: argparse.Namespace, source: Path) -> dict[str, object]:
    points, triangles = read_mesh(source)
    r, factors = thickness_of(points, asked.percent), factors_of(source.stem, points)
    return judged(asked, (points, triangles), r, factors, ["--thickness-map", "factor"])


def survey(description: str, row_of: Callable[[argparse.Namespace, Path], dict[str, object]]) -> int:
    """A row for each surface that the command line names, and what they come to."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--judge", required=True)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--percent", type=float, default=2)
    parser.add_argument("options", nargs="*")
    asked = parser.parse_args()
    sources = sorted(asked.folder.glob("*.ply"))
    sources = sources[:: max(1, len(sources) // asked.count)][: asked.count]
    rows = []
    for source in sources:
        row = row_of(asked, source)
        rows.append(row)
        figures = "  ".join(f"{name} {row[name]:.4f}" for name in FIGURES if name in row)
        print(f"{source.stem}: {'ok' if row['ok'] else row.get('error', 'wrong')}  {figures}  {row['seconds']:.1f} s", flush=True)
    right = sum(bool(row["ok"]) for row in rows)
    print(f"{right} of {len(rows)} ok")
    for name in FIGURES:
        values = [float(row[name]) for row in rows if row.get(name) is not None]
        if values:
            print(f"{name}: median {statistics.median(values):.5f}, largest {max(values):.5f}")
    return 0 if right == len(rows) else 1


if __name__ == "__main__":
    sys.exit(survey(__doc__.splitlines()[0], judge_mapped))
