# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the test modules of this folder inside FreeCAD.

A FreeCAD without a display ends with 0 after most failures, and runs no `__main__` part of a
script. Therefore: `freecadcmd -c "…; import thicken_testrun; sys.exit(thicken_testrun.main())"`, no
tests count as failure, and the last line tells what happened. tests/freecad/run reads it.
"""

from __future__ import annotations

import os
import sys
import unittest
import warnings
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
PASSED = "thicken: all FreeCAD tests passed"
SKIPPED = "thicken: all FreeCAD tests skipped"


def refuse_what_is_deprecated() -> None:
    """Have our own code raise where it uses what will not be there for long. FreeCAD's own code may."""
    for kind in (DeprecationWarning, PendingDeprecationWarning):
        warnings.filterwarnings("error", category=kind, module=r"(thicken|ThickenWorkbench|test_thicken|gui_)")


def main() -> int:
    refuse_what_is_deprecated()
    chosen = os.environ.get("THICKEN_TEST_MODULES", "").split()
    modules = chosen or sorted(path.stem for path in FOLDER.glob("test_thicken_*.py"))
    suite = unittest.TestSuite(unittest.defaultTestLoader.loadTestsFromName(module) for module in modules)
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2, warnings="").run(suite)
    passed = result.wasSuccessful() and result.testsRun > 0
    if not passed:
        print(f"\nthicken: FreeCAD tests failed ({result.testsRun} run)")
    else:
        print(f"\n{SKIPPED if result.testsRun == len(result.skipped) else PASSED}")
    sys.stdout.flush()
    return 0 if passed else 1
