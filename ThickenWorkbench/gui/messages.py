# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user is told: sentences of errors, and message boxes."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from thicken import native

from .. import runs
from ..numbers import count, number
from .qt import QtWidgets

translate = App.Qt.translate


def sentences(error: BaseException) -> str:
    """All that an error says, as whole sentences."""
    if isinstance(error, MemoryError):
        return translate("Thicken", "There is not enough memory. Simplify the mesh, or choose a coarser quality.")
    return runs.as_sentences(runs.all_parts(error))


def was_cancelled(error: BaseException | None) -> bool:
    return getattr(error, "code", None) == "cancelled"


def warn(title: str, text: str) -> None:
    QtWidgets.QMessageBox.warning(Gui.getMainWindow(), title, text)


def tell(title: str, text: str) -> None:
    QtWidgets.QMessageBox.information(Gui.getMainWindow(), title, text)


def tell_link(link: Any) -> None:
    """Why a link cannot be used, and what can."""
    text = translate(
        "Thicken", "“{label}” is a link. Select the object that it links to, “{linked}”, or make a copy of that where the link is."
    )
    tell(translate("Thicken", "A link is selected"), text.format(label=link.Label, linked=link.LinkedObject.Label))


def ask(title: str, text: str) -> bool:
    """Whether the user wants to go on."""
    box = QtWidgets.QMessageBox
    return box.question(Gui.getMainWindow(), title, text, box.Ok | box.Cancel, box.Cancel) == box.Ok


def extension_is_there() -> bool:
    """Whether the library can be used; otherwise the user is told what is missing and what to do."""
    try:
        native.load()
    except ImportError as error:
        warn(translate("Thicken", "Thicken cannot compute"), str(error))
        return False
    return True


def numbers(solid: Any) -> str:
    """One line about a solid."""
    report = solid.report
    return translate("Thicken", "{volume} mL, {triangles} triangles, thinnest wall {wall} mm").format(
        volume=number(report["output"]["volume_ml"]),
        triangles=count(report["output"]["triangles"]),
        wall=number(report["thinnest_wall"]["mm"]),
    )


def warning(text: str) -> str:
    """A warning of the library as a sentence."""
    return runs.as_sentences([text])
