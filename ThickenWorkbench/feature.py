# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric feature. Documents name this module and class: neither may move or be renamed."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import Mesh

from . import build, params
from .source_observer import observe_sources


class ThickenFeature:
    """Proxy of a Mesh::FeaturePython that holds the solid of its Source. It has no state of its own."""

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        params.ensure_properties(obj)

    def execute(self, obj: Any) -> None:
        """Compute the solid. When that is refused, nothing of an earlier one stays behind."""
        try:
            build.require_source(obj.Source, obj)
            mesh, report = build.solid_of(obj.Source, params.arguments(obj))
        except BaseException:
            obj.Mesh = Mesh.Mesh()
            params.clear_results(obj)
            raise
        mesh.Placement = build.placement_in_parent_of(obj, obj.Source)
        obj.Mesh = mesh  # takes over the Placement as well
        params.show_report(obj, report)
        for warning in obj.Warnings:
            App.Console.PrintWarning(f"{obj.Label}: {warning}\n")

    def onChanged(self, obj: Any, name: str) -> None:
        if name == "Quality" and "SchemaVersion" in obj.PropertiesList and "Restore" not in obj.State:
            params.show_quality(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        params.ensure_properties(obj)
        if App.GuiUp:
            from .view_provider import attach_view_provider

            attach_view_provider(obj)

    # FreeCAD before 0.21.2 calls the first pair, later ones the second.
    def __getstate__(self) -> None:
        return None

    def __setstate__(self, state: Any) -> None:
        return None

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        return None


observe_sources(ThickenFeature)


def make_thicken(
    doc: Any,
    source: Any,
    thickness: Any = None,
    side: str = "negative",
    method: str = "auto",
    *,
    cell: Any = None,
    resolution: int | None = None,
    tolerance: Any = None,
    repair: bool = False,
    name: str = "Thicken",
) -> Any:
    """Add a feature that thickens the mesh object `source` to `doc`, recompute, and return it.

    Lengths are numbers of mm, quantities, or text such as "2 mm". Without a thickness it is
    build.suggested_thickness(). Of cell, resolution and tolerance give one or none.

    A surface that is refused does not raise: as after any recompute, the feature's State then has
    "Invalid" and its getStatusString() says why. Arguments that make no sense raise, and leave
    the document as it was.
    """
    build.require_source(source)
    obj = doc.addObject("Mesh::FeaturePython", name)
    try:
        ThickenFeature(obj)
        params.set_inputs(
            obj, side=side, method=method, repair=repair, cell=cell, resolution=resolution, tolerance=tolerance
        )
        _set_thickness(obj, build.suggested_thickness(source) if thickness is None else thickness)
        group = source.getParentGeoFeatureGroup()
        if group is not None:
            group.addObject(obj)  # a link must not leave its coordinate system
        obj.Source = source
    except Exception:
        doc.removeObject(obj.Name)
        raise
    if App.GuiUp:
        from .view_provider import attach_view_provider

        attach_view_provider(obj)
        source.ViewObject.Visibility = False
    doc.recompute()
    return obj



def _set_thickness(obj: Any, thickness: Any) -> None:
    try:
        obj.Thickness = thickness
    except ArithmeticError:  # a unit of something else than length
        raise ValueError(f"thickness must be a length, not {thickness}") from None
    if not obj.Thickness.Value > 0:  # FreeCAD turns a negative length into 0
        raise ValueError(f"thickness must be above 0 mm, not {thickness}")
