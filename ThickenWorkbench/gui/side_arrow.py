# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrow in the 3D view that shows where the material will lie; a click on it flips the side."""

from __future__ import annotations

from typing import Any, Callable

import FreeCAD as App
import numpy as np
from numpy.typing import ArrayLike

from .. import preferences
from ..core.facets import doubled_normals
from .overlay import arrow, over_object
from .view_clicks import Unselect

# The arrow is as long as the thickness, but never too small to be seen and clicked.
_LEAST_LENGTH = 0.12  # of the diagonal
_NEAR_PIXELS = 12


class SideArrow:
    """Arrows at one place of the surface: one, or two for both sides."""

    def __init__(
        self, obj: Any, view: Any, vertices: ArrayLike, triangles: ArrayLike, flip: Callable[[], None]
    ) -> None:
        self._overlay = over_object(obj)
        self._placement = obj.getGlobalPlacement() if hasattr(obj, "getGlobalPlacement") else App.Placement()
        self.move(vertices, triangles)
        self._tips: list[np.ndarray] = []
        self._flip = flip
        self._view = view
        self._callback = view.addEventCallback("SoMouseButtonEvent", self._on_button)
        self._unselect = Unselect(always=False)

    def move(self, vertices: ArrayLike, triangles: ArrayLike) -> None:
        """Stand on another surface, once show() is called."""
        self._foot, self._normal, self._diagonal = _place(np.asarray(vertices, float), np.asarray(triangles))

    def show(self, side: str, thickness: float) -> None:
        """Draw for "negative", "positive" or "both"."""
        length = max(thickness, _LEAST_LENGTH * self._diagonal)
        signs = {"negative": [-1], "positive": [1], "both": [-1, 1]}[side.lower()]
        self._tips = [self._foot + sign * length * self._normal for sign in signs]
        colour = preferences.colour("ColorWall")
        self._overlay.show(*[arrow(self._foot, tip, colour) for tip in self._tips])

    def remove(self) -> None:
        if self._callback is not None:
            try:
                self._view.removeEventCallback("SoMouseButtonEvent", self._callback)
            except RuntimeError:  # the view was closed
                pass
            self._callback = None
            self._unselect.stop()
        self._overlay.remove()

    def middle_on_screen(self) -> tuple[int, int]:
        """Where the first arrow is, in pixels from the lower left corner of the view."""
        return self._pixels((self._foot + self._tips[0]) / 2)

    def _on_button(self, event: dict[str, Any]) -> None:
        if event["Button"] != "BUTTON1" or event["State"] != "DOWN":
            return
        if self._is_near(event["Position"]):
            self._unselect.expect()
            self._flip()
        else:
            self._unselect.forget()

    def _is_near(self, position: tuple[int, int]) -> bool:
        click = np.asarray(position, float)
        foot = np.asarray(self._pixels(self._foot), float)
        for tip in self._tips:
            along = np.asarray(self._pixels(tip), float) - foot
            share = np.clip((click - foot) @ along / max(along @ along, 1e-9), 0, 1)
            if np.linalg.norm(foot + share * along - click) < _NEAR_PIXELS:
                return True
        return False

    def _pixels(self, point: np.ndarray) -> tuple[int, int]:
        return self._view.getPointOnScreen(self._placement.multVec(App.Vector(*point)))


def _place(vertices: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
    """The middle of the triangle nearest to the middle of the surface, its normal, and the diagonal."""
    corners = vertices[triangles]
    centres = corners.mean(1)
    normals = doubled_normals(corners)
    areas = np.linalg.norm(normals, axis=1)
    box = np.ptp(corners.reshape(-1, 3), axis=0)
    off = np.linalg.norm(centres - np.average(centres, axis=0, weights=np.maximum(areas, 1e-30)), axis=1)
    off[areas <= 0] = np.inf
    chosen = int(np.argmin(off))
    return centres[chosen], normals[chosen] / max(areas[chosen], 1e-300), float(np.linalg.norm(box))
