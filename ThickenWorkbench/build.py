# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a source object and arguments to a solid: what lies between FreeCAD and the library."""

from __future__ import annotations

import math
import threading
from typing import Any, Callable

import FreeCAD as App

from .sources import RefusedError, bound_box, require_source, surface_arrays

__all__ = ["RefusedError", "require_source", "solid_of", "suggested_thickness", "surface_of"]

PREFERENCES = "User parameter:BaseApp/Preferences/Mod/Thicken"

# A wall that most printers can make and that does not change the look of the part.
_SUGGESTED_SHARE = 0.02


def suggested_thickness(source: Any, share: float = _SUGGESTED_SHARE) -> float:
    """A thickness to start from, mm: a share of the diagonal, rounded to one significant digit."""
    wanted = share * bound_box(source).DiagonalLength
    if not (math.isfinite(wanted) and wanted > 0):
        return 1.0
    return float(f"{wanted:.0e}")


def surface_of(feature: Any) -> tuple[Any, Any]:
    """The vertices and triangles that a recompute of `feature` thickens."""
    from . import params

    return surface_arrays(feature.Source, **params.choice(feature))


def solid_of(source: Any, arguments: dict[str, Any], **choice: Any) -> tuple[Any, Any]:
    """Return the solid of what is chosen of `source` as a FreeCAD mesh, in the source's own coordinates,
    and as a ThickenedMesh.

    `choice`: faces, facets and deflection, as for surface_arrays(). Raises RefusedError with
    sentences for the user.
    """
    from . import native

    if not arguments["thickness"] > 0:
        raise RefusedError("Thickness is 0 mm. Set it to more than that.")
    try:
        from . import precomputed
        from .mesh_io import MeshTransferError, mesh_from_arrays

        extension = native.load()
    except ImportError as error:
        raise RefusedError(str(error)) from None
    try:
        surface = surface_arrays(source, **choice)
        solid = _waiting(lambda context: precomputed.thicken(surface, arguments, **limits(), context=context))
        return mesh_from_arrays(solid.vertices, solid.triangles), solid
    except extension.ThickenError as error:
        raise RefusedError(sentences(error, source)) from None
    except MeshTransferError as error:
        raise RefusedError(str(error)) from None
    except MemoryError:
        raise RefusedError("There is not enough memory. Simplify the mesh, or choose a coarser Quality.") from None


def _waiting(step: Callable[[Any], Any]) -> Any:
    """What `step` returns for a RunContext; where there are windows, the user sees its progress and can stop it."""
    if not App.GuiUp or threading.current_thread() is not threading.main_thread():
        return step(None)
    from .gui.modal_run import run

    return run(step)


def limits() -> dict[str, Any]:
    """Threads and memory belong to the machine, not to the document."""
    preferences = App.ParamGet(PREFERENCES)
    memory = preferences.GetInt("MemoryMiB", 0)
    return {"threads": max(0, preferences.GetInt("Threads", 0)), "memory": memory if memory > 0 else None}


def sentences(error: Any, source: Any) -> str:
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
