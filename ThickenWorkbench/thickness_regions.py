# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions of facets of a Thicken feature that have a thickness of their own.

A feature stores the corners of their facets, in the coordinates of its source without the Placement, and not their
numbers: so they are found again when the source changes. What is not found again is told.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, NamedTuple, Sequence

import FreeCAD as App
import numpy as np

from . import runs
from .build import surface_of
from .core.found_again import found_again
from .core.patches import Brush
from .core.thickness_field import blended, region_weights
from .numbers import number, percent
from .sources import RefusedError, kind_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

translate = App.Qt.translate

# Where less of a region is found again the surface has become another, and a thickness by chance would be worse than none.
_LEAST_SHARE = 0.5
# A cut along a rim changes as much without anybody having to know.
_MOST_LOSS = 0.01


class ThicknessRegion(NamedTuple):
    """As set_thickness_regions() takes it."""

    facets: list[int]  #: of the source; of a shape, of its triangles
    thickness: float  #: mm


class ThicknessField:
    """The regions of a feature on a surface: a thickness for each vertex of it."""

    def __init__(self, feature: Any, surface: tuple[NDArray, NDArray]) -> None:
        """Raises RefusedError for a region that is not on the surface any more."""
        found = regions_on(feature, surface)
        helps = translate("Thicken", "Paint the region again, or remove it.")
        for region in found:
            if not region.thickness > 0:
                raise RefusedError(f"The thickness of region {region.number} is {region.thickness:g} mm. Set it to more than 0 mm.")
            if region.share < _LEAST_SHARE:
                raise RefusedError(f"{region.loss()} {helps}")
        self.notes = [region.loss() for region in found if region.loss()]  #: what is to be known of the regions
        self._lengths = [region.thickness for region in found]
        facets = [region.facets for region in found]
        self._weights = region_weights(*surface, facets, feature.Transition.Value) if found else None

    def values(self, base: float) -> NDArray[np.float64] | float:
        """The thickness at each vertex where it is `base` beside the regions; without any `base` itself."""
        return base if self._weights is None else blended(base, self._lengths, self._weights)


class FoundRegion(NamedTuple):
    """What is on a surface of a region."""

    number: int  #: counted from 1
    facets: NDArray[np.int64]  #: of the surface
    thickness: float  #: mm
    share: float  #: of the area that was painted

    def loss(self) -> str:
        """A sentence about what is not there; no text where all of it is."""
        if self.share >= 1 - _MOST_LOSS:
            return ""
        text = translate("Thicken", "Only {share} of thickness region {number} ({thickness} mm) is on the surface, which has changed.")
        return text.format(share=percent(self.share), number=self.number, thickness=number(self.thickness))


def regions_on(feature: Any, surface: tuple[NDArray, NDArray]) -> list[FoundRegion]:
    """What is on `surface` of each region of a Thicken feature."""
    painted = zip(_corners_of(feature), feature.RegionThickness)
    with runs.refusing(feature.Source):
        found = [(found_again(chosen, *surface), mm) for chosen, mm in painted]
    return [FoundRegion(k + 1, each.facets, mm, each.share) for k, (each, mm) in enumerate(found)]


