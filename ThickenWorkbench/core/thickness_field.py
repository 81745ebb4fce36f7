# SPDX-License-Identifier: LGPL-2.1-or-later
"""A thickness for each vertex of a surface: regions of facets have one of their own, and around them it changes linearly."""

from __future__ import annotations

from typing import TYPE_CHECKING, Sequence

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

# A way that is shorter by less than this share of the limit is the same: rounding would keep the search going.
_SAME_WAY = 1e-9


def region_weights(
    vertices: ArrayLike, triangles: ArrayLike, regions: Sequence[ArrayLike], transition: float
) -> NDArray[np.float64]:
    """How much of each region there is at each vertex, k × n, from 0 to 1.

    A region is a list of facets. The weight is 1 at their corners, and falls linearly with the distance along the
    surface to 0 at `transition` mm. Vertices with equal coordinates are one.
    """
    points, numbers = np.unique(np.asarray(vertices, float), axis=0, return_inverse=True)
    corners = numbers.reshape(-1)[np.asarray(triangles, np.int64)]
    weights = np.zeros((len(regions), len(np.asarray(vertices))))
    for row, facets in zip(weights, regions):
        inside = np.zeros(len(points), bool)
        inside[corners[np.asarray(facets, np.int64)]] = True
        weight = inside.astype(float)
        if transition > 0:
            weight = np.clip(1 - distance_along(points, corners, inside, transition) / transition, 0, 1)
        row[:] = weight[numbers.reshape(-1)]
    return weights


def blended(base: float, thicknesses: Sequence[float], weights: NDArray) -> NDArray[np.float64]:
    """The thickness at each vertex, mm: `base` where no region has a weight, that of a region where its weight alone is 1.

    Where the weights of several sum up to more than 1 it is their mean, so that no thickness jumps between regions.
    """
    summed = weights.sum(axis=0)
    of_regions = np.asarray(thicknesses, float) @ weights
    return (base * np.maximum(1 - summed, 0) + of_regions) / np.maximum(summed, 1)


def distance_along(vertices: NDArray, triangles: NDArray, inside: NDArray, limit: float) -> NDArray[np.float64]:
    """The distance of each vertex from those that are `inside`, along the surface, mm; infinite where it exceeds `limit`.

    The scheme of Bornemann and Rasch (2006): the distance is linear along each edge, and a straight way from the opposite
    edge leads to a corner. It is exact where the front of equal distances is straight, and else off by the order of
    an edge times the front's curvature. All triangles beside vertices that have changed are looked at in one round, until none changes.
    """
    triangles = np.asarray(triangles, np.int64)
    # As good as infinite, without the sums of infinities that are no numbers.
    far = 1e3 * (limit + np.linalg.norm(np.ptp(vertices, axis=0)))
    distance = np.where(inside, 0.0, far)
    first, star = _stars(triangles, len(vertices))
    changed = np.flatnonzero(inside)
    while len(changed):
        active = triangles[_beside(changed, first, star)]
        before = distance.copy()
        for role in range(3):
            a, b, c = (active[:, (role + k) % 3] for k in range(3))
            ways = _way_over(vertices[a], vertices[b], vertices[c], before[a], before[b])
            np.minimum.at(distance, c, np.where(ways <= limit, ways, far))
        changed = np.flatnonzero(distance < before - _SAME_WAY * limit)
    return np.where(distance <= limit, distance, np.inf)


def _way_over(a: NDArray, b: NDArray, c: NDArray, at_a: NDArray, at_b: NDArray) -> NDArray[np.float64]:
    """The shortest distance at `c` of those that come straight from a point of the edge between `a` and `b`."""
    edge = b - a
    length = np.maximum(np.linalg.norm(edge, axis=1), 1e-300)
    along = np.einsum("ij,ij->i", c - a, edge) / length
    height = np.linalg.norm(c - a - (along / length)[:, None] * edge, axis=1)
    slope = np.clip((at_b - at_a) / length, -1, 1)
    # Where the derivative along the edge is 0; beyond an end the end is best, since the way is a convex function.
    offset = slope * height / np.sqrt(np.maximum(1 - slope**2, 1e-30))
    share = np.clip((along - offset) / length, 0, 1)
    return at_a + share * (at_b - at_a) + np.hypot(height, along - share * length)


def _stars(triangles: NDArray, count: int) -> tuple[NDArray, NDArray]:
    """Triangles around each vertex: those of v are star[first[v]:first[v + 1]]."""
    order = np.argsort(triangles.ravel(), kind="stable")
    return np.searchsorted(triangles.ravel()[order], np.arange(count + 1)), order // 3


def _beside(chosen: NDArray, first: NDArray, star: NDArray) -> NDArray:
    """The triangles around any of the chosen vertices."""
    counts = first[chosen + 1] - first[chosen]
    offsets = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    return np.unique(star[np.repeat(first[chosen], counts) + offsets])
