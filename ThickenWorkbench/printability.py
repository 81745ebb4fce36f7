# SPDX-License-Identifier: LGPL-2.1-or-later
"""What to know about a solid before it is printed: trapped resin, thin walls, overhangs, size."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterable, NamedTuple

import numpy as np

from .placed import placed_solid
from .sources import DEFAULT_DEFLECTION

if TYPE_CHECKING:
    from numpy.typing import NDArray

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
    return measured(obj, direction, minimum_wall, deflection).facts


def write_report(
    obj: Any,
    path: str | os.PathLike[str],
    direction: Iterable[float] = (0, 0, 1),
    minimum_wall: Any = 1.0,
    *,
    deflection: float = DEFAULT_DEFLECTION,
) -> dict[str, Any]:
    """Write the facts of printability() and return them.

    A path that ends in .json gets the facts alone. Any other gets one HTML page with pictures in it,
    and the facts are written beside it, to the same name with .json.
    """
    target = Path(path)
    found = measured(obj, direction, minimum_wall, deflection)
    if target.suffix.lower() != ".json":
        from .report_page import page

        target.write_text(page(found), encoding="utf-8")
    target.with_suffix(".json").write_text(json.dumps(found.facts, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
    return found.facts


def measured(obj: Any, direction: Iterable[float], minimum_wall: Any, deflection: float) -> Measured:
    """All that printability() and write_report() are made from."""
    import FreeCAD as App

    from . import native

    up = np.array([float(x) for x in direction])
    if up.shape != (3,) or not np.linalg.norm(up) > 0:
        raise ValueError("direction must be three numbers that are not all 0")
    up /= np.linalg.norm(up)
    least = App.Units.Quantity(minimum_wall).Value if isinstance(minimum_wall, str) else float(minimum_wall)
    if not least > 0:
        raise ValueError(f"minimum_wall must be above 0 mm, not {minimum_wall}")
    vertices, triangles = placed_solid(obj, deflection)
    inspection = native.load().inspect(vertices, triangles)
    facts: dict[str, Any] = {
        "object": obj.Label,
        "valid": inspection["status"] == "ok",
        "defects": [defect["sentence"] for defect in inspection["defects"]],
        "triangles": len(triangles),
        "direction": up.tolist(),
        "minimum_wall_mm": least,
        "bounding_box": _box(vertices, triangles, up),
    }
    nothing = np.zeros(len(triangles), bool)
    if not facts["valid"]:
        facts["printable"] = False
        facts["warnings"] = ["The mesh is no valid solid: " + sentence + "." for sentence in facts["defects"]]
        return Measured(vertices, triangles, np.full(len(triangles), np.nan), nothing, nothing, facts)
    return _measured_solid(obj, vertices, triangles, inspection, up, least, facts)


def _measured_solid(obj, vertices, triangles, inspection, up, least, facts) -> Measured:
    from .thickness_map import wall_values

    areas, normals = _areas_and_normals(vertices, triangles)
    walls = wall_values(obj, vertices, triangles)
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
        return {"mm": None, "place_mm": None, "share_below_minimum": 0.0}
    thinnest = int(np.nanargmin(walls))
    below = known & (walls < least * (1 - 1e-6))
    return {
        "mm": float(walls[thinnest]),
        "place_mm": vertices[triangles[thinnest]].mean(axis=0).tolist(),
        "share_below_minimum": float(areas[below].sum() / areas[known].sum()),
    }


def _at(place: list[float]) -> str:
    return "(" + ", ".join(f"{x:.4g}" for x in place) + ") mm"


def _warnings(facts: dict[str, Any]) -> list[str]:
    found = []
    wall = facts["thinnest_wall"]
    if wall["share_below_minimum"] > 0:
        found.append(
            f"{100 * wall['share_below_minimum']:.2g} % of the walls are thinner than {facts['minimum_wall_mm']:g} mm, "
            f"the thinnest {wall['mm']:.3g} mm at {_at(wall['place_mm'])}."
        )
    for cavity in facts["trapped"]:
        found.append(
            f"A closed cavity traps {cavity['volume_ml']:.3g} mL; its lowest point is at "
            f"{_at(cavity['lowest_place_mm'])}. Add drain holes."
        )
    return found
