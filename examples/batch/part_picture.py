# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small picture of a solid, for the summary."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
from ThickenWorkbench.core.picture import draw, view_along  # noqa: E402

SIZE = (96, 72)
_STEEL = (120, 160, 205)


def picture_of(solid: Path) -> bytes:
    """A PNG of a binary STL."""
    corners = np.frombuffer(solid.read_bytes(), _TRIANGLE, offset=84)["corners"].reshape(-1, 3)
    triangles = np.arange(len(corners)).reshape(-1, 3)
    colours = np.broadcast_to(_STEEL, (len(triangles), 3))
    return draw(corners, triangles, colours, view_along(np.array([0, 0, 1.0]), 30, 35), SIZE)


_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
