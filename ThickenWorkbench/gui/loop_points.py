# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that are set, taken and dragged on the surface of an object in the 3D view."""

from __future__ import annotations

from contextlib import suppress
from typing import Any, Protocol

import FreeCAD as App
import numpy as np

from .view_clicks import Unselect

# A point is taken, not a new one set, by a press so near to it.
_NEAR_PIXELS = 9


class Owner(Protocol):
    """Who has the points."""

    points: list[Any]  #: in the coordinates of the object

    def pressed(self, place: Any) -> None: ...  #: on the surface, beside the points
    def taken(self, index: int) -> None: ...  #: a press on a point
    def dragged(self, index: int, place: Any) -> None: ...  #: the point is to be there


class LoopPoints:
    """Tells `owner` what the mouse does on `obj`, until stop(). Places are in the coordinates of the object."""

    def __init__(self, view: Any, obj: Any, owner: Owner) -> None:
        self._view, self._obj, self._owner = view, obj, owner
        self._held: int | None = None  # the point that follows the mouse
        self._callbacks = {
            kind: view.addEventCallback(kind, call)
            for kind, call in (("SoMouseButtonEvent", self._on_button), ("SoLocation2Event", self._on_move))
        }
        self._unselect = Unselect()

    def stop(self) -> None:
        for kind, callback in self._callbacks.items():
            with suppress(RuntimeError):  # the view was closed
                self._view.removeEventCallback(kind, callback)
        self._callbacks = {}
        self._unselect.stop()

    def _on_button(self, event: dict[str, Any]) -> None:
        if event["Button"] != "BUTTON1":
            return
        if event["State"] != "DOWN":
            self._held = None
            return
        self._held = self._point_at(event["Position"])
        if self._held is not None:
            self._owner.taken(self._held)
        elif (place := self._place_at(event["Position"])) is not None:
            self._owner.pressed(place)

    def _on_move(self, event: dict[str, Any]) -> None:
        if self._held is None or self._held >= len(self._owner.points):
            return
        if (place := self._place_at(event["Position"])) is not None:
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
