# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangle surfaces in binary PLY files, and finer ones made of them; the standard library only."""

import math
from array import array
from pathlib import Path


def read_ply(path: Path) -> tuple[array, array]:
    """Coordinates, three a vertex, and indices, three a triangle, of a binary little-endian file that
    holds these alone: float or double x y z, uchar-counted lists of int."""
    head, body = path.read_bytes().split(b"end_header\n", 1)
    words = head.decode("ascii").split()
    if "binary_little_endian" not in words:
        raise ValueError(f"{path}: not a binary little-endian PLY file")
    vertices, faces = (int(words[words.index(name) + 1]) for name in ("vertex", "face"))
    positions = array("d" if "double" in words else "f")
    size = 3 * vertices * positions.itemsize
    positions.frombytes(body[:size])
    if len(body) - size != 13 * faces:
        raise ValueError(f"{path}: more in it than coordinates and triangles")
    corners = array("i")
    corners.frombytes(b"".join(body[i + 1 : i + 13] for i in range(size, len(body), 13)))
    return array("d", positions), corners


def write_ply(path: Path, positions: array, corners: array) -> None:
    """Writes floats, as scans are stored."""
    head = ("ply\nformat binary_little_endian 1.0\n"
            f"element vertex {len(positions) // 3}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {len(corners) // 3}\nproperty list uchar int vertex_indices\nend_header\n")  # fmt: skip
    data = corners.tobytes()
    faces = b"".join(b"\x03" + data[i : i + 12] for i in range(0, len(data), 12))
    path.write_bytes(head.encode() + array("f", positions).tobytes() + faces)


def subdivided(positions: array, corners: array) -> tuple[array, array]:
    """Every triangle as four, by the middles of its edges."""
    positions, finer = array("d", positions), array("i")
    middle: dict[tuple[int, int], int] = {}

    def middle_of(a: int, b: int) -> int:
        key = (a, b) if a < b else (b, a)
        if key not in middle:
            middle[key] = len(positions) // 3
            positions.extend((positions[3 * a + k] + positions[3 * b + k]) / 2 for k in range(3))
        return middle[key]

    for i in range(0, len(corners), 3):
        a, b, c = corners[i : i + 3]
        ab, bc, ca = middle_of(a, b), middle_of(b, c), middle_of(c, a)
        finer.extend((a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca))
    return positions, finer


def subdivided_to(positions: array, corners: array, triangles: int) -> tuple[array, array]:
    """Subdivided as often as comes nearest to so many triangles, by their ratio."""
    levels = round(math.log(max(1.0, 3 * triangles / len(corners)), 4))
    for _ in range(levels):
        positions, corners = subdivided(positions, corners)
    return positions, corners
