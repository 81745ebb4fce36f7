# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the library within a recompute: FreeCAD waits for the result, but shows progress and can stop it."""

from __future__ import annotations

import threading
import time
from typing import Any, Callable

import FreeCAD as App
import FreeCADGui as Gui

from .. import runs
from .qt import QtCore, QtWidgets
from .stages import stage_name

translate = App.Qt.translate

# So long a run says nothing; then every so often the screen is refreshed. Seconds.
_PATIENCE = 0.7
_REFRESH = 0.03


_waiting = 0


def waits() -> bool:
    """Whether a dialog of this module is handling events, within whatever FreeCAD is doing."""
    return _waiting > 0


def wait_for(step: Callable[[Any], Any]) -> Any:
    """Return what `step` returns for a RunContext, or raise what it raises."""
    outcome: dict[str, Any] = {}

    def work() -> None:
        try:
            outcome["result"] = step(context)
        except BaseException as error:  # raised again below, in the thread that waits
            outcome["error"] = error

    with runs.started() as context:
        thread = threading.Thread(target=work, name="thicken", daemon=True)
        thread.start()
        thread.join(_PATIENCE)
        if thread.is_alive():
            _wait(thread, context)
    if "error" in outcome:
        raise outcome["error"]
    return outcome["result"]


def _wait(thread: threading.Thread, context: Any) -> None:
    global _waiting
    dialog = QtWidgets.QProgressDialog(Gui.getMainWindow())
    dialog.setWindowTitle(translate("Thicken", "Thicken"))
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setRange(0, 1000)
    dialog.setMinimumDuration(0)
    # While FreeCAD recomputes, a filter swallows all clicks; the filter that was added last is asked
    # first, and lets those on the dialog through.
    clicks = _Clicks(dialog)
    QtWidgets.QApplication.instance().installEventFilter(clicks)
    dialog.show()
    _waiting += 1
    try:
        while thread.is_alive():
            dialog.setLabelText(stage_name(context.stage))
            dialog.setRange(0, 1000 if context.progress > 0 else 0)  # 0: how far it is cannot be told
            dialog.setValue(min(999, int(1000 * context.progress)))
            QtWidgets.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
            if dialog.wasCanceled():
                context.cancel()
            time.sleep(_REFRESH)
    finally:
        _waiting -= 1
        QtWidgets.QApplication.instance().removeEventFilter(clicks)
        dialog.close()
        dialog.deleteLater()


class _Clicks(QtCore.QObject):
    """Hands mouse events to the dialog itself."""

    def __init__(self, dialog: Any) -> None:
        super().__init__()
        self._dialog = dialog

    def eventFilter(self, watched: Any, event: Any) -> bool:
        if event.type() == QtCore.QEvent.MouseButtonPress and isinstance(watched, QtWidgets.QPushButton):
            if watched.window() is self._dialog:
                self._dialog.cancel()
                return True
        return False
