# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of texts that are legible on what a widget has behind them.

The palettes of FreeCAD's dark style sheets say nothing of links, errors or the ground: the lightness of the text decides.
"""

from __future__ import annotations

from typing import Any

from .qt import QtGui

_ON_LIGHT = {"good": "#1a7f37", "bad": "#c01c28", "link": "#0b57d0"}
_ON_DARK = {"good": "#57e389", "bad": "#ff7b72", "link": "#79b8ff"}


# A text of more than this lightness (of 255) is meant for a dark ground.
_LIGHT_TEXT = 100


def tones(widget: Any) -> dict[str, str]:
    """Names of colours for "good", "bad" and "link" in a label or a text browser."""
    text = widget.palette().color(QtGui.QPalette.WindowText)
    return _ON_DARK if text.lightness() > _LIGHT_TEXT else _ON_LIGHT
