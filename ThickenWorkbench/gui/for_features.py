# SPDX-License-Identifier: LGPL-2.1-or-later
"""Connects features, which import nothing of this package, with FreeCAD's windows."""

from __future__ import annotations

from typing import Any, Callable

from .. import windows


class _ForFeatures:
    """Loads what it needs when it is asked: FreeCAD starts without it."""

    def attach_view(self, obj: Any) -> None:
        from ..view_provider import attach_view_provider

        attach_view_provider(obj)

    def wait_for(self, step: Callable[[Any], Any]) -> Any:
        from .modal_run import wait_for

        return wait_for(step)


def connect() -> None:
    """To be called when FreeCAD starts with windows."""
    windows.connect(_ForFeatures())
