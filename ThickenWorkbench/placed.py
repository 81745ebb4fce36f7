# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids as they stand in the document: arrays in global coordinates, rounded to single precision."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .sources import DEFAULT_DEFLECTION, RefusedError, kind_of, surface_arrays

if TYPE_CHECKING:
    from numpy.typing import NDArray


def placed_points(points: NDArray, placement: Any) -> NDArray[np.float64]:
    """`points` (n × 3) moved by an App.Placement; by the identity bit for bit."""
    points = np.asarray(points, float)
    if placement.isIdentity():
        return points
    matrix = np.array(placement.toMatrix().A).reshape(4, 4)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def placed_solid(obj: Any, deflection: float = DEFAULT_DEFLECTION) -> tuple[NDArray[np.float64], NDArray]:
    """The vertices and triangles of a mesh object or shape in global coordinates.

    The coordinates are rounded to the floats that an STL file holds. Raises RefusedError for an object
    without a surface.
    """
    if kind_of(obj) == "mesh" and obj.Mesh.CountFacets == 0:
        raise RefusedError(f"“{obj.Label}” has no mesh. Mend what it is made from first.")
    vertices, triangles = surface_arrays(obj, deflection=deflection)
    points = placed_points(vertices, obj.getGlobalPlacement())
    return points.astype(np.float32).astype(float), triangles
