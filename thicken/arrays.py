# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickening, checking, reading and writing of meshes held in NumPy arrays. Lengths are mm.

Vertices are n × 3 real numbers, triangles m × 3 indices into them, counter-clockwise seen from the
positive side. Any real or integer type and any memory layout will do.
"""

from __future__ import annotations

import os
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Sequence

import numpy as np

from . import native

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._thicken import RunContext

_MIB = 1 << 20
_STEEL = (120, 160, 205)


class Region(IntEnum):
    """The part of the solid's boundary that a triangle belongs to."""

    ORIGINAL = 0  #: the surface itself
    SHELL = 1  #: the inner shell
    WALL = 2  #: the cross-section below the rim


class ThickenedMesh(NamedTuple):
    """A solid whose validity has been proved, and the facts about it."""

    vertices: NDArray[np.float64]  #: n × 3, those of weld_mesh() first
    triangles: NDArray[np.int64]  #: m × 3, the surface's own first and in their order
    region: NDArray[np.uint8]  #: m values of Region
    depth: NDArray[np.float64]  #: how deep the solid is below each vertex of the surface
    report: dict[str, Any]  #: the object of docs/report.md
    #: with `gap` the vertices and triangles of the surface there, which the solid keeps in place of the given one
    gap_surface: tuple[NDArray[np.float64], NDArray[np.int64]] | None = None


class RepairedMesh(NamedTuple):
    """A surface without defects, and what was done to make it one."""

    vertices: NDArray[np.float64]  #: n × 3
    triangles: NDArray[np.int64]  #: m × 3
    origin: NDArray[np.int64]  #: the triangle of the given surface that each one is, or is a part of; -1: added
    report: dict[str, Any]  #: the entry "repair" of docs/report.md


class TrimmedMesh(NamedTuple):
    """A part of a surface, cut out along loops, and the facts about it."""

    vertices: NDArray[np.float64]  #: n × 3
    triangles: NDArray[np.int64]  #: m × 3, those that no path divides first and in their order
    origin: NDArray[np.int64]  #: the triangle of the surface that each one is, or is a piece of
    paths: list[NDArray[np.float64]]  #: for each loop the corners of its path on the surface, k × 3
    report: dict[str, Any]  #: the object of docs/report.md


class SurfaceSize(NamedTuple):
    """What of a surface makes a run long."""

    triangles: int
    area: float  #: mm²
    diagonal: float  #: mm, of the bounding box


def size_of(vertices: ArrayLike, triangles: ArrayLike) -> SurfaceSize:
    """Return the size of a surface, as forecast_mesh() takes it."""
    points, corners = np.asarray(vertices, float), np.asarray(triangles)
    if not len(corners):
        return SurfaceSize(0, 0.0, 0.0)
    a, b, c = points[corners.T]
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
    return SurfaceSize(len(corners), float(area), float(np.linalg.norm(np.ptp(points, axis=0))))


def forecast_mesh(
    size: SurfaceSize,
    thickness: float,
    *,
    side: Literal["negative", "positive", "both"] = "negative",
    method: Literal["auto", "sweep", "reconstruct"] = "auto",
    cell: float | None = None,
    resolution: int | None = None,
    tolerance: float | None = None,
    gap: float = 0.0,
    threads: int = 0,
) -> tuple[float, int]:
    """Return the seconds and the bytes that thicken_mesh() is likely to take for a surface of this size.

    The seconds are of an idle machine like the one that the forecast was fitted on. Nothing is computed for it.
    """
    return native.load().forecast(
        *size[:2], thickness, diagonal=size.diagonal, side=side, method=method,
        cell=cell, resolution=resolution, tolerance=tolerance, gap=gap, threads=threads,
    )  # fmt: skip


def _with_factors(thickness: ArrayLike, vertices: ArrayLike) -> tuple[Any, Any]:
    """The largest of the thicknesses of the vertices, and factors of it; one number as it is."""
    if not np.ndim(thickness):
        return thickness, []
    lengths = np.asarray(thickness, float)
    if lengths.shape != np.shape(vertices)[:1] or not (np.isfinite(lengths).all() and (lengths > 0).all()):
        raise ValueError("thickness must be a length above 0 mm, or one for each vertex")
    return float(lengths.max()), lengths / lengths.max()


