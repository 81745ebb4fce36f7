# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes FreeCAD find the translations of the workbench."""

from __future__ import annotations

from pathlib import Path

import FreeCADGui as Gui

FOLDER = Path(__file__).resolve().parent.parent / "translations"


def load() -> None:
    """FreeCAD looks for Thicken_<language>.qm, now and whenever the user changes the language."""
    Gui.addLanguagePath(str(FOLDER))
    Gui.updateLocale()
