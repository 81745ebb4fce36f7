# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a mended surface: what may be joined, and what was changed, in words and in colours."""

from __future__ import annotations

from typing import Any

import FreeCAD as App

from ..repair_feature import Joins, repair_step, sentences
from ..sources import surface_arrays
from . import macro
from .feature_panel import FeaturePanel
from .overlay import over_object
from .qt import QtCore, QtWidgets, length_box, on_value, wrapped_label
from .repair_marks import key, marks
from .run_row import RunRow, stopped_text

translate = App.Qt.translate

_WAIT_MS = 400  # after the last key before a preview is computed


class RepairPanel(FeaturePanel):
    """Edits a repair feature, and previews what it will do. Nothing is written before OK."""

    def __init__(self, feature: Any) -> None:
        self.feature = feature
        self.document = feature.Document
        self.objects = [feature, feature.Source]
        self._overlay = over_object(feature)
        self._surface: Any = None
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self.preview)
        self._build()
        self.preview()

    def _build(self) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("RepairPanel")
        self.form.setWindowTitle(translate("Thicken", "Repair Surface"))
        column = QtWidgets.QVBoxLayout(self.form)
        self.automatic = QtWidgets.QCheckBox(translate("Thicken", "Weld corners of rims automatically"))
        self.automatic.setObjectName("WeldAutomatically")
        self.automatic.setChecked(self.feature.WeldAutomatically)
        self.weld = self._length("Weld", translate("Thicken", "The farthest that rims may be apart to be joined"))
        self.weld.setEnabled(not self.feature.WeldAutomatically)
        self.automatic.toggled.connect(lambda on: self.weld.setEnabled(not on))
        self.automatic.toggled.connect(self._later)
        self.bridge = self._length(
            "Bridge", translate("Thicken", "The widest gap between rims to be closed by a strip of triangles; 0: none")
        )
        self.fill = self._length(
            "FillHoles", translate("Thicken", "Rims that are shorter than this are closed by a patch; 0: none")
        )
        rows = QtWidgets.QFormLayout()
        rows.addRow(self.automatic)
        rows.addRow(translate("Thicken", "Join rims within"), self.weld)
        rows.addRow(translate("Thicken", "Bridge gaps up to"), self.bridge)
        rows.addRow(translate("Thicken", "Fill holes with a rim below"), self.fill)
        self.legend = QtWidgets.QLabel(" &nbsp; ".join(_coloured(word, colour) for word, colour in key()))
        self.status = wrapped_label("Status", "\n".join(self.feature.Changes) or _nothing())
        self.run_row = RunRow(self.stop)
        column.addLayout(rows)
        for widget in (self.run_row.widget, self.legend, self.status):
            column.addWidget(widget)
        column.addStretch()

    def _length(self, name: str, tip: str) -> Any:
        box = length_box(getattr(self.feature, name).Value)
        box.setObjectName(name)
        box.setToolTip(tip)
        on_value(box, self._later)
        return box

    def _later(self, *_: Any) -> None:
        self._timer.start(_WAIT_MS)

    def joins(self) -> Joins:
        """What the fields ask for."""
        lengths = [float(box.property("rawValue")) for box in (self.weld, self.bridge, self.fill)]
        return Joins(None if self.automatic.isChecked() else lengths[0], *lengths[1:])

    def preview(self) -> None:
        """Compute what the repair would do, and show it."""

        def make_step() -> Any:
            self._surface = surface_arrays(self.feature.Source)
            return repair_step(self.feature.Source, self.joins())

        self.compute(make_step, self._previewed, self._failed)

    def _previewed(self, mended: Any) -> None:
        told = "\n".join(sentences(mended.report))
        self.status.setText(told or _nothing())
        self._overlay.show(*marks(self._surface, mended))

    def _failed(self, text: str) -> None:
        self.status.setText(text or stopped_text())
        self._overlay.show()

    def accept(self) -> bool:
        """Change the feature. Its recompute shows progress and can be stopped."""
        self._timer.stop()
        self.abandon()
        joins, reference = self.joins(), macro.reference(self.feature)
        self.document.openTransaction(translate("Thicken", "Repair surface"))
        macro.run(f"{reference}.WeldAutomatically = {self.automatic.isChecked()}")
        if joins.weld is not None:
            macro.run(f"{reference}.Weld = '{joins.weld:.9g} mm'")
        macro.run(f"{reference}.Bridge = '{joins.bridge:.9g} mm'")
        macro.run(f"{reference}.FillHoles = '{joins.fill_holes:.9g} mm'")
        macro.run(f"{macro.DOCUMENT}.recompute()")
        if not self.feature.isValid():
            self.status.setText(self.feature.getStatusString())
            self.document.abortTransaction()
            self.document.recompute()
            return False
        self.document.commitTransaction()
        return self.reject()

    def leave_view(self) -> None:
        self._timer.stop()
        self._overlay.remove()


def _nothing() -> str:
    return translate("Thicken", "There was nothing to mend.")


def _coloured(word: str, colour: tuple[float, float, float]) -> str:
    red, green, blue = (round(255 * part) for part in colour)
    return f'<span style="color:#{red:02x}{green:02x}{blue:02x}">\u25a0</span> {word}'
