# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a repair would do to a surface, in colours: removed, added, welded."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import numpy as np

from thicken.arrays import RepairedMesh
from .overlay import faces, points

translate = App.Qt.translate

REMOVED = (0.85, 0.2, 0.15)
ADDED = (0.2, 0.65, 0.3)
WELDED = (0.2, 0.45, 0.9)
LEFT = (0.95, 0.6, 0.1)


def key() -> list[tuple[str, tuple[float, float, float]]]:
    """What each colour stands for."""
    return [
        (translate("Thicken", "removed"), REMOVED),
        (translate("Thicken", "added"), ADDED),
        (translate("Thicken", "joined"), WELDED),
        (translate("Thicken", "left"), LEFT),
    ]


def marks(surface: tuple[Any, Any], mended: RepairedMesh) -> list[Any]:
    """Nodes in the coordinates of the surface, whose arrays are those that were mended."""
    vertices, triangles = surface
    removed, joined = _ids(mended, lambda change: change["removed"]), _ids(mended, _joins)
    added = mended.triangles[mended.origin < 0]
    left = mended.report["left_places_mm"] + mended.report["left_hole_places_mm"]
    nodes = [
        faces(vertices, triangles[ids], colour)
        for ids, colour in ((removed, REMOVED), (np.setdiff1d(joined, removed), WELDED))
        if len(ids)
    ]
    if len(added):
        nodes.append(faces(mended.vertices, added, ADDED))
    if left:
        nodes.append(points(left, LEFT))
    return nodes


def _joins(change: dict[str, Any]) -> bool:
    return change["kind"] in ("welded", "divided")


def _ids(mended: RepairedMesh, wanted: Any) -> Any:
    lists = [change["triangles"] for change in mended.report["changes"] if wanted(change)]
    return np.unique(np.concatenate([np.array(ids, np.int64) for ids in lists])) if lists else np.array([], np.int64)
