# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickens open mesh surfaces into printable solids in FreeCAD documents, and what `thicken` does on NumPy arrays.

Names are loaded when they are first used: the package can be imported, and documents with its
features opened, where the compiled extension is missing; what needs it then says why it failed.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

import thicken

__version__ = "0.2.0"

if TYPE_CHECKING:
    from thicken import (
        Region,
        RepairedMesh,
        RunContext,
        SurfacePaths,
        ThickenedMesh,
        ThickenError,
        TrimmedMesh,
        check_mesh,
        divide_into_sheets,
        forecast_mesh,
        read_mesh,
        repair_mesh,
        size_of,
        thicken_mesh,
        trim,
        weld_mesh,
        write_mesh,
    )

    from .check_surface import check_surface
    from .drain_holes import make_drain_holes
    from .export import export_for_printing
    from .feature import make_thicken
    from .part_solid import make_part_solid, part_solid, part_solid_of
    from .printability import printability
    from .regions import facet_regions
    from .repair_feature import make_repair
    from .report_page import write_report
    from .thickness_map import thickness_map
    from .thickness_regions import facets_near, set_thickness_regions, thickness_regions
    from .trim_feature import make_trim

_HOMES = {
    **dict.fromkeys([*thicken.OF_ARRAYS, *thicken.OF_EXTENSION], "thicken"),
    "check_surface": "check_surface",
    "make_drain_holes": "drain_holes",
    "export_for_printing": "export",
    "make_thicken": "feature",
    "make_part_solid": "part_solid",
    "part_solid": "part_solid",
    "part_solid_of": "part_solid",
    "printability": "printability",
    "write_report": "report_page",
    "facet_regions": "regions",
    "make_repair": "repair_feature",
    "thickness_map": "thickness_map",
    **dict.fromkeys(["facets_near", "set_thickness_regions", "thickness_regions"], "thickness_regions"),
    "make_trim": "trim_feature",
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
    return getattr(thicken if home == "thicken" else import_module(f"{__name__}.{home}"), name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
