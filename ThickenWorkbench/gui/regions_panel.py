# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Thickness Regions task panel: a brush paints where a thickened solid is thicker or thinner."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from .. import build, preferences
from ..core.facets import areas_of, edges_of
from ..core.patches import Brush
from ..core.thickness_field import blended, region_weights
from ..numbers import number
from ..sources import RefusedError
from ..thickness_regions import facet_numbers, regions_on
from . import macro
from .brush_strokes import BrushStrokes
from .camera import view_of
from .colour_scale import UNKNOWN, colours
from .feature_inputs import in_mm
from .feature_panel import FeaturePanel
from .legend import Legend
from .looks import Looks
from .map_scale import area_shares, around
from .overlay import coloured_faces, faces, lines, over_object
from .qt import QtCore, QtWidgets, length_box, on_value, wrapped_label
from .run_row import RunRow

translate = App.Qt.translate

_NONE = -1  # in place of a region
_START = 1.5  # times the thickness elsewhere, of a new region
_BRUSH_SHARE = 0.04  # of the diagonal
_PAUSE_MS = 150  # after the last edit before the field is computed
_LINE, _CURRENT_LINE = 1.5, 3.0  # pixels
_OUTLINE = (0.1, 0.1, 0.1)  # unlike all colours of the scale
_LIST_HEIGHT = 90


