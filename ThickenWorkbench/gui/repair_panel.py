# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a mended surface: what was changed, and how far apart corners may be to become one."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from . import macro
from .panel import Panel
from .qt import QtWidgets, length_box

translate = App.Qt.translate


class RepairPanel(Panel):
    """Edits a repair feature. Nothing is written before OK."""

    buttons = ("Ok", "Cancel")

    def __init__(self, feature: Any) -> None:
        self.feature = feature
        self.document = feature.Document
        self.objects = [feature, feature.Source]
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("RepairPanel")
        self.form.setWindowTitle(translate("Thicken", "Repair Surface"))
        column = QtWidgets.QVBoxLayout(self.form)
        self.automatic = QtWidgets.QCheckBox(translate("Thicken", "Weld corners of rims automatically"))
        self.automatic.setObjectName("WeldAutomatically")
        self.automatic.setChecked(feature.WeldAutomatically)
        self.weld = length_box(feature.Weld.Value)
        self.weld.setObjectName("Weld")
        self.weld.setToolTip(translate("Thicken", "The farthest that corners of rims may be apart to become one"))
        self.weld.setEnabled(not feature.WeldAutomatically)
        self.automatic.toggled.connect(lambda on: self.weld.setEnabled(not on))
        self.status = QtWidgets.QLabel("\n".join(feature.Changes) or translate("Thicken", "There was nothing to mend."))
        self.status.setObjectName("Status")
        self.status.setWordWrap(True)
        for widget in (self.automatic, self.weld, self.status):
            column.addWidget(widget)
        column.addStretch()

    def accept(self) -> bool:
        """Change the feature. Its recompute shows progress and can be stopped."""
        reference = macro.reference(self.feature)
        self.document.openTransaction(translate("Thicken", "Repair surface"))
        macro.run(f"{reference}.WeldAutomatically = {self.automatic.isChecked()}")
        if not self.automatic.isChecked():
            macro.run(f"{reference}.Weld = '{float(self.weld.property('rawValue')):.9g} mm'")
        macro.run(f"{macro.DOCUMENT}.recompute()")
        if not self.feature.isValid():
            self.status.setText(self.feature.getStatusString())
            self.document.abortTransaction()
            self.document.recompute()
            return False
        self.document.commitTransaction()
        return self.reject()

    def reject(self) -> bool:
        self.close()
        Gui.getDocument(self.document.Name).resetEdit()
        return True

    def leave_view(self) -> None:
        """Nothing is drawn."""
