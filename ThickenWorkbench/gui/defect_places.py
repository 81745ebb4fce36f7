# SPDX-License-Identifier: LGPL-2.1-or-later
"""The defects of a surface one by one: what to list, to mark and to go to."""

from __future__ import annotations

from typing import Any, NamedTuple

import FreeCAD as App
import numpy as np

from ..numbers import place

translate = App.Qt.translate

# Their triangles come in pairs, one after the other.
_PAIRED = {"self-intersecting"}


def kind_name(code: str) -> str:
    """A heading for a code of docs/errors.md."""
    names = {
        "empty": translate("Thicken", "No triangles"),
        "not-finite": translate("Thicken", "Coordinates that are no numbers"),
        "degenerate": translate("Thicken", "Triangles without area"),
        "not-manifold": translate("Thicken", "Edges or points where the surface branches"),
        "not-oriented": translate("Thicken", "Neighbours that face opposite ways"),
        "self-intersecting": translate("Thicken", "Triangles that cross"),
    }
    return names.get(code, code)


class Place(NamedTuple):
    """One defect. Coordinates are those of the document, mm."""

    name: str
    corners: Any  #: n × 3, what to look at


def places(defect: Any) -> list[Place]:
    """The places of one kind of defect: its triangles, or else its edges, or else its vertices."""
    if len(defect.triangles):
        return _of_triangles(defect)
    for what, word in (
        (defect.edges, translate("Thicken", "Edge")),
        (defect.vertices, translate("Thicken", "Point")),
    ):
        if len(what):
            corners = [np.asarray(item, float).reshape(-1, 3) for item in what]
            return [Place(f"{word} {_at(item)}", item) for item in corners]
    return [Place(_at(np.array([tuple(defect.place)])), np.array([tuple(defect.place)]))]


def _of_triangles(defect: Any) -> list[Place]:
    step = 2 if defect.code in _PAIRED and len(defect.triangles) % 2 == 0 else 1
    result = []
    for first in range(0, len(defect.triangles), step):
        corners = np.asarray(defect.triangles[first : first + step], float).reshape(-1, 3)
        ids = " – ".join(str(facet) for facet in defect.facets[first : first + step])
        word = translate("Thicken", "Triangles") if step == 2 else translate("Thicken", "Triangle")
        result.append(Place(f"{word} {ids} {_at(corners)}", corners))
    return result


def _at(corners: Any) -> str:
    return translate("Thicken", "at {place}").format(place=place(corners.mean(0)))
