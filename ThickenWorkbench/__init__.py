# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickens open mesh surfaces into printable solids, on NumPy arrays and in FreeCAD documents.

Names are loaded when they are first used: the package can be imported, and documents with its
features opened, where the compiled extension is missing; what needs it then says why it failed.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

if TYPE_CHECKING:
    from ._thicken import RunContext, ThickenError
    from .arrays import (
        Region,
        RepairedMesh,
        ThickenedMesh,
        check_mesh,
        divide_into_sheets,
        forecast_mesh,
        read_mesh,
        repair_mesh,
        size_of,
        thicken_mesh,
        weld_mesh,
        write_mesh,
    )
    from .check_surface import check_surface
    from .drain_holes import make_drain_holes
    from .export import export_for_printing
    from .feature import make_thicken
    from .part_solid import make_part_solid, part_solid, part_solid_of
    from .printability import printability, write_report
    from .regions import facet_regions
    from .repair_feature import make_repair
    from .thickness_map import thickness_map

_HOMES = {
    "Region": "arrays",
    "RepairedMesh": "arrays",
    "ThickenedMesh": "arrays",
    "check_mesh": "arrays",
    "divide_into_sheets": "arrays",
    "forecast_mesh": "arrays",
    "read_mesh": "arrays",
    "repair_mesh": "arrays",
    "size_of": "arrays",
    "thicken_mesh": "arrays",
    "weld_mesh": "arrays",
    "write_mesh": "arrays",
    "check_surface": "check_surface",
    "make_drain_holes": "drain_holes",
    "export_for_printing": "export",
    "make_thicken": "feature",
    "make_part_solid": "part_solid",
    "part_solid": "part_solid",
    "part_solid_of": "part_solid",
    "printability": "printability",
    "write_report": "printability",
    "facet_regions": "regions",
    "make_repair": "repair_feature",
    "thickness_map": "thickness_map",
    "RunContext": "native",
    "ThickenError": "native",
}
__all__ = sorted(_HOMES)


class _Package(ModuleType):
    """Some functions have the name of their module. Importing a module puts it into its package by
    its name: here the function stays what the name means."""

    def __setattr__(self, name: str, value: Any) -> None:
        if not (name in _HOMES and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package


def __getattr__(name: str):
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    module = import_module(f"{__name__}.{home}")
    owner = module.load() if home == "native" else module
    return getattr(owner, name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
