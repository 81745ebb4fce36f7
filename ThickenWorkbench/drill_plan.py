# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which holes are drilled into a solid, one after the other."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from .drain_places import cavities_of, lowest_point, places_for, ways_down
from .sources import RefusedError

# What stays below a hole is worth a warning when it is deeper than this share of the hole's diameter.
_DEEP_POOL = 0.25


def drill_cavities(
    extension: Any, vertices: NDArray, triangles: NDArray, up: Sequence[float], diameter: float, count: int, sides: int
) -> tuple[NDArray, NDArray, list[dict[str, Any]], list[str]]:
    """The solid with `count` holes in each cavity, downwards against `up`, what is known of each hole,
    and warnings. Raises RefusedError where there is no cavity or none can be drilled."""
    direction = np.asarray(up, float)
    facts = extension.inspect(vertices, triangles)
    if facts["status"] != "ok":
        raise RefusedError("There is no valid solid to drill: " + facts["defects"][0]["sentence"] + ".")
    cavities = cavities_of(facts, triangles)
    if not cavities:
        raise RefusedError("The solid has no cavity, so that nothing is trapped in it. Give places to drill it all the same.")
    points, holes, warnings, reasons = vertices, [], [], []
    for cavity in cavities:
        taken: list[NDArray] = []
        for _ in range(count):
            groups = places_for(points, cavity, direction, diameter, taken)
            ways = [way for group in groups for way in ways_down(points, cavity, direction, diameter, group)]
            drilled, reason = _drill(extension, vertices, triangles, ways, diameter, sides)
            if drilled is None:
                reasons.append(reason)
                break
            vertices, triangles = drilled["vertices"], drilled["triangles"]
            taken.append(np.array(drilled["entry"]))
            holes.append(drilled)
        if taken:
            pool = taken[0] @ direction - lowest_point(points, cavity, direction) @ direction
            if pool > _DEEP_POOL * diameter:
                warnings.append(f"{pool:.3g} mm of resin stay below the lowest hole of a cavity of "
                                f"{cavity.volume / 1000:.3g} mL: no hole could be drilled lower down.")  # fmt: skip
        if 0 < len(taken) < count:
            warnings.append(f"A cavity of {cavity.volume / 1000:.3g} mL got {len(taken)} of {count} holes.")
    if not holes:
        raise RefusedError(reasons[0])
    return vertices, triangles, holes, warnings


def drill_places(
    extension: Any,
    vertices: NDArray,
    triangles: NDArray,
    places: Sequence[Sequence[float]],
    diameter: float,
    sides: int,
) -> tuple[NDArray, NDArray, list[dict[str, Any]]]:
    """The solid with a hole at each of `places`, at a right angle to the surface there."""
    holes = []
    for place in places:
        near = extension.closest_points(vertices, triangles, [place])
        point = near["point"][0]
        axes = _ways_in(vertices, triangles, point, int(near["triangle"][0]), diameter)
        drilled = extension.drill(vertices, triangles, [point] * len(axes), axes, diameter, sides=sides)
        vertices, triangles = drilled["vertices"], drilled["triangles"]
        holes.append(drilled)
    return vertices, triangles, holes


def _drill(extension, vertices, triangles, ways, diameter, sides) -> tuple[dict[str, Any] | None, str]:
    if not ways:
        return None, "There is no room for a hole: choose a smaller diameter or fewer holes."
    try:
        return extension.drill(vertices, triangles, *zip(*ways), diameter, sides=sides), ""
    except extension.ThickenError as error:
        if error.code != "no-solid":
            raise
        return None, str(error)


def _ways_in(vertices: NDArray, triangles: NDArray, point: NDArray, facet: int, diameter: float) -> list[NDArray]:
    """Against the mean normal of the surface within the hole, then against that of the facet itself."""
    corners = vertices[triangles]
    doubled = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    own = doubled[facet] / np.linalg.norm(doubled[facet])
    close = np.linalg.norm(corners.mean(axis=1) - point, axis=1) < diameter / 2
    # Not the other side of a thin wall.
    close &= doubled @ own > 0.3 * np.linalg.norm(doubled, axis=1)
    mean = doubled[close].sum(axis=0) if close.any() else own
    return [-mean / np.linalg.norm(mean), -own]
