# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page in FreeCAD's preferences, and what follows when something there changes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from .. import preferences
from ..view_provider import ICONS, RegionViewProvider

PAGE = Path(__file__).resolve().parent / "ui" / "preferences.ui"

_observer: Any = None


class _Colours:
    """Paints the features again when one of the colours changes."""

    def onChange(self, group: Any, key: str) -> None:
        if key.startswith("Color"):
            repaint_all()


def add() -> None:
    """Add the page, once for as long as FreeCAD runs."""
    global _observer
    if _observer is not None:
        return
    Gui.addIconPath(str(ICONS))  # FreeCAD looks for preferences-thicken.svg there
    Gui.addPreferencePage(str(PAGE), "Thicken")
    _observer = _Colours()
    App.ParamGet(preferences.PATH).Attach(_observer)


def repaint_all() -> None:
    """Paint all regions of all documents again."""
    for document in App.listDocuments().values():
        for obj in document.Objects:
            view = getattr(obj, "ViewObject", None)
            if isinstance(getattr(view, "Proxy", None), RegionViewProvider):
                view.Proxy.paint(view)
