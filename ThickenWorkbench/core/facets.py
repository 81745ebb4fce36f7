# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the triangles of a mesh have each: normals, areas, edges."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def doubled_normals(corners: NDArray) -> NDArray:
    """The normals of triangles, n × 3 × 3 corners, as long as twice the area."""
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def areas_of(corners: NDArray) -> NDArray:
    """The areas of triangles, n × 3 × 3 corners."""
    return np.linalg.norm(doubled_normals(corners), axis=1) / 2


def edges_of(triangles: NDArray) -> NDArray:
    """The edges of n triangles, 3 n × 2, the lesser end first: the first edges of all, then the second, then the third."""
    return np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
