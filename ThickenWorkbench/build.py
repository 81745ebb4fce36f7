# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a source object and arguments to a solid: what lies between FreeCAD and the library."""

from __future__ import annotations

import math
from typing import Any

from . import runs
from .sources import RefusedError, bound_box, require_source, surface_arrays

__all__ = ["RefusedError", "require_source", "solid_of", "suggested_thickness", "surface_of"]

# A wall that most printers can make and that does not change the look of the part.
_SUGGESTED_SHARE = 0.02

# Surfaces are hardly ever smaller or larger than this, mm: their unit is likely to be another.
_SMALLEST, _LARGEST = 1.0, 10_000.0


def diagonal(source: Any) -> float:
    """Of the bounding box, mm; 0 for nothing."""
    box = bound_box(source)
    return box.DiagonalLength if box.isValid() else 0.0


def suggested_thickness(source: Any, share: float = _SUGGESTED_SHARE) -> float:
    """A thickness to start from, mm: a share of the diagonal, rounded to one significant digit."""
    wanted = share * diagonal(source)
    if not (math.isfinite(wanted) and wanted > 0):
        return 1.0
    return float(f"{wanted:.0e}")


def likely_unit(source: Any) -> str | None:
    """The unit that the coordinates of `source` are likely to be in: "m" or "µm"; None for mm."""
    length = diagonal(source)
    if 0 < length < _SMALLEST:
        return "m"
    return "µm" if length > _LARGEST else None


def surface_of(feature: Any) -> tuple[Any, Any]:
    """The vertices and triangles that a recompute of `feature` thickens."""
    from . import params

    with runs.refusing(feature.Source):
        return surface_arrays(feature.Source, **params.choice(feature))


def solid_of(source: Any, surface: tuple[Any, Any], arguments: dict[str, Any]) -> tuple[Any, Any]:
    """Return the solid of `surface`, of `source`, as a FreeCAD mesh in the source's own coordinates, and as a
    ThickenedMesh. Raises RefusedError with sentences for the user.
    """
    import numpy as np

    if not np.min(arguments["thickness"]) > 0:
        raise RefusedError("Thickness is 0 mm. Set it to more than that.")
    with runs.refusing(source):
        from thicken import native

        from .core import precomputed
        from .mesh_io import mesh_from_arrays

        native.load()
        limits = {"threads": runs.threads(), "memory": runs.memory()}
        solid = runs.run(lambda context: precomputed.thicken(surface, arguments, **limits, context=context))
        return mesh_from_arrays(solid.vertices, solid.triangles), solid


def fingerprint(surface: tuple[Any, Any], arguments: dict[str, Any], mesh: Any) -> str:
    """What a solid was made from, and what it is, as a short text: as long as both are the same, so is the other."""
    from thicken import __version__

    from .core import precomputed
    from .mesh_io import arrays_from_mesh

    made_from = precomputed.key(surface, {**arguments, "version": __version__})
    return f"{made_from} {precomputed.key(arrays_from_mesh(mesh), {})}"
