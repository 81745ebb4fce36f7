# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facts of printability() as rich text for a narrow panel. Places are links."""

from __future__ import annotations

from html import escape
from typing import Any, Iterable

import FreeCAD as App

from ..numbers import count, number, percent

translate = App.Qt.translate

_SCHEME = "place:"


def summary(facts: dict[str, Any], colours: dict[str, str]) -> str:
    """A verdict, what to know before printing, and a table; `colours` are those of tones()."""
    good = translate("Thicken", "Ready to print")
    bad = translate("Thicken", "To mend before printing")
    verdict = good if facts["printable"] else bad
    colour = colours["good" if facts["printable"] else "bad"]
    link = colours["link"]
    rows = "".join(
        f"<tr><td>{escape(name)}&nbsp;&nbsp;</td><td>{text.replace('<a ', f'<a style=color:{link} ')}</td></tr>"
        for name, text in _rows(facts)
    )
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
    yield translate("Thicken", "Size"), f"{' × '.join(number(side, 4) for side in facts['bounding_box']['size_mm'])} mm"
    yield translate("Thicken", "Height"), f"{number(facts['bounding_box']['height_mm'], 4)} mm"
    yield translate("Thicken", "Triangles"), count(facts["triangles"])
    if not facts["valid"]:
        return
    yield translate("Thicken", "Parts"), count(facts["parts"])
    yield translate("Thicken", "Volume"), f"{number(facts['volume_ml'], 4)} mL"
    yield translate("Thicken", "Surface"), f"{number(facts['area_mm2'] / 100, 4)} cm²"
    wall = facts["thinnest_wall"]
    if wall["mm"] is not None:
        yield translate("Thicken", "Thinnest wall"), _link(f"{number(wall['mm'])} mm", wall["place_mm"])
    overhang = facts["overhang"]
    text = f"{number(overhang['area_mm2'] / 100)} cm² ({percent(overhang['share'])})"
    yield translate("Thicken", "Overhang beyond {angle}°").format(angle=number(overhang["degrees"])), text
    yield translate("Thicken", "On the plate"), f"{number(overhang['on_plate_mm2'] / 100)} cm²"
    for cavity in facts["trapped"]:
        yield translate("Thicken", "Trapped"), _link(f"{number(cavity['volume_ml'])} mL", cavity["lowest_place_mm"])
    for pool in facts["pools"]:
        yield translate("Thicken", "Stays below holes"), _link(f"{number(pool['volume_ml'])} mL", pool["lowest_place_mm"])


def _link(text: str, place: Iterable[float]) -> str:
    return f'<a href="{_SCHEME}{",".join(f"{part:.9g}" for part in place)}">{escape(text)}</a>'
