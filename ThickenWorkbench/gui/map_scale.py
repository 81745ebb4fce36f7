# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the scale of a thickness map begins and ends, and how the area is spread over it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.facets import areas_of
from ..mesh_io import arrays_from_mesh

_BINS = 40


# The scale of a wall reaches so far from the thickness that was asked for: half of it less, half of it more.
_HALF = 0.5


def asked_thickness(obj: Any) -> float | None:
    """The thickness, mm, that `obj`, or what it is made from, was given; None where there is none."""
    for _ in range(100):  # a chain of features; documents have no cycles
        if obj is None or hasattr(obj, "ThinnestWall"):
            break
        obj = getattr(obj, "Source", None)
    return obj.Thickness.Value if obj is not None else None


def ends(found: Any, asked: float | None = None) -> tuple[float, float]:
    """The least and the largest value with a colour of its own.

    A wall has the thickness that was asked for in the middle, so that the same colour means the same in every
    solid; where none is known, the median. A deviation has 0 in its middle.
    """
    if found.what == "wall":
        middle = asked if asked else found.percentiles[50]
        return (1 - _HALF) * middle, (1 + _HALF) * middle
    low, high = found.percentiles[1], found.percentiles[99]
    most = max(abs(low), abs(high)) or max(abs(found.minimum), abs(found.maximum))
    return -most, most


def around(asked: float, values: NDArray) -> tuple[float, float]:
    """The same of thicknesses on a surface: `asked` in the middle, and all of them on the scale."""
    half = max(_HALF * asked, float(np.abs(values - asked).max()))
    return asked - half, asked + half


def shares(feature: Any, found: Any, low: float, high: float) -> tuple[NDArray, NDArray]:
    """Shares of the measured area in equal steps of the scale, and the edges of these; what lies
    beyond an end counts to the last step there."""
    return area_shares(*arrays_from_mesh(feature.Mesh), found.facet_values, low, high)


def area_shares(vertices: NDArray, triangles: NDArray, facet_values: NDArray, low: float, high: float) -> tuple[NDArray, NDArray]:
    """The same of values of the facets of any mesh; NaN is not measured."""
    areas = areas_of(vertices[triangles].astype(float))
    known = np.isfinite(facet_values)
    if not high > low:  # one value: a step around it
        low, high = low - 1e-6 * max(abs(low), 1.0), high + 1e-6 * max(abs(high), 1.0)
    values = np.clip(facet_values[known], low, high)
    counted, edges = np.histogram(values, _BINS, (low, high), weights=areas[known])
    return counted / max(counted.sum(), 1e-300), edges
