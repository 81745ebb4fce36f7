# SPDX-License-Identifier: LGPL-2.1-or-later
"""Merges neighbouring triangles of a closed mesh that lie in one plane into one face with holes.

A patch of triangles that is no plain face (whose outline touches itself, or that is further from its
plane than allowed) stays triangles: the result is always a polyhedron.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .brep_solid import Faces
from .polyhedron import edges_of, unit_normals

# How far the vertices of a face may be from its plane, as a share of the largest coordinate: what is
# left of a plane once its points have been rounded to single precision.
_PLANE_SHARE = 2e-7


def merged_faces(
    points: NDArray, triangles: NDArray, shell_of_triangle: NDArray, tolerance: float
) -> tuple[NDArray, NDArray, Faces, float]:
    """As polyhedron.triangle_faces(), with the faces merged; `tolerance` grows to what they need."""
    allowed = max(tolerance, _PLANE_SHARE * float(np.abs(points).max()))
    patch_of, origins, normals = _patches(points, triangles, allowed)
    loops = _outlines(triangles, patch_of, len(points))
    split = _patches_that_are_no_face(points, loops, normals)
    if len(split):
        patch_of, origins, normals = _split(points, triangles, patch_of, origins, normals, split)
        loops = _outlines(triangles, patch_of, len(points))
    loops = _without_straight_vertices(points, loops, allowed)
    deviation = _deviation(points, loops, origins, normals)
    shell_of_patch = np.zeros(len(origins), np.int64)
    shell_of_patch[patch_of] = shell_of_triangle
    return _assembled(points, loops, origins, normals, shell_of_patch, max(tolerance, 1.5 * deviation))


def _patches(points: NDArray, triangles: NDArray, allowed: float) -> tuple[NDArray, NDArray, NDArray]:
    """The patch of each triangle, and a point and the unit normal of the plane of each patch."""
    normals = unit_normals(points, triangles)
    first, second = _neighbours(triangles, len(points))
    # One way is enough: the plane of a small triangle is not known well at the far end of a large one.
    flat = _within_plane(points, triangles, normals, first, second, allowed)
    flat |= _within_plane(points, triangles, normals, second, first, allowed)
    flat &= np.einsum("ij,ij->i", normals[first], normals[second]) > 0.9
    patch_of = _components(len(triangles), first[flat], second[flat])
    origins, planes = _planes(points, triangles, patch_of)
    off = np.abs(np.einsum("ikj,ij->ik", points[triangles] - origins[patch_of][:, None], planes[patch_of])).max(1)
    turned = np.einsum("ij,ij->i", normals, planes[patch_of]) < 0.9
    bad = np.unique(patch_of[(off > allowed) | turned])
    return _split(points, triangles, patch_of, origins, planes, bad)


def _neighbours(triangles: NDArray, points: int) -> tuple[NDArray, NDArray]:
    """The two triangles at each edge of a closed mesh."""
    _, edge_of_use, _ = edges_of(triangles, points)
    by_edge = np.argsort(edge_of_use, kind="stable").reshape(-1, 2) // 3
    return by_edge[:, 0], by_edge[:, 1]


def _within_plane(points: NDArray, triangles: NDArray, normals: NDArray, of: NDArray, other: NDArray, allowed: float) -> NDArray:
    """Whether all corners of the triangles `other` are in the planes of the triangles `of`."""
    ways = points[triangles[other]] - points[triangles[of, 0]][:, None]
    return np.abs(np.einsum("ikj,ij->ik", ways, normals[of])).max(axis=1) <= allowed


def _components(count: int, first: NDArray, second: NDArray) -> NDArray:
    """Numbers from 0 of the connected components of a graph, by the lowest member that each has seen."""
    label = np.arange(count)
    while True:
        least = np.minimum(label[first], label[second])
        after = label.copy()
        np.minimum.at(after, first, least)
        np.minimum.at(after, second, least)
        np.minimum.at(after, label[first], least)
        np.minimum.at(after, label[second], least)
        after = after[after]
        if np.array_equal(after, label):
            return np.unique(label, return_inverse=True)[1]
        label = after


def _planes(points: NDArray, triangles: NDArray, patch_of: NDArray) -> tuple[NDArray, NDArray]:
    """A point of the plane and its unit normal, weighted by area, of each patch."""
    count = int(patch_of.max()) + 1
    a, b, c = (points[triangles[:, k]] for k in range(3))
    doubled = np.cross(b - a, c - a)
    weight = np.linalg.norm(doubled, axis=1)
    middles = (a + b + c) / 3
    total = np.bincount(patch_of, weight, count)
    normals = np.column_stack([np.bincount(patch_of, doubled[:, k], count) for k in range(3)])
    origins = np.column_stack([np.bincount(patch_of, weight * middles[:, k], count) for k in range(3)])
    return origins / total[:, None], normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]


def _split(
    points: NDArray, triangles: NDArray, patch_of: NDArray, origins: NDArray, normals: NDArray, patches: list[int]
) -> tuple[NDArray, NDArray, NDArray]:
    """The same with every triangle of `patches` a patch of its own."""
    if len(patches) == 0:
        return patch_of, origins, normals
    alone = np.isin(patch_of, patches)
    label = patch_of.copy()
    label[alone] = len(origins) + np.arange(int(alone.sum()))
    label = np.unique(label, return_inverse=True)[1]
    origins, normals = _planes(points, triangles, label)
    return label, origins, normals


def _outlines(triangles: NDArray, patch_of: NDArray, points: int) -> list[list[list[int]]]:
    """The outlines of each patch as loops of vertices, the patch to the left. A patch whose outline
    touches itself in a vertex gets an empty list."""
    _, edge_of_use, _ = edges_of(triangles, points)
    by_edge = np.argsort(edge_of_use, kind="stable").reshape(-1, 2)
    crossing = patch_of[by_edge[:, 0] // 3] != patch_of[by_edge[:, 1] // 3]
    uses = np.sort(by_edge[crossing].ravel())
    start, end = triangles.ravel()[uses], np.roll(triangles, -1, axis=1).ravel()[uses]
    onward: list[dict[int, int]] = [{} for _ in range(int(patch_of.max()) + 1)]
    touching = set()
    for patch, a, b in zip(patch_of[uses // 3].tolist(), start.tolist(), end.tolist()):
        if a in onward[patch]:
            touching.add(patch)
        onward[patch][a] = b
    return [[] if patch in touching else _loops(ways) for patch, ways in enumerate(onward)]


def _loops(onward: dict[int, int]) -> list[list[int]]:
    loops = []
    while onward:
        first, vertex = onward.popitem()
        loop = [first]
        while vertex != first:
            loop.append(vertex)
            vertex = onward.pop(vertex)
        least = loop.index(min(loop))
        loops.append(loop[least:] + loop[:least])
    return sorted(loops)


def _signed_area(points: NDArray, loop: list[int], normal: NDArray) -> float:
    ring = points[loop] - points[loop[0]]
    return float(np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0) @ normal) / 2


def _patches_that_are_no_face(points: NDArray, loops: list[list[list[int]]], normals: NDArray) -> list[int]:
    """Patches without exactly one outer outline. The outer one is made the first."""
    wrong = []
    for patch, outlines in enumerate(loops):
        if len(outlines) == 1 and len(outlines[0]) == 3:
            continue
        outer = [k for k, loop in enumerate(outlines) if _signed_area(points, loop, normals[patch]) > 0]
        if len(outer) != 1:
            wrong.append(patch)
    return wrong


def _without_straight_vertices(points: NDArray, loops: list[list[list[int]]], allowed: float) -> list[list[list[int]]]:
    """Leave out the vertices in the middle of straight edges between the same two faces."""
    uses = np.bincount(np.concatenate([np.array(loop) for outlines in loops for loop in outlines]), minlength=len(points))
    keep = uses != 2
    for outlines in loops:
        for loop in outlines:
            ring = points[loop]
            before, after = np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0)
            bent = _distance_from_line(ring, before, after) > allowed
            bent |= np.einsum("ij,ij->i", ring - before, after - ring) <= 0
            keep[np.array(loop)[bent]] = True
    changed = True
    while changed:  # two faces have to agree about a vertex
        changed = False
        for outlines in loops:
            for loop in outlines:
                if not _still_good(points, loop, keep, allowed):
                    keep[loop] = True
                    changed = True
    return [[[v for v in loop if keep[v]] for loop in outlines] for outlines in loops]


def _still_good(points: NDArray, loop: list[int], keep: NDArray, allowed: float) -> bool:
    """Whether what is left of a loop is a polygon that passes the vertices that were left out."""
    left = [k for k, vertex in enumerate(loop) if keep[vertex]]
    if len(left) == len(loop):
        return True
    if len(left) < 3:
        return False
    for k, following in zip(left, left[1:] + [left[0] + len(loop)]):
        between = [loop[i % len(loop)] for i in range(k + 1, following)]
        if between:
            ends = points[[loop[k], loop[following % len(loop)]]]
            if (_distance_from_line(points[between], ends[:1], ends[1:]) > allowed).any():
                return False
    return True


def _distance_from_line(p: NDArray, a: NDArray, b: NDArray) -> NDArray:
    way = b - a
    length = np.maximum(np.linalg.norm(way, axis=1), 1e-300)
    return np.linalg.norm(np.cross(way, p - a), axis=1) / length


def _deviation(points: NDArray, loops: list[list[list[int]]], origins: NDArray, normals: NDArray) -> float:
    most = 0.0
    for outlines, origin, normal in zip(loops, origins, normals):
        for loop in outlines:
            most = max(most, float(np.abs((points[loop] - origin) @ normal).max()))
    return most


def _assembled(
    points: NDArray, loops: list[list[list[int]]], origins: NDArray, normals: NDArray, shells: NDArray, tolerance: float
) -> tuple[NDArray, NDArray, Faces, float]:
    used: dict[int, int] = {}
    edges: dict[tuple[int, int], int] = {}
    edge_uses, against, wire_starts, face_starts = [], [], [0], [0]
    for outlines, normal in zip(loops, normals):
        outer_first = sorted(outlines, key=lambda loop: -_signed_area(points, loop, normal)) if len(outlines) > 1 else outlines
        for loop in outer_first:
            ring = [used.setdefault(vertex, len(used)) for vertex in loop]
            for a, b in zip(ring, ring[1:] + ring[:1]):
                edge_uses.append(edges.setdefault((min(a, b), max(a, b)), len(edges)))
                against.append(a > b)
            wire_starts.append(len(edge_uses))
        face_starts.append(len(wire_starts) - 1)
    faces = Faces(
        edges=np.array(edge_uses), against=np.array(against), wire_starts=np.array(wire_starts),
        face_starts=np.array(face_starts), origins=origins, normals=normals, shell_of_face=shells,
    )  # fmt: skip
    return points[list(used)], np.array(list(edges)), faces, tolerance
