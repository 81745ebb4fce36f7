# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times the Part solid of a mesh beside FreeCAD's own way, sewing.

    freecadcmd -c "import sys; sys.path[:0] = ['.', 'tests/freecad']; import bench_part_solid as b; b.main(5000, 20000)"
"""

from __future__ import annotations

import time

import Part

import ThickenWorkbench
from ThickenWorkbench import mesh_io
from thicken_surfaces import grid


def compare(facets: int) -> tuple[int, float, float]:
    """Facets of a saddle, about as many as asked, and the seconds of a Part solid of shared edges and of
    sewing; the check of the mesh is among the first."""
    side = round((facets / 4) ** 0.5) + 1
    vertices, halves = grid(lambda x, y: (x * x - y * y) / 300, size=200, n=side)
    # Cell by cell, as files have them: in the order of grid() sewing takes many times as long.
    triangles = halves.reshape(2, -1, 3).transpose(1, 0, 2).reshape(-1, 3)
    solid = ThickenWorkbench.thicken_mesh(vertices, triangles, 5)
    mesh = mesh_io.mesh_from_arrays(solid.vertices, solid.triangles)
    ThickenWorkbench.part_solid(*mesh_io.arrays_from_mesh(mesh))  # imports are not timed
    start = time.perf_counter()
    shape = ThickenWorkbench.part_solid(*mesh_io.arrays_from_mesh(mesh))
    ours = time.perf_counter() - start
    start = time.perf_counter()
    sewn = Part.Shape()
    sewn.makeShapeFromMesh(mesh.Topology, 0.01, True)
    theirs_solid = Part.Solid(sewn.Shells[0])
    theirs = time.perf_counter() - start
    if abs(shape.Volume - theirs_solid.Volume) > 1e-6 * shape.Volume:
        raise AssertionError(f"volumes differ: {shape.Volume} and {theirs_solid.Volume}")
    return len(solid.triangles), ours, theirs


def main(*sizes: int) -> None:
    for size in sizes:
        facets, ours, theirs = compare(size)
        print(f"\n{facets} facets: shared {ours:.2f} s, sewn {theirs:.2f} s, {theirs / ours:.0f} times", flush=True)
