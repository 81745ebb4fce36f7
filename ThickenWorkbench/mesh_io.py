# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD meshes to NumPy arrays and back: whole meshes at a time, bit for bit.

FreeCAD's mesh kernel holds floats in the mesh's own coordinates; a Placement comes on top.
`mesh.Topology` and the text formats give placed or rounded numbers, so neither is used: a mesh
goes out by FreeCAD's binary format BMS, which stores the kernel as it is, and comes in as a binary
PLY, which keeps the order of points and facets and drops nothing. Building a mesh from Python
lists would lose every facet at a non-manifold edge, in silence, and crash on malformed ones.
"""

from __future__ import annotations

import io
import os
import tempfile

import FreeCAD as App
import Mesh
import numpy as np
from numpy.typing import ArrayLike, NDArray

# BMS, of FreeCAD's MeshKernel::Write: magic and version, 256 bytes of text, the numbers of points
# and facets, then float triples, then per facet three points and three neighbours.
_BMS_MAGIC = 0xA0B0C0D0
_BMS_COUNTS = 264
_BMS_POINTS = 272
_POINT_BYTES = 12
_FACET_BYTES = 24


class MeshTransferError(RuntimeError):
    """FreeCAD stored other numbers than it was given, or in a form that is not known."""


def arrays_from_mesh(mesh: Mesh.Mesh) -> tuple[NDArray[np.float32], NDArray[np.uint32]]:
    """Return the points (n × 3, the kernel's own floats, without Placement) and facets (m × 3)."""
    if mesh.CountFacets == 0:
        return np.empty((0, 3), np.float32), np.empty((0, 3), np.uint32)
    content = _bms_content(_without_placement(mesh))
    header = np.frombuffer(content, "<u4", 1)
    if header[0] != _BMS_MAGIC:
        raise MeshTransferError("This FreeCAD writes its meshes in a form that Thicken does not know.")
    points, facets = (int(n) for n in np.frombuffer(content, "<u4", 2, _BMS_COUNTS))
    if (points, facets) != (mesh.CountPoints, mesh.CountFacets):
        raise MeshTransferError(f"FreeCAD wrote {facets} of {mesh.CountFacets} facets of a mesh.")
    vertices = np.frombuffer(content, "<f4", 3 * points, _BMS_POINTS).reshape(-1, 3)
    rows = np.frombuffer(content, "<u4", 6 * facets, _BMS_POINTS + _POINT_BYTES * points).reshape(-1, 6)
    return vertices, np.ascontiguousarray(rows[:, :3])


def mesh_from_arrays(vertices: ArrayLike, triangles: ArrayLike) -> Mesh.Mesh:
    """Return a mesh with these points and facets, in this order, and the identity as Placement.

    The vertices have to be floats already, whatever their dtype; points that no triangle uses are
    left out. Raises MeshTransferError rather than return a mesh with any other numbers in it.
    """
    points, facets = _used_only(np.asarray(vertices), np.asarray(triangles))
    singles = np.ascontiguousarray(points, "<f4")
    if not np.array_equal(singles, points):
        raise MeshTransferError("The coordinates need more precision than FreeCAD's meshes have.")
    mesh = Mesh.Mesh()
    if len(facets) == 0:
        return mesh
    mesh.read(Stream=io.BytesIO(_ply_content(singles, facets)), Format="PLY")
    stored_points, stored_facets = arrays_from_mesh(mesh)
    same = np.array_equal(stored_points.view("<u4"), singles.view("<u4")) and np.array_equal(
        stored_facets, facets
    )
    if not same:
        raise MeshTransferError("FreeCAD did not take over the mesh as it is.")
    return mesh


def _without_placement(mesh: Mesh.Mesh) -> Mesh.Mesh:
    if mesh.Placement.isIdentity():
        return mesh
    local = mesh.copy()
    local.Placement = App.Placement()
    return local


def _bms_content(mesh: Mesh.Mesh) -> bytes:
    # By way of a file: writing binary formats into a Python stream truncates them (FreeCAD 0.20).
    with tempfile.TemporaryDirectory(prefix="thicken-") as folder:
        path = os.path.join(folder, "mesh.bms")
        mesh.write(path)
        with open(path, "rb") as file:
            return file.read()


def _used_only(vertices: NDArray, triangles: NDArray) -> tuple[NDArray, NDArray]:
    """Leave out the points that no triangle uses, as FreeCAD would, and keep the order."""
    if len(triangles) == 0:
        return vertices[:0], triangles[:0]
    if vertices.ndim != 2 or triangles.ndim != 2 or vertices.shape[1] != 3 or triangles.shape[1] != 3:
        raise ValueError("vertices and triangles must have the shape (n, 3)")
    if triangles.min() < 0 or triangles.max() >= len(vertices):
        raise ValueError("a triangle names a vertex that does not exist")
    used = np.zeros(len(vertices), bool)
    used[triangles] = True
    if used.all():
        return vertices, triangles
    return vertices[used], (np.cumsum(used) - 1)[triangles]


def _ply_content(points: NDArray[np.float32], facets: NDArray) -> bytes:
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(facets)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.empty(len(facets), np.dtype([("corners", "u1"), ("index", "<i4", 3)]))
    rows["corners"] = 3
    rows["index"] = facets
    return header.encode("ascii") + points.tobytes() + rows.tobytes()
