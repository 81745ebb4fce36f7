# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD shows of the workbench before anything is done with it."""

import os
import platform
from pathlib import Path
from unittest import mock

import FreeCADGui as Gui

from thicken import native
from ThickenWorkbench.gui import notice
from ThickenWorkbench.gui.qt import QtWidgets
from gui_case import GuiCase, click, process_events
from thicken_surfaces import saddle

class Offers(GuiCase):
    def names(self):
        return [name for name in Gui.listCommands() if name.startswith("Thicken_")]

    def test_commands_are_in_toolbar_and_menu(self):
        self.assertIn("Thicken", Gui.activeWorkbench().listToolbars())
        self.assertIn("Thicken", Gui.activeWorkbench().listMenus())
        self.assertEqual(len(self.names()), len(Gui.activeWorkbench().getToolbarItems()["Thicken"]))

    def test_every_command_says_what_it_does(self):
        self.assertGreater(len(self.names()), 0)
        for name in self.names():
            info = Gui.Command.get(name).getInfo()
            for key in ("menuText", "toolTip", "statusTip", "whatsThis"):
                self.assertGreater(len(info[key]), 3, f"{name} has no {key}")
            self.assertTrue(Path(info["pixmap"]).is_file(), f"{name} has no icon")

    def test_commands_wait_for_a_selection(self):
        for name in self.names():
            self.assertFalse(Gui.Command.get(name).isActive(), f"{name} is active without a selection")
        self.select(self.add_mesh(saddle()))
        self.assertTrue(Gui.Command.get("Thicken_Make").isActive())
        self.assertFalse(Gui.Command.get("Thicken_Map").isActive(), "a surface has no wall to measure")

    def test_context_menu_offers_what_can_be_done(self):
        from ThickenWorkbench.gui import commands

        self.assertEqual(commands.usable(), [])
        self.select(self.add_mesh(saddle()))
        self.assertIn("Thicken_Make", commands.usable())
        self.assertNotIn("Thicken_Map", commands.usable())

    def test_missing_extension_is_told_with_a_remedy(self):
        self.select(self.add_mesh(saddle()))
        with mock.patch.object(native, "_loaded", None):
            with mock.patch.dict(os.environ, {native.DIRECTORY_VARIABLE: str(self.folder)}):
                self.assertIsNone(self.run_command("Thicken_Make"))
        self.assertEqual(len(self.messages), 1)
        for word in (native.file_name(), native.platform_name(), "docs/install.md"):
            self.assertIn(word, self.messages[0])
        self.assertEqual(len(self.doc.Objects), 1)

    def bars(self):
        process_events()
        return Gui.getMainWindow().findChildren(QtWidgets.QToolBar, notice.NAME)

    def test_missing_extension_is_told_once_by_a_bar(self):
        workbench = Gui.activeWorkbench()
        self.assertEqual(self.bars(), [], "the extension is there")
        with mock.patch.object(native, "_loaded", None), mock.patch.object(notice, "_shown", False):
            with mock.patch.dict(os.environ, {native.DIRECTORY_VARIABLE: str(self.folder)}):
                workbench.Activated()
                workbench.Activated()
            (bar,) = self.bars()
        self.picture("missing-extension")
        text = bar.findChild(QtWidgets.QLabel).text()
        for word in (native.file_name(), native.platform_name(), platform.python_version()):
            self.assertIn(word, text)
        self.assertEqual(self.messages, [])
        close = [button for button in bar.findChildren(QtWidgets.QPushButton) if button.text() == "Close"]
        click(close[0])
        self.assertEqual(self.bars(), [])
