# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holes through which resin drains out of a hollow part, and plugs that close them again.

Documents name this module and its two feature classes: neither may move or be renamed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, NamedTuple

import FreeCAD as App

from . import runs, windows
from .beside import put_beside, show_instead_of
from .following_mesh import FollowingMesh
from .numbers import number
from .proxy import add_properties
from .source_observer import observe_sources
from .sources import RefusedError, kind_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

translate = App.Qt.translate

_RESULT = 1 | 8  # read-only, and changing it does not touch the document
_HIDDEN = 4

_INPUTS = [
    ("App::PropertyLink", "Source", "The hollow solid"),
    ("App::PropertyLength", "Diameter", "Diameter of the thickest round pin that passes a hole"),
    ("App::PropertyIntegerConstraint", "Count", "Holes in each cavity, where no Places are given"),
    ("App::PropertyVector", "Direction", "The direction in which the part grows while it is printed"),
    ("App::PropertyVectorList", "Places", "Where to drill instead, without the Placement: points on the surface"),
]
_RESULTS = [
    ("App::PropertyBool", "Valid", "Whether there is a solid with holes; it has been proved valid"),
    ("App::PropertyVolume", "Volume", "Volume of the solid"),
    ("App::PropertyInteger", "TriangleCount", "Triangles of the solid"),
    ("App::PropertyInteger", "HoleCount", "Holes that were drilled"),
    ("App::PropertyVectorList", "HolePlaces", "Where each hole begins, without the Placement"),
    ("App::PropertyVectorList", "HoleAxes", "The way of each hole through the wall"),
    ("App::PropertyFloatList", "HoleLengths", "How long each hole is, mm"),
    ("App::PropertyInteger", "Trapped", "Cavities that are left closed"),
    ("App::PropertyStringList", "Warnings", "What to know about the holes"),
]
# What a plug is made from: the corners of each cross-section, one after the other, and from where to
# where each hole has its wall all around.
_OUTLINES = [("App::PropertyVectorList", "Outlines", ""), ("App::PropertyFloatList", "Walled", ""),
             ("App::PropertyIntegerList", "RegionRuns", "Regions of the triangles")]  # fmt: skip

SIDES = 24

# Farther from the surface than this share of a hole's diameter, the middle of a triangle is within the hole.
_ON_SURFACE = 1e-3
_WALL = 2  # Region.WALL


class _Hole(NamedTuple):
    entry: NDArray
    axis: NDArray
    length: float
    outline: NDArray  #: SIDES × 3
    walled: tuple[float, float]


class DrainHolesFeature(FollowingMesh):
    """Proxy of a Mesh::FeaturePython that holds the solid of its Source with holes in it."""

    def ensure_properties(self, obj: Any) -> None:
        fresh = "Diameter" not in obj.PropertiesList
        add_properties(obj, "Drain", _INPUTS)
        add_properties(obj, "Result", _RESULTS, _RESULT)
        add_properties(obj, "Internal", _OUTLINES, _RESULT | _HIDDEN)
        if fresh:
            obj.Diameter = 3.5
            obj.Count = (1, 1, 100, 1)  # value, least, most, step
            obj.Direction = App.Vector(0, 0, 1)
        obj.setEditorMode("Placement", 1)  # it follows the source's

    def make(self, obj: Any) -> tuple[Any, Any]:
        _require_solid(obj.Source, obj)
        return _drilled(obj)

    def show(self, obj: Any, told: Any) -> None:
        from .regions import runs_of

        if told is None:
            _show(obj, [], None, [])
            obj.RegionRuns = []
            return
        _show(obj, told.holes, told.facts, told.warnings)
        obj.RegionRuns = runs_of(told.region)
        for warning in told.warnings:
            App.Console.PrintWarning(f"{obj.Label}: {warning}\n")


class PlugFeature(FollowingMesh):
    """Proxy of a Mesh::FeaturePython that holds a plug for each hole of its Source, where the holes are."""

    def ensure_properties(self, obj: Any) -> None:
        present = set(obj.PropertiesList)
        if "Source" not in present:
            obj.addProperty("App::PropertyLink", "Source", "Plug", "The solid with the holes")
        if "Clearance" not in present:
            obj.addProperty("App::PropertyLength", "Clearance", "Plug", "Between a plug and the wall of its hole")
            obj.Clearance = 0.1
        if "Valid" not in present:
            obj.addProperty("App::PropertyBool", "Valid", "Result", "Whether there are plugs", _RESULT)
        obj.setEditorMode("Placement", 1)

    def make(self, obj: Any) -> tuple[Any, Any]:
        source = obj.Source
        if source is None or not isinstance(source.Proxy, DrainHolesFeature) or not source.Valid:
            raise RefusedError("There are no holes to plug. Set Source to a feature with drain holes.")
        return _plugs(source, obj.Clearance.Value), True

    def show(self, obj: Any, told: Any) -> None:
        obj.Valid = told is not None


