# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Export for Printing command: asks for a file, writes it, and tells what was read back from it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD as App

from . import macro, messages
from .files import ask_target
from .qt import QtCore, QtWidgets

translate = App.Qt.translate

_SUFFIXES = {".stl", ".3mf"}


def export(obj: Any) -> None:
    """Ask for a file and write `obj` to it."""
    if not messages.extension_is_there():
        return
    path = _ask(obj)
    if path is None:
        return
    QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        exported = macro.assign("exported", macro.call("export_for_printing", obj, str(path)))
    except Exception as error:  # told to the user; the file is not there
        QtWidgets.QApplication.restoreOverrideCursor()
        messages.warn(translate("Thicken", "Nothing was written"), str(error))
        return
    QtWidgets.QApplication.restoreOverrideCursor()
    messages.tell(
        translate("Thicken", "Export for Printing"),
        translate(
            "Thicken",
            "“{label}” was written to {path}, read again and proved valid: {triangles} triangles, {volume} mL.",
        ).format(
            label=obj.Label, path=path, triangles=f"{exported['triangles']:,}", volume=f"{exported['volume_ml']:.4g}"
        ),
    )


def _ask(obj: Any) -> Path | None:
    name = ask_target(
        obj,
        translate("Thicken", "Export for Printing"),
        ".stl",
        translate("Thicken", "For printing (*.stl *.3mf)"),
    )
    if not name:
        return None
    path = Path(name)
    return path if path.suffix.lower() in _SUFFIXES else path.with_name(path.name + ".stl")
