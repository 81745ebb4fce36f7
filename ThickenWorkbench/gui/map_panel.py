# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Thickness Map task panel: colours a solid by a measured length, with scale and histogram."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from .. import preferences
from ..numbers import number
from ..thickness_map import map_step
from . import macro
from .camera import go_to, view_of
from .chosen import is_thicken
from .colour_scale import colours
from .legend import Legend
from .map_scale import asked_thickness, ends, shares
from .overlay import over_view, points
from .panel import Panel
from .qt import QtWidgets, wrapped_label
from .region_colours import paint_plain, paint_points
from .run_row import RunRow, stopped_text

translate = App.Qt.translate

WHATS = ["wall", "deviation"]

# So much of the diagonal is shown around a place.
_AROUND = 0.1


class MapPanel(Panel):
    """Changes nothing in the document."""

    def __init__(self, feature: Any) -> None:
        self.feature = feature
        self.map: Any = None  #: the ThicknessMap that is shown
        self.document = feature.Document
        self.objects = [feature]
        self._view = view_of(self.document)
        self._overlay = over_view(self._view)
        self._build()
        Gui.Selection.clearSelection()
        self._measure()

    def leave_view(self) -> None:
        self._overlay.remove()
        self._plain()

    def _build(self) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("MapPanel")
        self.form.setWindowTitle(translate("Thicken", "Thickness Map"))
        column = QtWidgets.QVBoxLayout(self.form)
        self.what = QtWidgets.QComboBox()
        self.what.setObjectName("What")
        self.what.addItem(translate("Thicken", "Wall thickness (mm)"))
        if is_thicken(self.feature):
            self.what.addItem(translate("Thicken", "Deviation of the shell from the thickness (mm)"))
        self.what.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.what.currentIndexChanged.connect(lambda _: self._measure())
        self.facts = wrapped_label("Facts")
        self.legend = Legend()
        self.to_least = self._button("ToLeast", translate("Thicken", "Go to the least"), lambda: self.map.minimum_place)
        self.to_most = self._button("ToMost", translate("Thicken", "Go to the largest"), lambda: self.map.maximum_place)
        self.run_row = RunRow(self.stop)
        column.addWidget(self.what)
        column.addWidget(self.run_row.widget)
        column.addWidget(self.facts)
        column.addWidget(self.legend, 1)
        column.addWidget(self.to_least)
        column.addWidget(self.to_most)

    def _button(self, name: str, text: str, place: Any) -> Any:
        button = QtWidgets.QPushButton(text)
        button.setObjectName(name)
        button.setEnabled(False)
        button.clicked.connect(lambda: self._go(place()))
        return button

    def _measure(self) -> None:
        what = WHATS[self.what.currentIndex()]
        self.map = None
        self._overlay.show()
        for button in (self.to_least, self.to_most):
            button.setEnabled(False)
        self.facts.setText(translate("Thicken", "Measuring …"))
        self.compute(lambda: map_step(self.feature, what), self._measured, self._failed)

    def _failed(self, sentences: str) -> None:
        self.facts.setText(sentences or stopped_text())
        self._plain()

    def _measured(self, found: Any) -> None:
        self.map = found
        macro.record("thickness", self.map, "thickness_map", self.feature, what=self.map.what)
        low, high = ends(self.map, asked_thickness(self.feature))
        paint_points(self.feature.ViewObject, colours(self.map.vertex_values, low, high))
        self.legend.show_shares(*shares(self.feature, self.map, low, high))
        self.facts.setText(
            translate(
                "Thicken", "Least {least}, mean {mean}, largest {largest} mm. 98 % of the area: {low} to {high} mm."
            ).format(
                least=number(self.map.minimum, 4),
                mean=number(self.map.mean, 4),
                largest=number(self.map.maximum, 4),
                low=number(self.map.percentiles[1], 4),
                high=number(self.map.percentiles[99], 4),
            )
        )
        for button in (self.to_least, self.to_most):
            button.setEnabled(True)

    def _go(self, place: Any) -> None:
        """Go to a place and mark it: it may be behind the part."""
        self._overlay.show(points([tuple(place)], preferences.colour("ColorDefect"), 12.0))
        go_to(self._view, tuple(place), _AROUND * self.feature.Mesh.BoundBox.DiagonalLength)

    def _plain(self) -> None:
        """The colours that the feature has otherwise."""
        with suppress(ReferenceError, RuntimeError):  # deleted in the meantime
            view = self.feature.ViewObject
            if hasattr(view.Proxy, "paint"):
                view.Proxy.paint(view)
            else:
                paint_plain(view)
