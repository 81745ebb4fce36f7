# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes features notice when the mesh of their source is exchanged or edited.

To FreeCAD the mesh of a mesh object is an output: setting it leaves the object untouched, so that
nothing that depends on it would be recomputed.
"""

from __future__ import annotations

from typing import Any

import FreeCAD as App


class SourceObserver:
    """Touches the features of the given proxy class whose source has got another mesh.

    A source that failed has none, and FreeCAD then does not recompute what depends on it: it would go
    on showing what belongs to an earlier mesh, so that it is cleared here.
    """

    def __init__(self, proxy_class: type) -> None:
        self.proxy_class = proxy_class

    def slotChangedObject(self, obj: Any, name: str) -> None:
        if name != "Mesh" or getattr(obj.Document, "Restoring", False):
            return
        for dependent in obj.InList:
            if isinstance(getattr(dependent, "Proxy", None), self.proxy_class):
                dependent.touch()
                if obj.Mesh.CountFacets == 0:
                    dependent.Proxy.clear(dependent)


def observe_sources(proxy_class: type) -> None:
    """Watch all documents, as long as FreeCAD runs."""
    App.addDocumentObserver(SourceObserver(proxy_class))
