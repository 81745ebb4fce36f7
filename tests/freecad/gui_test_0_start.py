# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the workbench adds to FreeCAD's start. Runs first: the workbench must not be active yet."""

import sys
import time
import unittest

import FreeCADGui as Gui

# What activating may take beyond FreeCAD's own share.
START_LIMIT = 0.3


class _Empty(Gui.Workbench):
    """A workbench with nothing in it: what activating costs FreeCAD itself."""

    MenuText = ToolTip = "Empty"

    def Initialize(self):
        pass

    def GetClassName(self):
        return "Gui::PythonWorkbench"


def _seconds(name: str) -> tuple[float, float]:
    """Wall-clock time, and the processor's time of this process, which others do not lengthen."""
    wall, own = time.perf_counter(), time.process_time()
    Gui.activateWorkbench(name)
    Gui.updateGui()
    return time.perf_counter() - wall, time.process_time() - own


class Start(unittest.TestCase):
    def test_activating_is_quick(self):
        self.assertNotIn("ThickenWorkbench.gui.commands", sys.modules, "the workbench was active before")
        Gui.addWorkbench(_Empty())
        _seconds("NoneWorkbench")
        empty, empty_own = _seconds("_Empty")
        _seconds("NoneWorkbench")
        ours, ours_own = _seconds("ThickenWorkbench")
        print(f"activation: {1000 * ours:.0f} ms, of an empty workbench {1000 * empty:.0f} ms")
        self.assertEqual(Gui.activeWorkbench().name(), "ThickenWorkbench")
        self.assertLess(ours_own - empty_own, START_LIMIT)
