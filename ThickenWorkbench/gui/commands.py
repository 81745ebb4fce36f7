# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench. They only compose calls that a recorded macro can repeat."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from .. import build
from ..view_provider import ICONS

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP
translate = App.Qt.translate

MAKE = "Thicken_Make"


class MakeCommand:
    """Thickens the selected meshes by a thickness that suits their size; it is a property afterwards."""

    def GetResources(self) -> dict[str, str]:
        return {
            "Pixmap": str(ICONS / "thicken.svg"),
            "MenuText": QT_TRANSLATE_NOOP("Thicken_Make", "Thicken"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "Thicken_Make",
                "Turn the selected open mesh into a printable solid, keeping every triangle of it",
            ),
        }

    def IsActive(self) -> bool:
        return App.ActiveDocument is not None and bool(_selected_meshes())

    def Activated(self) -> None:
        doc = App.ActiveDocument
        doc.openTransaction("Thicken")
        Gui.addModule("ThickenWorkbench")
        made = []
        for source in _selected_meshes():
            thickness = build.suggested_thickness(source)
            Gui.doCommand(
                "thicken = ThickenWorkbench.make_thicken(App.ActiveDocument, "
                f"App.ActiveDocument.getObject('{source.Name}'), thickness={thickness!r})"
            )
            made.append(doc.ActiveObject)
        doc.commitTransaction()
        _report_refusals(made)


def _selected_meshes() -> list[Any]:
    document = App.ActiveDocument
    return [
        obj
        for obj in Gui.Selection.getSelection()
        if obj.Document == document and obj.isDerivedFrom("Mesh::Feature")
    ]


def _report_refusals(features: list[Any]) -> None:
    refused = [f"{feature.Label}: {feature.getStatusString()}" for feature in features if not feature.isValid()]
    if refused:
        from .qt import QtWidgets

        QtWidgets.QMessageBox.warning(
            Gui.getMainWindow(), translate("Thicken", "No valid solid"), "\n\n".join(refused)
        )


def register() -> list[str]:
    """Add the commands to FreeCAD and return their names."""
    Gui.addCommand(MAKE, MakeCommand())
    return [MAKE]
