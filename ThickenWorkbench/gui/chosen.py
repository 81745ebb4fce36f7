# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has selected, as inputs of the commands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui


@dataclass(frozen=True)
class Chosen:
    """An object, or a part of it."""

    source: Any
    faces: tuple[str, ...] = ()  #: of a shape: "Face3"
    facets: tuple[int, ...] = ()  #: of a mesh: indices

    def named(self) -> dict[str, Any]:
        """The arguments of make_thicken() that name the part."""
        return {"faces": list(self.faces) or None, "facets": list(self.facets) or None}


def surfaces() -> list[Chosen]:
    """Meshes, shapes, chosen faces and chosen facets, in the order of selection; of a group what is in it."""
    chosen = []
    for selected in _selection():
        for obj in _members(selected.Object):
            if is_mesh(obj):
                chosen.append(Chosen(obj, facets=tuple(_facets(obj))))
            elif is_shape(obj):
                own = selected.SubElementNames if obj == selected.Object else ()
                chosen.append(Chosen(obj, faces=tuple(n for n in own if n.startswith("Face"))))
    return chosen


def solids() -> list[Any]:
    """The selected objects that have a mesh or a shape; of a group the visible ones in it."""
    members = [obj for selected in _selection() for obj in _members(selected.Object)]
    return [obj for obj in members if is_mesh(obj) or is_shape(obj)]


def surface_objects() -> list[Any]:
    """The selected objects that surfaces() tells the parts of, without looking at facets."""
    return [obj for obj in solids() if is_mesh(obj) or obj.Shape.Faces]


def wires() -> list[Any]:
    """The selected sketches and other shapes that have closed wires and no faces."""
    shapes = [obj for obj in solids() if is_shape(obj) and not obj.Shape.Faces]
    return [obj for obj in shapes if any(wire.isClosed() for wire in obj.Shape.Wires)]


def printables() -> list[Any]:
    """solids(), and links to such: they can be measured and written where the link is."""
    return solids() + links()


def links() -> list[Any]:
    """The selected links to objects with a mesh or a shape."""
    found = [selected.Object for selected in _selection() if selected.Object.isDerivedFrom("App::Link")]
    return [link for link in found if link.LinkedObject is not None and (is_mesh(link.LinkedObject) or is_shape(link.LinkedObject))]


def _members(obj: Any) -> list[Any]:
    """An object itself, or the visible ones within a group or an App::Part, in its order."""
    if not (obj.hasExtension("App::GroupExtension") and not obj.isDerivedFrom("Part::Feature")):
        return [obj]
    return [member for child in obj.Group if child.ViewObject.Visibility for member in _members(child)]


def made_solids() -> list[Any]:
    """The selected meshes that this workbench made and proved to be solids."""
    return [obj for obj in solids() if is_mesh(obj) and getattr(obj, "Valid", False) and not hasattr(obj, "Changes")]


def anything() -> bool:
    """Whether there is an object that surfaces() would return, or a link to one, without looking at its facets."""
    return bool(solids()) or bool(links())


def is_mesh(obj: Any) -> bool:
    return obj.isDerivedFrom("Mesh::Feature")


def is_shape(obj: Any) -> bool:
    return obj.isDerivedFrom("Part::Feature")


def is_thicken(obj: Any) -> bool:
    return {"Source", "Thickness", "ThinnestWall"} <= set(obj.PropertiesList)


def _selection() -> list[Any]:
    document = App.ActiveDocument
    if document is None:
        return []
    return [selected for selected in Gui.Selection.getSelectionEx(document.Name) if selected.Object is not None]


def _facets(obj: Any) -> list[int]:
    """Facets that one of FreeCAD's mesh tools has marked."""
    return list(obj.Mesh.getFacetSelection()) if hasattr(obj.Mesh, "getFacetSelection") else []
