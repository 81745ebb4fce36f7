# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces for the tests, as (vertices, triangles), and the files they go into."""

from __future__ import annotations

import math
import struct
from array import array
from pathlib import Path


def wave(n: int, size: float = 20.0, height: float = 1.5):
    """A height field of 2·n² triangles, facing up, with one rim; its coordinates are float values."""
    def rounded(x: float) -> float:
        return struct.unpack("<f", struct.pack("<f", x))[0]

    step = size / n
    vertices = [
        tuple(map(rounded, (i * step, j * step, height * math.sin(6 * i / n) * math.cos(5 * j / n))))
        for j in range(n + 1)
        for i in range(n + 1)
    ]
    triangles = []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            b, c, d = a + 1, a + n + 2, a + n + 1
            triangles += [(a, b, c), (a, c, d)]
    return vertices, triangles


SQUARE = ([(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)], [(0, 1, 2), (0, 2, 3)])


# A wall on the middle line of a floor: three triangles at an edge.
TEE = (
    [(0, 0, 0), (2, 0, 0), (4, 0, 0), (0, 4, 0), (2, 4, 0), (4, 4, 0), (2, 0, 2), (2, 4, 2)],
    [(0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (1, 4, 7), (1, 7, 6)],
)


def with_extra(extra_vertices, extra_triangles, base=SQUARE):
    """`base` and more: indices of the extra triangles count on after its vertices."""
    return base[0] + list(extra_vertices), base[1] + list(extra_triangles)


def write_off(path: Path, surface) -> Path:
    vertices, triangles = surface
    lines = ["OFF", f"{len(vertices)} {len(triangles)} 0"]
    lines += [" ".join(repr(float(x)) for x in v) for v in vertices]
    lines += ["3 " + " ".join(map(str, t)) for t in triangles]
    path.write_text("\n".join(lines) + "\n")
    return path


def write_ply(path: Path, surface) -> Path:
    """Binary, for large surfaces."""
    vertices, triangles = surface
    head = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    points = array("f", (x for v in vertices for x in v)).tobytes()
    path.write_bytes(head.encode() + points + b"".join(struct.pack("<B3i", 3, *t) for t in triangles))
    return path


def read_stl(path: Path) -> list[tuple]:
    """The triangles of a binary STL, each three exact corners."""
    data = path.read_bytes()
    (count,) = struct.unpack_from("<I", data, 80)
    assert len(data) == 84 + 50 * count, "the STL has not the length that its count means"
    triangles = []
    for k in range(count):
        numbers = struct.unpack_from("<12f", data, 84 + 50 * k)
        triangles.append((numbers[3:6], numbers[6:9], numbers[9:12]))
    return triangles


def turned_to_start(triangle: tuple) -> tuple:
    """The same triangle in the same sense, from its smallest corner."""
    k = triangle.index(min(triangle))
    return triangle[k:] + triangle[:k]
