# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Drain Holes task panel: where resin leaves the cavities of a solid."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from .. import preferences
from . import macro, messages
from .camera import view_of
from .directions import direction, direction_box
from .overlay import over_view, points
from .panel import Panel
from .qt import QtCore, QtWidgets, length_box
from .view_clicks import ViewClicks

translate = App.Qt.translate


class DrainPanel(Panel):
    """Nothing is written before OK."""

    buttons = ("Ok", "Cancel")

    def __init__(self, solid: Any) -> None:
        self.solid = solid
        self.places: list[Any] = []
        self.document = solid.Document
        self.objects = [solid]
        self._view = view_of(self.document)
        self._build()
        Gui.Selection.clearSelection()
        self._overlay = over_view(self._view)
        self._clicks = ViewClicks(self._view, solid, self._clicked)

    # --- what FreeCAD calls ---

    def accept(self) -> bool:
        document = self.solid.Document
        document.openTransaction(translate("Thicken", "Drain holes"))
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            made = macro.assign("drained", self._call())
        except Exception as error:  # arguments that make no sense: told here, nothing was made
            document.abortTransaction()
            self.status.setText(messages.sentences(error))
            return False
        finally:
            QtWidgets.QApplication.restoreOverrideCursor()
        if not made.isValid():
            self.status.setText(made.getStatusString())
            document.abortTransaction()
            return False
        document.commitTransaction()
        self.leave_view()
        return True

    # --- within ---

    def _build(self) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("DrainPanel")
        self.form.setWindowTitle(translate("Thicken", "Drain Holes"))
        column = QtWidgets.QVBoxLayout(self.form)
        rows = QtWidgets.QFormLayout()
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
        column.addWidget(self.plug)
        self.status = QtWidgets.QLabel()
        self.status.setObjectName("Status")
        self.status.setWordWrap(True)
        column.addWidget(self.status)
        self.clear = QtWidgets.QPushButton(translate("Thicken", "Place automatically"))
        self.clear.setObjectName("Clear")
        self.clear.clicked.connect(self._clear)
        column.addWidget(self.clear)
        column.addStretch()
        self._tell()

    def _clicked(self, place: Any) -> None:
        self.places.append(place)
        self._tell()

    def _clear(self) -> None:
        self.places = []
        self._tell()

    def _tell(self) -> None:
        """Where the holes will be; called before the overlay is there, too."""
        self.clear.setEnabled(bool(self.places))
        self.count.setEnabled(not self.places)
        if self.places:
            text = translate("Thicken", "{count} places chosen by clicks.").format(count=len(self.places))
        else:
            text = translate(
                "Thicken", "At the lowest points of each cavity. Click on the solid to choose the places yourself."
            )
        self.status.setText(text)
        if hasattr(self, "_overlay"):
            corners = np.array([tuple(place) for place in self.places]).reshape(-1, 3)
            self._overlay.show(*([points(corners, preferences.colour("ColorDefect"), 12.0)] if len(corners) else []))

    def _call(self) -> str:
        return macro.call(
            "make_drain_holes",
            macro.Text(macro.DOCUMENT),
            self.solid,
            diameter=f"{self.diameter.property('rawValue'):.9g} mm",
            direction=direction(self.direction),
            count=None if self.places else self.count.value(),
            places=[tuple(round(part, 6) for part in place) for place in self.places] or None,
            plug=self.plug.isChecked() or None,
        )

    def leave_view(self) -> None:
        self._clicks.stop()
        self._overlay.remove()
