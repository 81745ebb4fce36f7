# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Drain Holes task panel: where resin leaves the cavities of a solid."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from .. import preferences
from ..drain_holes import drill_step
from . import macro
from .camera import view_of
from .directions import AXES, direction, direction_box
from .feature_panel import FeaturePanel
from .looks import Looks
from .overlay import over_view, points
from .qt import QtCore, QtWidgets, length_box, on_value, wrapped_label
from .run_row import RunRow
from .view_clicks import ViewClicks

translate = App.Qt.translate

_PAUSE_MS = 300


class DrainPanel(FeaturePanel):
    """Nothing is written before OK. With `feature`, that one is edited."""

    def __init__(self, solid: Any, feature: Any = None) -> None:
        self.solid, self.feature = solid, feature
        self.found: Any = None  #: the holes of the inputs that are shown; None while they are computed
        self.document = solid.Document
        self.objects = [solid] + ([feature] if feature is not None else [])
        self.places = [] if feature is None else [self._placement().multVec(place) for place in feature.Places]
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._preview)
        self._view = view_of(self.document)
        self._build()
        Gui.Selection.clearSelection()
        self._looks = Looks([feature], [solid]) if feature is not None else None
        self._overlay = over_view(self._view)
        self._clicks = ViewClicks(self._view, solid, self._clicked)
        self._edited()

    # --- what FreeCAD calls ---

    def accept(self) -> bool:
        return self.commit(translate("Thicken", "Drain holes"))

    def leave_view(self) -> None:
        self._timer.stop()
        self._clicks.stop()
        self._overlay.remove()
        if self._looks is not None:
            self._looks.restore()

    # --- within ---

    def _placement(self) -> Any:
        return self.solid.getGlobalPlacement()

    def _build(self) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("DrainPanel")
        self.form.setWindowTitle(translate("Thicken", "Drain Holes"))
        column = QtWidgets.QVBoxLayout(self.form)
        rows = QtWidgets.QFormLayout()
        rows.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        column.addLayout(rows)
        self.diameter = length_box(preferences.get("DrainDiameter"), minimum=0.1)
        self.diameter.setObjectName("Diameter")
        rows.addRow(translate("Thicken", "Diameter"), self.diameter)
        self.direction = direction_box()
        rows.addRow(translate("Thicken", "Printed towards"), self.direction)
        self.count = QtWidgets.QSpinBox()
        self.count.setObjectName("Count")
        self.count.setRange(1, 20)
        rows.addRow(translate("Thicken", "Holes in each cavity"), self.count)
        self.plug = QtWidgets.QCheckBox(translate("Thicken", "Make plugs for the holes"))
        self.plug.setObjectName("Plug")
        self.plug.setVisible(self.feature is None)  # plugs are an object of their own
        column.addWidget(self.plug)
        self.status = wrapped_label("Status")
        self.run_row = RunRow(self.stop)
        self.clear = QtWidgets.QPushButton(translate("Thicken", "Place automatically"))
        self.clear.setObjectName("Clear")
        for widget in (self.status, self.run_row.widget, self.clear):
            column.addWidget(widget)
        column.addStretch()
        self._show_start()
        on_value(self.diameter, lambda _: self._edited())
        self.direction.currentIndexChanged.connect(lambda _: self._edited())
        self.count.valueChanged.connect(lambda _: self._edited())
        self.clear.clicked.connect(self._clear)

    def _show_start(self) -> None:
        if self.feature is None:
            return
        self.diameter.setProperty("rawValue", self.feature.Diameter.Value)
        self.count.setValue(self.feature.Count)
        towards = np.array(tuple(self.feature.Direction))
        self.direction.setCurrentIndex(int(np.argmax([towards @ axis for axis in AXES])))

    def _clicked(self, place: Any) -> None:
        self.places.append(place)
        self._edited()

    def _clear(self) -> None:
        self.places = []
        self._edited()

    def _edited(self) -> None:
        """Say where the holes will be, and find out once the user pauses."""
        self.abandon()
        self.found = None
        self.clear.setEnabled(bool(self.places))
        self.count.setEnabled(not self.places)
        self.status.setText(self._where())
        self._mark([tuple(place) for place in self.places])
        self._timer.start(_PAUSE_MS)

    def _where(self) -> str:
        if not self.places:
            return translate(
                "Thicken", "At the lowest points of each cavity. Click on the solid to choose the places yourself."
            )
        if len(self.places) == 1:
            return translate("Thicken", "One place chosen by a click.")
        return translate("Thicken", "{count} places chosen by clicks.").format(count=len(self.places))

    def _preview(self) -> None:
        self.compute(self._step, self._previewed, self._failed)

    def _step(self) -> Any:
        return drill_step(
            self.solid, self._diameter(), self.count.value(), App.Vector(*direction(self.direction)), self._local_places()
        )

    def _previewed(self, made: Any) -> None:
        self.found = made
        self._mark([tuple(self._placement().multVec(App.Vector(*hole.entry))) for hole in made.holes])
        self.status.setText("\n".join([self._where(), *made.warnings]))

    def _failed(self, sentences: str) -> None:
        self.status.setText("\n".join(filter(None, [self._where(), sentences])))

    def _mark(self, places: list[Any]) -> None:
        corners = np.array(places).reshape(-1, 3)
        self._overlay.show(*([points(corners, preferences.colour("ColorDefect"), 12.0)] if len(corners) else []))

    def _diameter(self) -> float:
        return round(float(self.diameter.property("rawValue")), 9)

    def _local_places(self) -> list[Any]:
        inverse = self._placement().inverse()
        return [tuple(round(part, 6) for part in inverse.multVec(place)) for place in self.places]

    def _make(self) -> Any:
        return macro.assign("drained", macro.call(
            "make_drain_holes",
            macro.Text(macro.DOCUMENT),
            self.solid,
            diameter=f"{self._diameter():.9g} mm",
            direction=direction(self.direction),
            count=None if self.places else self.count.value(),
            places=[tuple(round(part, 6) for part in place) for place in self.places] or None,
            plug=self.plug.isChecked() or None,
        ))  # fmt: skip

    def _change(self) -> Any:
        reference = macro.reference(self.feature)
        wanted = {
            "Diameter": f"'{self._diameter():.9g} mm'",
            "Count": str(self.count.value()),
            "Direction": f"App.Vector{direction(self.direction)}",
            "Places": "[" + ", ".join(f"App.Vector{place}" for place in self._local_places()) + "]",
        }
        for name, text in wanted.items():
            macro.run(f"{reference}.{name} = {text}")
        macro.run(f"{macro.DOCUMENT}.recompute()")
        return self.feature
