# SPDX-License-Identifier: LGPL-2.1-or-later
"""A progress bar, and below it a button that stops."""

from __future__ import annotations

from typing import Any, Callable

import FreeCAD as App

from .qt import QtWidgets
from .stages import stage_name

translate = App.Qt.translate


class RunRow:
    """Hidden unless something runs. `widget` goes into a panel."""

    def __init__(self, stop: Callable[[], None]) -> None:
        self.widget = QtWidgets.QWidget()
        column = QtWidgets.QVBoxLayout(self.widget)
        column.setContentsMargins(0, 0, 0, 0)
        self.progress = QtWidgets.QProgressBar()
        self.progress.setObjectName("Progress")
        self.stop = QtWidgets.QPushButton(translate("Thicken", "Stop"))
        self.stop.setObjectName("Stop")
        self.stop.clicked.connect(lambda *_: stop())
        column.addWidget(self.progress)
        column.addWidget(self.stop)
        self.show_running(False)

    def show_running(self, running: bool) -> None:
        self.progress.setRange(0, 0)  # how far it is is not known yet
        self.progress.setFormat("")
        self.widget.setVisible(running)

    def progressed(self, share: float, stage: str) -> None:
        if share > 0:
            self.progress.setRange(0, 1000)
            self.progress.setValue(int(1000 * share))
        self.progress.setFormat(f"{stage_name(stage)}: %p %" if share > 0 else stage_name(stage))


def stopped_text() -> Any:
    return translate("Thicken", "Stopped.")
