# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the workbench adds to FreeCAD's start. Runs first: the workbench must not be active yet."""

import sys
import unittest

import FreeCADGui as Gui

# Modules that activating may load: those of the commands and what they need to stand in menus.
MOST_MODULES = 20


class Start(unittest.TestCase):
    def test_activating_loads_little(self):
        """What takes long to load is loaded when it is first used: how long that is goes with the machine, and what it is does not."""
        self.assertNotIn("ThickenWorkbench.gui.commands", sys.modules, "the workbench was active before")
        before = set(sys.modules)
        Gui.activateWorkbench("ThickenWorkbench")
        Gui.updateGui()
        self.assertEqual(Gui.activeWorkbench().name(), "ThickenWorkbench")
        loaded = set(sys.modules) - before
        self.assertIn("ThickenWorkbench.gui.commands", loaded)
        ours = {name for name in loaded if name.partition(".")[0] in ("ThickenWorkbench", "thicken", "_thicken")}
        self.assertEqual({name for name in ours if "_panel" in name or name.endswith("_thicken")}, set())
        self.assertLess(len(ours), MOST_MODULES, sorted(ours))
