# SPDX-License-Identifier: LGPL-2.1-or-later
# The compiled extension, whose source is libthicken/python. A test compares the two.
from os import PathLike
from typing import Any, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
__abi__: int  #: of thicken.native

class ThickenError(RuntimeError):
    code: str
    defects: list[dict[str, Any]]
    input: dict[str, Any] | None
    repair: dict[str, Any] | None
    memory: dict[str, Any] | None
    time: dict[str, Any] | None

class SurfacePaths:
    def __init__(self, vertices: ArrayLike, triangles: ArrayLike, *, threads: int = 0) -> None: ...
    def path(self, points: ArrayLike, *, closed: bool = True, smooth: int = 0) -> NDArray[np.float64]: ...

class RunContext:
    memory_limit: int
    def __init__(self) -> None: ...
    def cancel(self) -> None: ...
    def set_time_limit(self, seconds: float) -> None: ...
    @property
    def cancelled(self) -> bool: ...
    @property
    def progress(self) -> float: ...
    @property
    def stage(self) -> str: ...

def thicken(
    vertices: ArrayLike,
    triangles: ArrayLike,
    thickness: float,
    *,
    side: str = "negative",
    method: str = "auto",
    precision: str = "single",
    cell: float | None = None,
    resolution: int | None = None,
    tolerance: float | None = None,
    smooth: int | None = None,
    repair: bool = False,
    weld: float | None = None,
    bridge: float | None = None,
    fill_holes: float | None = None,
    strict: bool = False,
    join: str | None = None,
    simplify: str = "auto",
    gap: float = 0.0,
    threads: int = 0,
    context: RunContext | None = None,
    thickness_map: Sequence[float] = [],
    rim_thickness: float | None = None,
    rim_width: float | None = None,
    rim_round: float | None = None,
) -> dict[str, Any]: ...
def forecast(
    triangles: int,
    area: float,
    thickness: float,
    *,
    diagonal: float = 0.0,
    side: str = "negative",
    method: str = "auto",
    cell: float | None = None,
    resolution: int | None = None,
    tolerance: float | None = None,
    gap: float = 0.0,
    threads: int = 0,
) -> tuple[float, int]: ...
def check(
    vertices: ArrayLike, triangles: ArrayLike, *, threads: int = 0, context: RunContext | None = None
) -> dict[str, Any]: ...
def repair_mesh(
    vertices: ArrayLike,
    triangles: ArrayLike,
    *,
    weld: float | None = None,
    bridge: float | None = None,
    fill_holes: float | None = None,
    threads: int = 0,
    context: RunContext | None = None,
) -> dict[str, Any]: ...
def trim(
    vertices: ArrayLike,
    triangles: ArrayLike,
    loops: list[ArrayLike],
    *,
    keep: Sequence[float] | None = None,
    smooth: int = 0,
    single: bool = True,
    threads: int = 0,
    context: RunContext | None = None,
) -> dict[str, Any]: ...
def divide_into_sheets(
    vertices: ArrayLike, triangles: ArrayLike
) -> list[tuple[NDArray[np.float64], NDArray[np.int64]]]: ...
def weld(vertices: ArrayLike, triangles: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.int64]]: ...
def read_mesh(path: str | PathLike[str]) -> tuple[NDArray[np.float64], NDArray[np.int64]]: ...
def write_mesh(
    path: str | PathLike[str], vertices: ArrayLike, triangles: ArrayLike, *, region: ArrayLike | None = None
) -> None: ...
def render_picture(
    vertices: ArrayLike,
    triangles: ArrayLike,
    *,
    colours: ArrayLike | None = None,
    region: ArrayLike | None = None,
    towards: Sequence[float],
    up: Sequence[float],
    size: tuple[int, int],
    cut: tuple[Sequence[float], Sequence[float]] | None = None,
) -> bytes: ...
def view_direction(up: Sequence[float], turn: float, rise: float) -> list[float]: ...
def inspect(
    vertices: ArrayLike, triangles: ArrayLike, *, threads: int = 0, context: RunContext | None = None
) -> dict[str, Any]: ...
def wall_thickness(
    vertices: ArrayLike,
    triangles: ArrayLike,
    *,
    edges: ArrayLike | None = None,
    threads: int = 0,
    context: RunContext | None = None,
) -> NDArray[np.float64]: ...
def closest_points(
    vertices: ArrayLike, triangles: ArrayLike, points: ArrayLike, *, context: RunContext | None = None
) -> dict[str, NDArray[Any]]: ...
def drill(
    vertices: ArrayLike,
    triangles: ArrayLike,
    places: Sequence[Sequence[float]],
    axes: Sequence[Sequence[float]],
    diameter: float,
    *,
    sides: int = 24,
    threads: int = 0,
    context: RunContext | None = None,
) -> dict[str, Any]: ...
