# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks where to write."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCADGui as Gui

from .qt import QtWidgets


def ask_target(obj: Any, title: str, suffix: str, kinds: str) -> str:
    """The file that the user names, by default after `obj` and beside its document; "" when there is none."""
    folder = Path(obj.Document.FileName).parent if obj.Document.FileName else Path.home()
    name, _ = QtWidgets.QFileDialog.getSaveFileName(
        Gui.getMainWindow(), title, str(folder / f"{obj.Label}{suffix}"), kinds
    )
    return name
