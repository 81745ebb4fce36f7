# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt by FreeCAD's own wrapper, and all that differs between its versions.

FreeCAD before 1.0 has no PySide.QtWidgets: QtGui carries the widgets. FreeCAD 1.x may be built with
Qt 5 or Qt 6.
"""

from __future__ import annotations

from typing import Any, Callable

import FreeCADGui as Gui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui

__all__ = ["QtCore", "QtGui", "QtWidgets", "length_box", "on_value", "run_dialog", "standard_buttons", "wrapped_label"]


def run_dialog(dialog: Any) -> int:
    """Show a modal dialog and wait: Qt 6 has no exec_()."""
    return dialog.exec() if hasattr(dialog, "exec") else dialog.exec_()


def standard_buttons(*names: str) -> Any:
    """Flags for a task panel. As they are: Qt 6 cannot make an int of them."""
    flags = getattr(QtWidgets.QDialogButtonBox, names[0])
    for name in names[1:]:
        flags |= getattr(QtWidgets.QDialogButtonBox, name)
    return flags


class _WrappedLabel(QtWidgets.QLabel):
    """Asks for the height that its words take at its width: a panel gives no more than is asked for, and what stands above them would be squeezed."""

    def minimumSizeHint(self) -> Any:
        size = super().minimumSizeHint()
        size.setHeight(max(size.height(), self.heightForWidth(self.width())))
        return size

    def resizeEvent(self, event: Any) -> None:
        super().resizeEvent(event)
        self.updateGeometry()


def wrapped_label(name: str, text: str = "") -> Any:
    """Words over as many lines as they take, which can be marked and copied."""
    label = _WrappedLabel(text)
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    return label


def length_box(value: float, minimum: float = 0.0) -> Any:
    """FreeCAD's own field for a length in mm, which understands units and, once bound, expressions."""
    box = Gui.UiLoader().createWidget("Gui::QuantitySpinBox")
    box.setProperty("unit", "mm")
    box.setProperty("minimum", minimum)
    box.setProperty("keyboardTracking", True)
    box.setProperty("rawValue", float(value))  # "value" would want a Quantity and give 0 for a number
    return box


def on_value(box: Any, slot: Callable[[float], None]) -> None:
    """Call `slot` with mm when a length_box() changes: its signals are C++ only, so connected by name."""
    QtCore.QObject.connect(box, QtCore.SIGNAL("valueChanged(double)"), slot)
