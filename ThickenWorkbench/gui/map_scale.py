# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the scale of a thickness map begins and ends, and how the area is spread over it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..mesh_io import arrays_from_mesh

_BINS = 40


def ends(found: Any) -> tuple[float, float]:
    """The least and the largest value with a colour of its own.

    A few facets at an edge can lie far beyond all others and would leave one colour for these. But
    nothing thin is hidden, and a deviation has 0 in its middle.
    """
    low, high = found.percentiles[1], found.percentiles[99]
    if found.what == "deviation":
        most = max(abs(low), abs(high)) or max(abs(found.minimum), abs(found.maximum))
        return -most, most
    return found.minimum, high if high > found.minimum else found.maximum


def shares(feature: Any, found: Any, low: float, high: float) -> tuple[NDArray, NDArray]:
    """Shares of the measured area in equal steps of the scale, and the edges of these; what lies
    beyond an end counts to the last step there."""
    vertices, triangles = arrays_from_mesh(feature.Mesh)
    corners = vertices[triangles].astype(float)
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    known = np.isfinite(found.facet_values)
    if not high > low:  # one value: a step around it
        low, high = low - 1e-6 * max(abs(low), 1.0), high + 1e-6 * max(abs(high), 1.0)
    values = np.clip(found.facet_values[known], low, high)
    counted, edges = np.histogram(values, _BINS, (low, high), weights=areas[known])
    return counted / max(counted.sum(), 1e-300), edges