observe_sources(DrainHolesFeature)
observe_sources(PlugFeature)


def make_drain_holes(
    doc: Any,
    solid: Any,
    diameter: Any = 3.5,
    count: int = 1,
    direction: Iterable[float] = (0, 0, 1),
    places: Iterable[Iterable[float]] = (),
    plug: bool = False,
    *,
    clearance: Any = 0.1,
    name: str = "DrainHoles",
) -> Any:
    """Add a feature with the closed mesh object `solid` and holes in it to `doc`, recompute, and return it.

    Without places, each cavity gets `count` holes: the first at its lowest place, seen along the print
    direction `direction`, straight down through the wall or, where that is too steep, at a right angle. `places` are global points on the surface
    instead; each gets a hole at a right angle to it. With `plug`, an object "Plugs" holds a plug for
    each hole, thinner by `clearance` all around. Lengths are mm, quantities, or text with a unit.

    What cannot be drilled does not raise: the feature's State then has "Invalid" and its
    getStatusString() says why. Arguments that make no sense raise, and leave the document as it was.
    """
    _require_solid(solid)
    inverse = solid.getGlobalPlacement().inverse()
    local = [inverse.multVec(App.Vector(*place)) for place in places]
    towards = App.Vector(*direction)
    if not towards.Length > 0:
        raise ValueError("direction must be longer than 0")
    if not 1 <= int(count) <= 100:
        raise ValueError(f"count must be 1 to 100, not {count}")
    obj = doc.addObject("Mesh::FeaturePython", name)
    try:
        DrainHolesFeature(obj)
        _set_length(obj, "Diameter", diameter)
        obj.Count = int(count)
        obj.Direction = towards
        obj.Places = local
        put_beside(obj, solid)
        obj.Source = solid
        if plug:
            _add_plugs(doc, obj, clearance)
    except Exception:
        doc.removeObject(obj.Name)
        raise
    show_instead_of(obj, solid)
    doc.recompute()
    return obj


def _add_plugs(doc: Any, holes: Any, clearance: Any) -> Any:
    obj = doc.addObject("Mesh::FeaturePython", "Plugs")
    try:
        PlugFeature(obj)
        _set_length(obj, "Clearance", clearance)
        put_beside(obj, holes)
        obj.Source = holes
    except Exception:
        doc.removeObject(obj.Name)
        raise
    windows.attach_view(obj)
    return obj


def _set_length(obj: Any, name: str, value: Any) -> None:
    try:
        setattr(obj, name, value)
    except ArithmeticError:  # a unit of something else than length
        raise ValueError(f"{name.lower()} must be a length, not {value}") from None
    if not getattr(obj, name).Value > 0:  # FreeCAD turns a negative length into 0
        raise ValueError(f"{name.lower()} must be above 0 mm, not {value}")


def _require_solid(source: Any, feature: Any = None) -> None:
    if source is None:
        raise RefusedError("No solid is chosen. Set Source to an object with a closed mesh.")
    label = getattr(source, "Label", source)
    if kind_of(source) != "mesh":
        raise RefusedError(f"“{label}” is not a mesh. Choose an object with a closed mesh.")
    if feature is not None and (source == feature or feature in source.OutListRecursive):
        raise RefusedError(f"“{label}” depends on “{feature.Label}”. Choose another Source.")


class _Drilled(NamedTuple):
    vertices: NDArray
    triangles: NDArray
    region: NDArray  #: of each triangle, a value of Region: the wall of a hole is wall
    holes: list[_Hole]
    facts: dict[str, Any]  #: what is known of the solid
    warnings: list[str]


def _drilled(obj: Any) -> tuple[Any, _Drilled]:
    """The mesh, and how it was made."""
    with runs.refusing(obj.Source):
        from .mesh_io import mesh_from_arrays

        made = runs.run(drill_step(
            obj.Source, obj.Diameter.Value, obj.Count, obj.Direction, [tuple(place) for place in obj.Places]
        ))  # fmt: skip
        return mesh_from_arrays(made.vertices, made.triangles), made


