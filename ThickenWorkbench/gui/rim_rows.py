# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of the Thicken task panel for the profile of the rim."""

from __future__ import annotations

from typing import Any, Callable

import FreeCAD as App

from .. import params
from .qt import length_box, on_value

translate = App.Qt.translate


class RimRows:
    """A field for each length of the profile; 0: none."""

    def __init__(self, rows: Any, edited: Callable[[], None]) -> None:
        labels = {
            "rim_thickness": translate("Thicken", "Rim thickness"),
            "rim_width": translate("Thicken", "Rim width"),
            "rim_round": translate("Thicken", "Rim radius"),
        }
        tips = {
            "rim_thickness": translate("Thicken", "How thick the solid is at the rim of the surface; 0: as elsewhere"),
            "rim_width": translate("Thicken", "How far from the rim the solid is as thick as elsewhere; together with the rim thickness"),
            "rim_round": translate("Thicken", "The radius of the edge between shell and wall; 0: sharp. It is as fine as the triangles at the rim"),
        }
        self.boxes = {word: length_box(0.0) for word in params.RIM}
        for word, box in self.boxes.items():
            box.setObjectName(params.RIM[word])
            box.setToolTip(tips[word])
            on_value(box, lambda _: edited())
            rows.addRow(labels[word], box)

    def inputs(self) -> dict[str, float | None]:
        """By the names and in the words of make_thicken()."""
        return {word: float(box.property("rawValue")) or None for word, box in self.boxes.items()}

    def show(self, inputs: dict[str, Any]) -> bool:
        """Show what inputs() returns; whether there is a profile."""
        for word, box in self.boxes.items():
            box.setProperty("rawValue", float(inputs.get(word) or 0))
        return any(inputs.get(word) for word in self.boxes)
