# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the proxies of all features have in common: no state of their own, and a view when there is one."""

from __future__ import annotations

from typing import Any, Iterable

import FreeCAD as App

from .stateless import Stateless


def add_properties(obj: Any, group: str, table: Iterable[tuple[str, str, str]], attributes: int = 0) -> None:
    """Add those properties of `table` (type, name, description) that `obj` lacks."""
    present = set(obj.PropertiesList)
    for kind, name, doc in table:
        if name not in present:
            obj.addProperty(kind, name, group, doc, attributes)


class StatelessProxy(Stateless):
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