def set_thickness_regions(feature: Any, regions: Iterable[tuple[Iterable[int], Any]], transition: Any = None) -> None:
    """Give facets of the source of the Thicken feature `feature` other thicknesses, from its next recompute on.

    A region is a pair: indices of facets, and a length (mm, a quantity or text). Around all of them the thickness
    changes linearly over `transition` (a length) along the surface; None leaves the property Transition as it is. Without
    a region the thickness is the same everywhere. ValueError for what makes no sense, which changes nothing.
    """
    vertices, triangles = _surface_of(feature)
    numbers = facet_numbers(feature, len(triangles))
    corners, lengths = [], []
    for facets, thickness in regions:
        chosen = np.unique(np.fromiter(facets, np.int64))
        at = np.minimum(np.searchsorted(numbers, chosen), len(numbers) - 1)
        if len(chosen) == 0 or (numbers[at] != chosen).any():
            wrong = f"facet {chosen[numbers[at] != chosen][0]} is not thickened" if len(chosen) else "it has no facet"
            raise ValueError(f"region {len(corners) + 1}: {wrong}")
        corners.append(np.asarray(vertices, float)[np.asarray(triangles)[at]])
        lengths.append(_length("thickness", thickness))
        if not 0 < lengths[-1] < np.inf:
            raise ValueError(f"the thickness of region {len(corners)} must be above 0 mm, not {thickness}")
    if transition is not None:
        width = _length("transition", transition)
        if not 0 <= width < np.inf:
            raise ValueError(f"transition must be 0 mm or more, not {transition}")
        feature.Transition = width
    feature.RegionThickness = lengths
    feature.RegionSizes = [len(each) for each in corners]
    feature.RegionCorners = [App.Vector(*row) for each in corners for row in each.reshape(-1, 3).tolist()]


def thickness_regions(feature: Any) -> list[ThicknessRegion]:
    """The regions of a Thicken feature as they are on its source now."""
    surface = _surface_of(feature)
    numbers = facet_numbers(feature, len(surface[1]))
    return [ThicknessRegion(numbers[region.facets].tolist(), region.thickness) for region in regions_on(feature, surface)]


def facets_near(feature: Any, places: Sequence[ArrayLike], radius: float) -> list[int]:
    """The facets of the source of a Thicken feature that a brush of `radius` mm paints at `places` of the document.

    They are connected with the facet at the place, so that the other side of a thin part is not painted.
    """
    surface = _surface_of(feature)
    brush = Brush(*surface)
    to_source = feature.Source.getGlobalPlacement().inverse()
    painted = [brush.around(tuple(to_source.multVec(App.Vector(*place))), radius) for place in places]
    facets = np.unique(np.concatenate(painted)) if painted else np.empty(0, np.int64)
    return [int(facet) for facet in facet_numbers(feature, len(surface[1]))[facets]]


def _surface_of(feature: Any) -> tuple[NDArray, NDArray]:
    if not hasattr(feature, "RegionCorners"):
        raise ValueError(f"“{getattr(feature, 'Label', feature)}” is no Thicken feature")
    return surface_of(feature)


def facet_numbers(feature: Any, count: int) -> NDArray[np.int64]:
    """The facet of the source that each of the `count` triangles is which `feature` thickens; ascending."""
    chosen = np.unique(np.asarray(feature.Facets, np.int64)) if kind_of(feature.Source) == "mesh" else ()
    return np.asarray(chosen) if len(chosen) else np.arange(count)


def _corners_of(feature: Any) -> list[NDArray]:
    """The corners of the facets of each region, k × 3 × 3. Raises RefusedError where the properties contradict each other."""
    sizes, lengths = list(feature.RegionSizes), list(feature.RegionThickness)
    corners = np.array([tuple(place) for place in feature.RegionCorners], float).reshape(-1, 3)
    if len(sizes) != len(lengths) or min(sizes, default=1) < 1 or 3 * sum(sizes) != len(corners):
        raise RefusedError(
            f"RegionThickness has {len(lengths)} lengths, and there are {len(sizes)} thickness regions. Paint them again."
        )
    return np.split(corners.reshape(-1, 3, 3), np.cumsum(sizes)[:-1]) if sizes else []


def _length(what: str, value: Any) -> float:
    """In mm."""
    try:
        quantity = App.Units.Quantity(value) if isinstance(value, str) else value
        is_plain = not hasattr(quantity, "Unit") or quantity.Unit == App.Units.Unit()
        return float(quantity) if is_plain else quantity.getValueAs("mm").Value
    except (ArithmeticError, TypeError, ValueError):
        raise ValueError(f"{what} must be a length, not {value}") from None
