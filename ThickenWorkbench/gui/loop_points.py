# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that are set, taken and dragged on the surface of an object in the 3D view."""

from __future__ import annotations

from contextlib import suppress
from typing import Any, Protocol

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from .qt import QtCore, QtWidgets

# A point is taken, not a new one set, by a press so near to it.
_NEAR_PIXELS = 9


class Owner(Protocol):
    """Who has the points."""

    points: list[Any]  #: in the coordinates of the object

    def pressed(self, place: Any) -> None: ...  #: on the surface, beside the points
    def taken(self, index: int) -> None: ...  #: a press on a point
    def dragged(self, index: int, place: Any) -> None: ...  #: the point is to be there


def _active_view() -> list[Any]:
    """The widget that the active 3D view is drawn on, behind what it lies in: PySide forgets a widget with the object
    that it was found in, and graphicsView() of a view may be that of one which has been closed."""
    area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    window = area.activeSubWindow() or area.subWindowList()[-1]
    graphics = window.findChild(QtWidgets.QGraphicsView)
    return [area, window, graphics, graphics.viewport()]


class LoopPoints(QtCore.QObject):
    """Tells `owner` what the left button does on `obj`, until stop(). Places are in the coordinates of the object.

    The widget is watched, not FreeCAD's events: those tell of a press only when the button is released, and of what
    a drag means to the view. What is done to points is kept from the view, which would select or turn.
    """

    def __init__(self, view: Any, obj: Any, owner: Owner) -> None:
        super().__init__()
        self._view, self._obj, self._owner = view, obj, owner
        self._held: int | None = None  # the point that follows the mouse
        self._is_down = False  # since a press on the surface
        self._widgets = _active_view()
        self._port = self._widgets[-1]
        self._port.installEventFilter(self)

    def stop(self) -> None:
        with suppress(RuntimeError):  # the view was closed
            self._port.removeEventFilter(self)

    def eventFilter(self, watched: Any, event: Any) -> bool:
        kind = event.type()
        if kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            if event.button() == QtCore.Qt.LeftButton:
                self._is_down = self._pressed(self._pixel(event))
                return self._is_down
        elif kind == QtCore.QEvent.MouseMove and self._is_down:
            self._moved(self._pixel(event))
            return True
        elif kind == QtCore.QEvent.MouseButtonRelease and event.button() == QtCore.Qt.LeftButton and self._is_down:
            self._is_down, self._held = False, None
            return True
        return False

    def _pixel(self, event: Any) -> tuple[int, int]:
        """From the lower left corner, as FreeCAD counts."""
        ratio = self._port.devicePixelRatioF()
        return round(event.pos().x() * ratio), round((self._port.height() - 1 - event.pos().y()) * ratio)

    def _pressed(self, pixel: tuple[int, int]) -> bool:
        self._held = self._point_at(pixel)
        if self._held is not None:
            self._owner.taken(self._held)
        elif (place := self._place_at(pixel)) is not None:
            self._owner.pressed(place)
        else:
            return False
        return True

    def _moved(self, pixel: tuple[int, int]) -> None:
        if self._held is None or self._held >= len(self._owner.points):
            return
        if (place := self._place_at(pixel)) is not None:
            self._owner.dragged(self._held, place)

    def _placement(self) -> Any:
        return self._obj.getGlobalPlacement()

    def _place_at(self, position: tuple[int, int]) -> Any:
        """Where the surface is below a pixel; None: it is not there, or hidden by another object."""
        found = self._view.getObjectInfo(tuple(position))
        if not found or found.get("Object") != self._obj.Name:
            return None
        return self._placement().inverse().multVec(App.Vector(found["x"], found["y"], found["z"]))

    def _point_at(self, position: tuple[int, int]) -> int | None:
        """The point nearest to a pixel, of those that are near."""
        place = self._placement()
        pixels = [self._view.getPointOnScreen(place.multVec(App.Vector(*point))) for point in self._owner.points]
        if not pixels:
            return None
        away = np.linalg.norm(np.array(pixels, float) - position, axis=1)
        nearest = int(np.argmin(away))
        return nearest if away[nearest] < _NEAR_PIXELS else None
