# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks where to write."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from .qt import QtWidgets

# FreeCAD's own: the folder that its file dialogs were in last.
_LAST_FOLDER = ("User parameter:BaseApp/Preferences/General", "FileOpenSavePath")


def ask_target(obj: Any, title: str, suffix: str, kinds: list[str]) -> str:
    """The file that the user names, by default after `obj`, beside its document or what was opened last; "" when
    there is none. A name without one of the suffixes of `kinds` gets that of the kind that was chosen."""
    name, kind = QtWidgets.QFileDialog.getSaveFileName(
        Gui.getMainWindow(), title, str(_folder(obj) / f"{file_name(obj.Label)}{suffix}"), ";;".join(kinds)
    )
    if not name or Path(name).suffix.lower() in {_suffix(each) for each in kinds}:
        return name
    return name + _suffix(kind or kinds[0])


def file_name(label: str) -> str:
    """A label without what no system allows in the name of a file."""
    return re.sub(r'[\\/:*?"<>|]', "_", label).strip(" .") or "Solid"


def _folder(obj: Any) -> Path:
    if obj.Document.FileName:
        return Path(obj.Document.FileName).parent
    group, key = _LAST_FOLDER
    last = Path(App.ParamGet(group).GetString(key, ""))
    return last if last.is_absolute() and last.is_dir() else Path.home()


def _suffix(kind: str) -> str:
    """".stl" of "… (*.stl)"."""
    return "." + kind.rsplit("*.", 1)[-1].rstrip(")")
