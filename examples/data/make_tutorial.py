# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the STL files of docs/tutorial.md from the other data: in the folder of the project,

freecadcmd -c "import sys; sys.path[:0] = ['.', 'examples/data']; import make_tutorial; make_tutorial.main()"
"""

from pathlib import Path

import FreeCAD as App
import MeshPart
import numpy as np
import Part

from ThickenWorkbench import check_mesh, mesh_io, read_mesh, write_mesh

FOLDER = Path(__file__).resolve().parent
# Above all teeth of the rim of femur.ply.
CUT_ABOVE_RIM = 1.0


def cut(vertices: np.ndarray, triangles: np.ndarray, height: float) -> tuple[np.ndarray, np.ndarray]:
    """What lies above a height; triangles that cross it are divided there, so that the rim is plane."""
    above = vertices[:, 2] > height
    points, made = list(vertices), {}

    def on_edge(a: int, b: int) -> int:
        key = (min(a, b), max(a, b))
        if key not in made:
            low, high = vertices[key[0]], vertices[key[1]]
            point = low + (height - low[2]) / (high[2] - low[2]) * (high - low)
            point[2] = height
            made[key] = len(points)
            points.append(point)
        return made[key]

    kept = []
    for triangle in triangles:
        corners = [int(v) for v in triangle]
        count = int(above[corners].sum())
        if count == 3:
            kept.append(corners)
        elif count:
            while not (above[corners[0]] and (count == 2 or not above[corners[2]]) and (count == 1 or above[corners[1]])):
                corners = corners[1:] + corners[:1]
            a, b, c = corners
            if count == 1:
                kept.append([a, on_edge(a, b), on_edge(a, c)])
            else:
                low_b, low_a = on_edge(b, c), on_edge(a, c)
                kept += [[a, b, low_b], [a, low_b, low_a]]
    return np.array(points), np.array(kept)


def bone() -> tuple[np.ndarray, np.ndarray]:
    """femur.ply, sawn straight off where its rim is a comb."""
    vertices, triangles = read_mesh(FOLDER / "femur.ply")
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    unique, counts = np.unique(edges, axis=0, return_counts=True)
    rim = vertices[unique[counts == 1].ravel()]
    return cut(vertices, triangles, float(rim[:, 2].max()) + CUT_ABOVE_RIM)


def bracket() -> tuple[np.ndarray, np.ndarray]:
    """A round foot with an arm."""
    body = Part.makeCylinder(15, 20).fuse(Part.makeBox(40, 12, 8, App.Vector(0, -6, 0)))
    mesh = MeshPart.meshFromShape(Shape=body, LinearDeflection=0.05, AngularDeflection=0.2, Relative=False)
    return mesh_io.arrays_from_mesh(mesh)


def main() -> None:
    for name, (vertices, triangles) in (("bone", bone()), ("pawn", read_mesh(FOLDER / "pawn.ply")), ("bracket", bracket())):
        singles = np.asarray(vertices, np.float32).astype(float)
        facts = check_mesh(singles, triangles)
        if facts["defects"]:
            raise RuntimeError(f"{name}: {facts['defects'][0]['sentence']}")
        write_mesh(FOLDER / f"{name}.stl", singles, triangles)
        print(f"\n{name}.stl: {len(triangles)} triangles")
