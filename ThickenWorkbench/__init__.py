# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickens open mesh surfaces into printable solids, on NumPy arrays and in FreeCAD documents.

Names are loaded when they are first used: the package can be imported, and documents with its
features opened, where the compiled extension is missing; what needs it then says why it failed.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

__version__ = "0.1.0"

if TYPE_CHECKING:
    from ._thicken import RunContext, ThickenError
    from .arrays import Region, ThickenedMesh, check_mesh, read_mesh, thicken_mesh, weld_mesh, write_mesh
    from .feature import make_thicken

_HOMES = {
    "Region": "arrays",
    "ThickenedMesh": "arrays",
    "check_mesh": "arrays",
    "read_mesh": "arrays",
    "thicken_mesh": "arrays",
    "weld_mesh": "arrays",
    "write_mesh": "arrays",
    "make_thicken": "feature",
    "RunContext": "native",
    "ThickenError": "native",
}
__all__ = sorted(_HOMES)


def __getattr__(name: str):
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    module = import_module(f"{__name__}.{home}")
    owner = module.load() if home == "native" else module
    return getattr(owner, name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
