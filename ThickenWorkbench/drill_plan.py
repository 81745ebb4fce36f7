# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which holes are drilled into a solid, one after the other."""

from __future__ import annotations

from typing import Any, NamedTuple, Sequence

import FreeCAD as App
import numpy as np
from numpy.typing import NDArray

from .core.drain_places import cavities_of, places_for, ways_down
from .core.drain_pools import HoleEnds, pools
from .core.facets import doubled_normals
from .numbers import number
from .sources import RefusedError


translate = App.Qt.translate


class Drill(NamedTuple):
    """What all holes have in common, and the library to drill them with."""

    extension: Any
    diameter: float
    sides: int
    run: dict[str, Any]  #: threads and context of the library's functions

    def inspect(self, vertices: NDArray, triangles: NDArray) -> dict[str, Any]:
        return self.extension.inspect(vertices, triangles, **self.run)

    def __call__(self, vertices: NDArray, triangles: NDArray, places: Any, axes: Any) -> dict[str, Any]:
        return self.extension.drill(vertices, triangles, places, axes, self.diameter, sides=self.sides, **self.run)


def drill_cavities(
    drill: Drill, vertices: NDArray, triangles: NDArray, up: Sequence[float], count: int
) -> tuple[NDArray, NDArray, list[dict[str, Any]], list[str]]:
    """The solid with `count` holes in each cavity, downwards against `up`, what is known of each hole,
    and warnings. Raises RefusedError where there is no cavity or none can be drilled."""
    direction, diameter = np.asarray(up, float), drill.diameter
    facts = drill.inspect(vertices, triangles)
    if facts["status"] != "ok":
        raise RefusedError("There is no valid solid to drill: " + facts["defects"][0]["sentence"] + ".")
    cavities = cavities_of(facts, triangles)
    if not cavities:
        raise RefusedError(translate(
            "Thicken", "The solid has no cavity, so that nothing is trapped in it. Give places to drill it all the same."
        ))  # fmt: skip
    points, holes, warnings, reasons = vertices, [], [], []
    for cavity in cavities:
        taken: list[NDArray] = []
        for _ in range(count):
            groups = places_for(points, cavity, direction, diameter, taken)
            ways = [way for group in groups for way in ways_down(points, cavity, direction, diameter, group)]
            drilled, reason = _first_of(drill, vertices, triangles, ways)
            if drilled is None:
                reasons.append(reason)
                break
            vertices, triangles = drilled["vertices"], drilled["triangles"]
            taken.append(np.array(drilled["entry"]))
            holes.append(drilled)
        if 0 < len(taken) < count:
            got = translate("Thicken", "A cavity of {volume} mL got {some} of {all} holes.")
            warnings.append(got.format(volume=number(cavity.volume / 1000), some=len(taken), all=count))
    if not holes:
        raise RefusedError(reasons[0])
    advice = translate("Thicken", "no hole could be drilled lower down")
    warnings = pool_warnings(drill, points, cavities, holes, direction, advice) + warnings
    return vertices, triangles, holes, warnings


def drill_places(
    drill: Drill, vertices: NDArray, triangles: NDArray, up: Sequence[float], places: Sequence[Sequence[float]]
) -> tuple[NDArray, NDArray, list[dict[str, Any]], list[str]]:
    """The solid with a hole at each of `places`, at a right angle to the surface there; the rest as
    drill_cavities()."""
    facts, points = drill.inspect(vertices, triangles), vertices
    cavities = cavities_of(facts, triangles) if facts["status"] == "ok" else []
    holes = []
    for place in places:
        near = drill.extension.closest_points(vertices, triangles, [place])
        point = near["point"][0]
        axes = _ways_in(vertices, triangles, point, int(near["triangle"][0]), drill.diameter)
        drilled = drill(vertices, triangles, [point] * len(axes), axes)
        vertices, triangles = drilled["vertices"], drilled["triangles"]
        holes.append(drilled)
    advice = translate("Thicken", "place a hole lower down")
    warnings = pool_warnings(drill, points, cavities, holes, np.asarray(up, float), advice)
    return vertices, triangles, holes, warnings


def pool_warnings(drill: Drill, vertices, cavities, holes, up: NDArray, advice: str) -> list[str]:
    """A sentence for each cavity in which resin stays."""
    ends = [HoleEnds(np.array(hole["entry"]), np.array(hole["exit"])) for hole in holes]
    stays = translate(
        "Thicken", "{depth} mm of resin, about {volume} mL, stay below the lowest hole of a cavity of {all} mL: {advice}."
    )
    return [
        stays.format(depth=number(pool.depth), volume=number(pool.volume / 1000),
                     all=number(pool.cavity.volume / 1000), advice=advice)
        for pool in pools(drill.extension, vertices, cavities, ends, up, drill.diameter)
    ]


def _first_of(drill: Drill, vertices, triangles, ways) -> tuple[dict[str, Any] | None, str]:
    if not ways:
        return None, translate("Thicken", "There is no room for a hole: choose a smaller diameter or fewer holes.")
    try:
        return drill(vertices, triangles, *zip(*ways)), ""
    except drill.extension.ThickenError as error:
        if error.code != "no-solid":
            raise
        return None, str(error)


def _ways_in(vertices: NDArray, triangles: NDArray, point: NDArray, facet: int, diameter: float) -> list[NDArray]:
    """Against the mean normal of the surface within the hole, then against that of the facet itself."""
    corners = vertices[triangles]
    doubled = doubled_normals(corners)
    own = doubled[facet] / np.linalg.norm(doubled[facet])
    close = np.linalg.norm(corners.mean(axis=1) - point, axis=1) < diameter / 2
    # Not the other side of a thin wall.
    close &= doubled @ own > 0.3 * np.linalg.norm(doubled, axis=1)
    mean = doubled[close].sum(axis=0) if close.any() else own
    return [-mean / np.linalg.norm(mean), -own]
