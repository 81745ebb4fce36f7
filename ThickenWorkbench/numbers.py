# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as a reader has them: few digits, no powers of ten, in the language of FreeCAD's windows."""

from __future__ import annotations

import math
from typing import Iterable

import FreeCAD as App

# More places after the point say nothing about something that is printed.
_MOST_PLACES = 4


def number(value: float, digits: int = 3) -> str:
    """`value` with so many digits that count, at most four of them after the point."""
    if not math.isfinite(value):
        return "–"
    size = math.floor(math.log10(abs(value))) if value else 0
    places = min(max(digits - 1 - size, 0), _MOST_PLACES)
    rounded = round(value, min(digits - 1 - size, _MOST_PLACES)) + 0.0  # not −0
    text = f"{rounded:,.{places}f}"
    return _localised(text.rstrip("0").rstrip(".") if places else text)


def count(value: int) -> str:
    """A number of things."""
    return _localised(f"{value:,}")


def percent(share: float) -> str:
    """A share as "12 %"; what is there but hardly is "< 0.01 %", and what is nearly all "> 99 %"."""
    if 0 < share < 1e-4:
        return f"< {_localised('0.01')} %"
    if 0.99 < share < 1:
        return "> 99 %"
    return f"{number(100 * share, 2)} %"


def place(point: Iterable[float]) -> str:
    """"(1.2, 3, 4) mm"; where the decimal mark is a comma, coordinates are parted by semicolons."""
    parts = [number(x, 4) for x in point]
    return f"({('; ' if _marks()[0] == ',' else ', ').join(parts)}) mm"


def _localised(text: str) -> str:
    point, group = _marks()
    return text.translate({ord(","): group, ord("."): point})


def _marks() -> tuple[str, str]:
    """The decimal mark, and what parts thousands."""
    if not App.GuiUp:
        return ".", ","
    from PySide import QtCore

    locale = QtCore.QLocale()
    return str(locale.decimalPoint()), str(locale.groupSeparator())


def language() -> str:
    """That of FreeCAD's windows, as in "de"."""
    if not App.GuiUp:
        return "en"
    from PySide import QtCore

    return str(QtCore.QLocale().name()).partition("_")[0] or "en"
