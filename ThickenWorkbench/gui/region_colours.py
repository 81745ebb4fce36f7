# SPDX-License-Identifier: LGPL-2.1-or-later
"""Original, shell and wall in different colours: painted on FreeCAD's own nodes of a mesh's view.

Nothing of it is stored: the regions are in the document and the colours in the preferences, so that
documents that were made without a display have them too.
"""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import numpy as np
from pivy import coin

from .. import preferences
from thicken.arrays import Region
from ..regions import facet_regions
from .overlay import set_colours
from .qt import QtCore

KEYS = {Region.ORIGINAL: "ColorOriginal", Region.SHELL: "ColorShell", Region.WALL: "ColorWall"}


def paint(view: Any, on: bool = True) -> None:
    """Paint the facets of a Thicken feature, or give them FreeCAD's one colour again."""
    nodes = _nodes(view)
    if nodes is None:
        return
    material, binding = nodes
    regions = facet_regions(view.Object)
    # While an object is recomputed or undone, its mesh and its regions change one after the other.
    if not on or len(regions) == 0 or len(regions) != view.Object.Mesh.CountFacets:
        paint_plain(view)
        return
    palette = np.array([preferences.colour(KEYS[region]) for region in Region])
    if binding.value.getValue() == coin.SoMaterialBinding.PER_FACE and _shows(material, palette, regions):
        return
    set_colours(material, palette[regions])
    binding.value = coin.SoMaterialBinding.PER_FACE


def paint_plain(view: Any) -> None:
    """Give the mesh the one colour that FreeCAD has for it."""
    nodes = _nodes(view)
    if nodes is not None:
        nodes[1].value = coin.SoMaterialBinding.OVERALL
        set_colours(nodes[0], [tuple(view.ShapeColor)[:3]])


def paint_points(view: Any, colours: Any) -> None:
    """Give each point of the mesh a colour (n × 3), blended over the facets."""
    nodes = _nodes(view)
    if nodes is not None:
        set_colours(nodes[0], colours)
        nodes[1].value = coin.SoMaterialBinding.PER_VERTEX_INDEXED


def paint_later(view: Any) -> None:
    """Paint once FreeCAD has finished with what it is doing."""

    def now() -> None:
        with suppress(ReferenceError, RuntimeError):  # the view is gone
            view.Proxy.paint(view)

    QtCore.QTimer.singleShot(0, now)


def painted(view: Any) -> set[tuple[float, float, float]]:
    """The colours that are on the view now."""
    nodes = _nodes(view)
    return set() if nodes is None else {tuple(round(c, 3) for c in v) for v in nodes[0].diffuseColor.getValues()}


def _shows(material: Any, palette: Any, regions: Any) -> bool:
    """Whether the colours are on the material already: the first facet of each run of a region tells."""
    field = material.diffuseColor
    if field.getNum() != len(regions):
        return False
    starts = [0, *(np.flatnonzero(np.diff(regions.astype(int))) + 1)]
    return all(np.allclose(field[int(k)].getValue(), palette[regions[k]], atol=1e-6) for k in starts)


def _nodes(view: Any) -> tuple[Any, Any] | None:
    """The material and the binding that all display modes of a mesh share."""
    found = []
    for kind in (coin.SoMaterial, coin.SoMaterialBinding):
        search = coin.SoSearchAction()
        search.setType(kind.getClassTypeId())
        search.setSearchingAll(True)  # also below switches that are off
        search.setInterest(coin.SoSearchAction.FIRST)
        search.apply(view.RootNode)
        path = search.getPath()
        if path is None:
            return None
        found.append(path.getTail())
    return tuple(found)
