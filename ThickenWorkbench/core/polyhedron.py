# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a valid closed mesh to the edges and planar faces of a polyhedron."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .brep_solid import Faces

def shells_of_solids(shells: list[dict[str, Any]]) -> list[list[int]]:
    """The shells of each solid, the outer one first, from the list that `_thicken.inspect` gives."""
    solids = {number: [number] for number, shell in enumerate(shells) if not shell["cavity"]}
    for number, shell in enumerate(shells):
        if shell["cavity"]:
            solids[shell["within"]].append(number)
    return list(solids.values())


def edges_of(triangles: NDArray, points: int) -> tuple[NDArray, NDArray, NDArray]:
    """Edges (e × 2, the lower end first), the edge of each use (3 m), whether it is used backwards."""
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    low, high = np.minimum(start, end), np.maximum(start, end)
    keys, edge_of_use = np.unique(low * points + high, return_inverse=True)
    return np.column_stack([keys // points, keys % points]), edge_of_use, start > end


def unit_normals(points: NDArray, triangles: NDArray) -> NDArray:
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    return normals / np.linalg.norm(normals, axis=1)[:, None]


def triangle_faces(
    points: NDArray, triangles: NDArray, shell_of_triangle: NDArray, tolerance: float
) -> tuple[NDArray, NDArray, Faces, float]:
    """A face for each triangle: points, edges, faces, and the tolerance that they need."""
    edges, edge_of_use, against = edges_of(triangles, len(points))
    count = len(triangles)
    faces = Faces(
        edges=edge_of_use,
        against=against,
        wire_starts=3 * np.arange(count + 1),
        face_starts=np.arange(count + 1),
        origins=points[triangles[:, 0]],
        normals=unit_normals(points, triangles),
        shell_of_face=shell_of_triangle,
    )
    return points, edges, faces, tolerance
