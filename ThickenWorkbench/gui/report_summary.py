# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facts of printability() as rich text for a narrow panel. Places are links."""

from __future__ import annotations

from html import escape
from typing import Any, Iterable

import FreeCAD as App

translate = App.Qt.translate

_SCHEME = "place:"


def summary(facts: dict[str, Any]) -> str:
    """A verdict, what to heed, and a table."""
    good = translate("Thicken", "Ready to print")
    bad = translate("Thicken", "Heed before printing")
    verdict, colour = (good, "#26a269") if facts["printable"] else (bad, "#c01c28")
    rows = "".join(f"<tr><td>{escape(name)}&nbsp;&nbsp;</td><td>{text}</td></tr>" for name, text in _rows(facts))
    warnings = "".join(f"<li>{escape(sentence)}</li>" for sentence in facts["warnings"])
    return (
        f'<h3 style="color: {colour}">{escape(verdict)}</h3>'
        + (f"<ul style='margin-left: -20px'>{warnings}</ul>" if warnings else "")
        + f"<table>{rows}</table>"
    )


def place_of(link: str) -> tuple[float, ...]:
    """The place that a link of the summary stands for."""
    return tuple(float(part) for part in link.removeprefix(_SCHEME).split(","))


def _rows(facts: dict[str, Any]) -> Iterable[tuple[str, str]]:
    size = " × ".join(f"{side:.4g}" for side in facts["bounding_box"]["size_mm"])
    yield translate("Thicken", "Size"), f"{size} mm"
    yield translate("Thicken", "Height"), f"{facts['bounding_box']['height_mm']:.4g} mm"
    yield translate("Thicken", "Triangles"), f"{facts['triangles']:,}"
    if not facts["valid"]:
        return
    yield translate("Thicken", "Parts"), str(facts["parts"])
    yield translate("Thicken", "Volume"), f"{facts['volume_ml']:.4g} mL"
    yield translate("Thicken", "Surface"), f"{facts['area_mm2'] / 100:.4g} cm²"
    wall = facts["thinnest_wall"]
    if wall["mm"] is not None:
        yield translate("Thicken", "Thinnest wall"), _link(f"{wall['mm']:.4g} mm", wall["place_mm"])
    overhang = facts["overhang"]
    text = f"{overhang['area_mm2'] / 100:.4g} cm² ({100 * overhang['share']:.2g} %)"
    yield translate("Thicken", "Overhang beyond {angle}°").format(angle=f"{overhang['degrees']:g}"), text
    yield translate("Thicken", "On the plate"), f"{overhang['on_plate_mm2'] / 100:.4g} cm²"
    for cavity in facts["trapped"]:
        yield translate("Thicken", "Trapped"), _link(f"{cavity['volume_ml']:.4g} mL", cavity["lowest_place_mm"])


def _link(text: str, place: Iterable[float]) -> str:
    return f'<a href="{_SCHEME}{",".join(f"{part:.9g}" for part in place)}">{escape(text)}</a>'
