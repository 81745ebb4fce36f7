# SPDX-License-Identifier: LGPL-2.1-or-later
"""Takes a picture of every panel, narrow and wide, light and dark, in every language, to be looked at:
`THICKEN_GUI_PICTURES=folder tests/freecad/run-gui gui_panels`."""

import FreeCADGui as Gui
import Mesh
from PySide import QtCore, QtGui

import ThickenWorkbench
from gui_case import GuiCase, dark_sheet, main_window, process_events, wait_until
from thicken_surfaces import crossing_plates

LANGUAGES = {"en": "English", "de": "German", "zh": "Chinese Simplified"}
WIDTHS = (264, 370)


class Panels(GuiCase):
    def dock(self):
        docks = main_window().findChildren(QtGui.QDockWidget)
        return next(dock for dock in docks if dock.objectName() in ("Combo View", "Tasks", "Model"))

    def take(self, name, language, width, theme):
        main_window().resizeDocks([self.dock()], [width], QtCore.Qt.Horizontal)
        for _ in range(5):
            process_events()
        self.picture_of(self.dock(), f"{name}-{language}-{width}-{theme}")

    def panels(self):
        cube = self.doc.addObject("Mesh::Feature", "Cube")
        cube.Mesh = Mesh.createBox(20, 20, 20)
        crossing = self.add_mesh(crossing_plates(), "Crossing")
        solid = ThickenWorkbench.make_thicken(self.doc, cube, thickness=2)
        self.look()
        return (("make", "Make", cube), ("refused", "Make", crossing), ("check", "Check", crossing), ("map", "Map", solid),
                ("drain", "Drain", solid), ("report", "Report", solid), ("regions", "Regions", solid))  # fmt: skip

    def idle(self, panel):
        preview = getattr(panel, "_preview", None)
        wait_until(lambda: not getattr(preview, "busy", bool)(), "the preview is there")
        timer = getattr(panel, "_timer", None)
        wait_until(lambda: timer is None or not timer.isActive(), "it has begun")
        wait_until(lambda: panel._job is None, "it has computed")

    def test_all(self):
        self.addCleanup(Gui.setLocale, "English")
        self.addCleanup(QtGui.QApplication.instance().setStyleSheet, "")
        panels = self.panels()
        for theme in ("light", "dark"):
            QtGui.QApplication.instance().setStyleSheet(dark_sheet() if theme == "dark" else "")
            for language, name in LANGUAGES.items():
                Gui.setLocale(name)
                for label, command, target in panels:
                    self.select(target)
                    panel = self.run_command(f"Thicken_{command}")
                    self.idle(panel)
                    if label == "make":
                        self.child(panel, "Advanced").setChecked(True)
                    for width in WIDTHS:
                        self.take(label, language, width, theme)
                    panel.reject()
                    Gui.Control.closeDialog()
                    process_events()
