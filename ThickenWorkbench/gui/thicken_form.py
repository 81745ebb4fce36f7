# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widgets of the Thicken task panel: what they are and what they say, nothing of what happens then."""

from __future__ import annotations

from typing import Any, Callable

import FreeCAD as App

from .. import params, preferences
from ..sources import DEFAULT_DEFLECTION
from .qt import QtCore, QtWidgets, length_box, on_value

translate = App.Qt.translate

OUTPUTS = ["mesh", "solid"]
AUTOMATIC = -1


class ThickenForm:
    """All inputs of one panel. `changed` is called after each edit by the user."""

    def __init__(
        self, title: str, thickness: float, of_shape: bool, of_mesh: bool, changed: Callable[[], None]
    ) -> None:
        self._changed = changed
        self._of_shape = of_shape
        self._quiet = False
        self.widget = QtWidgets.QWidget()
        self.widget.setObjectName("ThickenPanel")
        self.widget.setWindowTitle(translate("Thicken", "Thicken"))
        column = QtWidgets.QVBoxLayout(self.widget)
        self.title = _named(_label(title), "Title")
        column.addWidget(self.title)
        self._add_region_row(column, of_mesh)
        rows = QtWidgets.QFormLayout()
        column.addLayout(rows)
        self._add_shape_rows(rows, thickness)
        self._add_quality_rows(rows)
        self._add_switches(column)
        self._add_run_rows(column)
        column.addStretch()
        self._show_number()

    def _add_region_row(self, column: Any, of_mesh: bool) -> None:
        self.pick = _named(QtWidgets.QPushButton(translate("Thicken", "Pick a region")), "Pick")
        self.pick.setCheckable(True)
        self.pick.setToolTip(
            translate(
                "Thicken", "Thicken a part of the mesh: each click in the view adds a smooth patch, or takes it away"
            )
        )
        self.sharpest = _named(QtWidgets.QSpinBox(), "Sharpest")
        self.sharpest.setRange(1, 180)
        self.sharpest.setValue(20)
        self.sharpest.setSuffix("°")
        self.sharpest.setToolTip(translate("Thicken", "A patch ends where the surface turns by more than this"))
        self.whole = _named(QtWidgets.QPushButton(translate("Thicken", "All of it")), "Whole")
        line = QtWidgets.QHBoxLayout()
        for widget in (self.pick, self.sharpest, self.whole):
            line.addWidget(widget)
            widget.setVisible(of_mesh)
        column.addLayout(line)
        self.show_picking(False)

    def show_picking(self, picking: bool) -> None:
        """The angle belongs to picking."""
        self.sharpest.setEnabled(picking)

    def _add_shape_rows(self, rows: Any, thickness: float) -> None:
        self.thickness = _named(length_box(thickness), "Thickness")
        self.thickness.setToolTip(
            translate("Thicken", "How thick the solid is: a length with a unit, a sum, or an expression (ƒx)")
        )
        on_value(self.thickness, lambda _: self._edited())
        rows.addRow(translate("Thicken", "Thickness"), self.thickness)
        self.side = self._choice("Side", [
            translate("Thicken", "Negative: behind the surface"),
            translate("Thicken", "Positive: where the normals point"),
            translate("Thicken", "Both: the surface is the middle"),
        ])  # fmt: skip
        self.side.setToolTip(translate("Thicken", "Where the material lies; a click on the arrow in the view flips it"))
        self.flip = _named(QtWidgets.QPushButton(translate("Thicken", "Flip")), "Flip")
        self.flip.clicked.connect(self.flip_side)
        line = QtWidgets.QHBoxLayout()
        line.addWidget(self.side, 1)
        line.addWidget(self.flip)
        rows.addRow(translate("Thicken", "Side"), line)
        self.output = self._choice("Output", [
            translate("Thicken", "Mesh"),
            translate("Thicken", "Part solid"),
        ])  # fmt: skip
        rows.addRow(translate("Thicken", "Output"), self.output)

    def _add_quality_rows(self, rows: Any) -> None:
        self.method = self._choice("Method", [
            translate("Thicken", "Automatic"),
            translate("Thicken", "Sweep"),
            translate("Thicken", "Reconstruct"),
        ])  # fmt: skip
        rows.addRow(translate("Thicken", "Method"), self.method)
        self.quality = self._choice("Quality", [
            translate("Thicken", "Automatic"),
            translate("Thicken", "Cell width"),
            translate("Thicken", "Resolution"),
            translate("Thicken", "Tolerance"),
        ])  # fmt: skip
        rows.addRow(translate("Thicken", "Quality"), self.quality)
        self.length = _named(length_box(0.25), "QualityLength")
        on_value(self.length, lambda _: self._edited())
        self.cells = _named(QtWidgets.QSpinBox(), "QualityCells")
        self.cells.setRange(8, 4096)
        self.cells.setValue(128)
        self.cells.valueChanged.connect(lambda _: self._edited())
        both = QtWidgets.QVBoxLayout()
        both.addWidget(self.length)
        both.addWidget(self.cells)
        rows.addRow("", both)
        self.smooth = _named(QtWidgets.QSpinBox(), "Smooth")
        self.smooth.setRange(AUTOMATIC, 100)
        self.smooth.setValue(AUTOMATIC)
        self.smooth.setSpecialValueText(translate("Thicken", "Automatic"))
        self.smooth.setToolTip(translate("Thicken", "Rounds of shape optimisation of the new surface"))
        self.smooth.valueChanged.connect(lambda _: self._edited())
        rows.addRow(translate("Thicken", "Smoothing"), self.smooth)
        self.deflection = _named(length_box(DEFAULT_DEFLECTION), "Deflection")
        self.deflection.setToolTip(translate("Thicken", "The farthest that the triangles of a shape may be from it"))
        on_value(self.deflection, lambda _: self._edited())
        if self._of_shape:
            rows.addRow(translate("Thicken", "Deflection"), self.deflection)

    def _add_switches(self, column: Any) -> None:
        self.repair = self._switch("Repair", translate("Thicken", "Repair a defective surface first"), False)
        self.preview = self._switch("Preview", translate("Thicken", "Preview"), preferences.get("Preview"))
        column.addWidget(self.repair)
        column.addWidget(self.preview)

    def _add_run_rows(self, column: Any) -> None:
        self.forecast = _named(_label(""), "Forecast")
        self.status = _named(_label(""), "Status")
        self.progress = _named(QtWidgets.QProgressBar(), "Progress")
        self.progress.setRange(0, 1000)
        self.stop = _named(QtWidgets.QPushButton(translate("Thicken", "Stop")), "Stop")
        line = QtWidgets.QHBoxLayout()
        line.addWidget(self.progress, 1)
        line.addWidget(self.stop)
        for widget in (self.forecast, self.status):
            column.addWidget(widget)
        column.addLayout(line)
        self.show_running(False)

    # --- what the inputs are ---

    def inputs(self) -> dict[str, Any]:
        """By the names and in the words of make_thicken()."""
        quality = list(params.QUALITY_NUMBER)[self.quality.currentIndex()]
        number = self.cells.value() if quality == "Resolution" else self.length.property("rawValue")
        return {
            "thickness": float(self.thickness.property("rawValue")),
            "side": params.SIDES[self.side.currentIndex()].lower(),
            "method": params.METHODS[self.method.currentIndex()].lower(),
            **({} if quality == "Automatic" else {quality.lower(): number}),
            "smooth": None if self.smooth.value() == AUTOMATIC else self.smooth.value(),
            "repair": self.repair.isChecked(),
            "deflection": float(self.deflection.property("rawValue")) if self._of_shape else None,
        }

    def output_word(self) -> str:
        return OUTPUTS[self.output.currentIndex()]

    def expression(self) -> str:
        """The expression that the thickness is bound to, or no text."""
        return str(self.thickness.property("expression") or "")

    def set_inputs(self, inputs: dict[str, Any]) -> None:
        """Show inputs, without calling `changed`."""
        self._quiet = True
        self.thickness.setProperty("rawValue", float(inputs["thickness"]))
        self.side.setCurrentIndex([side.lower() for side in params.SIDES].index(inputs["side"]))
        self.method.setCurrentIndex([method.lower() for method in params.METHODS].index(inputs["method"]))
        for index, name in enumerate(params.QUALITY_NUMBER):
            if name.lower() in inputs:
                self.quality.setCurrentIndex(index)
                number = inputs[name.lower()]
                if name == "Resolution":
                    self.cells.setValue(number)
                else:
                    self.length.setProperty("rawValue", number)
        smooth = inputs.get("smooth")
        self.smooth.setValue(AUTOMATIC if smooth is None else smooth)
        self.repair.setChecked(bool(inputs.get("repair")))
        if self._of_shape:
            self.deflection.setProperty("rawValue", float(inputs["deflection"]))
        self._quiet = False
        self._show_number()

    def flip_side(self) -> None:
        """The other side; both sides become the negative one."""
        self.side.setCurrentIndex(1 if self.side.currentIndex() == 0 else 0)

    # --- what the panel tells ---

    def show_running(self, running: bool) -> None:
        """Progress and its button belong to a run, and nothing can be edited while it lasts."""
        self.progress.setVisible(running)
        self.stop.setVisible(running)
        inputs = (self.pick, self.whole, self.thickness, self.side, self.flip, self.method, self.quality, self.length,
                  self.cells, self.smooth, self.deflection, self.repair, self.preview)  # fmt: skip
        for widget in inputs:
            widget.setEnabled(not running)

    def tell(self, text: str, bad: bool = False) -> None:
        self.status.setText(text)
        self.status.setStyleSheet("color: #c01c28" if bad else "")

    # --- within ---

    def _choice(self, name: str, words: list[str]) -> Any:
        box = _named(QtWidgets.QComboBox(), name)
        box.addItems(words)
        # Long words must not widen the whole panel.
        box.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        box.setMinimumContentsLength(12)
        box.currentIndexChanged.connect(lambda _: self._edited())
        return box

    def _switch(self, name: str, text: str, on: bool) -> Any:
        box = _named(QtWidgets.QCheckBox(text), name)
        box.setChecked(on)
        box.toggled.connect(lambda _: self._edited())
        return box

    def _edited(self) -> None:
        if not self._quiet and hasattr(self, "stop"):
            self._show_number()
            self._changed()

    def _show_number(self) -> None:
        quality = list(params.QUALITY_NUMBER)[self.quality.currentIndex()]
        self.length.setVisible(quality in ("Cell", "Tolerance"))
        self.cells.setVisible(quality == "Resolution")


def _named(widget: Any, name: str) -> Any:
    widget.setObjectName(name)
    return widget


def _label(text: str) -> Any:
    label = QtWidgets.QLabel(text)
    label.setWordWrap(True)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    return label
