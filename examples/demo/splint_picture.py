# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the picture of the README: a splint for a scanned hand.

    PYTHONPATH=. python3 examples/demo/splint_picture.py ../shared/data/open/cut_hand_wrist.ply docs/splint.png

The hand is GEL's (Jakob Andreas Bærentzen, MIT licence). Any hand that points along y, in millimetres, will do.
"""

from __future__ import annotations

import sys

import numpy as np
from picture import beside, draw

import thicken

SURFACE, SHELL, WALL, SKIN = (242, 199, 68), (76, 127, 208), (217, 69, 58), (226, 190, 164)


def section(vertices: np.ndarray, triangles: np.ndarray, point, normal) -> list[np.ndarray]:
    """The closed lines in which a plane cuts a surface, the longest first."""
    height = (vertices - point) @ (np.asarray(normal, float) / np.linalg.norm(normal))
    following: dict[tuple[int, int], tuple[int, int]] = {}
    for corners in triangles.tolist():
        for a, b, c in (corners, corners[1:] + corners[:1], corners[2:] + corners[:2]):
            if (height[a] < 0) != (height[b] < 0) and (height[a] < 0) != (height[c] < 0):
                ends = [(min(a, b), max(a, b)), (min(a, c), max(a, c))]
                following.update([ends if height[a] < 0 else ends[::-1]])
    lines = []
    while following:
        edge, after = following.popitem()
        line = [edge]
        while after in following:
            line.append(after)
            after = following.pop(after)
        ends = np.array(line)
        share = height[ends[:, 0]] / (height[ends[:, 0]] - height[ends[:, 1]])
        lines.append(vertices[ends[:, 0]] + share[:, None] * (vertices[ends[:, 1]] - vertices[ends[:, 0]]))
    return sorted(lines, key=len, reverse=True)


def main(source: str, target: str) -> None:
    vertices, triangles = thicken.read_mesh(source)
    wrist = section(vertices, triangles, (7, -52, -8), (-0.25, 1, 0))[:1]
    fingers = section(vertices, triangles, (0, 6, 0), (0.12, 1, 0))[:2]  # and the thumb
    back = vertices[np.linalg.norm(vertices - (8, -25, 60), axis=1).argmin()]
    cut = thicken.trim(vertices, triangles, [line[::4] for line in wrist + fingers], keep=back)
    splint = thicken.thicken_mesh(cut.vertices, cut.triangles, 3.0, side="positive")
    colours = np.array([SURFACE, SHELL, WALL], float)[splint.region]
    together = (
        np.vstack([splint.vertices, vertices]),
        np.vstack([splint.triangles, triangles + len(splint.vertices)]),
        np.vstack([colours, np.tile(np.array(SKIN, float), (len(triangles), 1))]),
    )
    size, up = (560, 480), (0, 1, 0)
    worn = draw(*together, towards=(0.3, -0.3, 1), up=up, size=size)
    alone = draw(splint.vertices, splint.triangles, colours, towards=(0.5, -0.55, -1), up=up, size=size)
    beside([worn, alone], [("scanned surface, kept", SURFACE), ("shell, 3 mm from it", SHELL), ("wall", WALL)]).save(target)


if __name__ == "__main__":
    main(*sys.argv[1:])
