# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Part Solid command: solids of Part that follow closed meshes."""

from __future__ import annotations

from typing import Any

import FreeCAD as App

from ..part_solid import size_warning
from . import macro, messages

translate = App.Qt.translate


def make_solids(sources: list[Any]) -> None:
    """Make a solid of each, as one step of undo; the user is asked before a large one, and told what was refused."""
    if not messages.extension_is_there():
        return
    warnings = [size_warning(source.Mesh.CountFacets) for source in sources]
    title = translate("Thicken", "Part Solid")
    if any(warnings) and not messages.ask(title, "\n\n".join(filter(None, warnings))):
        return
    document = sources[0].Document
    document.openTransaction(title)
    made = [
        macro.assign("solid", macro.call("make_part_solid", macro.Text(macro.DOCUMENT), source)) for source in sources
    ]
    refused = [f"{solid.Source.Label}: {solid.getStatusString()}" for solid in made if not solid.isValid()]
    if refused:
        document.abortTransaction()
        messages.warn(title, "\n\n".join(refused))
        return
    document.commitTransaction()
