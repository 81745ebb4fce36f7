# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Trim Surface task panel: a loop is clicked on a surface, point by point, and the part within it stays."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from .. import preferences
from ..sources import surface_arrays
from . import macro, messages
from .camera import view_of
from .feature_panel import FeaturePanel
from .loop_points import LoopPoints
from .looks import Looks
from .overlay import lines, over_object, points
from .qt import QtWidgets, wrapped_label
from .run_row import RunRow

translate = App.Qt.translate

_LEAST_POINTS = 3  # of a loop
_POINT, _CURRENT = 9.0, 14.0  # pixels
_MOST_SMOOTHING = 5


class TrimPanel(FeaturePanel):
    """Nothing is written before OK. With `feature`, that one is edited."""

    def __init__(self, source: Any, feature: Any = None) -> None:
        self.source, self.feature = source, feature
        self.document = source.Document
        self.objects = [source] + ([feature] if feature is not None else [])
        # of the loop, in the coordinates of the source without its Placement, as everything here
        self.points: list[Any] = [] if feature is None else list(feature.Points)
        self.current: int | None = None  # the point that was set or taken last
        self.keep: Any = None if feature is None or feature.KeepInside else feature.Keep
        self.paths: Any = None  # a SurfacePaths, once it is there
        self._view = view_of(self.document)
        self._build()
        Gui.Selection.clearSelection()
        self._looks = Looks([feature], [source]) if feature is not None else None
        self._overlay = over_object(source)
        self._mouse = LoopPoints(self._view, source, self)
        self.compute(self._step, self._prepared, self.status.setText)

    # --- what FreeCAD calls ---

    def accept(self) -> bool:
        if not self._has_loop():
            self.status.setText(translate("Thicken", "A loop has three points at least. Click on the surface."))
            return False
        return self.commit(translate("Thicken", "Trim Surface"))

    def leave_view(self) -> None:
        self._mouse.stop()
        self._overlay.remove()
        if self._looks is not None:
            self._looks.restore()

    # --- what the mouse does on the surface ---

    def pressed(self, place: Any) -> None:
        if self.closed.isChecked():
            self.keep = place
            self._edited()
            return
        after = len(self.points) if self.current is None else self.current + 1
        self.points.insert(after, place)
        self.current = after
        self._edited()

    def taken(self, index: int) -> None:
        """A press on the first point closes the loop."""
        if index == 0 and self.current == len(self.points) - 1 and len(self.points) >= _LEAST_POINTS:
            self.closed.setChecked(True)
        self.current = index
        self._edited()

    def dragged(self, index: int, place: Any) -> None:
        self.points[index] = place
        self._edited()

    # --- within ---

    def _build(self) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("TrimPanel")
        self.form.setWindowTitle(translate("Thicken", "Trim Surface"))
        column = QtWidgets.QVBoxLayout(self.form)
        self.closed = QtWidgets.QCheckBox(translate("Thicken", "The loop is closed"))
        self.closed.setObjectName("Closed")
        self.closed.setChecked(self.feature is not None)
        self.remove = QtWidgets.QPushButton(translate("Thicken", "Remove the point"))
        self.remove.setObjectName("Remove")
        self.inside = QtWidgets.QPushButton(translate("Thicken", "Keep the part inside"))
        self.inside.setObjectName("Inside")
        self.smooth = QtWidgets.QSpinBox()
        self.smooth.setObjectName("Smooth")
        self.smooth.setRange(0, _MOST_SMOOTHING)
        self.smooth.setValue(0 if self.feature is None else self.feature.Smooth)
        rows = QtWidgets.QFormLayout()
        rows.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        rows.addRow(translate("Thicken", "Rounds of smoothing"), self.smooth)
        self.status = wrapped_label("Status")
        self.run_row = RunRow(self.stop)
        column.addLayout(rows)
        for widget in (self.closed, self.remove, self.inside, self.status, self.run_row.widget):
            column.addWidget(widget)
        column.addStretch()
        self.closed.toggled.connect(lambda _: self._edited())
        self.remove.clicked.connect(self._remove)
        self.inside.clicked.connect(self._keep_inside)
        self.smooth.valueChanged.connect(lambda _: self._edited())

    def _step(self) -> Any:
        from thicken import SurfacePaths

        surface = surface_arrays(self.source)
        return lambda context: SurfacePaths(*surface)

    def _prepared(self, paths: Any) -> None:
        self.paths = paths
        self._edited()

    def _remove(self) -> None:
        if self.current is not None:
            del self.points[self.current]
            self.current = self.current - 1 if self.current > 0 else (0 if self.points else None)
        self._edited()

    def _keep_inside(self) -> None:
        self.keep = None
        self._edited()

    def _has_loop(self) -> bool:
        return len(self.points) >= _LEAST_POINTS or (self.feature is not None and bool(self.feature.Wires) and not self.points)

    def _edited(self) -> None:
        """Show the points and the path through them, and say what can be done next."""
        if len(self.points) < _LEAST_POINTS and self.closed.isChecked():
            self.closed.setChecked(False)  # comes back here
            return
        self.closed.setEnabled(len(self.points) >= _LEAST_POINTS)
        self.remove.setEnabled(self.current is not None)
        self.inside.setEnabled(self.keep is not None)
        path, reason = self._path()
        self._draw(path)
        self.status.setText("\n".join(filter(None, [self._next(), reason])))

    def _next(self) -> str:
        if not self.closed.isChecked():
            return translate(
                "Thicken",
                "Click on the surface to set points, and on the first one to close the loop. Points can be dragged; a new one comes after the one that is chosen.",
            )
        if self.keep is None:
            return translate("Thicken", "The part inside of the loop stays. Click on the surface to keep that part.")
        return translate("Thicken", "The part that was clicked on stays.")

    def _path(self) -> tuple[np.ndarray, str]:
        """The corners of the path, and why there is none."""
        from thicken import ThickenError

        if self.paths is None or len(self.points) < 2:
            return np.zeros((0, 3)), ""
        try:
            places = np.array([tuple(point) for point in self.points])
            return self.paths.path(places, closed=self.closed.isChecked(), smooth=self.smooth.value()), ""
        except ThickenError as error:
            return np.zeros((0, 3)), messages.sentences(error)

    def _draw(self, path: np.ndarray) -> None:
        nodes, colour = [], preferences.colour("ColorWall")
        if len(path):
            last = path[:1] if self.closed.isChecked() else path[:0]
            corners = np.concatenate([path, last])
            nodes.append(lines(np.stack([corners[:-1], corners[1:]], axis=1), colour))
        if self.points:
            nodes.append(points([tuple(point) for point in self.points], colour, _POINT))
        if self.current is not None:
            nodes.append(points([tuple(self.points[self.current])], preferences.colour("ColorDefect"), _CURRENT))
        if self.keep is not None:
            nodes.append(points([tuple(self.keep)], preferences.colour("ColorShell"), _CURRENT))
        self._overlay.show(*nodes)

    def _make(self) -> Any:
        place = self.source.getGlobalPlacement()

        def of_document(point: Any) -> tuple[float, ...]:
            return tuple(round(part, 6) for part in place.multVec(App.Vector(*point)))

        return macro.assign("trimmed", macro.call(
            "make_trim",
            macro.Text(macro.DOCUMENT),
            self.source,
            points=[of_document(point) for point in self.points],
            keep=None if self.keep is None else of_document(self.keep),
            smooth=self.smooth.value() or None,
        ))  # fmt: skip

    def _change(self) -> Any:
        reference = macro.reference(self.feature)

        def vector(point: Any) -> str:
            return f"App.Vector{tuple(round(part, 6) for part in point)}"

        wanted = {
            "Points": "[" + ", ".join(vector(point) for point in self.points) + "]",
            "KeepInside": str(self.keep is None),
            "Smooth": str(self.smooth.value()),
        }
        if self.keep is not None:
            wanted["Keep"] = vector(self.keep)
        for name, text in wanted.items():
            macro.run(f"{reference}.{name} = {text}")
        macro.run(f"{macro.DOCUMENT}.recompute()")
        return self.feature
