# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the proxies of all features have in common: no state of their own, and a view when there is one."""

from __future__ import annotations

from typing import Any

import FreeCAD as App


class StatelessProxy:
    """Keeps everything in the properties of the object. Subclasses add them in ensure_properties()."""

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        self.ensure_properties(obj)

    def ensure_properties(self, obj: Any) -> None:
        """Add the properties that `obj` lacks; idempotent. Called for new and for restored objects."""
        raise NotImplementedError

    def clear(self, obj: Any) -> None:
        """Leave nothing of an earlier result: there is none any more."""
        raise NotImplementedError

    def onDocumentRestored(self, obj: Any) -> None:
        self.ensure_properties(obj)
        if App.GuiUp:
            from .view_provider import attach_view_provider

            attach_view_provider(obj)

    # FreeCAD before 0.21.2 calls the first pair, later ones the second.
    def __getstate__(self) -> None:
        return None

    def __setstate__(self, state: Any) -> None:
        return None

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        return None
