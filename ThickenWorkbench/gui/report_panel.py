# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Printability Report task panel: shows the facts about a solid, and saves them with pictures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from .. import preferences, runs
from ..placed import linked_and_placement
from ..printability import Measured, report_step
from ..report_page import write_measured
from ..sources import bound_box
from . import macro, messages
from .camera import go_to, view_of
from .directions import direction, direction_box
from .files import ask_target
from .overlay import over_view, points
from .panel import Panel
from .qt import QtCore, QtWidgets, length_box, on_value, wrapped_label
from .run_row import RunRow, stopped_text
from .report_summary import place_of, summary
from .tones import tones

translate = App.Qt.translate

_PAUSE_MS = 300

# So much of the diagonal is shown around a place.
_AROUND = 0.15


class ReportPanel(Panel):
    """Changes nothing in the document."""

    def __init__(self, solid: Any) -> None:
        self.solid = solid
        self.report: Any = None  #: of the inputs that are shown; None while it is computed
        self.measured: Measured | None = None  #: what the report and its page are made from
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._compute)
        self.document = solid.Document
        self.objects = [solid]
        self._diagonal = bound_box(linked_and_placement(solid)[0]).DiagonalLength
        self._view = view_of(self.document)
        self._overlay = over_view(self._view)
        self._build()
        Gui.Selection.clearSelection()
        self._edited()

    def leave_view(self) -> None:
        self._timer.stop()
        self._overlay.remove()

    def go(self, link: Any) -> None:
        """Go to the place that a link of the summary names."""
        place = place_of(link.toString())
        go_to(self._view, place, _AROUND * self._diagonal)
        self._overlay.show(points([place], preferences.colour("ColorDefect"), 12.0))

    def _build(self) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("ReportPanel")
        self.form.setWindowTitle(translate("Thicken", "Printability Report"))
        column = QtWidgets.QVBoxLayout(self.form)
        rows = QtWidgets.QFormLayout()
        rows.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        column.addLayout(rows)
        self.direction = direction_box()
        self.direction.currentIndexChanged.connect(lambda _: self._edited())
        rows.addRow(translate("Thicken", "Printed towards"), self.direction)
        self.minimum = length_box(preferences.get("MinimumWall"), minimum=0.01)
        self.minimum.setObjectName("Minimum")
        on_value(self.minimum, lambda _: self._edited())
        rows.addRow(translate("Thicken", "Thinnest wall that prints"), self.minimum)
        self.facts = QtWidgets.QTextBrowser()
        self.facts.setOpenLinks(False)
        self.facts.anchorClicked.connect(self.go)
        self.facts.setObjectName("Facts")
        self.facts.setMinimumHeight(320)
        self.run_row = RunRow(self.stop)
        column.addWidget(self.run_row.widget)
        column.addWidget(self.facts, 1)
        self.save = QtWidgets.QPushButton(translate("Thicken", "Save..."))
        self.save.setObjectName("Save")
        self.save.clicked.connect(self._save)
        column.addWidget(self.save)
        self.saved = wrapped_label("Saved")
        column.addWidget(self.saved)

    def _inputs(self) -> dict[str, Any]:
        return {
            "direction": direction(self.direction),
            "minimum_wall": round(float(self.minimum.property("rawValue")), 9),
        }

    def _edited(self) -> None:
        self.abandon()
        self.report = self.measured = None
        self.saved.clear()
        self._overlay.show()
        self.save.setEnabled(False)
        self.facts.setPlainText(translate("Thicken", "Measuring …"))
        self._timer.start(_PAUSE_MS)

    def _compute(self) -> None:
        inputs = self._inputs()
        self.compute(lambda: report_step(self.solid, **inputs), self._computed, self._failed)

    def _failed(self, sentences: str) -> None:
        self.facts.setPlainText(sentences or stopped_text())

    def _computed(self, found: Measured) -> None:
        self.measured, self.report = found, found.facts
        macro.record("report", self.report, "printability", self.solid, **self._inputs())
        self.facts.setHtml(summary(self.report, tones(self.facts)))
        self.save.setEnabled(True)

    def _save(self) -> None:
        name = ask_target(
            self.solid,
            translate("Thicken", "Save the report"),
            ".html",
            [translate("Thicken", "Page with pictures (*.html)"), translate("Thicken", "Data (*.json)")],
        )
        if not name:
            return
        try:
            runs.run(lambda context: write_measured(self.measured, name, context))
        except runs.CancelledError:
            self.saved.setText(stopped_text())
            return
        except OSError as error:
            messages.warn(translate("Thicken", "Nothing was written"), str(error))
            return
        macro.record("report", self.report, "write_report", self.solid, name, **self._inputs())
        self.saved.setText(_told(Path(name)))


def _told(path: Path) -> str:
    """What was written."""
    if path.suffix.lower() == ".json":
        return translate("Thicken", "Written: {path}").format(path=path)
    both = translate("Thicken", "Written: {path}, and the same facts as data in {data}")
    return both.format(path=path, data=path.with_suffix(".json").name)
