# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a mesh that one means by pointing at them: what is connected without a sharp edge, or lies below a brush."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .facets import doubled_normals, edges_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


class SmoothPatches:
    """The neighbourhood of the facets of one mesh, for repeated questions."""

    def __init__(self, vertices: ArrayLike, triangles: ArrayLike) -> None:
        corners = np.asarray(vertices, float)[np.asarray(triangles)]
        normals = doubled_normals(corners)
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        self._normals = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
        self._count = len(corners)
        self._pairs = _neighbours(np.asarray(triangles, np.int64))
        cosines = np.einsum("ij,ij->i", self._normals[self._pairs[:, 0]], self._normals[self._pairs[:, 1]])
        self._angles = np.degrees(np.arccos(np.clip(cosines, -1, 1)))

    def around(self, facet: int, sharpest: float) -> NDArray[np.int64]:
        """The facets that are reached from `facet` over edges where the normals turn by at most `sharpest`
        degrees, in ascending order."""
        pairs = self._pairs[self._angles <= sharpest]
        both = np.concatenate([pairs, pairs[:, ::-1]])
        both = both[np.argsort(both[:, 0], kind="stable")]
        first = np.searchsorted(both[:, 0], np.arange(self._count + 1))
        reached = np.zeros(self._count, bool)
        reached[facet] = True
        front = np.array([facet])
        while len(front):
            # All neighbours of the front at once: rings of facets, not one facet at a time.
            runs = [both[first[f] : first[f + 1], 1] for f in front]
            found = np.unique(np.concatenate(runs)) if runs else front[:0]
            front = found[~reached[found]]
            reached[front] = True
        return np.flatnonzero(reached)


class Brush:
    """Paints on the facets of one mesh: along the surface, so that the other side of a thin part stays as it is."""

    def __init__(self, vertices: ArrayLike, triangles: ArrayLike) -> None:
        self._corners = np.asarray(vertices, float)[np.asarray(triangles)]
        self._middles = self._corners.mean(axis=1)
        self._reach = np.linalg.norm(self._corners - self._middles[:, None], axis=2).max(axis=1)
        self._pairs = _neighbours(np.asarray(triangles, np.int64))

    def facet_at(self, place: ArrayLike) -> int:
        """The facet that is nearest to a place."""
        return self._nearest(place, self._away(place))

    def around(self, place: ArrayLike, radius: float) -> NDArray[np.int64]:
        """The facet at a place, and those connected with it whose middles are within `radius` of the place; ascending."""
        away = self._away(place)
        facet = self._nearest(place, away)
        within = away <= radius
        within[facet] = True
        pairs = self._pairs[within[self._pairs].all(axis=1)]
        reached = np.zeros(len(within), bool)
        reached[facet] = True
        while len(front := pairs[reached[pairs[:, 0]] != reached[pairs[:, 1]]]):
            reached[front] = True
        return np.flatnonzero(reached)

    def _away(self, place: ArrayLike) -> NDArray[np.float64]:
        """From a place to the middle of each facet."""
        offset = self._middles - place
        return np.sqrt(np.einsum("ij,ij->i", offset, offset))

    def _nearest(self, place: ArrayLike, away: NDArray) -> int:
        # A facet cannot be nearer than its middle less its reach, and the nearest is no farther than the nearest middle.
        candidates = np.flatnonzero(away - self._reach <= away.min())
        return int(candidates[np.argmin(_distances(np.asarray(place, float), self._corners[candidates]))])


def _distances(point: NDArray, corners: NDArray) -> NDArray[np.float64]:
    """From a point to each triangle: to its plane where the point is above it, else to its edges."""
    a, b, c = corners.transpose(1, 0, 2)
    normal = np.cross(b - a, c - a)
    length = np.linalg.norm(normal, axis=1)
    unit = np.divide(normal, length[:, None], out=np.zeros_like(normal), where=length[:, None] > 0)
    inside = length > 0
    nearest = np.full(len(corners), np.inf)
    for start, end in ((a, b), (b, c), (c, a)):
        along = end - start
        square = np.maximum(np.einsum("ij,ij->i", along, along), 1e-300)
        share = np.clip(np.einsum("ij,ij->i", point - start, along) / square, 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(start + share[:, None] * along - point, axis=1))
        inside &= np.einsum("ij,ij->i", np.cross(along, point - start), unit) >= 0
    height = np.abs(np.einsum("ij,ij->i", point - a, unit))
    return np.where(inside, height, nearest)


def _neighbours(triangles: NDArray[np.int64]) -> NDArray[np.int64]:
    """Pairs of facets with an edge in common; at an edge of more than two, each with the next."""
    edges = edges_of(triangles)
    owners = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    edges, owners = edges[order], owners[order]
    same = (edges[1:] == edges[:-1]).all(axis=1)
    return np.column_stack([owners[:-1][same], owners[1:][same]])
