# SPDX-License-Identifier: LGPL-2.1-or-later
"""The main job in a FreeCAD without windows: import a scanned bone, thicken it, check and export it.

Run by scripts/demo. The solid is a jacket that fits the bone: it lies outside of it, and its inner
face is the scanned surface itself, triangle by triangle.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

import FreeCAD as App
import Mesh
import numpy as np

import picture
import ThickenWorkbench

PROJECT = Path(__file__).resolve().parents[2]
SURFACE = PROJECT / "examples" / "data" / "femur.ply"
THICKNESS = 3.0
SIDE = "positive"

COLOURS = np.array([(224, 190, 120), (110, 160, 215), (205, 95, 85)])  # original, shell, wall
CUT = (70, 74, 82)  # what the library paints the backs of triangles in
LEGEND = ["original surface", "shell", "wall"]


def require(condition: bool, what: str) -> None:
    if not condition:
        raise RuntimeError(f"the demo failed: {what}")


def make_feature(doc):
    """Import the surface and thicken it with the workbench's feature."""
    Mesh.insert(str(SURFACE), doc.Name)
    source = doc.Objects[0]
    require(source.Mesh.CountFacets == 8900, f"{SURFACE.name} was not imported whole")
    feature = ThickenWorkbench.make_thicken(doc, source, thickness=THICKNESS, side=SIDE)
    require("Invalid" not in feature.State, feature.getStatusString())
    return source, feature


def check_with_freecad(mesh) -> None:
    """FreeCAD's own opinion, beside the library's proof."""
    require(mesh.isSolid(), "FreeCAD finds the result open")
    require(not mesh.hasNonManifolds(), "FreeCAD finds the result non-manifold")
    require(not mesh.hasNonUniformOrientedFacets(), "FreeCAD finds the result inconsistently oriented")
    require(not mesh.hasSelfIntersections(), "FreeCAD finds the result self-intersecting")
    require(mesh.Volume > 0, "FreeCAD finds no volume")


def corner_sets(mesh) -> set:
    """The triangles of a FreeCAD mesh as sets of exact coordinates."""
    points, facets = mesh.Topology
    corners = [(p.x, p.y, p.z) for p in points]
    return {frozenset(corners[i] for i in facet) for facet in facets}


def export(doc, source, feature, folder: Path) -> Path:
    """Write STL and document, and read the STL back: it has to hold S and be a solid still."""
    stl = folder / "femur_solid.stl"
    stl.unlink(missing_ok=True)
    feature.Mesh.write(str(stl))
    read_back = Mesh.Mesh(str(stl))
    require(read_back.CountFacets == feature.Mesh.CountFacets, "triangles were lost in the STL")
    check_with_freecad(read_back)
    require(corner_sets(source.Mesh) <= corner_sets(read_back), "the STL lacks triangles of the bone")
    doc.saveAs(str(folder / "femur_solid.FCStd"))
    return stl


def draw_result(feature, png: Path) -> None:
    """Whole from the front, and cut open; the regions come from the library, through its NumPy door."""
    surface = ThickenWorkbench.read_mesh(SURFACE)
    solid = ThickenWorkbench.thicken_mesh(*surface, THICKNESS, side=SIDE)
    require(len(solid.triangles) == feature.TriangleCount, "NumPy and FreeCAD got different solids")
    middle = (solid.vertices.min(0) + solid.vertices.max(0)) / 2
    long_axis = np.argmax(np.ptp(solid.vertices, axis=0))
    up = np.eye(3)[long_axis]
    side = np.eye(3)[(long_axis + 1) % 3]
    towards = -(side + 0.5 * np.cross(up, side) + 0.25 * up)
    panels = [
        picture.draw(
            solid.vertices, solid.triangles, COLOURS[solid.region], towards=towards, up=up, size=(640, 800), cut=cut
        )
        for cut in (None, (middle, side))
    ]
    legend = [(name, tuple(colour)) for name, colour in zip(LEGEND, COLOURS.tolist())]
    picture.beside(panels, [*legend, ("cut through the material", CUT)]).save(png)


def print_facts(feature) -> None:
    print(f"surface        {SURFACE.relative_to(PROJECT)}, {feature.OriginalTriangles} triangles, all kept")
    print(f"thickness      {feature.Thickness.Value:g} mm on the {feature.Side.lower()} side")
    print(f"solid          {feature.TriangleCount} triangles: {feature.OriginalTriangles} original, "
          f"{feature.ShellTriangles} shell, {feature.WallTriangles} wall")  # fmt: skip
    print(f"proved valid   {'yes' if feature.Valid else 'no'}")
    print(f"volume         {feature.Volume.Value / 1000:.3f} mL")
    print(f"shell error    {100 * feature.ShellErrorMean:.3f} % mean, {100 * feature.ShellError:.3f} % at p99")
    print(f"thinnest wall  {feature.ThinnestWall.Value:.3f} mm")
    for warning in feature.Warnings:
        print(f"warning        {warning}")


def main() -> int:
    folder = Path(os.environ.get("THICKEN_DEMO_OUT", PROJECT / "out"))
    folder.mkdir(parents=True, exist_ok=True)
    png = folder / "femur_solid.png"
    png.unlink(missing_ok=True)
    doc = App.newDocument("Femur")
    source, feature = make_feature(doc)
    require(feature.Valid, "the result was not proved valid")
    check_with_freecad(feature.Mesh)
    stl = export(doc, source, feature, folder)
    draw_result(feature, png)
    print()
    print_facts(feature)
    print(f"written        {stl}")
    print(f"picture        {png}")
    print("demo: finished")
    sys.stdout.flush()
    return 0
