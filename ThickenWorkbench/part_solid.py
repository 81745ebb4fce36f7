# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part solids of closed triangle meshes, and the feature that keeps one up to date.

Documents name this module and PartSolidFeature: neither may move or be renamed.
"""

from __future__ import annotations

import os
import tempfile
from typing import TYPE_CHECKING, Any

import FreeCAD as App

from thicken import native

from . import runs
from .beside import placement_in_parent_of, put_beside
from .numbers import count, number
from .proxy import StatelessProxy
from .source_observer import observe_sources
from .sources import RefusedError, kind_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

translate = App.Qt.translate

# Open CASCADE's own smallest tolerance, mm.
_TOLERANCE = 1e-7

# Of one triangle, seconds, on a machine of 2020: making the solid, and all that Part then does with it.
_SECONDS_PER_TRIANGLE = 2e-5
_SECONDS_OF_CHECK_PER_TRIANGLE = 3e-4
_WARN_BEYOND_SECONDS = 30.0


def predicted_seconds(triangles: int, check: bool = True) -> float:
    """About how long a Part solid of so many triangles takes, with Part's own check of it."""
    return triangles * (_SECONDS_PER_TRIANGLE + (_SECONDS_OF_CHECK_PER_TRIANGLE if check else 0))


def size_warning(triangles: int) -> str:
    """A sentence for the user before a Part solid of so many triangles is made; "" for a small one."""
    seconds = predicted_seconds(triangles)
    if seconds <= _WARN_BEYOND_SECONDS:
        return ""
    warning = translate(
        "Thicken",
        "A Part solid of {faces} faces takes about {seconds} s to make, and a check or a cut of it {later} s. "
        "A mesh is enough for printing; choose a coarser quality, or merge coplanar facets, if a solid is needed.",
    )
    return warning.format(
        faces=count(triangles), seconds=number(predicted_seconds(triangles, check=False), 2), later=number(seconds, 2)
    )


def part_solid(vertices: ArrayLike, triangles: ArrayLike, merge_coplanar: bool = False) -> Any:
    """The Part.Solid that a closed mesh bounds; a compound of solids where it bounds several.

    One planar face a triangle, with vertices and edges in common between neighbours; with
    `merge_coplanar` one face for all neighbours in one plane. Corners of equal coordinates are one
    vertex. Raises RefusedError with the defects of a mesh that bounds no solid.
    """
    import Part

    from .core.brep_solid import brep_bytes
    from .core.coplanar import merged_faces
    from .core.polyhedron import shells_of_solids, triangle_faces

    extension, threads = native.load(), runs.threads()

    def step(context: Any) -> bytes:
        points, corners = extension.weld(vertices, triangles)
        found = extension.inspect(points, corners, threads=threads, context=context)
        if found["status"] != "ok":
            reasons = " ".join(defect["sentence"].capitalize() + "." for defect in found["defects"])
            raise RefusedError(f"The mesh bounds no solid. {reasons}")
        runs.go_on(context)
        make = merged_faces if merge_coplanar else triangle_faces
        points, edges, faces, tolerance = make(points, corners, found["shell_of_triangle"], _TOLERANCE)
        runs.go_on(context)
        return brep_bytes(points, edges, faces, shells_of_solids(found["shells"]), tolerance)

    content = runs.run(step)
    shape = Part.Shape()
    # By way of a file: Python has no other way in for the binary format.
    with tempfile.TemporaryDirectory(prefix="thicken-") as folder:
        path = os.path.join(folder, "solid.bin")
        with open(path, "wb") as file:
            file.write(content)
        shape.importBinary(path)
    return shape


class PartSolidFeature(StatelessProxy):
    """Proxy of a Part::FeaturePython that holds the Part solid of the mesh of its Source."""

    def ensure_properties(self, obj: Any) -> None:
        for kind, name, doc in (
            ("App::PropertyLink", "Source", "The mesh object that bounds the solid"),
            ("App::PropertyBool", "MergeCoplanar", "One face for all neighbouring triangles in one plane"),
        ):
            if name not in obj.PropertiesList:
                obj.addProperty(kind, name, "Solid", doc)
        obj.setEditorMode("Placement", 1)  # it follows the source's

    def execute(self, obj: Any) -> None:
        """Make the solid. When that is refused, nothing of an earlier one stays behind."""
        try:
            _require_mesh(obj.Source, obj)
            shape = _solid_of(obj.Source, obj.MergeCoplanar)
        except BaseException:
            self.clear(obj)
            raise
        obj.Shape = shape
        obj.Placement = placement_in_parent_of(obj, obj.Source)

    def clear(self, obj: Any) -> None:
        import Part

        obj.Shape = Part.Shape()


observe_sources(PartSolidFeature)


def make_part_solid(doc: Any, source: Any, merge_coplanar: bool = False, name: str = "") -> Any:
    """Add a feature with the Part solid of the closed mesh object `source`, recompute, and return it."""
    obj = add_part_solid(doc, source, merge_coplanar, name)
    if App.GuiUp:
        from .beside import show_instead_of

        show_instead_of(obj, source)
    doc.recompute()
    return obj


def add_part_solid(doc: Any, source: Any, merge_coplanar: bool = False, name: str = "") -> Any:
    """As make_part_solid(), without the recompute."""
    _require_mesh(source)
    obj = doc.addObject("Part::FeaturePython", name or f"{source.Name}Solid")
    PartSolidFeature(obj)
    put_beside(obj, source)
    obj.Source = source
    obj.MergeCoplanar = merge_coplanar
    return obj


def part_solid_of(source: Any) -> Any | None:
    """The feature with the Part solid of `source`, if there is one."""
    for dependent in source.InList:
        if isinstance(getattr(dependent, "Proxy", None), PartSolidFeature) and dependent.Source == source:
            return dependent
    return None


def _require_mesh(source: Any, feature: Any = None) -> None:
    if source is None:
        raise RefusedError("No mesh is chosen. Set Source to an object with a closed mesh.")
    if kind_of(source) != "mesh":
        raise RefusedError(f"“{getattr(source, 'Label', source)}” is not a mesh. Choose an object with a closed mesh.")
    if feature is not None and feature in source.OutListRecursive:
        raise RefusedError(f"“{source.Label}” depends on “{feature.Label}”. Choose another Source.")


def _solid_of(source: Any, merge_coplanar: bool) -> Any:
    try:
        from .mesh_io import arrays_from_mesh

        if not source.isValid() or source.Mesh.CountFacets == 0:
            raise RefusedError(f"“{source.Label}” has no mesh to make a solid of: mend that first.")
        warning = size_warning(source.Mesh.CountFacets)
        if warning:
            App.Console.PrintWarning(f"{source.Label}: {warning}\n")
        return part_solid(*arrays_from_mesh(source.Mesh), merge_coplanar=merge_coplanar)
    except ImportError as error:
        raise RefusedError(str(error)) from None
