# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the feature looks in the tree. Documents name this module and class: neither may move.

Nothing here imports FreeCADGui: the module can be loaded by a FreeCAD without a display.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .stateless import Stateless

ICONS = Path(__file__).resolve().parent.parent / "icons"


class FeatureViewProvider(Stateless):
    """What the views of all features have in common; keeps no state that would be saved."""

    icon = "thicken.svg"

    def __init__(self, view: Any) -> None:
        view.Proxy = self

    def attach(self, view: Any) -> None:
        self.Object = view.Object

    def getIcon(self) -> str:
        return str(ICONS / self.icon)

    def claimChildren(self) -> list[Any]:
        source = getattr(getattr(self, "Object", None), "Source", None)
        return [source] if source is not None else []

    def onDelete(self, view: Any, sub_elements: Any) -> bool:
        source = view.Object.Source
        if source is not None and source.ViewObject is not None:
            source.ViewObject.Visibility = True
        return True


class EditableViewProvider(FeatureViewProvider):
    """A double click opens the task panel."""

    def doubleClicked(self, view: Any) -> bool:
        view.Document.setEdit(view.Object.Name, 0)
        return True

    def setEdit(self, view: Any, mode: int = 0) -> bool | None:
        """Open the task panel that made the feature."""
        if mode != 0:
            return None  # moving, colours: FreeCAD's own
        from .gui.editing import edit

        return edit(view.Object)

    def unsetEdit(self, view: Any, mode: int = 0) -> bool | None:
        if mode != 0:
            return None
        from .gui.editing import end

        end()
        return True


class RegionViewProvider(EditableViewProvider):
    """Shows the regions of a solid in colours of their own."""

    def attach(self, view: Any) -> None:
        super().attach(view)
        if "RegionColors" not in view.PropertiesList:
            view.addProperty(
                "App::PropertyBool",
                "RegionColors",
                "Object Style",
                "Whether the original surface, the shell and the wall have colours of their own",
            )
            view.RegionColors = True

    def updateData(self, obj: Any, name: str) -> None:
        if name in ("Mesh", "RegionRuns") and obj.ViewObject is not None:
            from .gui.region_colours import paint_later

            self.paint(obj.ViewObject)  # at once: old colours do not fit a new mesh
            paint_later(obj.ViewObject)

    def onChanged(self, view: Any, name: str) -> None:
        if name in ("RegionColors", "ShapeColor", "ShapeMaterial", "ShapeAppearance", "Coloring"):
            from .gui.region_colours import paint_later

            paint_later(view)  # FreeCAD applies its own colour after this call

    def finishRestoring(self) -> None:
        self.paint(self.Object.ViewObject)

    def paint(self, view: Any) -> None:
        """Colour the regions. FreeCAD sets its own colour whenever one of its properties changes."""
        from .gui.region_colours import paint

        paint(view, getattr(view, "RegionColors", True))


class ThickenViewProvider(RegionViewProvider):
    """Of a thickened surface."""


class SolidViewProvider(FeatureViewProvider):
    """Of a Part solid."""

    icon = "part_solid.svg"


class RepairViewProvider(EditableViewProvider):
    """Of a mended surface."""

    icon = "repair_surface.svg"


class TrimViewProvider(EditableViewProvider):
    """Of a part that was cut out of a surface."""

    icon = "trim_surface.svg"


class DrainViewProvider(RegionViewProvider):
    """Of a solid with drain holes."""

    icon = "drain_holes.svg"


class PlugViewProvider(FeatureViewProvider):
    """Of plugs for drain holes."""

    icon = "drain_holes.svg"


# By the class of the feature's own proxy.
_PROVIDERS = {
    "ThickenFeature": ThickenViewProvider,
    "PartSolidFeature": SolidViewProvider,
    "RepairFeature": RepairViewProvider,
    "TrimFeature": TrimViewProvider,
    "DrainHolesFeature": DrainViewProvider,
    "PlugFeature": PlugViewProvider,
}


def attach_view_provider(obj: Any) -> None:
    """Give `obj` its view provider unless it has one.

    A document made without a display has no views; opened with one, FreeCAD makes views without a
    Proxy, and hides the objects. What a document saved with a display says of the view is read
    afterwards and stays.
    """
    view = obj.ViewObject
    if view is None or isinstance(view.Proxy, FeatureViewProvider):
        return
    _PROVIDERS.get(type(obj.Proxy).__name__, FeatureViewProvider)(view)
    view.Visibility = True
