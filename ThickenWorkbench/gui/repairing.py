# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Repair Surface command: mended copies of meshes, and what was done to them."""

from __future__ import annotations

from typing import Any

import FreeCAD as App

from . import macro, messages

translate = App.Qt.translate


def repair(sources: list[Any]) -> None:
    """Make a mended copy of each, as one step of undo, and tell what became of them."""
    if not messages.extension_is_there():
        return
    document = sources[0].Document
    document.openTransaction(translate("Thicken", "Repair surface"))
    made = [
        macro.assign("repaired", macro.call("make_repair", macro.Text(macro.DOCUMENT), source)) for source in sources
    ]
    document.commitTransaction()
    messages.tell(translate("Thicken", "Repair Surface"), "\n\n".join(_told(feature) for feature in made))


def _told(feature: Any) -> str:
    if not feature.isValid():
        return f"{feature.Label}: {feature.getStatusString()}"
    changes = list(getattr(feature, "Changes", ())) or [translate("Thicken", "There was nothing to mend.")]
    return f"{feature.Label}: " + "\n".join(changes)
