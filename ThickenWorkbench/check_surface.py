# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every defect that keeps a surface from being thickened, with its place in the document."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, NamedTuple, Sequence

import FreeCAD as App
import numpy as np

from . import runs
from .placed import placed_points
from .sources import DEFAULT_DEFLECTION, kind_of, surface_arrays

if TYPE_CHECKING:
    from numpy.typing import NDArray


class SurfaceDefect(NamedTuple):
    """One kind of defect of a surface: docs/errors.md lists the codes. Places are global, mm."""

    code: str
    sentence: str  #: what is wrong, where in the surface's own coordinates and in the document, what to do
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
    return runs.run(check_step(source, faces=faces, facets=facets, deflection=deflection))


def check_step(
    source: Any, *, faces: Sequence[str] = (), facets: Iterable[int] = (), deflection: float = DEFAULT_DEFLECTION
) -> runs.Step[list[SurfaceDefect]]:
    """The step of check_surface(): nothing of it touches `source` any more."""
    from thicken import native

    chosen = sorted({int(facet) for facet in facets})
    vertices, triangles = surface_arrays(source, faces=faces, facets=chosen, deflection=deflection)
    runs.require_room(len(triangles))
    extension, threads, placement = native.load(), runs.threads(), source.getGlobalPlacement()
    original = np.array(chosen) if chosen and kind_of(source) == "mesh" else np.arange(len(triangles))

    def step(context: Any) -> list[SurfaceDefect]:
        found = extension.check(vertices, triangles, threads=threads, context=context)
        points, corners = extension.weld(vertices, triangles)
        placed = placed_points(points, placement)
        return [_located(defect, placed, corners, original, placement) for defect in found["defects"]]

    return step


def _located(defect: dict[str, Any], points: NDArray, corners: NDArray, original: NDArray, placement: Any) -> SurfaceDefect:
    ids = np.array(defect["triangles"], np.int64)
    edges = np.array(defect["edges"], np.int64).reshape(-1, 2)
    place = placement.multVec(App.Vector(*(x or 0.0 for x in defect["place_mm"])))
    parts = [defect["sentence"]]
    if not placement.isIdentity() and (len(ids) or len(edges) or defect["vertices"]):
        parts.append(runs.in_document(placement, defect["place_mm"]))
    return SurfaceDefect(
        code=defect["code"],
        sentence=runs.as_sentences(parts),
        count=defect["count"],
        place=place,
        facets=original[ids].tolist(),
        triangles=points[corners[ids]],
        edges=points[edges],
        vertices=points[np.array(defect["vertices"], np.int64)],
    )
