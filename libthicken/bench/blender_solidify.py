# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inside Blender: print the seconds that Solidify takes on a surface, for each of its modes, as JSON.

usage: blender --background --factory-startup --python blender_solidify.py -- SURFACE.ply THICKNESS
"""

import json
import sys
import time
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from ply import read_ply  # noqa: E402 (Blender's path does not have this folder)


def load(path: Path) -> "bpy.types.Object":
    positions, corners = read_ply(path)
    mesh = bpy.data.meshes.new("surface")
    mesh.from_pydata(list(zip(*[iter(positions)] * 3)), [], list(zip(*[iter(corners)] * 3)))
    surface = bpy.data.objects.new("surface", mesh)
    bpy.context.collection.objects.link(surface)
    return surface


def seconds(surface: "bpy.types.Object", mode: str, thickness: float) -> float:
    """Of one evaluation: all that the scene has is the surface with the modifier."""
    modifier = surface.modifiers.new("solidify", "SOLIDIFY")
    modifier.solidify_mode = mode
    modifier.thickness, modifier.offset = thickness, -1
    modifier.use_even_offset = True
    start = time.perf_counter()
    made = surface.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    end = time.perf_counter()
    if len(made.polygons) < 2 * len(surface.data.polygons):
        raise RuntimeError("the modifier made no solid")
    surface.modifiers.remove(modifier)
    return end - start


def main() -> None:
    path, thickness = sys.argv[sys.argv.index("--") + 1 :]
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    surface = load(Path(path))
    bpy.context.view_layer.update()  # the surface itself is not what is measured
    print(json.dumps({name: seconds(surface, mode, float(thickness))
                      for name, mode in (("simple", "EXTRUDE"), ("complex", "NON_MANIFOLD"))}))  # fmt: skip


main()
