# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases: a surface, a thickness, a side and the formats of the files, all of them from a seed and a number."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mesh_files import write_mesh
from surfaces import families, surface

# Of the diagonal of the bounding box.
LEAST_THICKNESS, MOST_THICKNESS = 0.0005, 0.3
# A thickness has to be some steps of the floats (docs/limits.md); with so many, no refusal is due to them.
LEAST_STEPS = 64


@dataclass(frozen=True)
class Case:
    name: str
    source: Path
    triangles: int
    thickness: float
    side: str
    suffix: str  # of the output


def make_case(seed: int, number: int, closed: Path, folder: Path) -> Case | None:
    """Writes the surface of the case into `folder`. None where it would cut a closed surface and `closed` has none."""
    random = np.random.default_rng([seed, number])
    choices = families(closed)
    family = choices[number % len(choices)]
    if family is None:
        return None
    vertices, triangles = surface(random, family)
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    share = np.exp(random.uniform(np.log(LEAST_THICKNESS), np.log(MOST_THICKNESS)))
    step = np.spacing(np.float32(np.abs(vertices).max()))
    thickness = float(f"{max(share * diagonal, LEAST_STEPS * step):.6g}")
    source_suffix, suffix = random.choice([".ply", ".stl"], 2)
    name = f"{seed}-{number}-{family.__name__}"
    source = folder / f"{name}{source_suffix}"
    write_mesh(source, vertices, triangles)
    side = str(random.choice(["negative", "positive"]))
    return Case(name, source, len(triangles), thickness, side, str(suffix))