def _limited(context: RunContext | None, memory: float | None) -> RunContext | None:
    """The context with a limit of so many MiB, if there is one."""
    if memory is None:
        return context
    if not memory > 0:
        raise ValueError("memory must be a number of MiB above 0")
    context = context if context is not None else native.load().RunContext()
    context.memory_limit = int(memory * _MIB)
    return context


def thicken_mesh(
    vertices: ArrayLike,
    triangles: ArrayLike,
    thickness: float | ArrayLike,
    *,
    side: Literal["negative", "positive", "both"] = "negative",
    method: Literal["auto", "sweep", "reconstruct"] = "auto",
    cell: float | None = None,
    resolution: int | None = None,
    tolerance: float | None = None,
    smooth: int | None = None,
    repair: bool = False,
    weld: float | None = None,
    bridge: float | None = None,
    fill_holes: float | None = None,
    strict: bool = False,
    join: Literal["mitre", "round"] | None = None,
    simplify: Literal["off", "auto", "shell"] = "auto",
    gap: float = 0.0,
    rim_thickness: float | None = None,
    rim_width: float | None = None,
    rim_round: float | None = None,
    threads: int = 0,
    memory: float | None = None,
    precision: Literal["single", "double"] = "single",
    context: RunContext | None = None,
) -> ThickenedMesh:
    """Return the solid of `thickness` on one side of the surface, every triangle of which it keeps.

    `thickness` is a number of millimetres, or one for each vertex, linear over the triangles.
    Corners with equal coordinates become one vertex first, as by weld_mesh(). `precision` is that of the format the
    solid is meant for: with "single" (STL, FreeCAD) the surface is rounded to float before anything
    else, with "double" its coordinates stay; new vertices hold float values in either case.
    `join`: what the shell is like outside of convex edges and corners: "mitre", planes up to twice the thickness
    away (the default), or "round" (the default with `tolerance` and for "reconstruct").
    `weld`, `bridge` and `fill_holes`: with `repair`, as in repair_mesh(); `strict` refuses a solid that lost much by it.
    `simplify`: triangles to merge into fewer within the tolerance: "off", "auto", those of walls and of a shell that is
    denser than the surface, or "shell", all but the surface's own.
    `gap`: the solid begins so far from the surface; `gap_surface` of the result is what it keeps then.
    `rim_thickness` at the rim becomes `thickness` over `rim_width`; `rim_round`: radius of the edge of shell and wall.
    `memory` is a limit in MiB. `context` polls and cancels the run from another thread; Ctrl-C
    ends it as well. Other Python threads run meanwhile.

    Raises ThickenError for a surface that is refused and where no valid solid can be made, and
    TypeError or ValueError for arguments that make no sense.
    """
    context = _limited(context, memory)
    thickness, factors = _with_factors(thickness, vertices)
    solid = native.load().thicken(
        vertices,
        triangles,
        thickness,
        thickness_map=factors,
        side=side,
        method=method,
        precision=precision,
        cell=cell,
        resolution=resolution,
        tolerance=tolerance,
        smooth=smooth,
        repair=repair,
        weld=weld,
        bridge=bridge,
        fill_holes=fill_holes,
        strict=strict,
        join=join,
        simplify=simplify,
        gap=gap,
        rim_thickness=rim_thickness,
        rim_width=rim_width,
        rim_round=rim_round,
        threads=threads,
        context=context,
    )
    return ThickenedMesh(**solid)


def check_mesh(
    vertices: ArrayLike, triangles: ArrayLike, *, threads: int = 0, context: RunContext | None = None
) -> dict[str, Any]:
    """Return what kind of surface it is and every defect of it, as the object of docs/report.md.

    It is a valid input when the entry "defects" is empty. Vertex ids are those of weld_mesh().
    """
    return native.load().check(vertices, triangles, threads=threads, context=context)


def repair_mesh(
    vertices: ArrayLike,
    triangles: ArrayLike,
    *,
    weld: float | None = None,
    bridge: float | None = None,
    fill_holes: float | None = None,
    threads: int = 0,
    context: RunContext | None = None,
) -> RepairedMesh:
    """Return the surface without defects that docs/repair.md describes, as thicken_mesh(repair=True) uses it.

    In mm: `weld`, the farthest that rims may be apart to be joined; `bridge`, the widest gap to be closed by a strip
    between rims that run beside each other; `fill_holes`, the length that rims to be closed are shorter than. A valid
    surface comes back as weld_mesh() returns it where none of these is given. Raises ThickenError, with the code of the first defect, where nothing would remain.
    """
    mended = native.load().repair_mesh(
        vertices, triangles, weld=weld, bridge=bridge, fill_holes=fill_holes, threads=threads, context=context
    )
    return RepairedMesh(**mended)


