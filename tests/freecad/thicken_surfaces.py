# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces for tests, as arrays: vertices n × 3 (floats by value), triangles m × 3."""

from __future__ import annotations

import numpy as np


def grid(height, size: float = 20.0, n: int = 15):
    """The graph of `height(x, y)` over a square about the origin, normals upwards."""
    x, y = np.meshgrid(np.linspace(-size / 2, size / 2, n), np.linspace(-size / 2, size / 2, n))
    vertices = np.column_stack([x.ravel(), y.ravel(), height(x, y).ravel()])
    index = np.arange(n * n).reshape(n, n)
    a, b, c, d = (index[i : n - 1 + i, j : n - 1 + j].ravel() for i in (0, 1) for j in (0, 1))
    triangles = np.concatenate([np.column_stack([a, b, d]), np.column_stack([a, d, c])])
    return vertices.astype(np.float32), triangles


def plate(size: float = 20.0, n: int = 11):
    return grid(lambda x, y: 0 * x, size, n)


def saddle():
    return grid(lambda x, y: (x * x - y * y) / 30)


def together(*surfaces):
    """Several surfaces as one mesh."""
    starts = np.cumsum([0] + [len(vertices) for vertices, _ in surfaces])
    return (
        np.concatenate([vertices for vertices, _ in surfaces]),
        np.concatenate([triangles + start for (_, triangles), start in zip(surfaces, starts)]),
    )


def crossing_plates():
    """A plate and a tilted one through it: self-intersecting along the y axis."""
    return together(plate(), grid(lambda x, y: 0.21 * x + 0.013))


def fin():
    """A plate with a triangle that stands on one of its inner edges: not manifold there."""
    vertices, triangles = plate()
    a, b = triangles[60, 0], triangles[60, 2]
    top = vertices[a] + np.array([0.3, 0.4, 5], np.float32)
    return np.vstack([vertices, top]), np.vstack([triangles, [a, b, len(vertices)]])
