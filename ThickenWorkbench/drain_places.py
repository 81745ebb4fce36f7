# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where resin collects in the cavities of a solid, for a print direction: places for drain holes."""

from __future__ import annotations

from typing import Any, Iterator, NamedTuple

import numpy as np
from numpy.typing import NDArray

# Places that are tried for one hole before it is given up: so many close to the best, as many again
# further apart.
_MOST_CANDIDATES = 30

# Heights that differ by less than this share of the hole's diameter are the same.
_SAME_HEIGHT = 0.02

# A floor flatter than this against the direction can be drilled.
_LEAST_COSINE = 0.2


class Cavity(NamedTuple):
    """A closed hollow of a solid: its facets, and how much it holds."""

    shell: int
    volume: float  #: mm³
    triangles: NDArray  #: k × 3


def cavities_of(inspection: dict[str, Any], triangles: NDArray) -> list[Cavity]:
    """The cavities of a valid solid, the largest first."""
    found = [
        Cavity(number, shell["volume_mm3"], triangles[inspection["shell_of_triangle"] == number])
        for number, shell in enumerate(inspection["shells"])
        if shell["cavity"]
    ]
    return sorted(found, key=lambda cavity: (-cavity.volume, cavity.shell))


def lowest_point(vertices: NDArray, cavity: Cavity, up: NDArray) -> NDArray:
    """The lowest vertex of a cavity; of several the one that comes first."""
    corners = np.unique(cavity.triangles)
    return vertices[corners[(vertices[corners] @ up).argmin()]]


def places_for(vertices: NDArray, cavity: Cavity, up: NDArray, diameter: float, taken: list[NDArray]) -> NDArray:
    """Candidates (k × 3) for the next hole, the best first.

    The first hole of a cavity goes to its lowest place, and of a flat floor to the middle. Further
    ones go to other pools, then to other low places away from those that are `taken`.
    """
    points, is_pool = _floor(vertices, cavity, up)
    heights = points @ up
    lowest = points[heights <= heights.min() + _SAME_HEIGHT * diameter]
    middle = (lowest.min(axis=0) + lowest.max(axis=0)) / 2
    level = np.floor((heights - heights.min()) / (_SAME_HEIGHT * diameter))
    off_middle = np.linalg.norm(points - middle, axis=1)
    pools_first = np.where(is_pool, 0, 1) if taken else np.zeros(len(points))
    order = np.lexsort((np.arange(len(points)), off_middle, level, pools_first))
    for clearance in (4.0, 1.5):
        chosen = [
            *_spread(points[order], diameter / 4, taken, clearance * diameter),
            *_spread(points[order], diameter * 1.5, taken, clearance * diameter),
        ]
        if chosen:
            return np.array(chosen)
    return np.empty((0, 3))


def ways_down(vertices: NDArray, cavity: Cavity, up: NDArray, diameter: float, places: NDArray) -> list[list[NDArray]]:
    """For each place the axes of a hole there, the best first: straight down, and at a right angle
    through the floor, which a steep floor allows more often."""
    corners = vertices[cavity.triangles]
    middles = corners.mean(axis=1)
    doubled = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    ways = []
    for place in places:
        distance = np.linalg.norm(middles - place, axis=1)
        mean = doubled[distance <= max(distance.min(), diameter / 2)].sum(axis=0)
        length = np.linalg.norm(mean)
        slope = mean @ up / length if length > 0 else 0
        ways.append([-up, -mean / length] if 0.2 < slope < 0.99 else [-up])
    return ways


def _floor(vertices: NDArray, cavity: Cavity, up: NDArray) -> tuple[NDArray, NDArray]:
    """Points of the floor of a cavity, and which of them are lower than all around them."""
    corners = vertices[cavity.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.maximum(np.linalg.norm(normals, axis=1), 1e-300)
    floor = normals @ up > _LEAST_COSINE * lengths
    ids = np.unique(cavity.triangles)
    heights = vertices @ up
    is_lowest = np.ones(len(vertices), bool)
    for a, b in ((0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)):
        start, end = cavity.triangles[:, a], cavity.triangles[:, b]
        is_lowest[start[heights[end] < heights[start]]] = False
    middles = corners[floor].mean(axis=1)
    # The middle of a flat floor is seldom a vertex or the middle of a triangle.
    centre = _centre_of_bottom(corners[floor].reshape(-1, 3), up)
    points = np.concatenate([vertices[ids], middles, centre])
    is_pool = np.concatenate([is_lowest[ids], np.zeros(len(middles) + len(centre), bool)])
    return points, is_pool


def _centre_of_bottom(points: NDArray, up: NDArray) -> NDArray:
    """The centre of the box around the lowest of `points`, as 1 × 3; nothing for none."""
    if len(points) == 0:
        return points
    heights = points @ up
    lowest = points[heights <= heights.min() + 1e-6 * np.ptp(heights)]
    return (lowest.min(axis=0, keepdims=True) + lowest.max(axis=0, keepdims=True)) / 2


def _spread(points: NDArray, spacing: float, taken: list[NDArray], clearance: float) -> Iterator[NDArray]:
    """The points in their order, leaving out those that are too close to others."""
    chosen: list[NDArray] = []
    for point in points:
        if any(np.linalg.norm(point - other) < clearance for other in taken):
            continue
        if chosen and np.linalg.norm(np.array(chosen) - point, axis=1).min() < spacing:
            continue
        chosen.append(point)
        yield point
        if len(chosen) == _MOST_CANDIDATES:
            return
