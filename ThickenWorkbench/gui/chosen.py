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
    """Meshes, shapes, chosen faces and chosen facets, in the order of selection."""
    chosen = []
    for selected in _selection():
        obj = selected.Object
        if is_mesh(obj):
            chosen.append(Chosen(obj, facets=tuple(_facets(obj))))
        elif is_shape(obj):
            chosen.append(Chosen(obj, faces=tuple(n for n in selected.SubElementNames if n.startswith("Face"))))
    return chosen


def solids() -> list[Any]:
    """The selected objects that have a mesh or a shape."""
    return [selected.Object for selected in _selection() if is_mesh(selected.Object) or is_shape(selected.Object)]


def made_solids() -> list[Any]:
    """The selected meshes that this workbench made and proved to be solids."""
    return [obj for obj in solids() if is_mesh(obj) and getattr(obj, "Valid", False) and not hasattr(obj, "Changes")]


def anything() -> bool:
    """Whether there is an object that surfaces() would return, without looking at its facets."""
    return bool(solids())


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
