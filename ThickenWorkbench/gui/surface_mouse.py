# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the left button does on the surface of an object in the 3D view."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from .qt import QtCore, QtWidgets


def _active_view() -> list[Any]:
    """The widget that the active 3D view is drawn on, behind what it lies in: PySide forgets a widget with the object
    that it was found in, and graphicsView() of a view may be that of one which has been closed."""
    area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    window = area.activeSubWindow() or area.subWindowList()[-1]
    graphics = window.findChild(QtWidgets.QGraphicsView)
    return [area, window, graphics, graphics.viewport()]


class SurfaceMouse(QtCore.QObject):
    """Calls what subclasses do for presses and drags that begin on `obj`, until stop().

    The widget is watched, not FreeCAD's events: those tell of a press only when the button is released, and of what
    a drag means to the view. What is done here is kept from the view, which would select or turn.
    """

    def __init__(self, view: Any, obj: Any) -> None:
        super().__init__()
        self._view, self._obj = view, obj
        self._is_down = False  # since a press that was taken
        self._widgets = _active_view()
        self._port = self._widgets[-1]
        self._port.installEventFilter(self)

    def stop(self) -> None:
        with suppress(RuntimeError):  # the view was closed
            self._port.removeEventFilter(self)

    def pressed(self, pixel: tuple[int, int], shift: bool) -> bool:
        """Whether this press is taken from the view."""
        raise NotImplementedError

    def moved(self, pixel: tuple[int, int]) -> None:
        """The mouse moves with the button down."""
        raise NotImplementedError

    def released(self) -> None:
        """The button is up again."""

    def eventFilter(self, watched: Any, event: Any) -> bool:
        kind = event.type()
        if kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            if event.button() == QtCore.Qt.LeftButton:
                self._is_down = self.pressed(self._pixel(event), bool(event.modifiers() & QtCore.Qt.ShiftModifier))
                return self._is_down
        elif kind == QtCore.QEvent.MouseMove and self._is_down:
            self.moved(self._pixel(event))
            return True
        elif kind == QtCore.QEvent.MouseButtonRelease and event.button() == QtCore.Qt.LeftButton and self._is_down:
            self._is_down = False
            self.released()
            return True
        return False

    def place_at(self, pixel: tuple[int, int]) -> Any:
        """Where the surface is below a pixel, in the coordinates of the object; None: it is not there, or hidden by another object."""
        found = self._view.getObjectInfo(tuple(pixel))
        if not found or found.get("Object") != self._obj.Name:
            return None
        return self._obj.getGlobalPlacement().inverse().multVec(App.Vector(found["x"], found["y"], found["z"]))

    def _pixel(self, event: Any) -> tuple[int, int]:
        """From the lower left corner, as FreeCAD counts."""
        ratio = self._port.devicePixelRatioF()
        return round(event.pos().x() * ratio), round((self._port.height() - 1 - event.pos().y()) * ratio)
