# SPDX-License-Identifier: LGPL-2.1-or-later
"""What resin stays in a cavity below its lowest hole."""

from __future__ import annotations

from typing import Any, Iterator, NamedTuple, Sequence

import numpy as np
from numpy.typing import NDArray

from .drain_places import Cavity, lowest_point

# What stays below a hole is worth a warning when it is deeper than this share of the hole's diameter.
_DEEP = 0.25


class Pool(NamedTuple):
    depth: float  #: mm, from the lowest place of the cavity to the lower edge of its lowest hole
    volume: float  #: mm³ of the cavity below that edge; less where a part of it is drained elsewhere
    place: NDArray  #: the lowest place
    cavity: Cavity


class HoleEnds(NamedTuple):
    """Where the axis of a hole meets the two sides of the wall."""

    entry: NDArray
    exit: NDArray


def pools(
    extension: Any, vertices: NDArray, cavities: Sequence[Cavity], holes: Sequence[HoleEnds], up: NDArray, diameter: float
) -> Iterator[Pool]:
    """The pools that are left in the cavities of a solid by holes in its wall; cavities without a hole have none."""
    if not cavities or not holes:
        return
    ends = np.array([[hole.entry, hole.exit] for hole in holes], float)
    nearest = _nearest_ends(extension, vertices, cavities, ends)
    for number, cavity in enumerate(cavities):
        levels = [_lower_edge(ends[hole], end, up, diameter) for hole, (own, end) in enumerate(nearest) if own == number]
        if not levels:
            continue
        lowest = lowest_point(vertices, cavity, up)
        depth = min(levels) - float(lowest @ up)
        if depth > _DEEP * diameter:
            yield Pool(depth, volume_below(vertices[cavity.triangles], up, min(levels)), lowest, cavity)


def volume_below(corners: NDArray, up: NDArray, level: float) -> float:
    """The volume that closed triangles (k × 3 × 3) enclose below a level, mm³, whichever way they are turned.

    Summed over prisms from each triangle, or what of it is below, up to the level.
    """
    heights = corners @ up
    total = 0.0
    for triangle, height in zip(corners[heights.min(axis=1) < level], heights[heights.min(axis=1) < level]):
        polygon = _below(triangle, height - level)
        for k in range(1, len(polygon) - 1):
            part = polygon[[0, k, k + 1]]
            shadow = np.cross(part[1] - part[0], part[2] - part[0]) @ up / 2
            total += shadow * (level - (part @ up).mean())
    return abs(total)


def _below(triangle: NDArray, heights: NDArray) -> NDArray:
    """The corners of the part of a triangle with heights below 0."""
    kept = []
    for k in range(3):
        here, following = heights[k], heights[(k + 1) % 3]
        if here < 0:
            kept.append(triangle[k])
        if (here < 0) != (following < 0):
            kept.append(triangle[k] + here / (here - following) * (triangle[(k + 1) % 3] - triangle[k]))
    return np.array(kept)


def _nearest_ends(extension: Any, vertices: NDArray, cavities: Sequence[Cavity], ends: NDArray) -> list[tuple[int, int]]:
    """For each hole the cavity that it leads to, and which of its ends is there."""
    away = np.stack([
        extension.closest_points(vertices, cavity.triangles, ends.reshape(-1, 3))["distance"].reshape(-1, 2)
        for cavity in cavities
    ], axis=1)  # fmt: skip
    return [divmod(int(found.argmin()), 2) for found in away]


def _lower_edge(ends: NDArray, end: int, up: NDArray, diameter: float) -> float:
    """The height at which resin still runs into a hole."""
    along = ends[1] - ends[0]
    slant = (along @ up) ** 2 / max(float(along @ along), 1e-300)
    return float(ends[end] @ up) - diameter / 2 * float(np.sqrt(max(1 - slant, 0)))
