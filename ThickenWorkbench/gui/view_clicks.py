# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clicks on the surface of an object in the 3D view."""

from __future__ import annotations

from contextlib import suppress
from typing import Any, Callable

import FreeCAD as App
import FreeCADGui as Gui

from .qt import QtCore

# A click is over by then, also on a busy machine.
_CLICK_MS = 2000


class ViewClicks:
    """Calls `hit` with the place (of the document, mm) of each click on `obj`, until stop()."""

    def __init__(self, view: Any, obj: Any, hit: Callable[[Any], None]) -> None:
        self._view, self._obj, self._hit = view, obj, hit
        self._callback = view.addEventCallback("SoMouseButtonEvent", self._on_button)
        self._unselect = Unselect()

    def stop(self) -> None:
        if self._callback is not None:
            with suppress(RuntimeError):  # the view was closed
                self._view.removeEventCallback("SoMouseButtonEvent", self._callback)
            self._callback = None
            self._unselect.stop()

    def _on_button(self, event: dict[str, Any]) -> None:
        if event["Button"] != "BUTTON1" or event["State"] != "DOWN":
            return
        found = self._view.getObjectInfo(tuple(event["Position"]))
        if found and found.get("Object") == self._obj.Name:
            self._hit(App.Vector(found["x"], found["y"], found["z"]))


class Unselect:
    """Takes back the selection that a click makes as well: its colour would hide what is being chosen.

    Of each click, until stop(); without `always`, only of the one that follows expect(). FreeCAD selects when
    the button is released, and tells nobody else of that.
    """

    def __init__(self, always: bool = True) -> None:
        self._always, self._expected = always, False
        self._observes = True
        Gui.Selection.addObserver(self)

    def expect(self) -> None:
        """A button has just been pressed on what is not meant to select."""
        self._expected = True
        QtCore.QTimer.singleShot(_CLICK_MS, self.forget)

    def forget(self) -> None:
        self._expected = False

    def stop(self) -> None:
        if self._observes:
            self._observes = False
            Gui.Selection.removeObserver(self)

    def addSelection(self, document: str, name: str, sub: str, place: Any) -> None:
        if self._always or self._expected:
            self._expected = False
            QtCore.QTimer.singleShot(0, Gui.Selection.clearSelection)

    def setPreselection(self, document: str, name: str, sub: str) -> None:
        if self._always:
            QtCore.QTimer.singleShot(0, lambda: Gui.Selection.clearPreselection())
