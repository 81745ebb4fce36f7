# SPDX-License-Identifier: LGPL-2.1-or-later
"""The feature that mends a defective surface. Documents name this module and class: neither may move."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import FreeCAD as App

from . import numbers, runs
from .beside import put_beside, show_instead_of
from .following_mesh import FollowingMesh
from .proxy import add_properties
from .source_observer import observe_sources
from .sources import require_source, surface_arrays

if TYPE_CHECKING:
    from thicken.arrays import RepairedMesh

translate = App.Qt.translate

_RESULT = 1 | 8  # read-only, and changing it does not touch the document

_INPUTS = [
    ("App::PropertyLink", "Source", "The mesh or shape to mend"),
    ("App::PropertyBool", "WeldAutomatically", "Weld corners of rims over a millionth of the diagonal at most"),
    ("App::PropertyLength", "Weld", "The farthest that rims may be apart to be joined"),
    ("App::PropertyLength", "Bridge", "The widest gap between rims to be closed by a strip of triangles; 0: none"),
    ("App::PropertyLength", "FillHoles", "Rims that are shorter than this are closed by a patch; 0: none"),
]
_RESULTS = [
    ("App::PropertyBool", "Valid", "Whether there is a surface without defects"),
    ("App::PropertyStringList", "Changes", "What was changed"),
    ("App::PropertyInteger", "Removed", "Triangles, or parts of divided ones, that are gone"),
    ("App::PropertyArea", "RemovedArea", "Their area"),
    ("App::PropertyInteger", "Added", "Triangles of strips and patches"),
    ("App::PropertyInteger", "TriangleCount", "Triangles of the result"),
]


def words() -> dict[str, str]:
    """What a change of each kind is to a reader; the number is put behind, which suits one as well as many."""
    return {
        "welded": translate("Thicken", "Corners moved onto a corner nearby"),
        "not-finite": translate("Thicken", "Triangles with a corner that is no number, removed"),
        "degenerate": translate("Thicken", "Triangles without area, removed"),
        "duplicate": translate("Thicken", "Repeated triangles, removed"),
        "divided": translate("Thicken", "Triangles divided at a corner on one of their edges"),
        "turned": translate("Thicken", "Triangles turned over"),
        "non-manifold-edge": translate("Thicken", "Triangles removed where more than two met at an edge"),
        "one-sided": translate("Thicken", "Triangles removed to cut a one-sided part open"),
        "self-intersecting": translate("Thicken", "Triangles removed that met others"),
        "non-manifold-vertex": translate("Thicken", "Triangles removed where parts touched in a point only"),
        "overlapping": translate("Thicken", "Triangles removed of a sheet that lay on a larger one"),
        "crumb": translate("Thicken", "Triangles removed of small parts that came off"),
        "smoothed": translate("Thicken", "Triangles removed to give a border straight runs"),
        "bridged": translate("Thicken", "Triangles added in strips across gaps"),
        "filled": translate("Thicken", "Triangles added in holes"),
        "folded": translate("Thicken", "Triangles removed in a fold or gap with no room for a wall"),
    }


class RepairFeature(FollowingMesh):
    """Proxy of a Mesh::FeaturePython that holds what repair makes of its Source."""

    def ensure_properties(self, obj: Any) -> None:
        fresh = "WeldAutomatically" not in obj.PropertiesList
        add_properties(obj, "Repair", _INPUTS)
        add_properties(obj, "Result", _RESULTS, _RESULT)
        if fresh:
            obj.WeldAutomatically = True
        obj.setEditorMode("Placement", 1)  # it follows the source's

    def make(self, obj: Any) -> tuple[Any, dict[str, Any]]:
        require_source(obj.Source, obj)
        return _mended(obj)

    def show(self, obj: Any, told: dict[str, Any] | None) -> None:
        _show(obj, told)


observe_sources(RepairFeature)


def make_repair(
    doc: Any, source: Any, weld: Any = None, *, bridge: Any = 0, fill_holes: Any = 0, name: str = "Repair"
) -> Any:
    """Add a feature with a mended copy of the mesh or shape `source` to `doc`, recompute, and return it.

    `weld` is the farthest that rims may be apart to be joined; without it corners of rims become one over a millionth
    of the diagonal. `bridge` is the widest gap to be closed by a strip of triangles, and rims shorter than `fill_holes`
    are closed by a patch; 0: none. Its Changes say what was done; docs/repair.md says how. What cannot be mended
    does not raise: the feature's State then has "Invalid".
    """
    require_source(source)
    obj = doc.addObject("Mesh::FeaturePython", name)
    try:
        RepairFeature(obj)
        if weld is not None:
            obj.WeldAutomatically = False
            _set_length(obj, "Weld", weld)
        _set_length(obj, "Bridge", bridge)
        _set_length(obj, "FillHoles", fill_holes)
        put_beside(obj, source)
        obj.Source = source
    except Exception:
        doc.removeObject(obj.Name)
        raise
    show_instead_of(obj, source)
    doc.recompute()
    return obj


def _set_length(obj: Any, name: str, value: Any) -> None:
    try:
        setattr(obj, name, value)
    except ArithmeticError:  # a unit of something else than length
        raise ValueError(f"{name.lower()} must be a length, not {value}") from None
    if isinstance(value, (int, float)) and value < 0:  # FreeCAD turns it into 0
        raise ValueError(f"{name.lower()} must be 0 mm or more, not {value}")


def _mended(obj: Any) -> tuple[Any, dict[str, Any]]:
    with runs.refusing(obj.Source):
        from .mesh_io import mesh_from_arrays

        mended = runs.run(repair_step(obj.Source, Joins.of(obj)))
        # The corners that triangles were divided at are the surface's own: still floats.
        return mesh_from_arrays(mended.vertices, mended.triangles), mended.report


class Joins(NamedTuple):
    """What a repair may join, mm: repair_mesh() has the words."""

    weld: float | None  # None: a millionth of the diagonal
    bridge: float = 0.0  # 0: no strips
    fill_holes: float = 0.0  # 0: no patches

    @classmethod
    def of(cls, obj: Any) -> Joins:
        return cls(None if obj.WeldAutomatically else obj.Weld.Value, obj.Bridge.Value, obj.FillHoles.Value)


def repair_step(source: Any, joins: Joins) -> runs.Step[RepairedMesh]:
    """For the mended surface of `source`: nothing of it touches `source` any more."""
    from thicken.arrays import repair_mesh

    surface = surface_arrays(source)
    runs.require_room(len(surface[1]))
    lengths = {"weld": joins.weld, "bridge": joins.bridge or None, "fill_holes": joins.fill_holes or None}
    threads = runs.threads()
    return lambda context: repair_mesh(*surface, **lengths, threads=threads, context=context)


def _show(obj: Any, report: dict[str, Any] | None) -> None:
    obj.Valid = report is not None
    obj.Changes = sentences(report) if report else []
    obj.Removed = report["removed_triangles"] if report else 0
    obj.RemovedArea = report["removed_area_mm2"] if report else 0
    obj.Added = report["added_triangles"] if report else 0
    obj.TriangleCount = obj.Mesh.CountFacets


def sentences(report: dict[str, Any]) -> list[str]:
    """What was changed, and what was asked for and could not be."""
    told = [_sentence(change) for change in report["changes"]]
    for count, places, what in (
        ("left_corners", "left_places_mm", translate("Thicken", "Corners near another rim that could not be joined")),
        ("left_holes", "left_hole_places_mm", translate("Thicken", "Holes that no patch fits into")),
    ):
        if report[count]:
            told.append(_placed(what, report[count], report[places]))
    return told


def _sentence(change: dict[str, Any]) -> str:
    return _placed(words().get(change["kind"], change["kind"]), change["count"], change["places_mm"])


def _placed(what: str, count: int, places: list[Any]) -> str:
    if not places:
        return f"{what}: {numbers.count(count)}."
    first = translate("Thicken", "{what}: {count}, the first at {place}.")
    return first.format(what=what, count=numbers.count(count), place=numbers.place(places[0]))