def drill_step(source: Any, diameter: float, count: int, direction: Any, places: list[Any]) -> runs.Step[_Drilled]:
    """For the holes of a feature with these inputs, `places` in the source's own coordinates; nothing of it
    touches `source` any more."""
    import numpy as np

    from thicken import native
    from .mesh_io import arrays_from_mesh
    from .regions import facet_regions

    extension, threads = native.load(), runs.threads()
    if not diameter > 0:
        raise RefusedError("Diameter is 0 mm. Set it to more than that.")
    if not direction.Length > 0:
        raise RefusedError("Direction is 0. Set it to the direction in which the part is printed.")
    singles, triangles = arrays_from_mesh(source.Mesh)
    if len(triangles) == 0:
        raise RefusedError(f"“{source.Label}” has no mesh. Mend that first.")
    runs.require_room(len(triangles))
    vertices = singles.astype(float)
    regions = facet_regions(source) if hasattr(source, "RegionRuns") else np.empty(0, np.uint8)
    if len(regions) != len(triangles):
        regions = np.zeros(len(triangles), np.uint8)  # all of it is the part as it was given
    up = tuple(source.getGlobalPlacement().Rotation.inverted().multVec(direction).normalize())

    def step(context: Any) -> _Drilled:
        from .drill_plan import Drill, drill_cavities, drill_places

        drill = Drill(extension, diameter, SIDES, {"threads": threads, "context": context})
        if places:
            points, corners, found, warnings = drill_places(drill, vertices, triangles, up, places)
        else:
            points, corners, found, warnings = drill_cavities(drill, vertices, triangles, up, count)
        region = _regions(drill, vertices, triangles, regions, points, corners)
        facts = drill.inspect(points, corners)
        trapped = [shell["volume_mm3"] / 1000 for shell in facts["shells"] if shell["cavity"]]
        if trapped:
            volumes = ", ".join(number(volume) for volume in sorted(trapped, reverse=True))
            closed = translate("Thicken", "Cavities that stay closed: {count}, of {volumes} mL.")
            warnings.append(closed.format(count=len(trapped), volumes=volumes))
        return _Drilled(points, corners, region, [_hole_of(hole) for hole in found], facts, warnings)

    return step


def _regions(drill: Any, vertices: NDArray, triangles: NDArray, regions: NDArray, points: NDArray, corners: NDArray) -> NDArray:
    """Of each triangle of the drilled solid: that of the surface it lies in, or WALL for the wall of a hole."""
    near = drill.extension.closest_points(vertices, triangles, points[corners].mean(axis=1), context=drill.run["context"])
    result = regions[near["triangle"]]
    result[near["distance"] > _ON_SURFACE * drill.diameter] = _WALL
    return result


def _hole_of(hole: dict[str, Any]) -> _Hole:
    length = App.Vector(*hole["exit"]).distanceToPoint(App.Vector(*hole["entry"]))
    return _Hole(hole["entry"], hole["axis"], length, hole["outline"], hole["walled"])


def _show(obj: Any, holes: list[_Hole], facts: dict[str, Any] | None, warnings: list[str]) -> None:
    obj.Valid = facts is not None
    obj.Volume = facts["volume_mm3"] if facts else 0
    obj.TriangleCount = obj.Mesh.CountFacets
    obj.HoleCount = len(holes)
    obj.HolePlaces = [App.Vector(*hole.entry) for hole in holes]
    obj.HoleAxes = [App.Vector(*hole.axis) for hole in holes]
    obj.HoleLengths = [hole.length for hole in holes]
    obj.Trapped = sum(shell["cavity"] for shell in facts["shells"]) if facts else 0
    obj.Warnings = warnings
    obj.Outlines = [App.Vector(*corner) for hole in holes for corner in hole.outline]
    obj.Walled = [end for hole in holes for end in hole.walled]


def _plugs(holes: Any, clearance: float) -> Any:
    import numpy as np

    from thicken import native
    from .mesh_io import mesh_from_arrays
    from .core.plug import plug_arrays

    if not 0 < 2 * clearance < holes.Diameter.Value:
        raise RefusedError("Clearance must be above 0 mm and below half of the diameter of the holes.")
    outlines = np.array([tuple(corner) for corner in holes.Outlines]).reshape(len(holes.HolePlaces), -1, 3)
    walled = np.array(holes.Walled).reshape(-1, 2)
    axes = np.array([tuple(axis) for axis in holes.HoleAxes])
    fits = walled[:, 1] - walled[:, 0] > 2 * clearance
    if not fits.all():
        what = f"{int((~fits).sum())} of {len(fits)} holes get no plug: their wall is too slanted to hold one."
        if not fits.any():
            raise RefusedError(f"{what} Choose a smaller diameter or other places.")
        App.Console.PrintWarning(f"{holes.Label}: {what}\n")
    vertices, triangles = plug_arrays(outlines[fits], axes[fits], walled[fits], clearance)
    extension, threads = native.load(), runs.threads()
    facts = runs.run(lambda context: extension.inspect(vertices, triangles, threads=threads, context=context))
    if facts["status"] != "ok":
        raise RefusedError("The plugs overlap: put the holes further apart.")
    return mesh_from_arrays(vertices, triangles)
