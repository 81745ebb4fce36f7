# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes pawn.ply: a rounded chess pawn, 60 mm tall, closed, of even triangles: `python3 make_pawn.py`."""

from pathlib import Path

import numpy as np

# Radius and height, from the foot to the top, mm.
OUTLINE = [(0, 0), (8, 0), (13, 0.8), (15.5, 4), (14.5, 9), (11, 15), (8, 23), (7, 32), (8, 38),
           (11, 44), (12, 50), (10, 56), (5.5, 59.4), (0, 60)]  # fmt: skip
LEVELS = 4  # 20 · 4^4 triangles


def icosphere(levels: int) -> tuple[np.ndarray, np.ndarray]:
    """Points on the unit sphere and triangles, outwards."""
    g = (1 + 5**0.5) / 2
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
              (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]  # fmt: skip
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
                 (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11),
                 (6, 2, 10), (8, 6, 7), (9, 8, 1)]  # fmt: skip
    vertices, faces = np.array(points, float), np.array(triangles)
    for _ in range(levels):
        edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        unique, inverse = np.unique(edges, axis=0, return_inverse=True)
        a, b, c = faces.T
        ab, bc, ca = (inverse.ravel() + len(vertices)).reshape(3, -1)
        vertices = np.concatenate([vertices, vertices[unique].mean(axis=1)])
        corners = [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = np.concatenate([np.column_stack(corner) for corner in corners])
    return vertices / np.linalg.norm(vertices, axis=1, keepdims=True), faces


def rounded(outline: np.ndarray, count: int = 2000) -> np.ndarray:
    """A Catmull-Rom curve through the outline, at equal steps of its length."""
    ends = [outline[1] * [-1, 1], *outline, outline[-2] * [-1, 1]]  # mirrored at the axis: round there, too
    p = np.array(ends, float)
    t = np.linspace(0, 1, 100, endpoint=False)[:, None]
    pieces = [
        0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t**2 + (3 * b - a - 3 * c + d) * t**3)
        for a, b, c, d in zip(p, p[1:], p[2:], p[3:])
    ]
    curve = np.concatenate([*pieces, outline[-1:]])
    way = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    steps = np.linspace(0, way[-1], count)
    return np.column_stack([np.interp(steps, way, curve[:, k]) for k in range(2)])


def pawn() -> tuple[np.ndarray, np.ndarray]:
    """The sphere, each circle of latitude moved to the outline."""
    sphere, triangles = icosphere(LEVELS)
    curve = rounded(np.array(OUTLINE, float))
    share = np.arccos(np.clip(-sphere[:, 2], -1, 1)) / np.pi
    at = share * (len(curve) - 1)
    radius, height = (np.interp(at, np.arange(len(curve)), curve[:, k]) for k in range(2))
    around = np.arctan2(sphere[:, 1], sphere[:, 0])
    return np.column_stack([radius * np.cos(around), radius * np.sin(around), height]).astype(np.float32), triangles


def main() -> None:
    vertices, triangles = pawn()
    header = (
        "ply\nformat binary_little_endian 1.0\ncomment a chess pawn, millimetres\n"
        f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.empty(len(triangles), np.dtype([("corners", "u1"), ("index", "<i4", 3)]))
    rows["corners"], rows["index"] = 3, triangles
    target = Path(__file__).with_name("pawn.ply")
    target.write_bytes(header.encode() + vertices.astype("<f4").tobytes() + rows.tobytes())


if __name__ == "__main__":
    main()
