# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens task panels: one at a time, as FreeCAD has it."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from . import messages
from .qt import QtCore

translate = App.Qt.translate

_panel: Any = None
_observer: Any = None


class _Closing:
    """Closes the open panel before its document or an object of it goes, and with that the nodes that
    it draws below."""

    def slotDeletedDocument(self, gui_document: Any) -> None:
        if _is_open() and _panel.document == gui_document.Document:
            _close()

    def slotDeletedObject(self, view: Any) -> None:
        if _is_open() and view.Object in _panel.objects:
            _panel.leave_view()
            QtCore.QTimer.singleShot(0, _close)  # when FreeCAD has finished deleting


def _is_open() -> bool:
    return _panel is not None and bool(Gui.Control.activeDialog())


def _close() -> None:
    if _is_open():
        _panel.reject()
        if Gui.Control.activeDialog():
            Gui.Control.closeDialog()


def show(make_panel: Any) -> Any:
    """Show the panel that `make_panel` returns, unless one is open; the user is told why not."""
    global _panel, _observer
    if _observer is None:
        _observer = _Closing()
        Gui.addDocumentObserver(_observer)
    if Gui.Control.activeDialog():
        messages.tell(
            translate("Thicken", "A task is open"), translate("Thicken", "Close the open task panel first.")
        )
        return None
    if not messages.extension_is_there():
        return None
    from ..sources import RefusedError

    try:
        _panel = make_panel()
    except RefusedError as error:
        messages.warn(translate("Thicken", "Thicken cannot start"), str(error))
        return None
    Gui.Control.showDialog(_panel)
    _panel.watch()
    return _panel


def edit(feature: Any) -> bool:
    """Edit a feature in its panel; False when it cannot be."""
    if feature.Source is None:
        messages.warn(feature.Label, translate("Thicken", "No surface is chosen. Set Source in the property editor."))
        return False
    return show(lambda: _panel_of(feature)) is not None


def _panel_of(feature: Any) -> Any:
    kind = type(feature.Proxy).__name__
    if kind == "DrainHolesFeature":
        from .drain_panel import DrainPanel

        return DrainPanel(feature.Source, feature)
    if kind == "RepairFeature":
        from .repair_panel import RepairPanel

        return RepairPanel(feature)
    if kind == "TrimFeature":
        from .trim_panel import TrimPanel

        return TrimPanel(feature.Source, feature)
    from .surfaces import chosen_of
    from .thicken_panel import ThickenPanel

    return ThickenPanel([chosen_of(feature)], feature)


def end() -> None:
    """Close the panel of an edited feature when FreeCAD leaves its edit mode."""
    global _panel
    panel, _panel = _panel, None
    if panel is not None:
        panel.close()
    if Gui.Control.activeDialog():
        Gui.Control.closeDialog()


def current() -> Any:
    """The panel that was opened last."""
    return _panel
