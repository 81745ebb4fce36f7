# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for printing, read again and proved valid before they get their name."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import runs
from .placed import placed_solid
from .sources import DEFAULT_DEFLECTION, RefusedError

if TYPE_CHECKING:
    from numpy.typing import NDArray

FORMATS = (".stl", ".3mf")


def export_for_printing(
    obj: Any, path: str | os.PathLike[str], *, deflection: float = DEFAULT_DEFLECTION
) -> dict[str, Any]:
    """Write the closed mesh or solid `obj` to a binary .stl or a .3mf file, in mm, where it stands in the document.

    The file is read again and audited with exact predicates, and only then put in its place: there is a
    valid file or none. Returns path, triangles, volume_ml, area_mm2 and shells. `deflection` is the
    farthest that the triangles of a shape may be from it, mm.

    Raises sources.RefusedError for what is not a valid solid, with its defects; ValueError for another
    extension; ThickenError or OSError where nothing can be written.
    """
    return runs.run(export_step(obj, path, deflection=deflection))


def export_step(
    obj: Any, path: str | os.PathLike[str], *, deflection: float = DEFAULT_DEFLECTION
) -> runs.Step[dict[str, Any]]:
    """The step of export_for_printing(): nothing of it touches `obj` any more."""
    from thicken import native

    target = Path(path)
    if target.suffix.lower() not in FORMATS:
        raise ValueError(f"the file must end in {' or '.join(FORMATS)}, not in “{target.suffix}”")
    extension, label, threads = native.load(), obj.Label, runs.threads()
    vertices, triangles = placed_solid(obj, deflection)
    runs.require_room(len(triangles))

    def step(context: Any) -> dict[str, Any]:
        def inspect(*mesh: NDArray) -> dict[str, Any]:
            return extension.inspect(*mesh, threads=threads, context=context)

        facts = _require_solid(inspect(vertices, triangles), label, "is not a valid solid")
        # A folder beside the target: renaming within a file system is whole or not at all.
        with tempfile.TemporaryDirectory(prefix=".thicken-", dir=target.parent) as folder:
            written = Path(folder) / f"solid{target.suffix.lower()}"
            extension.write_mesh(written, vertices, triangles)
            again = inspect(*read_back(written))
            _require_solid(again, label, f"is not valid once it is written to {target.name}")
            if (again["volume_mm3"], len(again["shells"])) != (facts["volume_mm3"], len(facts["shells"])):
                raise RefusedError(f"What was read back from {target.name} is not what was written.")
            os.replace(written, target)
        return {
            "path": str(target),
            "triangles": len(triangles),
            "volume_ml": again["volume_mm3"] / 1000,
            "area_mm2": again["area_mm2"],
            "shells": len(again["shells"]),
        }

    return step


def read_back(path: Path) -> tuple[NDArray, NDArray]:
    """The vertices and triangles of a file that export_for_printing() wrote."""
    from thicken import native

    return native.load().read_mesh(path)


def _require_solid(facts: dict[str, Any], label: str, what: str) -> dict[str, Any]:
    if facts["status"] != "ok":
        reasons = " ".join(f"{d['sentence'][:1].upper()}{d['sentence'][1:]}." for d in facts["defects"])
        raise RefusedError(f"“{label}” {what}. {reasons}")
    return facts
