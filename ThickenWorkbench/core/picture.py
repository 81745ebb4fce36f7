# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of closed meshes, drawn without a window: an orthographic z-buffer in NumPy.

What a cutting plane takes away is not drawn. Where it goes through material, the eye meets the back of
a triangle, which is painted in a colour of its own.
"""

from __future__ import annotations

import io
from typing import Iterator, NamedTuple

import numpy as np
from numpy.typing import NDArray

BACKGROUND = (255, 255, 255)
CUT = (70, 74, 82)

_OVERSAMPLING = 2
_MARGIN = 0.94
# Pixels that are looked at at a time: bounds the memory, whatever the number of triangles.
_CHUNK = 2_000_000
# The rounding of a pixel's coordinates.
_NEAR = 1e-6


class View(NamedTuple):
    """Where the eye is: `towards` looks into the picture, `up` points up in it."""

    towards: tuple[float, ...]
    up: tuple[float, ...]

    def axes(self) -> NDArray:
        """Right, up and towards the eye, as rows."""
        back = -np.asarray(self.towards, float)
        back /= np.linalg.norm(back)
        right = np.cross(self.up, back)
        right /= np.linalg.norm(right)
        return np.array([right, np.cross(back, right), back])


def view_along(up: NDArray, turn: float, rise: float) -> View:
    """From the side and, with a positive `rise`, from above, both in degrees, of a part that grows along `up`."""
    least = np.eye(3)[np.abs(up).argmin()]
    side = np.cross(up, least)
    side /= np.linalg.norm(side)
    front = np.cross(side, up)
    flat = np.cos(np.radians(turn)) * front + np.sin(np.radians(turn)) * side
    towards = -np.cos(np.radians(rise)) * flat - np.sin(np.radians(rise)) * up
    return View(tuple(towards), tuple(up))


def draw(
    vertices: NDArray,
    triangles: NDArray,
    colours: NDArray,
    view: View,
    size: tuple[int, int] = (640, 480),
    cut_at: NDArray | None = None,
) -> bytes:
    """A PNG of the triangles of a closed mesh, each in its row of `colours` (m × 3, 0 to 255).

    With `cut_at`, what is nearer to the eye than this point is taken away.
    """
    width, height = (side * _OVERSAMPLING for side in size)
    eye = np.asarray(vertices, float) @ view.axes().T
    used = np.zeros(len(eye), bool)
    used[triangles] = True
    low, high = eye[used].min(axis=0), eye[used].max(axis=0)
    scale = _MARGIN * min(width / max(high[0] - low[0], 1e-300), height / max(high[1] - low[1], 1e-300))
    middle = (low + high) / 2
    pixel = np.column_stack([
        width / 2 + scale * (eye[:, 0] - middle[0]),
        height / 2 - scale * (eye[:, 1] - middle[1]),
        eye[:, 2],
    ])  # fmt: skip
    limit = np.inf if cut_at is None else float(np.asarray(cut_at, float) @ view.axes()[2])
    if cut_at is None:  # nobody sees the backs of a closed mesh
        front = _facing(pixel[triangles])
        triangles, colours = triangles[front], colours[front]
    nearest = _nearest_triangles(pixel[triangles], width, height, limit)
    image = np.full((height * width, 3), BACKGROUND, np.uint8)
    seen = nearest >= 0
    shown, which = np.unique(nearest[seen], return_inverse=True)
    image[seen] = _paint(eye[triangles[shown]], colours[shown])[which]
    return _png(image.reshape(height, width, 3), size)


def _nearest_triangles(corners: NDArray, width: int, height: int, limit: float) -> NDArray:
    """For each pixel the triangle that the eye meets first, or -1."""
    depth = np.full(width * height, -np.inf)
    nearest = np.full(width * height, -1, np.int64)
    planes = _planes(corners)
    for ids, x, y in _pixels(corners, width, height):
        b, c, z = (at_0[ids] + along_x[ids] * x + along_y[ids] * y for at_0, along_x, along_y in planes)
        inside = (b >= -_NEAR) & (c >= -_NEAR) & (b + c <= 1 + _NEAR) & (z <= limit)
        where, z, owner = (y * width + x)[inside], z[inside], ids[inside]
        order = np.lexsort((z, where))  # the last of each pixel is the nearest
        where, z, owner = where[order], z[order], owner[order]
        last = np.append(np.diff(where) > 0, True) if len(where) else np.zeros(0, bool)
        where, z, owner = where[last], z[last], owner[last]
        nearer = z > depth[where]
        depth[where[nearer]] = z[nearer]
        nearest[where[nearer]] = owner[nearer]
    return nearest


def _planes(corners: NDArray) -> list[tuple[NDArray, NDArray, NDArray]]:
    """What is linear over each triangle: the shares of its second and third corner, and the depth; each as its value
    at pixel (0, 0) and its growth along x and y. Not a number for a triangle that is seen from its edge."""
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = np.ascontiguousarray(corners.transpose(1, 2, 0))
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    area[area == 0] = np.nan
    b_x, b_y = (cy - ay) / area, (ax - cx) / area
    c_x, c_y = (ay - by) / area, (bx - ax) / area
    z_x, z_y = (b_x * (bz - az) + c_x * (cz - az)), (b_y * (bz - az) + c_y * (cz - az))
    return [(at_a - gx * ax - gy * ay, gx, gy) for at_a, gx, gy in ((0.0, b_x, b_y), (0.0, c_x, c_y), (az, z_x, z_y))]


def _pixels(corners: NDArray, width: int, height: int) -> Iterator[tuple[NDArray, NDArray, NDArray]]:
    """Triangle ids and the pixels whose middles are in the boxes around the triangles, some at a time."""
    # Whole numbers are the middles of pixels: most of many small triangles have none of them.
    flat = corners[:, :, :2]
    low = np.maximum(np.ceil(flat.min(axis=1) - _NEAR), 0).astype(np.int64)
    high = np.minimum(np.floor(flat.max(axis=1) + _NEAR), (width - 1, height - 1)).astype(np.int64)
    sides = np.maximum(high - low + 1, 0)
    counts = sides[:, 0] * sides[:, 1]
    ends = np.cumsum(counts)
    first = 0
    while first < len(corners):
        begun = ends[first - 1] if first else 0
        after = max(int(np.searchsorted(ends, begun + _CHUNK, side="right")), first + 1)
        ids = np.repeat(np.arange(first, after), counts[first:after])
        place = np.arange(len(ids)) - np.repeat(ends[first:after] - counts[first:after] - begun, counts[first:after])
        yield ids, low[ids, 0] + place % sides[ids, 0], low[ids, 1] + place // sides[ids, 0]
        first = after


def _facing(corners: NDArray) -> NDArray:
    """Which triangles turn their front to the eye; in pixels, y goes down."""
    (ax, ay), (bx, by), (cx, cy) = corners[:, :, :2].transpose(1, 2, 0)
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0


def _normals(corners: NDArray) -> NDArray:
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)


def _paint(corners: NDArray, colours: NDArray) -> NDArray:
    """Colours lit from the upper left behind the eye; CUT for triangles that show their back."""
    normals = _normals(corners)
    light = np.array([-0.4, 0.5, 0.77]) / np.linalg.norm([-0.4, 0.5, 0.77])
    shade = 0.4 + 0.6 * np.abs(normals @ light)
    return np.where((normals[:, 2] > 0)[:, None], colours * shade[:, None], CUT).astype(np.uint8)


def _png(image: NDArray, size: tuple[int, int]) -> bytes:
    from PIL import Image

    content = io.BytesIO()
    Image.fromarray(image).resize(size, Image.LANCZOS).save(content, "PNG", optimize=True)
    return content.getvalue()
