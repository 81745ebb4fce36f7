# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every defect that keeps a surface from being thickened, with its place in the document."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, NamedTuple, Sequence

import FreeCAD as App
import numpy as np

from .placed import placed_points
from .sources import DEFAULT_DEFLECTION, kind_of, surface_arrays

if TYPE_CHECKING:
    from numpy.typing import NDArray


class SurfaceDefect(NamedTuple):
    """One kind of defect of a surface: docs/errors.md lists the codes. Places are global, mm."""

    code: str
    sentence: str  #: what is wrong, where in the surface's own coordinates, and what to do
    count: int  #: of all that were found; the lists below hold at most 1000
    place: App.Vector  #: of the first
    facets: list[int]  #: indices into the source's facets (into the tessellation of a shape)
    triangles: NDArray  #: k × 3 × 3: corners of these facets
    edges: NDArray  #: k × 2 × 3: ends
    vertices: NDArray  #: k × 3


def check_surface(
    source: Any, *, faces: Sequence[str] = (), facets: Iterable[int] = (), deflection: float = DEFAULT_DEFLECTION
) -> list[SurfaceDefect]:
    """All kinds of defect of what is chosen of a mesh object or shape, as for make_thicken().

    An empty list means that it can be thickened. Raises sources.RefusedError where there is nothing
    to check, and ImportError without the extension.
    """
    from . import native

    chosen = sorted({int(facet) for facet in facets})
    vertices, triangles = surface_arrays(source, faces=faces, facets=chosen, deflection=deflection)
    extension = native.load()
    found = extension.check(vertices, triangles)
    points, corners = extension.weld(vertices, triangles)
    placed = placed_points(points, source.getGlobalPlacement())
    original = np.array(chosen) if chosen and kind_of(source) == "mesh" else np.arange(len(triangles))
    return [_located(defect, placed, corners, original, source) for defect in found["defects"]]


def _located(defect: dict[str, Any], points: NDArray, corners: NDArray, original: NDArray, source: Any) -> SurfaceDefect:
    ids = np.array(defect["triangles"], np.int64)
    edges = np.array(defect["edges"], np.int64).reshape(-1, 2)
    place = source.getGlobalPlacement().multVec(App.Vector(*(x or 0.0 for x in defect["place_mm"])))
    sentence = defect["sentence"]
    return SurfaceDefect(
        code=defect["code"],
        sentence=sentence[:1].upper() + sentence[1:] + ".",
        count=defect["count"],
        place=place,
        facets=original[ids].tolist(),
        triangles=points[corners[ids]],
        edges=points[edges],
        vertices=points[np.array(defect["vertices"], np.int64)],
    )
