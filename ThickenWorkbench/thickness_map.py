# SPDX-License-Identifier: LGPL-2.1-or-later
"""How thick a solid is facet by facet, and how far its shell is from its definition.

"wall" measures any closed mesh: from the middle of each facet straight through the material to the
boundary again, where that faces the other way; an edge has no wall, nor has the cross-section at the rim of
a Thicken feature. "deviation" is for
Thicken features: the distance of the shell from the surface less the thickness, which is 0 where the
shell is where Definition 5 of the paper puts it; facets of the surface itself and of the wall have none.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import FreeCAD as App
import numpy as np

from . import runs
from .core.facets import areas_of
from .regions import facet_regions
from .sources import RefusedError, kind_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

_ORIGINAL = 0  # Region.ORIGINAL
_SHELL = 1  # Region.SHELL
_WALL = 2  # Region.WALL
_BINS = 32


class Histogram(NamedTuple):
    """Share of the measured area between one edge and the next."""

    shares: NDArray[np.float64]
    edges: NDArray[np.float64]  #: mm; one more than shares


class ThicknessMap(NamedTuple):
    """Values in mm; NaN where nothing is measured."""

    what: str
    facet_values: NDArray[np.float64]  #: in the order of the mesh's facets
    vertex_values: NDArray[np.float64]  #: in the order of the mesh's points: mean of the facets around
    minimum: float
    maximum: float
    mean: float  #: weighted by area, like the percentiles
    percentiles: dict[int, float]  #: 1, 5, 50, 95, 99
    minimum_place: App.Vector  #: global: the middle of the facet with the minimum
    maximum_place: App.Vector
    histogram: Histogram


def thickness_map(feature: Any, what: Literal["wall", "deviation"] = "wall") -> ThicknessMap:
    """Measure the mesh of `feature`.

    Raises sources.RefusedError for an object without a closed mesh, and for "deviation" of an object that
    is not a Thicken feature with a solid.
    """
    return runs.run(map_step(feature, what))


def map_step(feature: Any, what: str = "wall") -> runs.Step[ThicknessMap]:
    """The step of thickness_map(): nothing of it touches `feature` any more."""
    from .mesh_io import arrays_from_mesh

    if what not in ("wall", "deviation"):
        raise ValueError(f"what must be 'wall' or 'deviation', not {what!r}")
    if kind_of(feature) != "mesh" or feature.Mesh.CountFacets == 0:
        raise RefusedError(f"“{getattr(feature, 'Label', feature)}” has no mesh to measure.")
    vertices, triangles = arrays_from_mesh(feature.Mesh)
    vertices = vertices.astype(float)
    runs.require_room(len(triangles))
    measure = _wall(feature, vertices, triangles) if what == "wall" else _deviation(feature, vertices, triangles)
    placement = feature.getGlobalPlacement()
    return lambda context: _summary(what, measure(context), vertices, triangles, placement)


def _wall(feature: Any, vertices: NDArray, triangles: NDArray) -> runs.Step[NDArray]:
    if not feature.Mesh.isSolid():
        raise RefusedError(f"“{feature.Label}” is not closed: only a closed mesh has a wall thickness.")
    return wall_step(feature, vertices, triangles)


def wall_step(obj: Any, vertices: NDArray, triangles: NDArray) -> runs.Step[NDArray]:
    """For the wall thickness at each of `triangles`, which bound the closed solid of `obj`; NaN for none."""
    from thicken import native

    extension, threads = native.load(), runs.threads()
    regions = facet_regions(obj) if hasattr(obj, "RegionRuns") else np.empty(0)

    # From its cross-section a sheet is as thick as it is broad.
    edges = regions == _WALL if len(regions) == len(triangles) else None

    def step(context: Any) -> NDArray:
        values = extension.wall_thickness(vertices, triangles, edges=edges, threads=threads, context=context)
        return np.where(np.isfinite(values), values, np.nan)

    return step


def _deviation(feature: Any, vertices: NDArray, triangles: NDArray) -> runs.Step[NDArray]:
    from thicken import native
    from .build import surface_of
    from .thickness_regions import ThicknessField

    if not getattr(feature, "Valid", False) or not hasattr(feature, "Thickness"):
        raise RefusedError(f"“{feature.Label}” is no Thicken feature with a solid: there is nothing to deviate from.")
    regions = facet_regions(feature)
    if len(regions) != len(triangles):
        raise RefusedError(f"The mesh of “{feature.Label}” is not the one that was computed. Recompute it.")
    shell = np.flatnonzero(regions == _SHELL)
    extension, surface = native.load(), surface_of(feature)
    asked = ThicknessField(feature, surface).values(feature.Thickness.Value)
    # With a gap, or once it is repaired, the surface that was thickened is another than the source's.
    own = regions == _ORIGINAL
    thickened = (vertices, triangles[own]) if own.any() else surface

    def step(context: Any) -> NDArray:
        middles = vertices[triangles[shell]].mean(axis=1)
        closest = extension.closest_points(*thickened, middles, context=context)
        measured = closest["on_rim"] == 0  # beyond the rim the shell is wall, whatever it is called
        wanted = asked if not np.ndim(asked) else _at_points(asked, surface, extension.closest_points(*surface, middles, context=context))
        values = np.full(len(triangles), np.nan)
        values[shell[measured]] = (closest["distance"] - wanted)[measured]
        return values

    return step


def _at_points(values: NDArray, surface: tuple[NDArray, NDArray], closest: dict[str, NDArray]) -> NDArray[np.float64]:
    """What a number for each vertex of a surface is at points of it."""
    corners = np.asarray(surface[1])[closest["triangle"]]
    a, b, c = np.asarray(surface[0], float)[corners].transpose(1, 0, 2)
    point = closest["point"]
    shares = np.stack([np.linalg.norm(np.cross(p - point, q - point), axis=1) for p, q in ((b, c), (c, a), (a, b))], axis=1)
    return (shares * values[corners]).sum(axis=1) / np.maximum(shares.sum(axis=1), 1e-300)


def _summary(what: str, values: NDArray, vertices: NDArray, triangles: NDArray, placement: Any) -> ThicknessMap:
    corners = vertices[triangles]
    areas = areas_of(corners)
    known = np.flatnonzero(np.isfinite(values) & (areas > 0))
    if len(known) == 0:
        raise RefusedError("There is no facet at which this could be measured.")
    sample, weights = values[known], areas[known] / areas[known].sum()
    low, high = known[sample.argmin()], known[sample.argmax()]

    def place(facet: int) -> App.Vector:
        return placement.multVec(App.Vector(*corners[facet].mean(axis=0)))

    return ThicknessMap(
        what=what,
        facet_values=values,
        vertex_values=_at_vertices(values, areas, triangles, len(vertices)),
        minimum=float(values[low]),
        maximum=float(values[high]),
        mean=float(sample @ weights),
        percentiles=_percentiles(sample, weights),
        minimum_place=place(low),
        maximum_place=place(high),
        histogram=_histogram(sample, weights),
    )


def _at_vertices(values: NDArray, areas: NDArray, triangles: NDArray, count: int) -> NDArray:
    known = np.isfinite(values)
    corners = triangles[known].ravel()
    weights = np.repeat(areas[known], 3)
    total = np.bincount(corners, weights, count)
    summed = np.bincount(corners, weights * np.repeat(values[known], 3), count)
    return np.divide(summed, total, out=np.full(count, np.nan), where=total > 0)


def _percentiles(sample: NDArray, weights: NDArray) -> dict[int, float]:
    order = np.argsort(sample, kind="stable")
    reached = np.cumsum(weights[order])
    last = len(sample) - 1
    return {p: float(sample[order[min(np.searchsorted(reached, p / 100), last)]]) for p in (1, 5, 50, 95, 99)}


def _histogram(sample: NDArray, weights: NDArray) -> Histogram:
    low, high = float(sample.min()), float(sample.max())
    if not high > low:  # one value: a bin around it
        high = low + max(abs(low), 1.0) * 1e-6
    shares, edges = np.histogram(sample, bins=_BINS, range=(low, high), weights=weights)
    return Histogram(shares, edges)
