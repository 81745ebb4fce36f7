# SPDX-License-Identifier: LGPL-2.1-or-later
"""The printability report as one HTML page with its pictures in it."""

from __future__ import annotations

import base64
import json
import os
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterable, Iterator

import FreeCAD as App
import numpy as np

from thicken.arrays import render_picture, view_direction

from . import runs
from .numbers import count, language, number, percent, place
from .printability import Measured, report_step
from .sources import DEFAULT_DEFLECTION

if TYPE_CHECKING:
    from numpy.typing import NDArray

translate = App.Qt.translate

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


def write_report(
    obj: Any,
    path: str | os.PathLike[str],
    direction: Iterable[float] = (0, 0, 1),
    minimum_wall: Any = 1.0,
    *,
    deflection: float = DEFAULT_DEFLECTION,
) -> dict[str, Any]:
    """Write the facts of printability() and return them.

    A path that ends in .json gets the facts alone. Any other gets one HTML page with pictures in it,
    and the facts are written beside it, to the same name with .json.
    """
    found = runs.run(report_step(obj, direction, minimum_wall, deflection=deflection))
    runs.run(lambda context: write_measured(found, path, context))
    return found.facts


def write_measured(found: Measured, path: str | os.PathLike[str], context: Any = None) -> None:
    """Write what report_step() has measured, as write_report() does; nothing when `context` is cancelled before."""
    target = Path(path)
    if target.suffix.lower() != ".json":
        target.write_text(page(found, context), encoding="utf-8")
    target.with_suffix(".json").write_text(json.dumps(found.facts, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")


def page(measured: Measured, context: Any = None) -> str:
    """The HTML text, in the language of FreeCAD's windows; it needs no other file.

    Raises runs.CancelledError once `context` is cancelled.
    """
    facts = measured.facts
    good = translate("Thicken", "Nothing stands against printing it.")
    verdict = (
        f'<p class="good">{escape(good)}</p>'
        if facts["printable"]
        else "<ul>" + "".join(f'<li class="bad">{escape(warning)}</li>' for warning in facts["warnings"]) + "</ul>"
    )
    rows = "".join(f"<tr><th>{escape(name)}</th><td>{escape(value)}</td></tr>" for name, value in _rows(facts))
    title = escape(translate("Thicken", "Printability of {object}").format(object=facts["object"]))
    pictures = escape(translate("Thicken", "Pictures"))
    return (
        f'<!DOCTYPE html>\n<html lang="{language()}"><head><meta charset="utf-8"><title>{title}</title>'
        f"<style>{_STYLE}</style></head><body>\n<h1>{title}</h1>\n{verdict}\n<table>{rows}</table>\n"
        f'<h2>{pictures}</h2>\n<div class="pictures">{_pictures(measured, context)}</div>\n</body></html>\n'
    )


def _rows(facts: dict[str, Any]) -> Iterator[tuple[str, str]]:
    box = facts["bounding_box"]
    along = translate("Thicken", "{height} mm, along {direction}")
    yield translate("Thicken", "Size"), " × ".join(number(side, 4) for side in box["size_mm"]) + " mm"
    yield (
        translate("Thicken", "Height while printing"),
        along.format(height=number(box["height_mm"], 4), direction=place(facts["direction"]).removesuffix(" mm")),
    )
    yield translate("Thicken", "Triangles"), count(facts["triangles"])
    valid = translate("Thicken", "yes, proved with exact predicates") if facts["valid"] else translate("Thicken", "no")
    yield translate("Thicken", "Valid solid"), valid
    if not facts["valid"]:
        return
    yield translate("Thicken", "Parts"), count(facts["parts"])
    yield translate("Thicken", "Material"), f"{number(facts['volume_ml'], 4)} mL"
    yield translate("Thicken", "Surface"), f"{number(facts['area_mm2'], 4)} mm²"
    yield from _wall_rows(facts)
    yield from _resin_rows(facts)
    overhang = facts["overhang"]
    yield (
        translate("Thicken", "Overhangs beyond {angle}°").format(angle=number(overhang["degrees"])),
        translate("Thicken", "{area} mm², {share} of the surface").format(
            area=number(overhang["area_mm2"], 4), share=percent(overhang["share"])
        ),
    )
    yield translate("Thicken", "On the plate"), f"{number(overhang['on_plate_mm2'], 4)} mm²"


def _wall_rows(facts: dict[str, Any]) -> Iterator[tuple[str, str]]:
    wall = facts["thinnest_wall"]
    if wall["mm"] is not None:
        at = translate("Thicken", "{mm} mm at {place}")
        yield translate("Thicken", "Thinnest wall"), at.format(mm=number(wall["mm"]), place=place(wall["place_mm"]))
    yield (
        translate("Thicken", "Walls below {least} mm").format(least=number(facts["minimum_wall_mm"])),
        translate("Thicken", "{share} of the area").format(share=percent(wall["share_below_minimum"])),
    )


def _resin_rows(facts: dict[str, Any]) -> Iterator[tuple[str, str]]:
    lowest = translate("Thicken", "{volume} mL, lowest at {place}")
    for index, cavity in enumerate(facts["trapped"], 1):
        yield (
            translate("Thicken", "Closed cavity {number}").format(number=index),
            lowest.format(volume=number(cavity["volume_ml"], 4), place=place(cavity["lowest_place_mm"])),
        )
    if not facts["trapped"]:
        yield translate("Thicken", "Closed cavities"), translate("Thicken", "none")
    for pool in facts["pools"]:
        text = lowest.format(volume=number(pool["volume_ml"]), place=place(pool["lowest_place_mm"]))
        yield translate("Thicken", "Stays below holes"), text


def _pictures(measured: Measured, context: Any) -> str:
    vertices, triangles, up = measured.vertices, measured.triangles, np.array(measured.facts["direction"])
    used = vertices[np.unique(triangles)]
    middle = (used.min(axis=0) + used.max(axis=0)) / 2
    above, below, side = view_direction(up, 35, 25), view_direction(up, 35, -35), view_direction(up, 0, 0)
    plain = np.tile(np.array(_PLAIN, float), (len(triangles), 1))
    # Colours, view and caption of each; None: not cut.
    views = [(plain, above, None, translate("Thicken", "From above."))]
    if measured.facts["valid"]:
        overhangs = np.where(measured.overhanging[:, None], _OVERHANG, plain)
        trapped = np.where(measured.in_cavity[:, None], _TRAPPED, plain)
        least = measured.facts["minimum_wall_mm"]
        walls = translate("Thicken", "Walls: {thin} below {least} mm, {thick} {most} mm and more, {plain} not measured.")
        views += [
            (overhangs, below, None,
             _caption(translate("Thicken", "From below. {colour} needs support."), colour=_OVERHANG)),
            (trapped, side, middle,
             _caption(translate("Thicken", "Cut through the middle. {colour} closed cavities."), colour=_TRAPPED)),
            (_wall_colours(measured.walls, least), above, None,
             _caption(walls, thin=_THIN, thick=_THICK, plain=_PLAIN, least=number(least), most=number(3 * least))),
        ]  # fmt: skip
    figures = []
    for colours, towards, cut_at, caption in views:
        runs.go_on(context)
        cut = None if cut_at is None else (cut_at, -towards)
        content = base64.b64encode(render_picture(vertices, triangles, colours, towards=towards, up=up, cut=cut)).decode()
        figures.append(
            f'<figure><img alt="" src="data:image/png;base64,{content}"><figcaption>{caption}</figcaption></figure>'
        )
    return "\n".join(figures)


def _caption(text: str, **blanks: Any) -> str:
    """`text` with colours as little squares in its blanks."""
    return escape(text).format(**{name: _key(b) if isinstance(b, tuple) else b for name, b in blanks.items()})


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
