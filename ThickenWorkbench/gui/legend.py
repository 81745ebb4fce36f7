# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scale of a thickness map with the histogram beside it, as a widget."""

from __future__ import annotations

from typing import Any

import FreeCAD as App

from ..numbers import number
from .colour_scale import colours, ticks
from .qt import QtCore, QtGui, QtWidgets

translate = App.Qt.translate

_BAR = 22  # pixels
_TEXT = 64
_MARGIN = 10


class Legend(QtWidgets.QWidget):
    """From the lowest value below to the highest above; bars show the share of the area."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("Legend")
        self.setMinimumHeight(240)
        self.setToolTip(translate("Thicken", "The longer a bar, the more of the area has this value (square roots)"))
        self._shares: Any = None
        self._low, self._high = 0.0, 1.0

    def show_shares(self, shares: Any, edges: Any) -> None:
        """Show shares of the area between one edge and the next; the scale is from the first to the last."""
        self._shares, self._edges = shares, edges
        self._low, self._high = float(edges[0]), float(edges[-1])
        self.update()

    def paintEvent(self, event: Any) -> None:
        if self._shares is None:
            return
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        self._draw_bar(painter)
        self._draw_ticks(painter)
        self._draw_histogram(painter)
        painter.end()

    def _y(self, value: float) -> float:
        share = (value - self._low) / max(self._high - self._low, 1e-300)
        return self.height() - _MARGIN - share * (self.height() - 2 * _MARGIN)

    def _draw_bar(self, painter: Any) -> None:
        gradient = QtGui.QLinearGradient(0, self._y(self._low), 0, self._y(self._high))
        for k in range(11):
            share = k / 10
            gradient.setColorAt(share, _colour(colours([share], 0, 1)[0]))
        painter.setPen(self.palette().color(QtGui.QPalette.WindowText))
        painter.setBrush(gradient)
        painter.drawRect(QtCore.QRectF(1, _MARGIN, _BAR, self.height() - 2 * _MARGIN))

    def _draw_ticks(self, painter: Any) -> None:
        painter.setPen(self.palette().color(QtGui.QPalette.WindowText))
        for value in ticks(self._low, self._high):
            y = self._y(value)
            painter.drawLine(QtCore.QPointF(_BAR, y), QtCore.QPointF(_BAR + 5, y))
            box = QtCore.QRectF(_BAR + 8, y - 10, _TEXT - 8, 20)
            painter.drawText(box, QtCore.Qt.AlignVCenter | QtCore.Qt.AlignLeft, number(value, 4))

    def _draw_histogram(self, painter: Any) -> None:
        shares, edges = self._shares, self._edges
        # By their square roots: the few per cent that are thin are what one looks for.
        lengths = shares**0.5
        most = max(float(lengths.max()), 1e-300)
        left = _BAR + _TEXT
        width = self.width() - left - 4
        painter.setPen(QtCore.Qt.NoPen)
        for length, start, end in zip(lengths, edges, edges[1:]):
            painter.setBrush(_colour(colours([(start + end) / 2], self._low, self._high)[0]).darker(110))
            top, bottom = self._y(end), self._y(start)
            painter.drawRect(QtCore.QRectF(left, top, width * float(length) / most, max(bottom - top - 1, 1)))
        painter.setPen(self.palette().color(QtGui.QPalette.Mid))
        painter.drawLine(QtCore.QPointF(left, _MARGIN), QtCore.QPointF(left, self.height() - _MARGIN))


def _colour(rgb: Any) -> Any:
    return QtGui.QColor.fromRgbF(*(float(part) for part in rgb))
