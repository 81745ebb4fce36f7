# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preferences page: every key of the table is on it with the same start, and it is heeded."""

import xml.etree.ElementTree as ElementTree

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ThickenWorkbench import preferences
from ThickenWorkbench.gui.preferences_page import PAGE
from gui_case import GuiCase, process_events, wait_until
from thicken_surfaces import plate, saddle

# Learned by the program, not set by the user.
NOT_ON_THE_PAGE = {"TimesForecast"}


def entries() -> dict:
    """The widgets of the page, by the key that they set."""
    found = {}
    for widget in ElementTree.parse(PAGE).iter("widget"):
        for prop in widget.findall("property"):
            if prop.get("name") == "prefEntry":
                found[prop.findtext("cstring")] = widget
    return found


def start_of(widget):
    for name, tag in (("value", "number"), ("value", "double"), ("checked", "bool")):
        for prop in widget.findall("property"):
            if prop.get("name") == name and prop.find(tag) is not None:
                return prop.findtext(tag)
    colour = widget.find("property[@name='color']/color")
    if colour is not None:
        red, green, blue = (int(colour.findtext(part)) for part in ("red", "green", "blue"))
        return red << 24 | green << 16 | blue << 8 | 0xFF
    return 0  # the first of a list


class Page(GuiCase):
    def test_it_has_every_key_with_its_start(self):
        table = {p.key: p.start for p in preferences.PREFERENCES if p.key not in NOT_ON_THE_PAGE}
        found = {key: start_of(widget) for key, widget in entries().items()}
        self.assertEqual(set(found), set(table))
        for key, start in table.items():
            shown = found[key]
            if isinstance(start, bool):
                self.assertEqual(shown, str(start).lower(), key)
            else:
                self.assertAlmostEqual(float(shown), float(start), msg=key)

    def test_freecad_shows_it(self):
        """Open the dialog, change a number on the page, and take it over."""
        seen = []

        def act():
            dialog = QtGui.QApplication.activeModalWidget()
            if dialog is None or isinstance(dialog, QtGui.QMessageBox):
                QtCore.QTimer.singleShot(100, act)
                return
            try:
                self.choose_page(dialog)
                box = dialog.findChild(QtGui.QWidget, "threads")
                seen.append(box is not None)
                if box is not None:
                    box.setValue(3)
                    self.picture_of(dialog, "preferences")
                dialog.findChild(QtGui.QDialogButtonBox).button(QtGui.QDialogButtonBox.Ok).click()
            finally:
                if not seen:  # a dialog that stays open would wait for ever
                    seen.append(False)
                    dialog.reject()

        self.addCleanup(preferences.put, "Threads", 0)
        QtCore.QTimer.singleShot(100, act)
        Gui.runCommand("Std_DlgPreferences")
        wait_until(lambda: seen, "the dialog was open")
        self.assertEqual(seen, [True])
        self.assertEqual(preferences.get("Threads"), 3)

    def choose_page(self, dialog):
        """Click on the page's name: FreeCAD 0.20 has a list of them, 1.0 a tree."""
        for view in dialog.findChildren(QtGui.QAbstractItemView):
            model = view.model()
            if model is None or model.rowCount() == 0:
                continue
            exactly = QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive
            for index in model.match(model.index(0, 0), QtCore.Qt.DisplayRole, "Thicken", 1, exactly):
                view.setCurrentIndex(index)
                process_events()
                return
        self.fail("no page of the name Thicken")

    def put(self, key, value):
        self.addCleanup(preferences.put, key, preferences.get(key))
        preferences.put(key, value)

    def test_defaults_are_taken(self):
        self.put("Side", 1)
        self.put("Output", 1)
        self.put("Preview", False)
        self.put("ThicknessPercent", 10.0)
        source = self.add_mesh(plate())
        self.select(source)
        panel = self.run_command("Thicken_Make")
        inputs = panel.form_parts.inputs()
        self.assertEqual((inputs["side"], panel.form_parts.output_word()), ("positive", "solid"))
        self.assertAlmostEqual(inputs["thickness"], 3)
        self.assertFalse(panel._preview.busy())

    def test_large_surfaces_are_not_previewed(self):
        self.put("PreviewTriangles", 1000)
        self.select(self.add_mesh(plate(n=40)))
        panel = self.run_command("Thicken_Make")
        self.assertFalse(panel._preview.busy())
        self.assertIn("Too many", self.child(panel, "Status").text())

    def test_memory_limit_is_told_in_the_panel(self):
        self.put("MemoryMiB", 1)
        self.put("Preview", False)
        self.select(self.add_mesh(saddle()))
        panel = self.run_command("Thicken_Make")
        self.press("Ok")
        wait_until(lambda: panel._job is None, "the run has ended")
        self.assertIn("1 MiB", self.child(panel, "Status").text())
        self.assertTrue(Gui.Control.activeDialog())
