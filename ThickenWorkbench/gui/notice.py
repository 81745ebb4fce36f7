# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bar below FreeCAD's toolbars that says, once, that the compiled part is missing: before anybody selects and waits."""

from __future__ import annotations

import platform
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from thicken import native

from .qt import QtCore, QtGui, QtWidgets

translate = App.Qt.translate

NAME = "ThickenNotice"

_shown = False


def show_if_needed() -> None:
    """Called whenever the workbench is activated; quick, as nothing is loaded."""
    global _shown
    if _shown or native.is_there():
        return
    _shown = True
    window = Gui.getMainWindow()
    window.addToolBarBreak(QtCore.Qt.TopToolBarArea)
    window.addToolBar(QtCore.Qt.TopToolBarArea, _bar(window))


def _text() -> str:
    text = translate(
        "Thicken",
        "Thicken cannot compute yet: its compiled part for {system} and Python {python} is missing ({file}). Install the add-on "
        "archive for this system, or put the file into the folder.",
    )
    return text.format(
        system=f"{platform.system()} ({native.platform_name()})", python=platform.python_version(), file=native.file_name()
    )


def _bar(window: Any) -> Any:
    bar = QtWidgets.QToolBar(translate("Thicken", "Thicken"), window)
    bar.setObjectName(NAME)
    bar.setMovable(False)
    label = QtWidgets.QLabel(_text())
    label.setWordWrap(True)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    label.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Preferred)
    bar.addWidget(label)
    for text, slot in (
        (translate("Thicken", "Open the folder"), _open_folder),
        (translate("Thicken", "Details"), _tell_all),
        (translate("Thicken", "Close"), bar.deleteLater),
    ):
        button = QtWidgets.QPushButton(text)
        button.clicked.connect(slot)
        bar.addWidget(button)
    return bar


def _open_folder() -> None:
    folder = native.place_for_file()
    folder.mkdir(parents=True, exist_ok=True)
    QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(str(folder)))


def _tell_all() -> None:
    from . import messages

    messages.extension_is_there()