class RegionsPanel(FeaturePanel):
    """Edits the thickness regions of a Thicken feature. Nothing is written before OK."""

    def __init__(self, feature: Any) -> None:
        self.feature, self.source = feature, feature.Source
        self.document = feature.Document
        self.objects = [self.source, feature]
        self._surface = build.surface_of(feature)
        self.base = feature.Thickness.Value
        found, problem = self._found()
        #: the region of each facet
        self.region_of = np.full(len(self._surface[1]), _NONE)
        for k, region in enumerate(found):
            self.region_of[region.facets] = k
        self.lengths = [region.thickness for region in found]  #: of the regions, mm
        self.values: Any = None  #: the thickness at each vertex, once it is there
        self._losses = [text for text in (problem, *(region.loss() for region in found)) if text]
        self._brush = Brush(*self._surface)
        self._field_node: Any = None
        # since the field was computed
        self._painted = np.zeros(len(self.region_of), bool)
        self._removed = np.zeros(len(self.region_of), bool)
        self._areas = areas_of(np.asarray(self._surface[0], float)[self._surface[1]])
        self._outlines: list[Any] = []
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._compute)
        view = view_of(self.document)
        self._build()
        Gui.Selection.clearSelection()
        self._looks = Looks([feature], [self.source])
        self._overlay = over_object(self.source)
        self._mouse = BrushStrokes(view, self.source, self)
        self._list_regions(0)
        self._compute()

    # --- what FreeCAD calls ---

    def accept(self) -> bool:
        return self.commit(translate("Thicken", "Thickness Regions"))

    def leave_view(self) -> None:
        self._timer.stop()
        self._mouse.stop()
        self._overlay.remove()
        self._looks.restore()

    # --- what the brush does ---

    def brush_radius(self) -> float:
        return float(self.radius.property("rawValue"))

    def painted(self, places: list[np.ndarray], removes: bool) -> None:
        if not self.lengths and not removes:
            self._add()
        if not self.lengths:
            return
        for place in places:
            below = self._brush.around(place, self.brush_radius())
            if removes:
                below = below[self.region_of[below] == self._current()]
            self.region_of[below] = _NONE if removes else self._current()
            self._painted[below], self._removed[below] = not removes, removes
        self._draw()

    def stroke_ended(self) -> None:
        self._list_regions(self._current())
        self._later()

    # --- within ---

    def _found(self) -> tuple[list[Any], str]:
        """The regions of the feature, or none and why: here they can be painted again."""
        try:
            return regions_on(self.feature, self._surface), ""
        except RefusedError as error:
            return [], str(error)

    def _build(self) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("RegionsPanel")
        self.form.setWindowTitle(translate("Thicken", "Thickness Regions"))
        column = QtWidgets.QVBoxLayout(self.form)
        elsewhere = translate("Thicken", "“{label}”: {thickness} mm elsewhere")
        words = elsewhere.format(label=self.feature.Label, thickness=number(self.base))
        self.list = QtWidgets.QListWidget()
        self.list.setObjectName("Regions")
        self.list.setMaximumHeight(_LIST_HEIGHT)
        self.list.currentRowChanged.connect(lambda _: self._chosen())
        buttons = QtWidgets.QHBoxLayout()
        buttons.addWidget(self._button("Add", translate("Thicken", "New region"), self._add))
        self.remove = self._button("Remove", translate("Thicken", "Remove"), self._remove)
        buttons.addWidget(self.remove)
        rows = QtWidgets.QFormLayout()
        rows.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        self.thickness = self._length(rows, "Thickness", translate("Thicken", "Thickness"), self.base)
        brush = build.suggested_thickness(self.source, _BRUSH_SHARE)
        self.radius = self._length(rows, "Radius", translate("Thicken", "Radius of the brush"), brush)
        transition = self.feature.Transition.Value if self.lengths else brush
        self.transition = self._length(rows, "Transition", translate("Thicken", "Transition"), transition)
        self.transition.setToolTip(
            translate("Thicken", "The thickness changes linearly over this distance along the surface around the regions")
        )
        on_value(self.thickness, self._set_thickness)
        on_value(self.transition, lambda _: self._later())
        self.legend = Legend()
        self.status = wrapped_label("Status")
        self.run_row = RunRow(self.stop)
        column.addWidget(wrapped_label("Elsewhere", words))
        column.addWidget(self.list)
        column.addLayout(buttons)
        column.addLayout(rows)
        for widget in (self.status, self.run_row.widget):
            column.addWidget(widget)
        column.addWidget(self.legend, 1)

    def _button(self, name: str, text: str, clicked: Any) -> Any:
        button = QtWidgets.QPushButton(text)
        button.setObjectName(name)
        button.clicked.connect(lambda *_: clicked())
        return button

    def _length(self, rows: Any, name: str, label: str, value: float) -> Any:
        box = length_box(value)
        box.setObjectName(name)
        rows.addRow(label, box)
        return box

    def _current(self) -> int:
        return self.list.currentRow()

    def _add(self) -> None:
        self.lengths.append(_START * self.base)
        self._list_regions(len(self.lengths) - 1)

    def _remove(self) -> None:
        gone = self._current()
        del self.lengths[gone]
        self.region_of[self.region_of == gone] = _NONE
        self.region_of[self.region_of > gone] -= 1
        self._list_regions(min(gone, len(self.lengths) - 1))
        self._later()

    def _set_thickness(self, length: float) -> None:
        if self._current() >= 0 and self.lengths[self._current()] != length:
            self.lengths[self._current()] = length
            self._list_regions(self._current())
            self._later()

    def _list_regions(self, current: int) -> None:
        """Show the regions with their thickness and area, and choose one."""
        text = translate("Thicken", "{number}: {thickness} mm on {area} mm²")
        self.list.blockSignals(True)
        self.list.clear()
        for k, length in enumerate(self.lengths):
            area = self._areas[self.region_of == k].sum()
            self.list.addItem(text.format(number=k + 1, thickness=number(length), area=number(area)))
        self.list.setCurrentRow(current)
        self.list.blockSignals(False)
        self._chosen()

    def _chosen(self) -> None:
        there = self._current() >= 0
        self.remove.setEnabled(there)
        self.thickness.setEnabled(there)
        if there and float(self.thickness.property("rawValue")) != self.lengths[self._current()]:
            self.thickness.setProperty("rawValue", float(self.lengths[self._current()]))
        self._tell()
        self._outline_all()
        self._draw()

    def _tell(self, problem: str = "") -> None:
        hint = translate("Thicken", "Drag over the surface to paint the region; with Shift to take away from it.")
        self.status.setText("\n".join([*self._losses, problem or hint]))

    # --- the field ---

    def _later(self) -> None:
        self._timer.start(_PAUSE_MS)

    def _regions(self) -> list[tuple[np.ndarray, float]]:
        """The facets and the thickness of those that have any."""
        found = [(np.flatnonzero(self.region_of == k), length) for k, length in enumerate(self.lengths)]
        return [(facets, length) for facets, length in found if len(facets)]

    def _compute(self) -> None:
        self.compute(self._step, self._computed, self._tell)

    def _step(self) -> Any:
        surface, base, regions = self._surface, self.base, self._regions()
        transition = float(self.transition.property("rawValue"))

        def step(context: Any) -> np.ndarray:
            weights = region_weights(*surface, [facets for facets, _ in regions], transition)
            return blended(base, [length for _, length in regions], weights)

        return step

    def _computed(self, values: np.ndarray) -> None:
        self.values = values
        self._painted[:] = self._removed[:] = False
        low, high = around(self.base, values)
        self.legend.show_shares(*area_shares(*self._surface, values[self._surface[1]].mean(axis=1), low, high))
        self._field_node = coloured_faces(*self._surface, colours(values, low, high))
        self._tell()
        self._draw()

    def _draw(self) -> None:
        """The field as it was computed last, what strokes have changed since, and the outlines of the regions."""
        nodes = [] if self._field_node is None else [self._field_node]
        vertices, triangles = self._surface
        for changed, colour in ((self._painted, preferences.colour("ColorShell")), (self._removed, UNKNOWN)):
            if changed.any():
                nodes.append(faces(vertices, triangles[changed], colour))
        self._overlay.show(*nodes, *self._outlines)

    def _outline_all(self) -> None:
        """Outline the regions as they are now: too slow for every step of a stroke."""
        vertices, triangles = self._surface
        self._outlines = []
        for k in range(len(self.lengths)):
            outline = _outline(triangles[self.region_of == k])
            if len(outline):
                width = _CURRENT_LINE if k == self._current() else _LINE
                self._outlines.append(lines(np.asarray(vertices, float)[outline], _OUTLINE, width))

    def _change(self) -> Any:
        now = build.surface_of(self.feature)
        if not all(np.array_equal(before, after) for before, after in zip(self._surface, now)):
            raise RefusedError(translate("Thicken", "The surface has changed since the panel was opened. Open it again."))
        numbers = facet_numbers(self.feature, len(self.region_of))
        regions = [(numbers[facets].tolist(), in_mm(length)) for facets, length in self._regions()]
        transition = in_mm(float(self.transition.property("rawValue")))
        macro.run(macro.call("set_thickness_regions", macro.reference(self.feature), regions, transition=transition))
        macro.run(f"{macro.DOCUMENT}.recompute()")
        return self.feature


def _outline(triangles: np.ndarray) -> np.ndarray:
    """The edges, k × 2, that only one of the triangles has."""
    found, counts = np.unique(edges_of(triangles), axis=0, return_counts=True)
    return found[counts == 1]
