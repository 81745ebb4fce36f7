# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Trim Surface command: the part of a surface within the closed wires that are selected with it."""

from __future__ import annotations

from typing import Any

import FreeCAD as App

from . import macro, messages

translate = App.Qt.translate


def trim(source: Any, wires: list[Any]) -> None:
    """Cut the part out, as one step of undo; what is refused is told, and leaves nothing."""
    if not messages.extension_is_there():
        return
    title = translate("Thicken", "Trim Surface")
    document = source.Document
    document.openTransaction(title)
    made = macro.assign("trimmed", macro.call("make_trim", macro.Text(macro.DOCUMENT), source, wires=list(wires)))
    if not made.isValid():
        text = made.getStatusString()
        document.abortTransaction()
        messages.warn(title, text)
        return
    document.commitTransaction()
