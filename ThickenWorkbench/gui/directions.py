# SPDX-License-Identifier: LGPL-2.1-or-later
"""The direction that a part is printed in, as a field of a task panel."""

from __future__ import annotations

from typing import Any

import FreeCAD as App

from .qt import QtWidgets

translate = App.Qt.translate

AXES = [(0, 0, 1), (0, 0, -1), (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)]


def direction_box() -> Any:
    """A list of the axes; direction() reads it."""
    box = QtWidgets.QComboBox()
    box.setObjectName("Direction")
    box.addItems(["+Z", "−Z", "+X", "−X", "+Y", "−Y"])
    box.setToolTip(translate("Thicken", "The direction in which the part grows while it is printed"))
    return box


def direction(box: Any) -> tuple[int, int, int]:
    return AXES[box.currentIndex()]
