# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Check Surface task panel: lists and marks every defect, and goes to the one that is clicked."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from .. import numbers, preferences
from ..check_surface import check_step
from ..sources import bound_box
from . import macro
from .camera import go_to, view_of
from .chosen import Chosen
from .defect_places import Place, kind_name, places
from .overlay import faces, lines, over_view, points
from .panel import Panel
from .qt import QtCore, QtWidgets, wrapped_label
from .run_row import RunRow, stopped_text

translate = App.Qt.translate

# So much of the diagonal is shown around a defect.
_AROUND = 0.06


class CheckPanel(Panel):
    """Changes nothing in the document."""

    def __init__(self, item: Chosen) -> None:
        self.item = item
        self.defects: list[Any] | None = None  #: None until they are known
        self.document = item.source.Document
        self.objects = [item.source]
        self._view = view_of(self.document)
        self._overlay = over_view(self._view)
        self._least = _AROUND * bound_box(item.source).DiagonalLength
        self._build()
        Gui.Selection.clearSelection()
        named = {name: value for name, value in item.named().items() if value is not None}
        self.compute(lambda: check_step(item.source, **named), self._checked, self._failed)

    def leave_view(self) -> None:
        self._overlay.remove()

    def _build(self) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("CheckPanel")
        self.form.setWindowTitle(translate("Thicken", "Check Surface"))
        column = QtWidgets.QVBoxLayout(self.form)
        self.status = wrapped_label("Status", translate("Thicken", "Checking …"))
        self.list = QtWidgets.QTreeWidget()
        self.list.setObjectName("Defects")
        self.list.setHeaderHidden(True)
        self.list.setMinimumHeight(260)
        self.list.itemClicked.connect(lambda row, _: self.go(row))
        self.list.itemActivated.connect(lambda row, _: self.go(row))
        self.sentence = wrapped_label("Sentence")
        self.repair = QtWidgets.QPushButton(translate("Thicken", "Repair Surface"))
        self.repair.setObjectName("Repair")
        self.repair.setVisible(False)
        self.repair.clicked.connect(self._repair)
        self.run_row = RunRow(self.stop)
        for widget in (self.status, self.run_row.widget, self.list, self.sentence, self.repair):
            column.addWidget(widget)

    def _failed(self, sentences: str) -> None:
        self.status.setText(sentences or stopped_text())

    def _checked(self, defects: list[Any]) -> None:
        self.defects = defects
        macro.record("defects", self.defects, "check_surface", self.item.source, **self.item.named())
        label = self.item.source.Label
        if not self.defects:
            sound = translate("Thicken", "“{label}” can be thickened: it has no defect.")
            self.status.setText(sound.format(label=label))
            self.list.setVisible(False)
            return
        count = sum(defect.count for defect in self.defects)
        found = translate("Thicken", "“{label}” has {count} defects. Click one to go there.")
        self.status.setText(found.format(label=label, count=numbers.count(count)))
        self.repair.setVisible(True)
        self._fill()
        self._mark()

    def _repair(self) -> None:
        """Close the panel, and make a mended copy instead."""
        self.reject()
        Gui.Control.closeDialog()
        from .repairing import repair

        repair([self.item.source])

    def _fill(self) -> None:
        for defect in self.defects or []:
            kind = QtWidgets.QTreeWidgetItem(self.list, [f"{kind_name(defect.code)} ({numbers.count(defect.count)})"])
            found = places(defect)
            everything = np.concatenate([place.corners for place in found])
            kind.setData(0, QtCore.Qt.UserRole, (defect.sentence, everything))
            for place in found:
                row = QtWidgets.QTreeWidgetItem(kind, [place.name])
                row.setToolTip(0, place.name)  # a narrow panel cuts it off
                row.setData(0, QtCore.Qt.UserRole, (defect.sentence, place.corners))
            kind.setExpanded(True)

    def go(self, row: Any) -> None:
        """Look at the defects of a row, and say what is wrong with them."""
        sentence, corners = row.data(0, QtCore.Qt.UserRole)
        self.sentence.setText(sentence)
        go_to(self._view, corners, self._least)
        self._mark(Place("", np.asarray(corners)))

    def _mark(self, chosen: Place | None = None) -> None:
        """Mark all defects, and the chosen one with larger dots."""
        colour = preferences.colour("ColorDefect")
        nodes = []
        for defect in self.defects or []:
            if len(defect.triangles):
                corners = np.asarray(defect.triangles, float)
                nodes.append(faces(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3), colour))
                nodes.append(lines(np.stack([corners, np.roll(corners, -1, 1)], 2).reshape(-1, 2, 3), colour, 1.5))
            if len(defect.edges):
                nodes.append(lines(defect.edges, colour))
            if len(defect.vertices):
                nodes.append(points(defect.vertices, colour))
            nodes.append(points([tuple(defect.place)], colour))
        if chosen is not None:
            nodes.append(points(chosen.corners, colour, size=13.0))
        self._overlay.show(*nodes)
