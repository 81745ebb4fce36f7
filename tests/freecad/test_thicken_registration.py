# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files that FreeCAD executes at its start, the commands, and the manifest."""

import sys
import types
import xml.etree.ElementTree as ElementTree
from datetime import date
from pathlib import Path
from unittest import mock

import ThickenWorkbench
from thicken_case import DocumentCase

ROOT = Path(__file__).resolve().parents[2]


class FakeGui(types.ModuleType):
    """As much of FreeCADGui as the workbench uses."""

    class Workbench:
        def appendToolbar(self, name, commands):
            self.toolbar = (name, commands)

        def appendMenu(self, name, commands):
            self.menu = (name, commands)

    def __init__(self):
        super().__init__("FreeCADGui")
        self.workbenches, self.commands, self.pages = [], {}, []

    def addWorkbench(self, workbench):
        self.workbenches.append(workbench)

    def addLanguagePath(self, folder):
        self.languages = folder

    def updateLocale(self):
        pass

    def addIconPath(self, folder):
        pass

    def addPreferencePage(self, page, group):
        self.pages.append((page, group))

    def addCommand(self, name, command):
        self.commands[name] = command


def execute(name: str) -> None:
    """As FreeCAD does: inside a function, without __file__."""
    exec(compile((ROOT / name).read_text(), name, "exec"))


class Registration(DocumentCase):
    def setUp(self):
        super().setUp()
        self.gui = FakeGui()
        patch = mock.patch.dict(sys.modules, {"FreeCADGui": self.gui})
        patch.start()
        self.addCleanup(patch.stop)
        for name in [module for module in sys.modules if module.startswith("ThickenWorkbench.gui")]:
            del sys.modules[name]

    def workbench(self):
        execute("Init.py")
        execute("InitGui.py")
        (workbench,) = self.gui.workbenches
        return workbench

    def test_workbench_is_registered(self):
        workbench = self.workbench()
        self.assertEqual(type(workbench).__name__, "ThickenWorkbench")
        self.assertEqual(workbench.GetClassName(), "Gui::PythonWorkbench")
        self.assertTrue(workbench.MenuText and workbench.ToolTip)
        self.assertTrue(Path(workbench.Icon).is_file())
        self.assertEqual(self.gui.commands, {}, "commands belong to Initialize, not to FreeCAD's start")

    def test_initialize_adds_the_commands(self):
        workbench = self.workbench()
        workbench.Initialize()
        name, commands = workbench.toolbar
        self.assertEqual(name, "Thicken")
        self.assertEqual(workbench.menu, workbench.toolbar)
        self.assertEqual(commands, list(self.gui.commands))
        self.assertIn("Thicken_Make", commands)
        ((page, group),) = self.gui.pages
        self.assertTrue(Path(page).is_file())
        self.assertEqual(group, "Thicken")
        for command in self.gui.commands.values():
            resources = command.GetResources()
            self.assertTrue(Path(resources["Pixmap"]).is_file())
            for key in ("MenuText", "ToolTip", "StatusTip", "WhatsThis"):
                self.assertTrue(resources[key])

    def test_manifest_agrees_with_the_package(self):
        tree = ElementTree.parse(ROOT / "package.xml").getroot()
        space = {"p": tree.tag[1:].split("}")[0]}
        text = lambda path: tree.findtext(path, namespaces=space)  # noqa: E731
        self.assertEqual(text("p:version"), ThickenWorkbench.__version__)
        self.assertEqual(text("p:content/p:workbench/p:classname"), "ThickenWorkbench")
        self.assertTrue((ROOT / text("p:icon")).is_file())
        self.assertTrue((ROOT / tree.find("p:license", space).get("file")).is_file())

    def test_manifest_has_what_the_index_of_addons_demands(self):
        tree = ElementTree.parse(ROOT / "package.xml").getroot()
        space = {"p": tree.tag[1:].split("}")[0]}
        addresses = {url.get("type"): url for url in tree.findall("p:url", space)}
        self.assertTrue({"repository", "readme", "bugtracker"} <= set(addresses), set(addresses))
        self.assertTrue(addresses["repository"].get("branch"))
        date.fromisoformat(tree.findtext("p:date", namespaces=space))
        minimum = tree.findtext("p:content/p:workbench/p:pythonmin", namespaces=space)
        self.assertRegex(minimum, r"^3\.\d+$")
        # The Addon Manager installs what is not optional beside FreeCAD's own, and another NumPy breaks that.
        needed = [item.text for item in tree.findall("p:content/p:workbench/p:depend", space)
                  if item.get("type") == "python" and item.get("optional") != "true"]  # fmt: skip
        self.assertEqual(needed, [])
