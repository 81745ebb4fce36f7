# SPDX-License-Identifier: LGPL-2.1-or-later
"""The feature that cuts a part out of a surface along lines. Documents name this module and class: neither may move."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Sequence

import FreeCAD as App

from . import runs
from .beside import put_beside, show_instead_of
from .following_mesh import FollowingMesh
from .proxy import add_properties
from .source_observer import observe_sources
from .sources import RefusedError, bound_box, require_source, surface_arrays

if TYPE_CHECKING:
    from thicken.arrays import TrimmedMesh

_RESULT = 1 | 8  # read-only, and changing it does not touch the document

# Of the diagonal of the surface's box: the farthest that the points taken of a wire may be from it.
_DEFLECTION = 2e-4
_MOST_SMOOTHING = 5

_INPUTS = [
    ("App::PropertyLink", "Source", "The mesh or shape to cut a part out of"),
    ("App::PropertyVectorList", "Points", "A loop: points near the surface, in the coordinates of the source without its Placement"),
    ("App::PropertyLinkList", "Wires", "More loops: sketches or other shapes whose closed wires lie near the surface"),
    ("App::PropertyBool", "KeepInside", "Keep the part inside of the loops, not the one at Keep"),
    ("App::PropertyVector", "Keep", "A point of the part that stays, in the coordinates of the source without its Placement"),
    ("App::PropertyInteger", "Smooth", "Rounds of rounding the corners of the loops, 0 to 5"),
]  # fmt: skip
_RESULTS = [
    ("App::PropertyBool", "Valid", "Whether there is a part"),
    ("App::PropertyInteger", "TriangleCount", "Triangles of the part"),
    ("App::PropertyInteger", "Untouched", "Those of them that are the source's own"),
    ("App::PropertyArea", "Area", "Area of the part"),
    ("App::PropertyStringList", "Warnings", "What is to be known of the result"),
]


class TrimFeature(FollowingMesh):
    """Proxy of a Mesh::FeaturePython that holds the part of its Source that loops border."""

    def ensure_properties(self, obj: Any) -> None:
        fresh = "KeepInside" not in obj.PropertiesList
        add_properties(obj, "Trim", _INPUTS)
        add_properties(obj, "Result", _RESULTS, _RESULT)
        if fresh:
            obj.KeepInside = True
        obj.setEditorMode("Placement", 1)  # it follows the source's

    def make(self, obj: Any) -> tuple[Any, dict[str, Any]]:
        require_source(obj.Source, obj)
        return _trimmed(obj)

    def show(self, obj: Any, told: dict[str, Any] | None) -> None:
        _show(obj, told)


observe_sources(TrimFeature)


def make_trim(
    doc: Any,
    source: Any,
    points: Sequence[Any] = (),
    wires: Iterable[Any] = (),
    *,
    keep: Any = None,
    smooth: int = 0,
    name: str = "Trim",
) -> Any:
    """Add a feature with the part of the mesh or shape `source` that loops border to `doc`, recompute, and return it.

    A loop is `points` near the surface, in the document's coordinates, or a closed wire of the sketches and shapes
    `wires`, which it follows. `keep` is a point of the part that stays; without it the part inside of the loops
    does. `smooth`: rounds of rounding the corners, 0 to 5. docs/trim.md says how the path runs. A loop that cannot be
    followed does not raise: the feature's State then has "Invalid".
    """
    require_source(source)
    if not 0 <= smooth <= _MOST_SMOOTHING:
        raise ValueError(f"smooth must be from 0 to {_MOST_SMOOTHING}, not {smooth}")
    to_source = source.getGlobalPlacement().inverse()
    obj = doc.addObject("Mesh::FeaturePython", name)
    try:
        TrimFeature(obj)
        obj.Points = [to_source.multVec(App.Vector(*point)) for point in points]
        obj.Wires = list(wires)
        obj.Smooth = smooth
        if keep is not None:
            obj.KeepInside = False
            obj.Keep = to_source.multVec(App.Vector(*keep))
        put_beside(obj, source)
        obj.Source = source
    except Exception:
        doc.removeObject(obj.Name)
        raise
    show_instead_of(obj, source)
    doc.recompute()
    return obj


def _trimmed(obj: Any) -> tuple[Any, dict[str, Any]]:
    with runs.refusing(obj.Source):
        from .mesh_io import mesh_from_arrays

        part = runs.run(trim_step(obj))
        return mesh_from_arrays(part.vertices, part.triangles), part.report


def trim_step(obj: Any) -> runs.Step[TrimmedMesh]:
    """For the part that the properties of `obj` ask for: nothing of it touches the document any more."""
    from thicken.arrays import trim

    surface = surface_arrays(obj.Source)
    runs.require_room(len(surface[1]))
    loops = loops_of(obj)
    keep = None if obj.KeepInside else tuple(obj.Keep)
    smooth, threads = obj.Smooth, runs.threads()
    return lambda context: trim(*surface, loops, keep=keep, smooth=smooth, threads=threads, context=context)


def loops_of(obj: Any) -> list[list[tuple[float, ...]]]:
    """The loops of a feature, in the coordinates of its source without the Placement."""
    loops = [[tuple(point) for point in obj.Points]] if obj.Points else []
    to_source = obj.Source.getGlobalPlacement().inverse()
    deflection = _DEFLECTION * bound_box(obj.Source).DiagonalLength
    for wire in obj.Wires:
        for points in _closed_wires(wire, deflection):
            loops.append([tuple(to_source.multVec(point)) for point in points])
    if not loops:
        raise RefusedError("There is no loop to trim along. Set Points, or Wires to a sketch with a closed wire.")
    return loops


def _closed_wires(source: Any, deflection: float) -> list[list[Any]]:
    """Points of the closed wires of an object, in the document's coordinates."""
    if not hasattr(source, "Shape"):
        raise RefusedError(f"“{source.Label}” has no wires. Choose a sketch, or another shape.")
    shape = source.Shape.copy()
    shape.Placement = App.Placement()
    place = source.getGlobalPlacement()
    found = []
    for wire in shape.Wires:
        if wire.isClosed():
            found.append([place.multVec(point) for point in wire.discretize(Deflection=deflection)[:-1]])
    if not found:
        raise RefusedError(f"“{source.Label}” has no closed wire. Close it, or choose another.")
    return found


def _show(obj: Any, report: dict[str, Any] | None) -> None:
    obj.Valid = report is not None
    obj.TriangleCount = obj.Mesh.CountFacets
    obj.Untouched = report["untouched_triangles"] if report else 0
    obj.Area = report["surface"]["area_mm2"] if report else 0
    obj.Warnings = report["warnings"] if report else []
