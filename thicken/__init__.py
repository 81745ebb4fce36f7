# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickens open triangle surfaces into printable solids: libthicken on NumPy arrays.

Names are loaded when they are first used: the package can be imported where the compiled extension
is missing; what needs it then says why it failed.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .native import NativeError

__version__ = "0.2.0"

if TYPE_CHECKING:
    from ._thicken import RunContext, SurfacePaths, ThickenError
    from .arrays import (
        Region,
        RepairedMesh,
        ThickenedMesh,
        TrimmedMesh,
        check_mesh,
        divide_into_sheets,
        forecast_mesh,
        read_mesh,
        render_picture,
        repair_mesh,
        size_of,
        thicken_mesh,
        trim,
        view_direction,
        weld_mesh,
        write_mesh,
    )

OF_ARRAYS = (
    "Region",
    "RepairedMesh",
    "ThickenedMesh",
    "TrimmedMesh",
    "check_mesh",
    "divide_into_sheets",
    "forecast_mesh",
    "read_mesh",
    "render_picture",
    "repair_mesh",
    "size_of",
    "thicken_mesh",
    "trim",
    "view_direction",
    "weld_mesh",
    "write_mesh",
)
OF_EXTENSION = ("RunContext", "SurfacePaths", "ThickenError")
__all__ = sorted([*OF_ARRAYS, *OF_EXTENSION, "NativeError"])


def __getattr__(name: str) -> Any:
    if name in OF_ARRAYS:
        return getattr(import_module(f"{__name__}.arrays"), name)
    if name in OF_EXTENSION:
        return getattr(import_module(f"{__name__}.native").load(), name)
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
