# SPDX-License-Identifier: LGPL-2.1-or-later
"""A brush that paints on the surface of an object in the 3D view."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np

from .surface_mouse import SurfaceMouse

# Of the radius: places of a stroke are no farther from each other, also where the mouse jumps.
_STEP = 0.5
_MOST_PLACES = 100  # between two positions of the mouse


class Owner(Protocol):
    """Who holds the brush."""

    def brush_radius(self) -> float: ...  #: mm
    def painted(self, places: list[np.ndarray], removes: bool) -> None: ...  #: in the coordinates of the object
    def stroke_ended(self) -> None: ...


class BrushStrokes(SurfaceMouse):
    """Tells `owner` where the left button paints on `obj`; with Shift it removes."""

    def __init__(self, view: Any, obj: Any, owner: Owner) -> None:
        super().__init__(view, obj)
        self._owner = owner
        self._last: np.ndarray | None = None
        self._removes = False

    def pressed(self, pixel: tuple[int, int], shift: bool) -> bool:
        self._last, self._removes = None, shift
        self.moved(pixel)
        return self._last is not None

    def moved(self, pixel: tuple[int, int]) -> None:
        place = self.place_at(pixel)
        if place is None:  # a stroke that comes back begins anew there
            self._last = None
            return
        here = np.array(tuple(place))
        self._owner.painted(_between(self._last, here, _STEP * self._owner.brush_radius()), self._removes)
        self._last = here

    def released(self) -> None:
        self._owner.stroke_ended()


def _between(start: np.ndarray | None, end: np.ndarray, step: float) -> list[np.ndarray]:
    """Places from after `start` to `end`; they are near the surface where the stroke is short."""
    if start is None:
        return [end]
    count = int(np.clip(np.ceil(np.linalg.norm(end - start) / max(step, 1e-9)), 1, _MOST_PLACES))
    return [start + (k + 1) / count * (end - start) for k in range(count)]
