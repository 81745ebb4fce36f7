# SPDX-License-Identifier: LGPL-2.1-or-later
"""How objects look while a task panel is open, and as before afterwards."""

from __future__ import annotations

from contextlib import suppress
from typing import Any, Sequence

_CLEAR = 50  # per cent
_PROPERTIES = ("Visibility", "Transparency")


class Looks:
    """Hides some objects, and shows others so that what is drawn behind them is seen."""

    def __init__(self, hide: Sequence[Any] = (), see_through: Sequence[Any] = ()) -> None:
        views = [obj.ViewObject for obj in [*hide, *see_through]]
        self._before = [(view, name, getattr(view, name)) for view in views for name in _PROPERTIES]
        for obj in hide:
            obj.ViewObject.Visibility = False
        for obj in see_through:
            obj.ViewObject.Visibility = True
            obj.ViewObject.Transparency = _CLEAR

    def restore(self) -> None:
        for view, name, value in self._before:
            with suppress(ReferenceError, RuntimeError):  # deleted in the meantime
                if getattr(view, name) != value:
                    setattr(view, name, value)
