# SPDX-License-Identifier: LGPL-2.1-or-later
"""The feature that mends a defective surface. Documents name this module and class: neither may move."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import FreeCAD as App
import Mesh

from . import numbers, runs
from .beside import placement_in_parent_of, put_beside, show_instead_of
from .proxy import StatelessProxy, add_properties
from .source_observer import observe_sources
from .sources import require_source, surface_arrays

if TYPE_CHECKING:
    from thicken.arrays import RepairedMesh

translate = App.Qt.translate

_RESULT = 1 | 8  # read-only, and changing it does not touch the document

_INPUTS = [
    ("App::PropertyLink", "Source", "The mesh or shape to mend"),
    ("App::PropertyBool", "WeldAutomatically", "Weld corners of rims over a millionth of the diagonal at most"),
    ("App::PropertyLength", "Weld", "The farthest that corners of rims may be apart to become one"),
]
_RESULTS = [
    ("App::PropertyBool", "Valid", "Whether there is a surface without defects"),
    ("App::PropertyStringList", "Changes", "What was changed"),
    ("App::PropertyInteger", "Removed", "Triangles, or parts of divided ones, that are gone"),
    ("App::PropertyArea", "RemovedArea", "Their area"),
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
        "folded": translate("Thicken", "Triangles removed in a fold or gap with no room for a wall"),
    }


class RepairFeature(StatelessProxy):
    """Proxy of a Mesh::FeaturePython that holds what repair makes of its Source."""

    def ensure_properties(self, obj: Any) -> None:
        fresh = "WeldAutomatically" not in obj.PropertiesList
        add_properties(obj, "Repair", _INPUTS)
        add_properties(obj, "Result", _RESULTS, _RESULT)
        if fresh:
            obj.WeldAutomatically = True
        obj.setEditorMode("Placement", 1)  # it follows the source's

    def execute(self, obj: Any) -> None:
        """Mend the surface. When that is refused, nothing of an earlier one stays behind."""
        try:
            require_source(obj.Source, obj)
            mesh, report = _mended(obj)
        except BaseException:
            self.clear(obj)
            raise
        mesh.Placement = placement_in_parent_of(obj, obj.Source)
        obj.Mesh = mesh  # takes over the Placement as well
        _show(obj, report)

    def clear(self, obj: Any) -> None:
        obj.Mesh = Mesh.Mesh()
        _show(obj, None)


observe_sources(RepairFeature)


def make_repair(doc: Any, source: Any, weld: Any = None, *, name: str = "Repair") -> Any:
    """Add a feature with a mended copy of the mesh or shape `source` to `doc`, recompute, and return it.

    `weld` is the farthest that corners of rims may be apart to become one; without it a millionth of
    the diagonal. Its Changes say what was done; docs/repair.md says how. What cannot be mended
    does not raise: the feature's State then has "Invalid".
    """
    require_source(source)
    obj = doc.addObject("Mesh::FeaturePython", name)
    try:
        RepairFeature(obj)
        if weld is not None:
            _set_weld(obj, weld)
        put_beside(obj, source)
        obj.Source = source
    except Exception:
        doc.removeObject(obj.Name)
        raise
    show_instead_of(obj, source)
    doc.recompute()
    return obj


def _set_weld(obj: Any, weld: Any) -> None:
    obj.WeldAutomatically = False
    try:
        obj.Weld = weld
    except ArithmeticError:  # a unit of something else than length
        raise ValueError(f"weld must be a length, not {weld}") from None
    if isinstance(weld, (int, float)) and weld < 0:  # FreeCAD turns it into 0
        raise ValueError(f"weld must be 0 mm or more, not {weld}")


def _mended(obj: Any) -> tuple[Any, dict[str, Any]]:
    with runs.refusing(obj.Source):
        from .mesh_io import mesh_from_arrays

        mended = runs.run(repair_step(obj.Source, None if obj.WeldAutomatically else obj.Weld.Value))
        # The corners that triangles were divided at are the surface's own: still floats.
        return mesh_from_arrays(mended.vertices, mended.triangles), mended.report


def repair_step(source: Any, weld: float | None) -> runs.Step[RepairedMesh]:
    """For the mended surface of `source`: nothing of it touches `source` any more."""
    from thicken.arrays import repair_mesh

    surface = surface_arrays(source)
    runs.require_room(len(surface[1]))
    threads = runs.threads()
    return lambda context: repair_mesh(*surface, weld=weld, threads=threads, context=context)


def _show(obj: Any, report: dict[str, Any] | None) -> None:
    obj.Valid = report is not None
    obj.Changes = [_sentence(change) for change in report["changes"]] if report else []
    obj.Removed = report["removed_triangles"] if report else 0
    obj.RemovedArea = report["removed_area_mm2"] if report else 0
    obj.TriangleCount = obj.Mesh.CountFacets


def _sentence(change: dict[str, Any]) -> str:
    what, count = words().get(change["kind"], change["kind"]), numbers.count(change["count"])
    if not change["places_mm"]:
        return f"{what}: {count}."
    first = translate("Thicken", "{what}: {count}, the first at {place}.")
    return first.format(what=what, count=count, place=numbers.place(change["places_mm"][0]))
