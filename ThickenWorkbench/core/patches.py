# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a mesh that one means by pointing at them: what is connected without a sharp edge."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


class SmoothPatches:
    """The neighbourhood of the facets of one mesh, for repeated questions."""

    def __init__(self, vertices: ArrayLike, triangles: ArrayLike) -> None:
        corners = np.asarray(vertices, float)[np.asarray(triangles)]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
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


def _neighbours(triangles: NDArray[np.int64]) -> NDArray[np.int64]:
    """Pairs of facets with an edge in common; at an edge of more than two, each with the next."""
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    owners = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    edges, owners = edges[order], owners[order]
    same = (edges[1:] == edges[:-1]).all(axis=1)
    return np.column_stack([owners[:-1][same], owners[1:][same]])
