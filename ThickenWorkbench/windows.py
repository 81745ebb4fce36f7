# SPDX-License-Identifier: LGPL-2.1-or-later
"""What features ask of FreeCAD's windows.

Features import nothing of `gui`. Where there are windows, InitGui.py connects what `gui` has for them.
"""

from __future__ import annotations

from typing import Any, Callable, Protocol

import FreeCAD as App


class Windows(Protocol):
    """What `gui` does for features."""

    def attach_view(self, obj: Any) -> None:
        """Give `obj` its view provider unless it has one."""

    def wait_for(self, step: Callable[[Any], Any]) -> Any:
        """Return what `step` returns for a RunContext; meanwhile a dialog shows the progress and can stop it."""


_connected: Windows | None = None


def connect(windows: Windows) -> None:
    """Have `windows` do what features ask for from now on."""
    global _connected
    _connected = windows


def connected() -> Windows | None:
    """The windows, or None in a FreeCAD without."""
    return _connected if App.GuiUp else None


def attach_view(obj: Any) -> None:
    """Give `obj` its view provider where there are windows."""
    windows = connected()
    if windows is not None:
        windows.attach_view(obj)
