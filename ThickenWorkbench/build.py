# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a source object and arguments to a solid: what lies between FreeCAD and the library."""

from __future__ import annotations

import math
from typing import Any

import FreeCAD as App

PREFERENCES = "User parameter:BaseApp/Preferences/Mod/Thicken"

# A wall that most printers can make and that does not change the look of the part.
_SUGGESTED_SHARE = 0.02


class RefusedError(RuntimeError):
    """Why a feature has no solid: whole sentences, with the place."""


def require_source(source: Any, feature: Any = None) -> None:
    """Raise RefusedError unless `source` is a mesh object that `feature` may depend on."""
    if source is None:
        raise RefusedError("No mesh is chosen. Set Source to a mesh object.")
    label = getattr(source, "Label", source)
    if not hasattr(source, "isDerivedFrom") or not source.isDerivedFrom("Mesh::Feature"):
        raise RefusedError(
            f"“{label}” is not a mesh. Make one of it first: Mesh Design ▸ Meshes ▸ Create mesh from shape."
        )
    if feature is not None and (source == feature or feature in source.OutListRecursive):
        raise RefusedError(f"“{label}” depends on “{feature.Label}”. Choose another Source.")


def suggested_thickness(source: Any) -> float:
    """A thickness to start from, mm: 2 % of the diagonal, rounded to one significant digit."""
    wanted = _SUGGESTED_SHARE * source.Mesh.BoundBox.DiagonalLength
    if not (math.isfinite(wanted) and wanted > 0):
        return 1.0
    return float(f"{wanted:.0e}")


def solid_of(source: Any, arguments: dict[str, Any]) -> tuple[Any, dict[str, Any]]:
    """Return the solid of the mesh of `source`, in its own coordinates, and the report.

    Raises RefusedError with sentences for the user.
    """
    from . import native

    if not arguments["thickness"] > 0:
        raise RefusedError("Thickness is 0 mm. Set it to more than that.")
    try:
        from . import precomputed
        from .mesh_io import MeshTransferError, arrays_from_mesh, mesh_from_arrays

        extension = native.load()
    except ImportError as error:
        raise RefusedError(str(error)) from None
    try:
        surface = arrays_from_mesh(source.Mesh)
        solid = precomputed.thicken(surface, arguments, **_limits())
        return mesh_from_arrays(solid.vertices, solid.triangles), solid.report
    except extension.ThickenError as error:
        raise RefusedError(_sentences(error, source)) from None
    except MeshTransferError as error:
        raise RefusedError(str(error)) from None
    except MemoryError:
        raise RefusedError("There is not enough memory. Simplify the mesh, or choose a coarser Quality.") from None


def _limits() -> dict[str, Any]:
    """Threads and memory belong to the machine, not to the document."""
    preferences = App.ParamGet(PREFERENCES)
    memory = preferences.GetInt("MemoryMiB", 0)
    return {"threads": max(0, preferences.GetInt("Threads", 0)), "memory": memory if memory > 0 else None}


def _sentences(error: Any, source: Any) -> str:
    """All that was found; the library's coordinates are the mesh's own, before the Placement."""
    parts = [defect["sentence"] for defect in error.defects]
    if not parts or not str(error).startswith(parts[0]):
        parts.insert(0, str(error))
    placement = source.getGlobalPlacement()
    located = [defect for defect in error.defects if defect["triangles"] or defect["edges"] or defect["vertices"]]
    if located and not placement.isIdentity():
        place = placement.multVec(App.Vector(*located[0]["place_mm"]))
        where = f"({place.x:g}, {place.y:g}, {place.z:g}) mm"
        parts.append(f"with the Placement of “{source.Label}” the first place is at {where}")
    return " ".join(part[:1].upper() + part[1:].rstrip(".") + "." for part in parts)


def placement_in_parent_of(feature: Any, source: Any) -> Any:
    """The Placement that puts `feature` where `source` is, whatever groups the two are in."""
    if feature.getParentGeoFeatureGroup() == source.getParentGeoFeatureGroup():
        return source.Placement
    parent = feature.getGlobalPlacement().multiply(feature.Placement.inverse())
    return parent.inverse().multiply(source.getGlobalPlacement())
