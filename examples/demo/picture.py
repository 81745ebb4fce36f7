# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of a solid, drawn without a window: an orthographic z-buffer in NumPy.

Pieces behind a cutting plane are drawn as they are; where the plane goes through material, the ray
meets the back of a triangle first, and the cut is painted in a colour of its own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw

BACKGROUND = (255, 255, 255)
CUT = (60, 64, 72)
_OVERSAMPLING = 2


@dataclass(frozen=True)
class View:
    """Where the eye is: `towards` looks into the picture, `up` points up in it."""

    towards: tuple[float, float, float]
    up: tuple[float, float, float]

    def axes(self) -> np.ndarray:
        """Right, up and towards-the-eye, as rows."""
        back = -np.asarray(self.towards, float)
        back /= np.linalg.norm(back)
        right = np.cross(self.up, back)
        right /= np.linalg.norm(right)
        return np.array([right, np.cross(back, right), back])


@dataclass(frozen=True)
class Plane:
    """Keeps what lies on the side that the normal points away from."""

    point: np.ndarray
    normal: np.ndarray


def _shades(normals: np.ndarray) -> np.ndarray:
    """Brightness of each triangle in eye coordinates, lit from the upper left behind the eye."""
    light = np.array([-0.4, 0.5, 0.77])
    return 0.35 + 0.65 * np.abs(normals @ (light / np.linalg.norm(light)))


def _cover(corners: np.ndarray, width: int, height: int):
    """Pixels of one triangle (pixel coordinates, depth) and their depth; None when it covers none."""
    low = np.maximum(np.floor(corners[:, :2].min(0)).astype(int), 0)
    high = np.minimum(np.ceil(corners[:, :2].max(0)).astype(int), (width - 1, height - 1))
    if (low > high).any():
        return None
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = corners
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if area == 0:
        return None
    x, y = np.meshgrid(np.arange(low[0], high[0] + 1), np.arange(low[1], high[1] + 1))
    b = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
    c = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
    inside = (b >= 0) & (c >= 0) & (b + c <= 1)
    if not inside.any():
        return None
    return x[inside], y[inside], (az + b * (bz - az) + c * (cz - az))[inside]


def draw(
    vertices: np.ndarray,
    triangles: np.ndarray,
    colours: np.ndarray,
    view: View,
    size: tuple[int, int],
    cut: Plane | None = None,
) -> Image.Image:
    """Draw triangles, each in its row of `colours`; of what `cut` takes away nothing is drawn."""
    width, height = (side * _OVERSAMPLING for side in size)
    axes = view.axes()
    eye = vertices @ axes.T
    low, high = eye.min(0), eye.max(0)
    scale = 0.92 * min(width / (high[0] - low[0]), height / (high[1] - low[1]))
    middle = (low + high) / 2
    pixel = np.column_stack([
        width / 2 + scale * (eye[:, 0] - middle[0]),
        height / 2 - scale * (eye[:, 1] - middle[1]),
        eye[:, 2],
    ])  # fmt: skip
    corners = eye[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    paint = np.where((normals[:, 2] > 0)[:, None], colours * _shades(normals)[:, None], CUT).astype(np.uint8)

    depth = np.full((height, width), -np.inf)
    image = np.full((height, width, 3), BACKGROUND, np.uint8)
    limit = _depth_limit(cut, axes, middle, scale, width, height)
    for index, triangle in enumerate(triangles):
        covered = _cover(pixel[triangle], width, height)
        if covered is None:
            continue
        x, y, z = covered
        nearer = (z > depth[y, x]) & (z <= limit[y, x])
        x, y = x[nearer], y[nearer]
        depth[y, x] = z[nearer]
        image[y, x] = paint[index]
    return Image.fromarray(image).resize(size, Image.LANCZOS)


def _depth_limit(cut: Plane | None, axes, middle, scale, width, height) -> np.ndarray:
    """The depth of the cutting plane at each pixel: what is nearer to the eye is taken away."""
    if cut is None:
        return np.full((height, width), np.inf)
    point, normal = axes @ cut.point, axes @ cut.normal
    if normal[2] <= 0:
        raise ValueError("the cutting plane has to face the eye")
    x = (np.arange(width) - width / 2) / scale + middle[0] - point[0]
    y = (height / 2 - np.arange(height)) / scale + middle[1] - point[1]
    return point[2] - (normal[0] * x[None, :] + normal[1] * y[:, None]) / normal[2]


def beside(pictures: list[Image.Image], legend: list[tuple[str, tuple[int, int, int]]]) -> Image.Image:
    """Pictures side by side above a line that names the colours."""
    line = 36
    width, height = sum(p.width for p in pictures), max(p.height for p in pictures)
    sheet = Image.new("RGB", (width, height + line), BACKGROUND)
    left = 0
    for picture in pictures:
        sheet.paste(picture, (left, 0))
        left += picture.width
    pen = ImageDraw.Draw(sheet)
    left = 20
    for name, colour in legend:
        pen.rectangle((left, height + 10, left + 14, height + 24), fill=colour)
        pen.text((left + 22, height + 11), name, fill=(0, 0, 0))
        left += 40 + 7 * len(name)
    return sheet
