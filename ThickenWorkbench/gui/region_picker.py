# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chooses a part of a mesh by clicks in the 3D view: each adds, or takes away, a smooth patch."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np

from .. import preferences
from ..mesh_io import arrays_from_mesh
from ..core.patches import Brush, SmoothPatches
from .camera import view_of
from .overlay import faces, over_object
from .view_clicks import ViewClicks


class RegionPicker:
    """`changed` is called with the chosen facets after each click, until stop()."""

    def __init__(self, source: Any, facets: tuple[int, ...], changed: Callable[[tuple[int, ...]], None]) -> None:
        self.sharpest = 20.0  #: degrees: what a patch ends at
        self._source, self._changed = source, changed
        self._vertices, self._triangles = arrays_from_mesh(source.Mesh)
        self._patches = SmoothPatches(self._vertices, self._triangles)
        self._brush = Brush(self._vertices, self._triangles)
        self._chosen = np.zeros(len(self._triangles), bool)
        self._chosen[list(facets)] = True
        self._overlay = over_object(source)
        self._clicks = ViewClicks(view_of(source.Document), source, self._clicked)
        self._show()

    def stop(self) -> None:
        self._clicks.stop()
        self._overlay.remove()

    def clear(self) -> None:
        self._chosen[:] = False
        self._tell()

    def facet_at(self, place: Any) -> int:
        """The facet that is nearest to a place of the document."""
        return self._brush.facet_at(tuple(self._source.getGlobalPlacement().inverse().multVec(place)))

    def _clicked(self, place: Any) -> None:
        facet = self.facet_at(place)
        patch = self._patches.around(facet, self.sharpest)
        self._chosen[patch] = not self._chosen[facet]
        self._tell()

    def _tell(self) -> None:
        self._show()
        self._changed(tuple(int(facet) for facet in np.flatnonzero(self._chosen)))

    def _show(self) -> None:
        chosen = self._triangles[self._chosen]
        colour = preferences.colour("ColorOriginal")
        self._overlay.show(*([faces(self._vertices, chosen, colour)] if len(chosen) else []))

