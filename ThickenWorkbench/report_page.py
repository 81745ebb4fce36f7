# SPDX-License-Identifier: LGPL-2.1-or-later
"""The printability report as one HTML page with its pictures in it."""

from __future__ import annotations

import base64
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from .picture import draw, view_along

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .printability import Measured

_PLAIN = (205, 208, 214)
_OVERHANG = (235, 120, 40)
_TRAPPED = (214, 60, 60)
_THIN = (214, 60, 60)
_THICK = (70, 130, 200)

_STYLE = """
body { font: 15px/1.5 sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; color: #222; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
table { border-collapse: collapse; } td, th { padding: .25rem 1.2rem .25rem 0; text-align: left; vertical-align: top; }
td { border-top: 1px solid #ddd; } .pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; max-width: 32rem; } figure img { width: 100%; } figcaption { color: #555; }
.good { color: #1a7f37; } .bad { color: #b3261e; } .key { display: inline-block; width: .9em; height: .9em; }
"""


def page(measured: Measured) -> str:
    """The HTML text; it needs no other file."""
    facts = measured.facts
    verdict = (
        '<p class="good">Nothing stands against printing it.</p>'
        if facts["printable"]
        else "<ul>" + "".join(f'<li class="bad">{escape(warning)}</li>' for warning in facts["warnings"]) + "</ul>"
    )
    rows = "".join(f"<tr><th>{escape(name)}</th><td>{escape(value)}</td></tr>" for name, value in _rows(facts))
    title = escape(f"Printability of {facts['object']}")
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title><style>{_STYLE}</style>'
        f"</head><body>\n<h1>{title}</h1>\n{verdict}\n<table>{rows}</table>\n<h2>Pictures</h2>\n"
        f'<div class="pictures">{_pictures_if_possible(measured)}</div>\n</body></html>\n'
    )


def _numbers(values: list[float], digits: int = 4) -> str:
    return ", ".join(f"{value:.{digits}g}" for value in values)


def _rows(facts: dict[str, Any]) -> list[tuple[str, str]]:
    box = facts["bounding_box"]
    rows = [
        ("Size", " × ".join(f"{side:.4g}" for side in box["size_mm"]) + " mm"),
        ("Height while printing", f"{box['height_mm']:.4g} mm, along ({_numbers(facts['direction'])})"),
        ("Triangles", str(facts["triangles"])),
        ("Valid solid", "yes, proved with exact predicates" if facts["valid"] else "no"),
    ]
    if not facts["valid"]:
        return rows
    wall, overhang = facts["thinnest_wall"], facts["overhang"]
    rows.append(("Parts", str(facts["parts"])))
    rows.append(("Material", f"{facts['volume_ml']:.4g} mL"))
    rows.append(("Surface", f"{facts['area_mm2']:.4g} mm²"))
    if wall["mm"] is not None:
        rows.append(("Thinnest wall", f"{wall['mm']:.3g} mm at ({_numbers(wall['place_mm'])}) mm"))
    share = 100 * wall["share_below_minimum"]
    rows.append((f"Walls below {facts['minimum_wall_mm']:g} mm", f"{share:.2g} % of the area"))
    for number, cavity in enumerate(facts["trapped"], 1):
        place = _numbers(cavity["lowest_place_mm"])
        rows.append((f"Closed cavity {number}", f"{cavity['volume_ml']:.4g} mL, lowest at ({place}) mm"))
    if not facts["trapped"]:
        rows.append(("Closed cavities", "none"))
    rows.append((
        f"Overhangs beyond {overhang['degrees']:g}°",
        f"{overhang['area_mm2']:.4g} mm², {100 * overhang['share']:.2g} % of the surface",
    ))  # fmt: skip
    rows.append(("On the plate", f"{overhang['on_plate_mm2']:.4g} mm²"))
    return rows


def _pictures_if_possible(measured: Measured) -> str:
    try:
        return _pictures(measured)
    except ImportError as error:  # the facts are worth a page without them
        return f"<p>There are none: {escape(str(error))}. They need Pillow.</p>"


def _pictures(measured: Measured) -> str:
    vertices, triangles, up = measured.vertices, measured.triangles, np.array(measured.facts["direction"])
    used = vertices[np.unique(triangles)]
    middle = (used.min(axis=0) + used.max(axis=0)) / 2
    above, below, side = view_along(up, 35, 25), view_along(up, 35, -35), view_along(up, 0, 0)
    plain = np.tile(np.array(_PLAIN, float), (len(triangles), 1))
    views = [(draw(vertices, triangles, plain, above), "From above.")]
    if measured.facts["valid"]:
        overhangs = np.where(measured.overhanging[:, None], _OVERHANG, plain)
        trapped = np.where(measured.in_cavity[:, None], _TRAPPED, plain)
        least = measured.facts["minimum_wall_mm"]
        views += [
            (draw(vertices, triangles, overhangs, below), f"From below. {_key(_OVERHANG)} needs support."),
            (draw(vertices, triangles, trapped, side, cut_at=middle), f"Cut through the middle. {_key(_TRAPPED)} closed cavities."),
            (draw(vertices, triangles, _wall_colours(measured.walls, least), above),
             f"Walls: {_key(_THIN)} below {least:g} mm, {_key(_THICK)} {3 * least:g} mm and more, {_key(_PLAIN)} not measured."),
        ]  # fmt: skip
    return "\n".join(
        f'<figure><img alt="" src="data:image/png;base64,{base64.b64encode(content).decode()}">'
        f"<figcaption>{caption}</figcaption></figure>"
        for content, caption in views
    )


def _key(colour: tuple[int, int, int]) -> str:
    return f'<span class="key" style="background:rgb{colour}"></span>'


def _wall_colours(walls: NDArray, least: float) -> NDArray:
    """Red below `least`, from light to blue up to three times of it, grey where nothing is measured."""
    share = np.clip((np.nan_to_num(walls) - least) / (2 * least), 0, 1)[:, None]
    light = np.array([235.0, 225.0, 190.0])
    colours = light + share * (np.array(_THICK) - light)
    colours[walls < least * (1 - 1e-6)] = _THIN
    colours[np.isnan(walls)] = _PLAIN
    return colours
