# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where resin collects in the cavities of a solid, for a print direction: places for drain holes."""

from __future__ import annotations

from typing import Any, Iterator, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .facets import doubled_normals

# Places that are tried for one hole before it is given up: so many close to the best, as many again
# further apart.
_MOST_CANDIDATES = 30

# Points on the longest side of a triangle that are looked at.
_MOST_STEPS = 20

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


def places_for(vertices: NDArray, cavity: Cavity, up: NDArray, diameter: float, taken: list[NDArray]) -> list[NDArray]:
    """Candidates for the next hole: groups (k × 3), and within each, the best first.

    The first hole of a cavity goes to its lowest place, and of a flat floor to the middle. Further
    ones go to other pools, then to other low places away from those that are `taken`.
    """
    points, is_pool = _floor(vertices, cavity, up, diameter)
    heights = points @ up
    lowest = points[heights <= heights.min() + _SAME_HEIGHT * diameter]
    middle = (lowest.min(axis=0) + lowest.max(axis=0)) / 2
    level = np.floor((heights - heights.min()) / (_SAME_HEIGHT * diameter))
    off_middle = np.linalg.norm(points - middle, axis=1)
    pools_first = np.where(is_pool, 0, 1) if taken else np.zeros(len(points))
    order = np.lexsort((np.arange(len(points)), off_middle, level, pools_first))
    # Close to the best place first, then anywhere, and further from other holes first.
    tries = [(4.0, 0.25), (1.5, 0.25), (4.0, 1.5), (1.5, 1.5)] if taken else [(0.0, 0.25), (0.0, 1.5)]
    groups = [
        np.array(list(_spread(points[order], spacing * diameter, taken, clearance * diameter)))
        for clearance, spacing in tries
    ]
    return [group for group in groups if len(group)]


def ways_down(
    vertices: NDArray, cavity: Cavity, up: NDArray, diameter: float, places: NDArray
) -> list[tuple[NDArray, NDArray]]:
    """Places with the axis of a hole there: all straight down first, then those at a right angle through
    the floor, which a steep floor allows more often."""
    corners = vertices[cavity.triangles]
    middles = corners.mean(axis=1)
    doubled = doubled_normals(corners)
    slanted = []
    for place in places:
        distance = np.linalg.norm(middles - place, axis=1)
        mean = doubled[distance <= max(distance.min(), diameter / 2)].sum(axis=0)
        length = np.linalg.norm(mean)
        if length > 0 and _LEAST_COSINE < mean @ up / length < 0.99:
            slanted.append((place, -mean / length))
    return [(place, -up) for place in places] + slanted


def _floor(vertices: NDArray, cavity: Cavity, up: NDArray, diameter: float) -> tuple[NDArray, NDArray]:
    """Points of the floor of a cavity, and which of them are lower than all around them."""
    corners = vertices[cavity.triangles]
    normals = doubled_normals(corners)
    lengths = np.maximum(np.linalg.norm(normals, axis=1), 1e-300)
    floor = normals @ up > _LEAST_COSINE * lengths
    ids = np.unique(cavity.triangles)
    heights = vertices @ up
    is_lowest = np.ones(len(vertices), bool)
    for a, b in ((0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)):
        start, end = cavity.triangles[:, a], cavity.triangles[:, b]
        is_lowest[start[heights[end] <= heights[start]]] = False
    middles = np.concatenate([corners[floor].mean(axis=1), _samples(corners[floor], diameter)])
    # The middle of a flat floor is seldom a vertex or the middle of a triangle.
    centre = _centre_of_bottom(corners[floor].reshape(-1, 3), up)
    points = np.concatenate([vertices[ids], middles, centre])
    is_pool = np.concatenate([is_lowest[ids], np.zeros(len(middles) + len(centre), bool)])
    return points, is_pool


def _samples(corners: NDArray, spacing: float) -> NDArray:
    """Points on those triangles that are too large for their corners and middles to stand for them."""
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    found = [np.empty((0, 3))]
    for triangle in corners[longest > 2 * spacing]:
        steps = min(int(longest.max() / spacing) + 1, _MOST_STEPS)
        i, j = np.divmod(np.arange((steps + 1) ** 2), steps + 1)
        shares = np.column_stack([i, j, steps - i - j])[i + j <= steps] / steps
        found.append(shares @ triangle)
    return np.concatenate(found)


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
