# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids as they stand in the document: arrays in global coordinates, rounded to single precision."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import FreeCAD as App
import numpy as np

from .sources import DEFAULT_DEFLECTION, RefusedError, kind_of, surface_arrays

if TYPE_CHECKING:
    from numpy.typing import NDArray


translate = App.Qt.translate

# Of the determinant of a matrix without a scale.
_ROUNDING = 1e-9


def placed_points(points: NDArray, placement: Any) -> NDArray[np.float64]:
    """`points` (n × 3) moved by an App.Placement; by the identity bit for bit."""
    points = np.asarray(points, float)
    if placement.isIdentity():
        return points
    matrix = np.array(placement.toMatrix().A).reshape(4, 4)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def linked_and_placement(obj: Any) -> tuple[Any, Any]:
    """The object with the mesh or shape that `obj` is, or is a link to, and where it stands in the document.

    Raises RefusedError for a link that scales.
    """
    if not obj.isDerivedFrom("App::Link"):
        return obj, obj.getGlobalPlacement()
    linked, matrix = obj.getLinkedObject(True, App.Matrix(), True)
    if np.abs(np.linalg.det(np.array(matrix.A).reshape(4, 4)) - 1) > _ROUNDING:
        text = translate("Thicken", "“{label}” is a link that scales. Make a copy of “{linked}” in that size instead.")
        raise RefusedError(text.format(label=obj.Label, linked=linked.Label))
    group = obj.getParentGeoFeatureGroup()
    parent = group.getGlobalPlacement() if group is not None else App.Placement()
    return linked, parent.multiply(App.Placement(matrix))


def placed_solid(obj: Any, deflection: float = DEFAULT_DEFLECTION) -> tuple[NDArray[np.float64], NDArray]:
    """The vertices and triangles of a mesh object, a shape, or a link to one, in global coordinates.

    The coordinates are rounded to the floats that an STL file holds. Raises RefusedError for an object
    without a surface.
    """
    linked, placement = linked_and_placement(obj)
    if kind_of(linked) == "mesh" and linked.Mesh.CountFacets == 0:
        raise RefusedError(f"“{obj.Label}” has no mesh. Mend what it is made from first.")
    vertices, triangles = surface_arrays(linked, deflection=deflection)
    return placed_floats(vertices, placement), triangles


def placed_floats(vertices: NDArray, placement: Any) -> NDArray[np.float64]:
    """`vertices` moved, and rounded to the floats that an STL file holds."""
    return placed_points(vertices, placement).astype(np.float32).astype(float)
