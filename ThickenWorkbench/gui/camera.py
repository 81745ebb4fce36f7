# SPDX-License-Identifier: LGPL-2.1-or-later
"""Goes to a place in the 3D view, without turning it."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from numpy.typing import ArrayLike
from pivy import coin

from ..sources import RefusedError

translate = App.Qt.translate


def view_of(document: Any) -> Any:
    """The 3D view of a document that was used last; raises RefusedError where there is none."""
    gui = Gui.getDocument(document.Name)
    view = gui.activeView()
    if hasattr(view, "getCameraNode"):
        return view
    for view in gui.mdiViewsOfType("Gui::View3DInventor"):
        return view
    raise RefusedError(translate("Thicken", "The document has no 3D view. Open one: View ▸ Create new view."))


def go_to(view: Any, places: ArrayLike, least_size: float) -> None:
    """Show all `places` (n × 3, of the document), and around a single one `least_size` mm."""
    places = np.asarray(places, float).reshape(-1, 3)
    low, high = places.min(0), places.max(0)
    margin = np.maximum((least_size - (high - low)) / 2, 0)
    box = coin.SbBox3f(coin.SbVec3f(*(low - margin)), coin.SbVec3f(*(high + margin)))
    camera = view.getCameraNode()
    camera.viewBoundingBox(box, 1.0, 1.0)
