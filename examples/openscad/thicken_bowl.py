# SPDX-License-Identifier: LGPL-2.1-or-later
"""Takes the outer skin of the bowl that OpenSCAD exported, thickens it, and writes shell.stl.

    python3 thicken_bowl.py bowl.stl shell.stl [THICKNESS]
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import numpy as np

import ThickenWorkbench


def skin(vertices, triangles):
    """The triangles that do not lie in the plane of the lid."""
    lid = vertices[:, 2].max()
    return triangles[(vertices[triangles, 2] < lid - 1e-6).any(axis=1)]


def main(source, target, thickness=1.6):
    vertices, triangles = ThickenWorkbench.read_mesh(source)
    vertices = vertices.astype(np.float32)
    solid = ThickenWorkbench.thicken_mesh(vertices, skin(vertices, triangles), float(thickness))
    ThickenWorkbench.write_mesh(target, solid.vertices, solid.triangles)
    print(f"{target}: {solid.report['output']['volume_ml']:.3g} mL")


if __name__ == "__main__":
    main(*sys.argv[1:])
