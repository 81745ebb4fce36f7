# SPDX-License-Identifier: LGPL-2.1-or-later
"""What to know about a solid before it is printed: trapped resin, thin walls, overhangs, size."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, NamedTuple

import numpy as np

import FreeCAD as App

from . import runs
from .numbers import number, percent, place
from .placed import linked_and_placement, placed_floats, placed_solid
from .sources import DEFAULT_DEFLECTION, kind_of, surface_arrays

if TYPE_CHECKING:
    from numpy.typing import NDArray

translate = App.Qt.translate

# Most printers hold a wall up to this angle against the print direction without support.
OVERHANG_DEGREES = 45.0

_MM3_PER_ML = 1000.0


class Measured(NamedTuple):
    """A solid with what was measured at its facets, for the facts and for the pictures."""

    vertices: NDArray  #: n × 3, global, mm
    triangles: NDArray  #: m × 3
    walls: NDArray  #: m: wall thickness, mm; NaN where there is none
    overhanging: NDArray  #: m: whether the facet needs support
    in_cavity: NDArray  #: m: whether the facet bounds a cavity
    facts: dict[str, Any]


def printability(
    obj: Any,
    direction: Iterable[float] = (0, 0, 1),
    minimum_wall: Any = 1.0,
    *,
    deflection: float = DEFAULT_DEFLECTION,
) -> dict[str, Any]:
    """The facts about the closed mesh or solid `obj` as a JSON object: docs/freecad.md lists its keys.

    `direction` is the one in which the part grows while it is printed, `minimum_wall` the thinnest
    wall that the printer makes (mm, a quantity, or text with a unit). Places are global. A mesh that
    is not a valid solid gets "valid" false, the defects, and no measures. Raises
    sources.RefusedError for an object without a surface.
    """
    return runs.run(report_step(obj, direction, minimum_wall, deflection=deflection)).facts


def report_step(
    obj: Any, direction: Iterable[float] = (0, 0, 1), minimum_wall: Any = 1.0, *, deflection: float = DEFAULT_DEFLECTION
) -> runs.Step[Measured]:
    """For all that printability() and write_report() are made from: nothing of it touches `obj` any more."""
    from thicken import native
    from .thickness_map import wall_step

    up = np.array([float(x) for x in direction])
    if up.shape != (3,) or not np.linalg.norm(up) > 0:
        raise ValueError("direction must be three numbers that are not all 0")
    up /= np.linalg.norm(up)
    least = App.Units.Quantity(minimum_wall).Value if isinstance(minimum_wall, str) else float(minimum_wall)
    if not least > 0:
        raise ValueError(f"minimum_wall must be above 0 mm, not {minimum_wall}")
    vertices, triangles = placed_solid(obj, deflection)
    runs.require_room(len(triangles))
    extension, label, threads = native.load(), obj.Label, runs.threads()
    linked, placement = linked_and_placement(obj)
    walls, left = wall_step(linked, vertices, triangles), _pool_step(linked, placement, up)

    def step(context: Any) -> Measured:
        inspection = extension.inspect(vertices, triangles, threads=threads, context=context)
        facts = _plain_facts(label, vertices, triangles, inspection, up, least)
        if not facts["valid"]:
            nothing = np.zeros(len(triangles), bool)
            return Measured(vertices, triangles, np.full(len(triangles), np.nan), nothing, nothing, facts)
        facts["pools"] = left(context)
        return _measured_solid(vertices, triangles, inspection, walls(context), up, least, facts)

    return step


def _pool_step(obj: Any, placement: Any, up: NDArray) -> runs.Step[list[dict[str, Any]]]:
    """For the resin that stays below the drain holes of `obj`, if it has any; it stands at `placement`."""
    from thicken import native
    from .core.drain_places import cavities_of
    from .core.drain_pools import HoleEnds, pools

    if not getattr(obj, "HoleCount", 0) or kind_of(obj.Source) != "mesh" or obj.Source.Mesh.CountFacets == 0:
        return lambda context: []
    extension, threads, diameter = native.load(), runs.threads(), obj.Diameter.Value
    local, triangles = surface_arrays(obj.Source)  # a drained solid has the coordinates of its source
    vertices = placed_floats(local, placement)
    starts = [np.array(placement.multVec(place)) for place in obj.HolePlaces]
    ways = [np.array(placement.Rotation.multVec(axis)) for axis in obj.HoleAxes]
    ends = [HoleEnds(start, start + length * way) for start, way, length in zip(starts, ways, obj.HoleLengths)]

    def step(context: Any) -> list[dict[str, Any]]:
        hollow = extension.inspect(vertices, triangles, threads=threads, context=context)
        cavities = cavities_of(hollow, triangles) if hollow["status"] == "ok" else []
        return [
            {"volume_ml": pool.volume / _MM3_PER_ML, "depth_mm": pool.depth, "lowest_place_mm": pool.place.tolist()}
            for pool in pools(extension, vertices, cavities, ends, up, diameter)
        ]

    return step


def _plain_facts(label, vertices, triangles, inspection, up, least) -> dict[str, Any]:
    """What can be told of any mesh."""
    facts: dict[str, Any] = {
        "object": label,
        "valid": inspection["status"] == "ok",
        "defects": [defect["sentence"] for defect in inspection["defects"]],
        "triangles": len(triangles),
        "direction": up.tolist(),
        "minimum_wall_mm": least,
        "bounding_box": _box(vertices, triangles, up),
    }
    if not facts["valid"]:
        facts["printable"] = False
        no_solid = translate("Thicken", "The mesh is no valid solid: {defect}.")
        facts["warnings"] = [no_solid.format(defect=sentence) for sentence in facts["defects"]]
    return facts


def _measured_solid(vertices, triangles, inspection, walls, up, least, facts) -> Measured:
    areas, normals = _areas_and_normals(vertices, triangles)
    overhanging, standing = _overhangs(vertices, triangles, normals, up)
    cavity_shells = [number for number, shell in enumerate(inspection["shells"]) if shell["cavity"]]
    in_cavity = np.isin(inspection["shell_of_triangle"], cavity_shells)
    trapped = [_trapped(vertices, triangles, inspection, number, up) for number in cavity_shells]
    facts |= {
        "volume_ml": inspection["volume_mm3"] / _MM3_PER_ML,
        "area_mm2": inspection["area_mm2"],
        "parts": sum(not shell["cavity"] and shell["within"] is None for shell in inspection["shells"]),
        "trapped": sorted(trapped, key=lambda cavity: -cavity["volume_ml"]),
        "trapped_volume_ml": sum(cavity["volume_ml"] for cavity in trapped),
        "thinnest_wall": _thinnest(vertices, triangles, walls, areas, least),
        "overhang": {
            "degrees": OVERHANG_DEGREES,
            "area_mm2": float(areas[overhanging].sum()),
            "share": float(areas[overhanging].sum() / areas.sum()),
            "on_plate_mm2": float(areas[standing].sum()),
        },
    }
    facts["warnings"] = _warnings(facts)
    facts["printable"] = not facts["warnings"]
    return Measured(vertices, triangles, walls, overhanging, in_cavity, facts)


def _areas_and_normals(vertices: NDArray, triangles: NDArray) -> tuple[NDArray, NDArray]:
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    doubled = np.cross(b - a, c - a)
    lengths = np.linalg.norm(doubled, axis=1)
    return lengths / 2, doubled / lengths[:, None]


def _box(vertices: NDArray, triangles: NDArray, up: NDArray) -> dict[str, Any]:
    used = vertices[np.unique(triangles)]
    heights = used @ up
    low, high = used.min(axis=0), used.max(axis=0)
    return {
        "size_mm": (high - low).tolist(),
        "low_mm": low.tolist(),
        "high_mm": high.tolist(),
        "height_mm": float(np.ptp(heights)),
    }


def _overhangs(vertices: NDArray, triangles: NDArray, normals: NDArray, up: NDArray) -> tuple[NDArray, NDArray]:
    """Which facets face down more than OVERHANG_DEGREES allow, and which of these lie on the plate instead."""
    heights = vertices @ up
    used = heights[triangles]
    on_plate = (used.max(axis=1) - used.min()) <= 1e-4 * np.ptp(used)
    steep = -(normals @ up) > np.sin(np.radians(OVERHANG_DEGREES)) + 1e-6
    return steep & ~on_plate, steep & on_plate


def _trapped(vertices: NDArray, triangles: NDArray, inspection: dict[str, Any], shell: int, up: NDArray) -> dict[str, Any]:
    corners = np.unique(triangles[inspection["shell_of_triangle"] == shell])
    lowest = vertices[corners[(vertices[corners] @ up).argmin()]]
    return {
        "volume_ml": inspection["shells"][shell]["volume_mm3"] / _MM3_PER_ML,
        "lowest_place_mm": lowest.tolist(),
        "middle_mm": ((vertices[corners].min(axis=0) + vertices[corners].max(axis=0)) / 2).tolist(),
    }


def _thinnest(vertices: NDArray, triangles: NDArray, walls: NDArray, areas: NDArray, least: float) -> dict[str, Any]:
    known = np.isfinite(walls)
    if not known.any():
        return {"mm": None, "place_mm": None, "share_below_minimum": 0.0, "area_below_minimum_mm2": 0.0}
    thinnest = int(np.nanargmin(walls))
    below = known & (walls < least * (1 - 1e-6))
    return {
        "mm": float(walls[thinnest]),
        "place_mm": vertices[triangles[thinnest]].mean(axis=0).tolist(),
        "share_below_minimum": float(areas[below].sum() / areas[known].sum()),
        "area_below_minimum_mm2": float(areas[below].sum()),
    }


def _warnings(facts: dict[str, Any]) -> list[str]:
    found = []
    wall, least = facts["thinnest_wall"], facts["minimum_wall_mm"]
    # What is narrower than it must be thick breaks out at a corner, if at all: it is no wall that fails.
    if wall["area_below_minimum_mm2"] >= least**2:
        thin = translate(
            "Thicken", "{area} mm² of the walls ({share}) are thinner than {least} mm, the thinnest {mm} mm at {place}."
        )
        found.append(thin.format(area=number(wall["area_below_minimum_mm2"]), share=percent(wall["share_below_minimum"]),
                                 least=number(least), mm=number(wall["mm"]), place=place(wall["place_mm"])))  # fmt: skip
    for cavity in facts["trapped"]:
        traps = translate("Thicken", "A closed cavity traps {volume} mL; its lowest point is at {place}. Add drain holes.")
        found.append(traps.format(volume=number(cavity["volume_ml"]), place=place(cavity["lowest_place_mm"])))
    for pool in facts["pools"]:
        stays = translate("Thicken", "{volume} mL of resin stay {depth} mm deep below the holes of a cavity, at {place}. "
                                     "Add a hole lower down.")  # fmt: skip
        found.append(stays.format(volume=number(pool["volume_ml"]), depth=number(pool["depth_mm"]), place=place(pool["lowest_place_mm"])))
    return found
