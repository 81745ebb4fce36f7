# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inputs of a feature in the words of the form, and back: what an edit sets."""

from __future__ import annotations

from typing import Any

from .. import params
from .chosen import is_shape

_CHOICES = {"side": params.SIDES, "method": params.METHODS, "join": params.JOINS, "simplify": params.SIMPLIFY}


def in_mm(value: float) -> str:
    return f"{value:.9g} mm"


def inputs_of(feature: Any) -> dict[str, Any]:
    """The inputs of a feature, as ThickenForm.inputs() has them."""
    found = {"smooth": None, "simplify": None, "gap": None, **dict.fromkeys(params.RIM), **params.arguments(feature)}
    found.pop("precision")
    found["join"] = None if feature.Join == params.JOINS[0] else feature.Join.lower()
    word = feature.Quality.lower()
    if word in params.QUALITIES:
        found.pop("cell", None)
        found |= {} if word == "standard" else {"quality": word}
    found["deflection"] = feature.Deflection.Value if is_shape(feature.Source) else None
    return found


def changes(before: dict[str, Any], after: dict[str, Any]) -> list[tuple[str, Any]]:
    """The properties of a feature that an edit sets, and to what."""
    result: list[tuple[str, Any]] = []
    if _quality_of(before) != _quality_of(after):
        result.append(("Quality", _quality_of(after)))
    for word, value in after.items():
        if before.get(word) == value or word == "quality":
            continue
        if word in _CHOICES:
            value = value.capitalize() if value else _CHOICES[word][0]
        elif word in ("thickness", "cell", "tolerance", "deflection"):
            value = in_mm(value)
        elif word == "smooth" and value is None:
            value = -1
        elif word == "gap" or word in params.RIM:
            value = in_mm(value or 0)
        result.append((params.RIM.get(word, word.capitalize()), value))
    return result


def _quality_of(inputs: dict[str, Any]) -> str:
    """The property Quality for the inputs of a form."""
    number = next((word for word in ("cell", "resolution", "tolerance") if word in inputs), None)
    return (number or inputs.get("quality", "standard")).capitalize()
