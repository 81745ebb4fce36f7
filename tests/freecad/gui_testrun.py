# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the gui_test_*.py of this folder in a FreeCAD with windows, and ends it. Started by run-gui.

What happens is written to the file that THICKEN_GUI_LOG names: FreeCAD's own output is full of
other things, and its exit status says nothing.
"""

import os
import sys
import traceback
import unittest
from pathlib import Path

FOLDER = Path(os.path.abspath(sys.argv[-1])).parent
SENTINEL = "thicken: the window tests passed"
sys.path.insert(0, str(FOLDER))

import thicken_testrun  # noqa: E402


def main(log) -> None:
    thicken_testrun.refuse_what_is_deprecated()
    chosen = os.environ.get("THICKEN_TEST_MODULES", "").split()
    modules = chosen or sorted(path.stem for path in FOLDER.glob("gui_test_*.py"))
    suite = unittest.TestSuite(unittest.defaultTestLoader.loadTestsFromName(module) for module in modules)
    result = unittest.TextTestRunner(stream=log, verbosity=2, warnings="").run(suite)
    passed = result.wasSuccessful() and result.testsRun > len(result.skipped)
    log.write(f"\n{SENTINEL}\n" if passed else f"\nthicken: window tests failed ({result.testsRun} run)\n")


with open(os.environ["THICKEN_GUI_LOG"], "w", buffering=1) as file:
    try:
        main(file)
    except BaseException:
        file.write(traceback.format_exc())
os._exit(0)
