# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric feature. Documents name this module and class: neither may move or be renamed."""

from __future__ import annotations

from typing import Any, Iterable, Sequence

import FreeCAD as App
import Mesh

from . import build, params
from .beside import placement_in_parent_of, put_beside, show_instead_of
from .proxy import StatelessProxy
from .sources import require_source
from .source_observer import observe_sources


class ThickenFeature(StatelessProxy):
    """Proxy of a Mesh::FeaturePython that holds the solid of its Source."""

    schema = params.SCHEMA_VERSION
    migrations = params.MIGRATIONS

    def ensure_properties(self, obj: Any) -> None:
        params.ensure_properties(obj)

    def execute(self, obj: Any) -> None:
        """Compute the solid. When that is refused, nothing of an earlier one stays behind."""
        from .thickness_regions import ThicknessField  # needs NumPy, which opening a document does not

        try:
            require_source(obj.Source, obj)
            surface = build.surface_of(obj)
            field = ThicknessField(obj, surface)
            arguments = params.arguments(obj, field.values(obj.Thickness.Value))
            if obj.Valid and obj.ComputedFor == build.fingerprint(surface, arguments, obj.Mesh):
                # Only its place has changed, or an edit was undone.
                obj.Placement = placement_in_parent_of(obj, obj.Source)
                return
            mesh, solid = build.solid_of(obj.Source, surface, arguments)
        except BaseException:
            self.clear(obj)
            raise
        obj.ComputedFor = build.fingerprint(surface, arguments, mesh)
        mesh.Placement = placement_in_parent_of(obj, obj.Source)
        obj.Mesh = mesh  # takes over the Placement as well
        params.show_solid(obj, solid)
        obj.Warnings = [*obj.Warnings, *field.notes]
        for warning in obj.Warnings:
            App.Console.PrintWarning(f"{obj.Label}: {warning}\n")

    def clear(self, obj: Any) -> None:
        obj.Mesh = Mesh.Mesh()
        params.clear_results(obj)

    def onChanged(self, obj: Any, name: str) -> None:
        if name == "Quality" and "SchemaVersion" in obj.PropertiesList and "Restore" not in obj.State:
            params.show_quality(obj)


observe_sources(ThickenFeature)

OUTPUTS = ("mesh", "solid")

_NAME = "Thicken"


def make_thicken(
    doc: Any,
    source: Any,
    thickness: Any = None,
    side: str = "negative",
    method: str = "auto",
    *,
    quality: str = "standard",
    cell: Any = None,
    resolution: int | None = None,
    tolerance: Any = None,
    smooth: int | None = None,
    join: str = "automatic",
    simplify: str = "auto",
    repair: bool = False,
    gap: Any = 0,
    rim_thickness: Any = 0,
    rim_width: Any = 0,
    rim_round: Any = 0,
    faces: Sequence[Any] = (),
    facets: Iterable[int] = (),
    deflection: Any = None,
    output: str = "mesh",
    name: str = _NAME,
) -> Any:
    """Add a feature that thickens the mesh or shape `source` to `doc`, recompute, and return it.

    `source` may be a list: every object of it gets a feature, and the list of them is returned.
    Lengths are numbers of mm, quantities, or text such as "2 mm". Without a thickness it is
    build.suggested_thickness(). `quality` is "draft", "standard" or "fine"; or give one of cell, resolution and
    tolerance. `join` is "intersection" (outside of convex edges planes go on until they meet), "arc" (they are rounded)
    or "automatic", which is arc with a tolerance and for the method "reconstruct". With `gap` the solid begins so far
    from the surface, and keeps not that but the surface there. `rim_thickness` at the rim changes to the thickness
    elsewhere over `rim_width`; `rim_round` is the radius of the edge between shell and wall.

    `faces` (names such as "Face3") choose a part of a shape, `facets` (indices) a part of a mesh;
    `deflection` is the farthest that the triangles of a shape may be from it. With output="solid" a
    Part solid of the result is added as well: part_solid.part_solid_of(feature).

    A surface that is refused does not raise: as after any recompute, the feature's State then has
    "Invalid" and its getStatusString() says why. Arguments that make no sense raise, and leave
    the document as it was.
    """
    several = isinstance(source, (list, tuple))
    sources = list(source) if several else [source]
    choice = (list(faces), [int(facet) for facet in facets], deflection)
    _require_sense(sources, choice, output)
    inputs = dict(
        side=side, method=method, join=join, repair=repair, smooth=smooth, simplify=simplify, quality=quality,
        cell=cell, resolution=resolution, tolerance=tolerance, gap=gap,
        rim=dict(rim_thickness=rim_thickness, rim_width=rim_width, rim_round=rim_round),
    )
    made = []
    try:
        for each in sources:
            made.append(_add_feature(doc, each, name, thickness, choice, inputs))
    except Exception:
        for feature in made:
            doc.removeObject(feature.Name)
        raise
    for feature in made:
        show_instead_of(feature, feature.Source)
    if output == "solid":
        from .part_solid import add_part_solid

        for feature in made:
            show_instead_of(add_part_solid(doc, feature), feature)
    doc.recompute()
    return made if several else made[0]


def _require_sense(sources: list[Any], choice: Any, output: str) -> None:
    if len(sources) > 1 and (choice[0] or choice[1]):
        raise ValueError("faces and facets choose a part of one source; several were given")
    if output not in OUTPUTS:
        raise ValueError(f"output must be one of {', '.join(OUTPUTS)}, not {output!r}")
    for each in sources:
        require_source(each)


def _add_feature(doc: Any, source: Any, name: str, thickness: Any, choice: Any, inputs: dict[str, Any]) -> Any:
    obj = doc.addObject("Mesh::FeaturePython", name)
    try:
        if name == _NAME:  # the tree and the file that is offered say what it is a solid of
            obj.Label = f"{source.Label}_thick"
        ThickenFeature(obj)
        params.set_inputs(obj, **inputs)
        params.set_choice(obj, source, *choice)
        _set_thickness(obj, build.suggested_thickness(source) if thickness is None else thickness)
        put_beside(obj, source)
        obj.Source = source
    except Exception:
        doc.removeObject(obj.Name)
        raise
    return obj


def _set_thickness(obj: Any, thickness: Any) -> None:
    try:
        obj.Thickness = thickness
    except ArithmeticError:  # a unit of something else than length
        raise ValueError(f"thickness must be a length, not {thickness}") from None
    if not obj.Thickness.Value > 0:  # FreeCAD turns a negative length into 0
        raise ValueError(f"thickness must be above 0 mm, not {thickness}")
