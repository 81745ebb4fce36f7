# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user sets once for all documents: the table of keys and what they start with.

FreeCAD keeps them in its own parameters; the preferences page and macros write them there. A test
compares this table with the page and with docs/freecad.md.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import FreeCAD as App

PATH = "User parameter:BaseApp/Preferences/Mod/Thicken"

_BYTE = 255.0


@dataclass(frozen=True)
class Preference:
    """One key: the kind of number that FreeCAD stores, and the value where none is stored."""

    key: str
    kind: str  #: Int, Float, Bool, or Unsigned for a colour 0xRRGGBBAA
    start: Any


PREFERENCES = [
    Preference("Threads", "Int", 0),  # 0: all that the machine has
    Preference("MemoryMiB", "Int", 0),  # 0: no limit
    Preference("ThicknessPercent", "Float", 2.0),  # of the diagonal, for the first thickness
    Preference("Side", "Int", 0),  # as in params.SIDES
    Preference("Output", "Int", 0),  # 0: mesh, 1: Part solid
    Preference("Preview", "Bool", True),
    Preference("PreviewTriangles", "Int", 300000),  # larger surfaces are not previewed
    Preference("TimesForecast", "Float", 1.0),  # what the runs on this machine take of the library's forecast
    Preference("MinimumWall", "Float", 1.0),  # mm, of the reports
    Preference("DrainDiameter", "Float", 3.5),  # mm
    Preference("ColorOriginal", "Unsigned", 0xF2C744FF),
    Preference("ColorShell", "Unsigned", 0x4C7FD0FF),
    Preference("ColorWall", "Unsigned", 0xD9453AFF),
    Preference("ColorDefect", "Unsigned", 0xE01B84FF),
]
_BY_KEY = {preference.key: preference for preference in PREFERENCES}


def get(key: str) -> Any:
    """The stored value, or the one that it starts with."""
    preference = _BY_KEY[key]
    return getattr(App.ParamGet(PATH), f"Get{preference.kind}")(key, preference.start)


def put(key: str, value: Any) -> None:
    """Store a value."""
    getattr(App.ParamGet(PATH), f"Set{_BY_KEY[key].kind}")(key, value)


def colour(key: str) -> tuple[float, float, float]:
    """Red, green and blue, each 0 to 1."""
    number = get(key)
    return tuple((number >> shift & 0xFF) / _BYTE for shift in (24, 16, 8))
