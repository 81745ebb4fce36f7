# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the proxies of all features have in common: no state of their own, and a view when there is one."""

from __future__ import annotations

from contextlib import suppress
from typing import Any, Callable, Iterable

from . import windows
from .stateless import Stateless


def add_properties(obj: Any, group: str, table: Iterable[tuple[str, str, str]], attributes: int = 0) -> None:
    """Add those properties of `table` (type, name, description) that `obj` lacks."""
    present = set(obj.PropertiesList)
    for kind, name, doc in table:
        if name not in present:
            obj.addProperty(kind, name, group, doc, attributes)


SCHEMA = "SchemaVersion"

# App::PropertyType by value: read-only, hidden, and changing it does not touch the document.
_INTERNAL = 1 | 4 | 8

# App::Property::PropDynamic, the status of what addProperty() made, has no name in Python.
_DYNAMIC = 21


def lock(obj: Any) -> None:
    """Keep users from deleting properties, where FreeCAD (1.1 and later) has a status for that."""
    for name in obj.PropertiesList:
        if _DYNAMIC in obj.getPropertyStatus(name):
            with suppress(ValueError, AttributeError, TypeError):  # an older FreeCAD has no such status
                obj.setPropertyStatus(name, "LockDynamic")


class StatelessProxy(Stateless):
    """Keeps everything in the properties of the object. Subclasses add them in ensure_properties()."""

    #: Of the properties. migrations[n] turns an object of schema n into one of n + 1.
    schema = 1
    migrations: dict[int, Callable[[Any], None]] = {}

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        self._prepare(obj, self.schema)

    def _prepare(self, obj: Any, schema: int) -> None:
        """Bring an object, of `schema` unless it says otherwise, to the present one."""
        schema = getattr(obj, SCHEMA, schema)
        self.ensure_properties(obj)
        if SCHEMA not in obj.PropertiesList:
            obj.addProperty("App::PropertyInteger", SCHEMA, "Internal", "Version of the properties", _INTERNAL)
        for version in range(schema, self.schema):
            self.migrations[version](obj)
        obj.SchemaVersion = max(schema, self.schema)  # a newer program's document keeps its number
        lock(obj)

    def ensure_properties(self, obj: Any) -> None:
        """Add the properties that `obj` lacks; idempotent. Called for new and for restored objects."""
        raise NotImplementedError

    def clear(self, obj: Any) -> None:
        """Leave nothing of an earlier result: there is none any more."""
        raise NotImplementedError

    def onDocumentRestored(self, obj: Any) -> None:
        self._prepare(obj, 1)
        windows.attach_view(obj)
