# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widgets of the Thicken task panel: what they are and what they say, nothing of what happens then."""

from __future__ import annotations

from typing import Any, Callable

import FreeCAD as App

from .. import params, preferences
from ..sources import DEFAULT_DEFLECTION
from .qt import QtWidgets, length_box, on_value, wrapped_label
from .rim_rows import RimRows
from .run_row import RunRow
from .tones import tones

translate = App.Qt.translate

OUTPUTS = ["mesh", "solid"]
# In the order of the lists.
QUALITIES = ["draft", "standard", "fine", "tolerance"]
GRIDS = ["", "cell", "resolution"]
AUTOMATIC = -1


class ThickenForm:
    """All inputs of one panel. `changed` is called after each edit by the user."""

    def __init__(
        self,
        title: str,
        thickness: float,
        *,
        of_shape: bool,
        of_mesh: bool,
        edits: bool,
        changed: Callable[[], None],
        stop: Callable[[], None],
    ) -> None:
        self._changed, self._stop = changed, stop
        self.edits = edits  #: a feature that is there already
        self.complete = False  #: until then nothing is called
        self._of_shape = of_shape
        self._quiet = False
        self.widget = QtWidgets.QWidget()
        self.widget.setObjectName("ThickenPanel")
        self.widget.setWindowTitle(translate("Thicken", "Thicken"))
        column = QtWidgets.QVBoxLayout(self.widget)
        self.title = wrapped_label("Title", title)
        column.addWidget(self.title)
        self._add_region_row(column, of_mesh)
        rows = _rows()
        column.addLayout(rows)
        self._add_shape_rows(rows, thickness)
        self._add_quality_rows(rows)
        self._add_switches(column)
        self._add_advanced(column)
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
        line.addWidget(self.sharpest)
        line.addWidget(self.whole, 1)
        for widget in (self.pick, self.sharpest, self.whole):
            widget.setVisible(of_mesh)
        column.addWidget(self.pick)
        column.addLayout(line)
        self.has_region = False
        self.show_picking(False)

    def show_picking(self, picking: bool) -> None:
        """The angle belongs to picking."""
        self.sharpest.setEnabled(picking)

    def show_region(self, chosen: bool) -> None:
        """Whether a part is chosen, so that there is something to go back to all of it from."""
        self.has_region = chosen
        self.whole.setEnabled(chosen)

    def _add_shape_rows(self, rows: Any, thickness: float) -> None:
        self.thickness = _named(length_box(thickness), "Thickness")
        self.thickness.setToolTip(
            translate("Thicken", "How thick the solid is: a length with a unit, a sum, or an expression (ƒx)")
        )
        on_value(self.thickness, lambda _: self._edited())
        rows.addRow(translate("Thicken", "Thickness"), self.thickness)
        self.gap = _named(length_box(0.0), "Gap")
        self.gap.setToolTip(
            translate("Thicken", "The solid begins so far from the surface, and not at it; where there is no room it has a hole")
        )
        on_value(self.gap, lambda _: self._edited())
        rows.addRow(translate("Thicken", "Gap"), self.gap)
        self.side = self._choice("Side", [
            translate("Thicken", "Negative (behind)"),
            translate("Thicken", "Positive (in front)"),
            translate("Thicken", "Both sides"),
        ])  # fmt: skip
        self.side.setToolTip(translate("Thicken", "Where the material lies; normals point to the front. A click on the arrow in the view flips it"))
        self.flip = _named(QtWidgets.QPushButton(translate("Thicken", "Flip")), "Flip")
        self.flip.clicked.connect(self.flip_side)
        both = QtWidgets.QVBoxLayout()
        both.addWidget(self.side)
        both.addWidget(self.flip)
        rows.addRow(translate("Thicken", "Side"), both)
        self.output = self._choice("Output", [
            translate("Thicken", "Mesh"),
            translate("Thicken", "Part solid"),
        ])  # fmt: skip
        if self.edits:
            self.output.setToolTip(
                translate("Thicken", "A Part solid is an object of its own: use the command “Part Solid”")
            )
        rows.addRow(translate("Thicken", "Output"), self.output)

    def _add_quality_rows(self, rows: Any) -> None:
        self.quality = self._choice("Quality", [
            translate("Thicken", "Draft"),
            translate("Thicken", "Standard"),
            translate("Thicken", "Fine"),
            translate("Thicken", "Within a tolerance"),
        ])  # fmt: skip
        self.quality.setCurrentIndex(QUALITIES.index("standard"))
        self.quality.setToolTip(
            translate("Thicken", "How closely parts of the shell that have to be rebuilt follow the thickness; a moved copy of the surface is the same in all")
        )
        rows.addRow(translate("Thicken", "Quality"), self.quality)
        self.tolerance = _named(length_box(0.05), "Tolerance")
        self.tolerance.setToolTip(
            translate("Thicken", "The farthest that the new shell may be from where it should be; what cannot be kept is refused")
        )
        on_value(self.tolerance, lambda _: self._edited())
        rows.addRow("", self.tolerance)
        self.deflection = _named(length_box(DEFAULT_DEFLECTION), "Deflection")
        self.deflection.setToolTip(translate("Thicken", "The farthest that the triangles of a shape may be from it"))
        on_value(self.deflection, lambda _: self._edited())
        if self._of_shape:
            rows.addRow(translate("Thicken", "Deflection"), self.deflection)

    def _add_advanced(self, column: Any) -> None:
        """What only some need, folded away."""
        self.advanced = _named(QtWidgets.QCheckBox(translate("Thicken", "Advanced")), "Advanced")
        self.advanced_rows = QtWidgets.QWidget()
        self.advanced.toggled.connect(self.advanced_rows.setVisible)
        rows = _rows()
        rows.setContentsMargins(0, 0, 0, 0)
        self.advanced_rows.setLayout(rows)
        self.method = self._choice("Method", [
            translate("Thicken", "Automatic"),
            translate("Thicken", "Moved copy only"),
            translate("Thicken", "Rebuilt everywhere"),
        ])  # fmt: skip
        self.method.setToolTip(
            translate(
                "Thicken",
                "The shell is a moved copy of the surface, and rebuilt where that does not fit; or only one of the two",
            )
        )
        rows.addRow(translate("Thicken", "Method"), self.method)
        self.join = self._choice("Join", [
            translate("Thicken", "Automatic"),
            translate("Thicken", "Intersection"),
            translate("Thicken", "Arc"),
        ])  # fmt: skip
        self.join.setToolTip(
            translate("Thicken", "Outside of convex edges: sharp, as planes that meet, or rounded, which takes many more triangles")
        )
        rows.addRow(translate("Thicken", "Join"), self.join)
        self.simplify = self._choice("Simplify", [
            translate("Thicken", "Shell and walls"),
            translate("Thicken", "None"),
            translate("Thicken", "Shell only"),
        ])  # fmt: skip
        self.simplify.setToolTip(
            translate("Thicken", "Where new triangles are merged into fewer, as far as the quality allows")
        )
        rows.addRow(translate("Thicken", "Fewer triangles"), self.simplify)
        self.rim = RimRows(rows, self._edited)
        self._add_grid_rows(rows)
        self.smooth = _named(QtWidgets.QSpinBox(), "Smooth")
        self.smooth.setRange(AUTOMATIC, 100)
        self.smooth.setValue(AUTOMATIC)
        self.smooth.setSpecialValueText(translate("Thicken", "Automatic"))
        self.smooth.setToolTip(translate("Thicken", "Rounds of shape optimisation of the new surface"))
        self.smooth.valueChanged.connect(lambda _: self._edited())
        rows.addRow(translate("Thicken", "Smoothing"), self.smooth)
        column.addWidget(self.advanced)
        column.addWidget(self.advanced_rows)
        self.advanced_rows.setVisible(False)

    def _add_grid_rows(self, rows: Any) -> None:
        self.grid = self._choice("Grid", [
            translate("Thicken", "By the quality"),
            translate("Thicken", "Cell width"),
            translate("Thicken", "Resolution"),
        ])  # fmt: skip
        self.grid.setToolTip(translate("Thicken", "The grid in which parts of the shell are rebuilt"))
        rows.addRow(translate("Thicken", "Grid"), self.grid)
        self.length = _named(length_box(0.25), "QualityLength")
        self.length.setToolTip(translate("Thicken", "Below half of the thickness: in larger cells both sides of the wall could meet"))
        on_value(self.length, lambda _: self._edited())
        self.cells = _named(QtWidgets.QSpinBox(), "QualityCells")
        self.cells.setRange(8, 4096)
        self.cells.setValue(128)
        self.cells.setToolTip(translate("Thicken", "Cells along the longest side"))
        self.cells.valueChanged.connect(lambda _: self._edited())
        both = QtWidgets.QVBoxLayout()
        both.addWidget(self.length)
        both.addWidget(self.cells)
        rows.addRow("", both)

    def _add_switches(self, column: Any) -> None:
        self.repair = self._switch("Repair", translate("Thicken", "Repair a defective surface first"), False)
        self.preview = self._switch("Preview", translate("Thicken", "Preview"), preferences.get("Preview"))
        column.addWidget(self.repair)
        column.addWidget(self.preview)

    def _add_run_rows(self, column: Any) -> None:
        self.forecast = wrapped_label("Forecast")
        self.status = wrapped_label("Status")
        for widget in (self.forecast, self.status):
            column.addWidget(widget)
        self.run_row = RunRow(self._stop)
        column.addWidget(self.run_row.widget)
        self.complete = True
        self.show_running(False)

    # --- what the inputs are ---

    def inputs(self) -> dict[str, Any]:
        """By the names and in the words of make_thicken()."""
        return {
            "thickness": float(self.thickness.property("rawValue")),
            "side": params.SIDES[self.side.currentIndex()].lower(),
            "method": params.METHODS[self.method.currentIndex()].lower(),
            "join": params.JOINS[self.join.currentIndex()].lower() if self.join.currentIndex() else None,
            "simplify": params.SIMPLIFY[self.simplify.currentIndex()].lower() if self.simplify.currentIndex() else None,
            **self._quality(),
            "smooth": None if self.smooth.value() == AUTOMATIC else self.smooth.value(),
            "repair": self.repair.isChecked(),
            "gap": float(self.gap.property("rawValue")) or None,
            **self.rim.inputs(),
            "deflection": float(self.deflection.property("rawValue")) if self._of_shape else None,
        }

    def _quality(self) -> dict[str, Any]:
        """The argument of make_thicken() that says how fine, if it is not the standard."""
        if self.grid.currentIndex() > 0:
            grid = GRIDS[self.grid.currentIndex()]
            return {grid: self.cells.value() if grid == "resolution" else float(self.length.property("rawValue"))}
        word = QUALITIES[self.quality.currentIndex()]
        if word == "tolerance":
            return {word: float(self.tolerance.property("rawValue"))}
        return {} if word == "standard" else {"quality": word}

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
        self.join.setCurrentIndex([join.lower() for join in params.JOINS].index(inputs.get("join") or "automatic"))
        self.simplify.setCurrentIndex([word.lower() for word in params.SIMPLIFY].index(inputs.get("simplify") or "auto"))
        self.show_quality(inputs)
        smooth = inputs.get("smooth")
        self.smooth.setValue(AUTOMATIC if smooth is None else smooth)
        self.repair.setChecked(bool(inputs.get("repair")))
        self.gap.setProperty("rawValue", float(inputs.get("gap") or 0))
        if self.rim.show(inputs):
            self.advanced.setChecked(True)
        if self._of_shape:
            self.deflection.setProperty("rawValue", float(inputs["deflection"]))
        self._quiet = False
        self._show_number()

    def show_quality(self, inputs: dict[str, Any]) -> None:
        """Show what _quality() returns."""
        self.quality.setCurrentIndex(QUALITIES.index("tolerance" if "tolerance" in inputs else inputs.get("quality", "standard")))
        self.grid.setCurrentIndex(next((k for k, name in enumerate(GRIDS) if name in inputs), 0))
        for name, field in (("tolerance", self.tolerance), ("cell", self.length)):
            if name in inputs:
                field.setProperty("rawValue", inputs[name])
        if "resolution" in inputs:
            self.cells.setValue(inputs["resolution"])
        words = inputs.get("join") or inputs.get("simplify")
        if self.grid.currentIndex() or inputs["method"] != "auto" or words or inputs.get("smooth") is not None:
            self.advanced.setChecked(True)

    def start_with(self, side: int, output: int) -> None:
        """Show the preferred choices, without calling `changed`."""
        self._quiet = True
        self.side.setCurrentIndex(side)
        self.output.setCurrentIndex(output)
        self._quiet = False

    def flip_side(self) -> None:
        """The other side; both sides become the negative one."""
        self.side.setCurrentIndex(1 if self.side.currentIndex() == 0 else 0)

    # --- what the panel tells ---

    def show_running(self, running: bool) -> None:
        """Progress and its button belong to a run, and nothing can be edited while it lasts."""
        self.run_row.show_running(running)
        inputs = (self.pick, self.thickness, self.gap, self.side, self.flip, self.method, self.join, self.simplify, self.quality,
                  self.tolerance, self.grid, self.length, self.cells, self.smooth, self.deflection, self.repair, self.preview)  # fmt: skip
        for widget in (*inputs, *self.rim.boxes.values()):
            widget.setEnabled(not running)
        self.output.setEnabled(not running and not self.edits)
        self.whole.setEnabled(not running and self.has_region)

    def tell(self, text: str, bad: bool = False) -> None:
        self.status.setText(text)
        self.status.setStyleSheet(f"color: {tones(self.title)['bad']}" if bad else "")

    # --- within ---

    def _choice(self, name: str, words: list[str]) -> Any:
        box = _named(QtWidgets.QComboBox(), name)
        box.addItems(words)
        # Long words must not widen the whole panel.
        box.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        box.setMinimumContentsLength(8)
        box.currentIndexChanged.connect(lambda _: self._edited())
        return box

    def _switch(self, name: str, text: str, on: bool) -> Any:
        box = _named(QtWidgets.QCheckBox(text), name)
        box.setChecked(on)
        box.toggled.connect(lambda _: self._edited())
        return box

    def _edited(self) -> None:
        if not self._quiet and self.complete:
            self._show_number()
            self._changed()

    def _show_number(self) -> None:
        grid = GRIDS[self.grid.currentIndex()]
        self.quality.setEnabled(grid == "")  # the grid decides
        self.tolerance.setVisible(grid == "" and QUALITIES[self.quality.currentIndex()] == "tolerance")
        self.length.setVisible(grid == "cell")
        self.cells.setVisible(grid == "resolution")


def _named(widget: Any, name: str) -> Any:
    widget.setObjectName(name)
    return widget


def _rows() -> Any:
    """Rows of fields that go below their names where the panel is narrow."""
    rows = QtWidgets.QFormLayout()
    rows.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
    return rows
