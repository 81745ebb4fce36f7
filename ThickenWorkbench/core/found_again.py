# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds facets that were chosen of a surface on what has become of it: by their corners, else by their place."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from thicken import native

from .facets import areas_of, doubled_normals

if TYPE_CHECKING:
    from numpy.typing import NDArray

# Of the mean edge of the chosen facets: how far the middle of a facet may be beside them, and above or below them.
# Beside: that of the nearest neighbour of an even mesh is three times as far. Above: what two scans of one thing differ by.
_BESIDE, _ABOVE = 0.1, 1.0


class Found(NamedTuple):
    facets: NDArray[np.int64]  #: ascending
    share: float  #: of the area that was chosen, at most 1


def found_again(chosen: NDArray, vertices: NDArray, triangles: NDArray) -> Found:
    """The facets of a surface that lie where `chosen` (k × 3 × 3 corners, k > 0) do.

    Facets with the very corners of chosen ones are those, in any order. Where some of these are missing, as after a
    trim, a repair or another scan, all others count whose middle lies on one of the missing and that face the same way.
    """
    same, missing = _identical(np.asarray(chosen, np.float32), np.asarray(vertices, np.float32), triangles)
    if missing.any():
        others = np.flatnonzero(~same)
        corners = np.asarray(vertices, float)[np.asarray(triangles)[others]]
        same[others[_lie_on(corners, np.asarray(chosen, float)[missing])]] = True
    area = areas_of(np.asarray(vertices, float)[np.asarray(triangles)[same]]).sum()
    whole = areas_of(np.asarray(chosen, float)).sum()
    return Found(np.flatnonzero(same), 1.0 if not missing.any() else min(1.0, float(area / max(whole, 1e-300))))


def _identical(chosen: NDArray, vertices: NDArray, triangles: NDArray) -> tuple[NDArray, NDArray]:
    """Which triangles of the surface have the corners of a chosen one, and which of the chosen there are not."""
    places = np.concatenate([chosen.reshape(-1, 3), vertices])
    numbers = np.unique(places, axis=0, return_inverse=True)[1].reshape(-1)
    count = len(chosen)
    rows = np.concatenate([numbers[: 3 * count].reshape(-1, 3), numbers[3 * count :][np.asarray(triangles)]])
    kinds = np.unique(np.sort(rows, axis=1), axis=0, return_inverse=True)[1].reshape(-1)
    return np.isin(kinds[count:], kinds[:count]), ~np.isin(kinds[:count], kinds[count:])


def _lie_on(corners: NDArray, chosen: NDArray) -> NDArray[np.bool_]:
    """Whether the middle of each triangle lies on a chosen one, and both face the same way."""
    middles = corners.mean(axis=1)
    closest: Any = native.load().closest_points(chosen.reshape(-1, 3), np.arange(3 * len(chosen)).reshape(-1, 3), middles)
    normals = _normals(chosen)[closest["triangle"]]
    offset = middles - closest["point"]
    above = np.einsum("ij,ij->i", offset, normals)
    beside = np.linalg.norm(offset - above[:, None] * normals, axis=1)
    edge = np.linalg.norm(chosen - np.roll(chosen, 1, axis=1), axis=2).mean()
    faces_same_way = np.einsum("ij,ij->i", _normals(corners), normals) > 0
    return (beside <= _BESIDE * edge) & (np.abs(above) <= _ABOVE * edge) & faces_same_way


def _normals(corners: NDArray) -> NDArray:
    normals = doubled_normals(corners)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