def divide_into_sheets(
    vertices: ArrayLike, triangles: ArrayLike
) -> list[tuple[NDArray[np.float64], NDArray[np.int64]]]:
    """Return the sheets of a surface that has edges of three and more triangles, the largest first.

    Each can be thickened by itself, with repair=True where it has other defects, and a slicer unites the solids.
    """
    return native.load().divide_into_sheets(vertices, triangles)


def trim(
    vertices: ArrayLike,
    triangles: ArrayLike,
    loops: Sequence[ArrayLike],
    *,
    keep: Sequence[float] | None = None,
    smooth: int = 0,
    threads: int = 0,
    precision: Literal["single", "double"] = "single",
    context: RunContext | None = None,
) -> TrimmedMesh:
    """Return the part of a surface that closed loops border, as docs/trim.md describes it.

    `loops`: k × 3 points near the surface each; the last is joined to the first. `keep`: a point of the part that
    stays; without it the part inside of the loops. `smooth`: rounds of rounding the corners of the loops, 0 to 5.
    Triangles that no path divides stay bit for bit. Raises ThickenError where a loop cannot be followed, with the
    place in its defects, and where the part is no valid surface.
    """
    if precision not in ("single", "double"):
        raise ValueError(f"precision must be 'single' or 'double', not {precision!r}")
    part = native.load().trim(
        vertices, triangles, list(loops), keep=None if keep is None else tuple(map(float, keep)), smooth=smooth,
        single=precision == "single", threads=threads, context=context,
    )  # fmt: skip
    return TrimmedMesh(**part)


def render_picture(
    vertices: ArrayLike,
    triangles: ArrayLike,
    colours: ArrayLike | None = None,
    *,
    region: ArrayLike | None = None,
    towards: Sequence[float] | None = None,
    up: Sequence[float] = (0, 0, 1),
    size: tuple[int, int] = (640, 480),
    cut: tuple[Sequence[float], Sequence[float]] | None = None,
) -> bytes:
    """Return a picture of a mesh as the bytes of a PNG file: what looks along `towards` sees, without perspective.

    `colours`: m × 3 from 0 to 255, or one for all triangles. Or `region`, of a solid, for the colours of its regions;
    with neither all is of one colour. `towards`: by default from the front, the right and above. `cut`: a point of a
    plane and its normal, which faces the eye; what is on that side of the plane is taken away. Where a cut goes through
    material, and where a mesh is open, its backs are seen in a colour of their own.
    """
    extension = native.load()
    if colours is None and region is None:
        colours = _STEEL
    return extension.render_picture(
        vertices, triangles, colours=None if colours is None else np.atleast_2d(colours), region=region,
        towards=extension.view_direction(up, 30, 35) if towards is None else towards, up=up, size=size, cut=cut,
    )  # fmt: skip


def view_direction(up: Sequence[float], turn: float, rise: float) -> NDArray[np.float64]:
    """Return `towards` for an eye that went `turn` degrees around a part that grows along `up`, and `rise` above it."""
    return np.array(native.load().view_direction(up, turn, rise))


def weld_mesh(vertices: ArrayLike, triangles: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Return the mesh with corners of equal coordinates made one vertex, as every run begins.

    Vertices come in the order in which the triangles use them, triangles stay as they are. Results
    and defects name the vertices of this mesh.
    """
    return native.load().weld(vertices, triangles)


def read_mesh(path: str | os.PathLike[str]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Return the vertices and triangles of a .stl, .ply, .obj, .off or .3mf file, equal corners welded."""
    return native.load().read_mesh(path)


def write_mesh(
    path: str | os.PathLike[str], vertices: ArrayLike, triangles: ArrayLike, *, region: ArrayLike | None = None
) -> None:
    """Write .stl, .ply, .obj, .off or .3mf, by the extension of `path`, whole or not at all.

    With `region`, of a solid, a .3mf holds the regions of its triangles as colours; the other formats have none.
    """
    native.load().write_mesh(path, vertices, triangles, region=region)
