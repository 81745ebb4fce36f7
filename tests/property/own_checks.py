# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be said of a solid without a judge, by code that the program does not share."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from mesh_files import read_corners


def sorted_triangles(corners: np.ndarray) -> np.ndarray:
    """Every triangle from its smallest corner on, in the same sense, and all of them in order: rows of nine numbers."""
    corners = corners + 0.0  # −0 is 0
    _, index = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    first = index.reshape(-1, 3).argmin(axis=1)
    turned = np.take_along_axis(corners, (first[:, None] + np.arange(3))[:, :, None] % 3, axis=1)
    return turned.reshape(-1, 9)


def what_is_wrong(source: Path, result: Path, side: str) -> str:
    """Empty where the result is closed and oriented, has volume and holds every triangle of the source."""
    surface, solid = read_corners(source), read_corners(result)
    if not np.isfinite(solid).all():
        return "a coordinate is not finite"
    _, index = np.unique(solid.reshape(-1, 3), axis=0, return_inverse=True)
    triangles = index.reshape(-1, 3).astype(np.int64)
    starts, ends = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    size = triangles.max() + 1
    there, back = np.sort(starts * size + ends), np.sort(ends * size + starts)
    if (np.diff(there) == 0).any():
        return "an edge is there twice in the same sense"
    if (there != back).any():
        return "not closed"
    a, b, c = (solid[:, k] - solid[0, 0] for k in range(3))
    if np.einsum("ij,ij->", a, np.cross(b, c)) <= 0:
        return "no positive volume"
    kept = sorted_triangles(surface if side == "negative" else surface[:, ::-1])
    found = {row.tobytes() for row in sorted_triangles(solid)}
    lost = sum(row.tobytes() not in found for row in kept)
    return f"{lost} of {len(kept)} triangles of the surface are not in the solid" if lost else ""
