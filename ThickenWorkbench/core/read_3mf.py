# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the one mesh of a 3MF file that this project wrote: to check it, not to import others' files."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

_MODEL = "3D/3dmodel.model"
_CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


def read_3mf(path: str | Path) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """The vertices (mm) and triangles. Raises ValueError for a file of another unit or without a mesh."""
    with zipfile.ZipFile(path) as archive:
        root = ElementTree.fromstring(archive.read(_MODEL))
    if root.get("unit", "millimeter") != "millimeter":
        raise ValueError(f"{path} is in {root.get('unit')}, not in millimetres")
    mesh = root.find(f".//{_CORE}mesh")
    if mesh is None:
        raise ValueError(f"{path} has no mesh")
    vertices = [[float(v.attrib[axis]) for axis in "xyz"] for v in mesh.iter(f"{_CORE}vertex")]
    triangles = [[int(t.attrib[corner]) for corner in ("v1", "v2", "v3")] for t in mesh.iter(f"{_CORE}triangle")]
    return np.array(vertices).reshape(-1, 3), np.array(triangles, np.int64).reshape(-1, 3)
