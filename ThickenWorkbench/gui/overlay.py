# SPDX-License-Identifier: LGPL-2.1-or-later
"""Things drawn over objects in the 3D view, and taken away again: no part of any document.

Over an object they hang in its own scene graph, below its Placement and that of its groups, so that
coordinates are the object's own; they stay visible when the object is hidden, and cannot be picked.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from pivy import coin

Colour = tuple[float, float, float]


class Overlay:
    """A group of nodes below a node: see over_object() and over_view()."""

    def __init__(self, parent: Any) -> None:
        self._parent = parent
        self.root = coin.SoSeparator()
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        self.root.addChild(style)
        self._content = coin.SoSeparator()
        self.root.addChild(self._content)
        self._parent.addChild(self.root)

    def show(self, *nodes: Any) -> None:
        """Replace what is shown."""
        self._content.removeAllChildren()
        for node in nodes:
            self._content.addChild(node)

    def remove(self) -> None:
        """Take everything away; harmless when the object is gone or this was done before."""
        if self._parent is not None and self._parent.findChild(self.root) >= 0:
            self._parent.removeChild(self.root)
        self._parent = None


def over_object(obj: Any) -> Overlay:
    """In the coordinates of an object, in every view."""
    return Overlay(obj.ViewObject.RootNode)


def over_view(view: Any) -> Overlay:
    """In the coordinates of the document, in one view."""
    return Overlay(view.getSceneGraph())


def faces(vertices: ArrayLike, triangles: ArrayLike, colour: Colour, transparency: float = 0.0) -> Any:
    """Triangles in one colour, lit on both sides; of an object's own triangles they are seen first."""
    material = coin.SoMaterial()
    material.diffuseColor = colour
    material.transparency = transparency
    return _group(material, _towards_eye(), _two_sided(), _coordinates(vertices), _face_set(triangles))


def coloured_faces(vertices: ArrayLike, triangles: ArrayLike, colours: ArrayLike) -> Any:
    """Triangles with a colour for each vertex, n × 3, blended between them; else as faces()."""
    material = coin.SoMaterial()
    set_colours(material, colours)
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
    return _group(material, binding, _towards_eye(), _two_sided(), _coordinates(vertices), _face_set(triangles))


def lines(points: ArrayLike, colour: Colour, width: float = 3.0) -> Any:
    """Segments, n × 2 × 3, drawn over whatever lies before them."""
    points = np.asarray(points, float).reshape(-1, 3)
    segments = coin.SoIndexedLineSet()
    index = np.column_stack([np.arange(len(points)).reshape(-1, 2), np.full(len(points) // 2, -1)])
    segments.coordIndex.setValues(0, index.size, index.ravel().tolist())
    style = coin.SoDrawStyle()
    style.lineWidth = width
    return _group(*_flat(colour), style, _coordinates(points), segments)


def points(places: ArrayLike, colour: Colour, size: float = 9.0) -> Any:
    """Dots of `size` pixels, drawn over whatever lies before them."""
    places = np.asarray(places, float).reshape(-1, 3)
    style = coin.SoDrawStyle()
    style.pointSize = size
    dots = coin.SoPointSet()
    dots.numPoints = len(places)
    return _group(*_flat(colour), style, _coordinates(places), dots)


def arrow(foot: ArrayLike, tip: ArrayLike, colour: Colour) -> Any:
    """A shaft and a head, as solid bodies, from `foot` to `tip`."""
    foot, tip = np.asarray(foot, float), np.asarray(tip, float)
    length = float(np.linalg.norm(tip - foot))
    material = coin.SoMaterial()
    material.diffuseColor = colour
    material.emissiveColor = tuple(0.4 * part for part in colour)
    place = coin.SoTransform()
    place.translation = tuple(foot)
    place.rotation = coin.SbRotation(coin.SbVec3f(0, 1, 0), coin.SbVec3f(*(tip - foot)))
    shaft, head = coin.SoCylinder(), coin.SoCone()
    shaft.radius, shaft.height = 0.05 * length, 0.7 * length
    head.bottomRadius, head.height = 0.14 * length, 0.3 * length
    to_shaft, to_head = coin.SoTranslation(), coin.SoTranslation()
    to_shaft.translation = (0, 0.35 * length, 0)
    to_head.translation = (0, 0.5 * length, 0)
    over_all = coin.SoAnnotation()  # drawn last, in front of what would hide it
    over_all.addChild(_group(material, place, to_shaft, shaft, to_head, head))
    return over_all


def set_colours(material: Any, colours: ArrayLike) -> None:
    """Give a material a list of colours, n × 3."""
    rows = np.ascontiguousarray(colours, np.float32)
    material.diffuseColor.deleteValues(0)
    material.diffuseColor.setValues(0, len(rows), rows)


def _group(*nodes: Any) -> Any:
    group = coin.SoSeparator()
    for node in nodes:
        group.addChild(node)
    return group


def _towards_eye() -> Any:
    offset = coin.SoPolygonOffset()
    offset.factor, offset.units = -1.0, -1.0
    return offset


def _two_sided() -> Any:
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    hints.creaseAngle = 0.5
    return hints


def _coordinates(vertices: ArrayLike) -> Any:
    rows = np.ascontiguousarray(vertices, np.float32)
    node = coin.SoCoordinate3()
    node.point.setValues(0, len(rows), rows)
    return node


def _face_set(triangles: ArrayLike) -> Any:
    rows = np.asarray(triangles, np.int32)
    index = np.column_stack([rows, np.full(len(rows), -1, np.int32)])
    node = coin.SoIndexedFaceSet()
    node.coordIndex.setValues(0, index.size, index.ravel())
    return node


def _flat(colour: Colour) -> tuple[Any, ...]:
    """Unlit, in one colour, not hidden by what lies nearer to the eye."""
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    base = coin.SoBaseColor()
    base.rgb = colour
    front = coin.SoDepthBuffer()
    front.test = False
    return light, base, front
