# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the feature looks in the tree. Documents name this module and class: neither may move.

Nothing here imports FreeCADGui: the module can be loaded by a FreeCAD without a display.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

ICONS = Path(__file__).resolve().parent.parent / "icons"


class ThickenViewProvider:
    """Proxy of the feature's view; keeps no state that would be saved."""

    def __init__(self, view: Any) -> None:
        view.Proxy = self

    def attach(self, view: Any) -> None:
        self.Object = view.Object

    def getIcon(self) -> str:
        return str(ICONS / "thicken.svg")

    def claimChildren(self) -> list[Any]:
        source = getattr(getattr(self, "Object", None), "Source", None)
        return [source] if source is not None else []

    def onDelete(self, view: Any, sub_elements: Any) -> bool:
        source = view.Object.Source
        if source is not None and source.ViewObject is not None:
            source.ViewObject.Visibility = True
        return True

    # FreeCAD before 0.21.2 calls the first pair, later ones the second.
    def __getstate__(self) -> None:
        return None

    def __setstate__(self, state: Any) -> None:
        return None

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        return None


def attach_view_provider(obj: Any) -> None:
    """Give `obj` its view provider unless it has one.

    A document made without a display has no views; opened with one, FreeCAD makes views without a
    Proxy, and hides the objects. What a document saved with a display says of the view is read
    afterwards and stays.
    """
    view = obj.ViewObject
    if view is None or isinstance(view.Proxy, ThickenViewProvider):
        return
    ThickenViewProvider(view)
    view.Visibility = True
