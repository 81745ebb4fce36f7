# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plugs for drilled holes: prisms of the holes' cross-section, thinner by a clearance."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def plug_arrays(outlines: NDArray, axes: NDArray, walled: NDArray, clearance: float) -> tuple[NDArray, NDArray]:
    """Vertices, of single precision, and triangles of a prism for each hole.

    `outlines`: h × n × 3 corners of the cross-sections, counter-clockwise about `axes` (h × 3, unit);
    `walled`: h × 2, from where to where along its axis each prism reaches.
    """
    holes, sides = outlines.shape[:2]
    middles = outlines.mean(axis=1, keepdims=True)
    inward = middles - outlines
    radius = np.linalg.norm(inward, axis=2, keepdims=True)
    # The clearance is between the sides; the corners stand off by more.
    inset = outlines + inward / radius * clearance / np.cos(np.pi / sides)
    ends = [inset + along[:, None, None] * axes[:, None, :] for along in walled.T]
    vertices = np.concatenate(ends, axis=1).reshape(-1, 3).astype(np.float32).astype(float)
    triangles = _prism(sides)
    starts = 2 * sides * np.arange(holes)
    return vertices, (triangles + starts[:, None, None]).reshape(-1, 3)


def _prism(sides: int) -> NDArray:
    """Triangles over the corners of the lower end, then those of the upper end."""
    low, turned = np.arange(sides), np.roll(np.arange(sides), -1)
    walls = [np.column_stack([low, turned, sides + turned]), np.column_stack([low, sides + turned, sides + low])]
    fan = np.array([[0, k, k + 1] for k in range(1, sides - 1)])
    return np.concatenate([*walls, sides + fan, fan[:, ::-1]])
