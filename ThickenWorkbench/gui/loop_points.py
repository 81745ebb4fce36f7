# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that are set, taken and dragged on the surface of an object in the 3D view."""

from __future__ import annotations

from typing import Any, Protocol

import FreeCAD as App
import numpy as np

from .surface_mouse import SurfaceMouse

# A point is taken, not a new one set, by a press so near to it.
_NEAR_PIXELS = 9


class Owner(Protocol):
    """Who has the points."""

    points: list[Any]  #: in the coordinates of the object

    def pressed(self, place: Any) -> None: ...  #: on the surface, beside the points
    def taken(self, index: int) -> None: ...  #: a press on a point
    def dragged(self, index: int, place: Any) -> None: ...  #: the point is to be there


class LoopPoints(SurfaceMouse):
    """Tells `owner` what the left button does on `obj`. Places are in the coordinates of the object."""

    def __init__(self, view: Any, obj: Any, owner: Owner) -> None:
        super().__init__(view, obj)
        self._owner = owner
        self._held: int | None = None  # the point that follows the mouse

    def pressed(self, pixel: tuple[int, int], shift: bool) -> bool:
        self._held = self._point_at(pixel)
        if self._held is not None:
            self._owner.taken(self._held)
        elif (place := self.place_at(pixel)) is not None:
            self._owner.pressed(place)
        else:
            return False
        return True

    def moved(self, pixel: tuple[int, int]) -> None:
        if self._held is None or self._held >= len(self._owner.points):
            return
        if (place := self.place_at(pixel)) is not None:
            self._owner.dragged(self._held, place)

    def released(self) -> None:
        self._held = None

    def _point_at(self, position: tuple[int, int]) -> int | None:
        """The point nearest to a pixel, of those that are near."""
        place = self._obj.getGlobalPlacement()
        pixels = [self._view.getPointOnScreen(place.multVec(App.Vector(*point))) for point in self._owner.points]
        if not pixels:
            return None
        away = np.linalg.norm(np.array(pixels, float) - position, axis=1)
        nearest = int(np.argmin(away))
        return nearest if away[nearest] < _NEAR_PIXELS else None
