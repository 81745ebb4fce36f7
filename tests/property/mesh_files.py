# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes as (vertices n×3 float64, triangles m×3 int), written to files and read back, apart from the library's own code."""

from __future__ import annotations

from pathlib import Path

import numpy as np

FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
FACE = np.dtype([("count", "u1"), ("corners", "<u4", 3)])


def write_mesh(path: Path, vertices: np.ndarray, triangles: np.ndarray) -> None:
    """Coordinates that are floats are stored without change: .stl, and .ply with "property float"."""
    if path.suffix == ".stl":
        facets = np.zeros(len(triangles), FACET)
        facets["corners"] = vertices[triangles]
        path.write_bytes(bytes(80) + np.uint32(len(triangles)).tobytes() + facets.tobytes())
        return
    head = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
    head += [f"property float {axis}" for axis in "xyz"]
    head += [f"element face {len(triangles)}", "property list uchar uint vertex_indices", "end_header", ""]
    faces = np.zeros(len(triangles), FACE)
    faces["count"], faces["corners"] = 3, triangles
    path.write_bytes("\n".join(head).encode() + vertices.astype("<f4").tobytes() + faces.tobytes())


def read_corners(path: Path) -> np.ndarray:
    """The corners of all triangles, m×3×3, of a file that the program wrote or write_mesh() did."""
    data = path.read_bytes()
    if path.suffix == ".stl":
        return np.frombuffer(data, FACET, offset=84)["corners"].astype(float)
    head, body = data.split(b"end_header\n", 1)
    lines = head.decode().splitlines()
    if "format binary_little_endian 1.0" not in lines:
        raise ValueError(f"{path} is not binary")
    counts = [int(line.split()[2]) for line in lines if line.startswith("element ")]
    real = "<f8" if "property double x" in lines else "<f4"
    vertices = np.frombuffer(body, real, 3 * counts[0]).reshape(-1, 3).astype(float)
    faces = np.frombuffer(body, FACE, counts[1], offset=vertices.size * np.dtype(real).itemsize)
    if not (faces["count"] == 3).all():
        raise ValueError(f"{path} has other faces than triangles")
    return vertices[faces["corners"]]


def read_mesh(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Corners of equal coordinates are one vertex."""
    vertices, index = np.unique(read_corners(path).reshape(-1, 3), axis=0, return_inverse=True)
    return vertices, index.reshape(-1, 3)
