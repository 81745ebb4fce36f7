# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt by FreeCAD's own wrapper. Before 1.0 that has no QtWidgets: QtGui carries the widgets."""

from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui

__all__ = ["QtCore", "QtGui", "QtWidgets"]
