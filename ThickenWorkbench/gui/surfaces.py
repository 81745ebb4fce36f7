# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrays and arguments that a feature will be computed from: the very ones, so that what is computed ahead fits."""

from __future__ import annotations

from typing import Any

from .. import params
from ..sources import surface_arrays
from .chosen import Chosen


def surface_of(item: Chosen, deflection: float) -> tuple[Any, Any]:
    """Vertices and triangles of what is chosen; `deflection` (mm) is for shapes."""
    return surface_arrays(item.source, faces=item.faces, facets=item.facets, deflection=deflection)


def chosen_of(feature: Any) -> Chosen:
    """What a feature thickens."""
    choice = params.choice(feature)
    return Chosen(feature.Source, tuple(choice["faces"]), tuple(choice["facets"]))


def arguments_of(inputs: dict[str, Any]) -> dict[str, Any]:
    """The arguments of thicken_mesh() that a feature with these inputs passes: see params.arguments()."""
    given = {name: value for name, value in inputs.items() if value is not None and name not in ("deflection", "quality", "join")}
    given |= params.join_arguments((inputs["join"] or "automatic").capitalize())
    word = inputs.get("quality", "standard").capitalize()
    return {**given, **params.quality_arguments(word, None, inputs["thickness"]), "precision": "single"}
