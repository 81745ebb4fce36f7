# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a closed triangle mesh as a polyhedral solid in Open CASCADE's binary format for shapes.

Vertices and edges are shared because they are written once: nothing has to be found again by sewing.
The format is that of BinTools_ShapeSet, version 3, which every Open CASCADE since 7.0 reads; its
records have a fixed length for each kind of shape, so that NumPy fills them as arrays. Edges need no
parametric curves on planes.

Indices of shapes count backwards from the last one written; those of curves and surfaces from 1.
"""

from __future__ import annotations

from typing import Any, Callable, NamedTuple

import numpy as np
from numpy.typing import NDArray

_SHELL_FLAGS = bytes([0, 1, 0, 1, 1, 0, 0])  # free, modified, checked, orientable, closed, infinite, convex
_SOLID_FLAGS = bytes([0, 1, 0, 0, 0, 0, 0])
_ROOT_FLAGS = bytes([1, 1, 0, 0, 0, 0, 0])
_END = b"*"

# From the number of a part, or an array of them, to what the file calls it.
_Index = Callable[[Any], Any]

_SUB = [("reversed", "u1"), ("index", "<i4"), ("location", "<i4")]
_VERTEX = np.dtype([("kind", "u1"), ("tolerance", "<f8"), ("point", "<f8", 3), ("curves", "u1"), ("flags", "S7"),
                    ("end", "S1")])  # fmt: skip
_EDGE = np.dtype([("kind", "u1"), ("tolerance", "<f8"), ("same", "u1", 3), ("curve_kind", "u1"), ("curve", "<i4"),
                  ("location", "<i4"), ("range", "<f8", 2), ("curves", "u1"), ("flags", "V7"), ("ends", _SUB, 2),
                  ("end", "S1")])  # fmt: skip
_LINE = np.dtype([("kind", "u1"), ("origin", "<f8", 3), ("direction", "<f8", 3)])
_PLANE = np.dtype([("kind", "u1"), ("origin", "<f8", 3), ("axes", "<f8", (3, 3))])  # normal, x, y
_WIRE_HEAD = np.dtype([("kind", "u1"), ("flags", "V7")])
_FACE = np.dtype([("kind", "u1"), ("natural", "u1"), ("tolerance", "<f8"), ("surface", "<i4"), ("location", "<i4"),
                  ("triangulated", "u1"), ("flags", "V7")])  # fmt: skip


class Faces(NamedTuple):
    """Planar faces with any number of wires of any length, each a run of directed edges."""

    edges: NDArray  #: per use: the edge
    against: NDArray  #: per use: whether the edge is run through from its second end to its first
    wire_starts: NDArray  #: w + 1: where the uses of each wire begin
    face_starts: NDArray  #: f + 1: where the wires of each face begin; the outer one is the first
    origins: NDArray  #: f × 3
    normals: NDArray  #: f × 3, unit
    shell_of_face: NDArray  #: f


def brep_bytes(
    points: NDArray, edges: NDArray, faces: Faces, solids: list[list[int]], tolerance: float
) -> bytes:
    """The content of a file for Part.Shape.importBinary(): a solid, or a compound of several.

    `edges` (e × 2) are the ends of each edge; a solid lists its shells.
    """
    counts = (len(points), len(edges), len(faces.wire_starts) - 1, len(faces.origins))
    shells = sum(len(solid) for solid in solids)
    total = sum(counts) + shells + len(solids) + (len(solids) > 1)
    first = np.concatenate([[0], np.cumsum(counts)])  # of vertices, edges, wires, faces, shells

    def index(number: Any) -> Any:
        return total - number

    parts = [
        b"\nOpen CASCADE Topology V3 (c)\nLocations 0\nCurve2ds 0\n",
        b"Curves %d\n" % len(edges), _lines(points, edges),
        b"Polygon3D 0\nPolygonOnTriangulations 0\n",
        b"Surfaces %d\n" % len(faces.origins), _planes(faces),
        b"Triangulations 0\n\nTShapes %d\n" % total,
        _vertices(points, tolerance),
        _edges(points, edges, tolerance, index),
        _wires(faces, index(first[1])),
        _faces(faces, index(first[2]), tolerance),
        *_solids(faces, solids, index, first),
    ]  # fmt: skip
    parts.append(np.array([total, 0, 0], "<i4").tobytes())  # the root: the last shape, no location, forward
    return b"".join(parts)


def _directions(points: NDArray, edges: NDArray) -> tuple[NDArray, NDArray]:
    ways = points[edges[:, 1]] - points[edges[:, 0]]
    lengths = np.linalg.norm(ways, axis=1)
    return ways / lengths[:, None], lengths


def _lines(points: NDArray, edges: NDArray) -> bytes:
    records = np.zeros(len(edges), _LINE)
    records["kind"] = 1
    records["origin"] = points[edges[:, 0]]
    records["direction"] = _directions(points, edges)[0]
    return records.tobytes()


def _planes(faces: Faces) -> bytes:
    normals = faces.normals
    least = np.eye(3)[np.abs(normals).argmin(axis=1)]
    across = np.cross(normals, least)
    across /= np.linalg.norm(across, axis=1)[:, None]
    records = np.zeros(len(normals), _PLANE)
    records["kind"] = 1
    records["origin"] = faces.origins
    records["axes"] = np.stack([normals, across, np.cross(normals, across)], axis=1)
    return records.tobytes()


def _vertices(points: NDArray, tolerance: float) -> bytes:
    records = np.zeros(len(points), _VERTEX)
    records["kind"] = 7
    records["tolerance"] = tolerance
    records["point"] = points
    flags = records["flags"]
    flags[:] = bytes([0, 1, 0, 1, 1, 0, 1])
    records["end"] = _END
    return records.tobytes()


def _edges(points: NDArray, edges: NDArray, tolerance: float, index: _Index) -> bytes:
    records = np.zeros(len(edges), _EDGE)
    records["kind"] = 6
    records["tolerance"] = tolerance
    records["same"] = [1, 1, 0]  # parameter, range; not degenerated
    records["curve_kind"] = 1
    records["curve"] = np.arange(1, len(edges) + 1)
    records["range"][:, 1] = _directions(points, edges)[1]
    records["flags"] = np.void(bytes([0, 1, 0, 1, 0, 0, 0]))
    records["ends"]["index"] = index(edges)
    records["ends"]["reversed"] = [0, 1]
    records["end"] = _END
    return records.tobytes()


def _wires(faces: Faces, first_edge: int) -> bytes:
    head = np.zeros(1, _WIRE_HEAD)
    head["kind"] = 5
    head["flags"] = np.void(bytes([0, 1, 0, 1, 1, 0, 0]))
    subs = np.zeros(len(faces.edges), _SUB)
    subs["reversed"] = faces.against
    subs["index"] = first_edge - faces.edges
    return _with_subs(np.repeat(head, len(faces.wire_starts) - 1), subs, faces.wire_starts)


def _faces(faces: Faces, first_wire: int, tolerance: float) -> bytes:
    heads = np.zeros(len(faces.origins), _FACE)
    heads["kind"] = 4
    heads["tolerance"] = tolerance
    heads["surface"] = np.arange(1, len(heads) + 1)
    heads["flags"] = np.void(bytes([0, 1, 0, 1, 0, 0, 0]))
    wires = len(faces.wire_starts) - 1
    subs = np.zeros(wires, _SUB)
    subs["index"] = first_wire - np.arange(wires)
    return _with_subs(heads, subs, faces.face_starts)


def _with_subs(heads: NDArray, subs: NDArray, starts: NDArray) -> bytes:
    """Each head followed by its sub-shapes and the mark of their end."""
    counts = np.diff(starts)
    lengths = heads.dtype.itemsize + counts * subs.dtype.itemsize + 1
    begins = np.concatenate([[0], np.cumsum(lengths)])
    out = np.zeros(begins[-1], np.uint8)
    head_bytes = heads.view(np.uint8).reshape(len(heads), -1)
    out[begins[:-1, None] + np.arange(heads.dtype.itemsize)] = head_bytes
    place = np.repeat(begins[:-1] + heads.dtype.itemsize, counts)
    place += (np.arange(len(subs)) - np.repeat(starts[:-1], counts)) * subs.dtype.itemsize
    out[place[:, None] + np.arange(subs.dtype.itemsize)] = subs.view(np.uint8).reshape(len(subs), -1)
    out[begins[1:] - 1] = ord(_END)
    return out.tobytes()


def _solids(faces: Faces, solids: list[list[int]], index: _Index, first: NDArray) -> list[bytes]:
    """Shells in the order of the solids, then the solids, then the compound of several."""
    parts = []
    order = [shell for solid in solids for shell in solid]
    first_face, next_shape = first[3], int(first[4])
    shell_shape = {}
    for shell in order:
        members = np.flatnonzero(faces.shell_of_face == shell)
        parts.append(bytes([3]) + _SHELL_FLAGS + _subs(index(first_face + members)))
        shell_shape[shell] = next_shape
        next_shape += 1
    solid_shapes = []
    for solid in solids:
        flags = _ROOT_FLAGS if len(solids) == 1 else _SOLID_FLAGS
        parts.append(bytes([2]) + flags + _subs(index(np.array([shell_shape[shell] for shell in solid]))))
        solid_shapes.append(next_shape)
        next_shape += 1
    if len(solids) > 1:
        parts.append(bytes([0]) + _ROOT_FLAGS + _subs(index(np.array(solid_shapes))))
    return parts


def _subs(indices: NDArray) -> bytes:
    subs = np.zeros(len(indices), _SUB)
    subs["index"] = indices
    return subs.tobytes() + _END
