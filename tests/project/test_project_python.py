# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layers of the workbench: arrays, features, windows. Each knows only those before it."""

import unittest
from pathlib import Path

from project_sources import PROJECT, cycles, imports, python_graph

WORKBENCH = PROJECT / "ThickenWorkbench"

# Of FreeCAD itself, and what it brings.
FREECAD = {"FreeCAD", "Mesh", "MeshPart", "Part", "FreeCADGui", "PySide", "pivy"}
WINDOWS = {"FreeCADGui", "pivy"}

# Documents name the module of a view provider: it stays where it is, with the features, and belongs to the windows.
OF_WINDOWS = "view_provider.py"


def roots(file: Path) -> set[str]:
    return {name.partition(".")[0] for name in imports(file)}


class Layers(unittest.TestCase):
    def test_no_modules_import_each_other(self):
        graph = python_graph("ThickenWorkbench", "thicken")
        self.assertGreater(len(graph), 60)
        self.assertIn("ThickenWorkbench.core.brep_solid", graph["ThickenWorkbench.core.coplanar"])
        self.assertEqual(cycles(graph), [])

    def test_arrays_know_nothing_of_freecad(self):
        files = [*(WORKBENCH / "core").glob("*.py"), *(PROJECT / "thicken").glob("*.py")]
        self.assertGreater(len(files), 10)
        for file in files:
            with self.subTest(file.name):
                self.assertEqual(roots(file) & FREECAD, set())
                inside = {name for name in imports(file) if name.startswith("ThickenWorkbench")}
                self.assertEqual({name for name in inside if not name.startswith("ThickenWorkbench.core.")}, set())

    def test_features_know_nothing_of_windows(self):
        files = [file for file in WORKBENCH.glob("*.py") if file.name != OF_WINDOWS]
        self.assertGreater(len(files), 20)
        for file in files:
            with self.subTest(file.name):
                self.assertEqual(roots(file) & WINDOWS, set())
                windows = ("ThickenWorkbench.gui", "ThickenWorkbench.view_provider")
                self.assertEqual({name for name in imports(file) if name.startswith(windows)}, set())


if __name__ == "__main__":
    unittest.main()
