# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Export for Printing command: asks for a file, writes it, and tells what was read back from it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD as App

from ..numbers import count, number
from . import macro, messages
from .files import ask_target

translate = App.Qt.translate


def export(obj: Any) -> None:
    """Ask for a file and write `obj` to it."""
    if not messages.extension_is_there():
        return
    path = _ask(obj)
    if path is None:
        return
    try:
        exported = macro.assign("exported", macro.call("export_for_printing", obj, str(path)))
    except Exception as error:  # told to the user; the file is not there
        messages.warn(translate("Thicken", "Nothing was written"), messages.sentences(error))
        return
    messages.tell(
        translate("Thicken", "Export for Printing"),
        translate(
            "Thicken",
            "“{label}” was written to {path}, read again and proved valid: {triangles} triangles, {volume} mL.",
        ).format(
            label=obj.Label, path=path, triangles=count(exported["triangles"]), volume=number(exported["volume_ml"], 4)
        ),
    )


def _ask(obj: Any) -> Path | None:
    name = ask_target(
        obj,
        translate("Thicken", "Export for Printing"),
        ".stl",
        [translate("Thicken", "Stereolithography (*.stl)"), translate("Thicken", "3D Manufacturing Format (*.3mf)")],
    )
    return Path(name) if name else None
