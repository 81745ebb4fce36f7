#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the stages of the reconstruction, after the figures 5 to 9, 13 and 14 of the paper.

usage: stage_pictures.py BUILD_FOLDER OUTPUT_FOLDER

scripts/stage_pictures builds what this needs and calls it.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np
from picture import beside
from picture import draw as draw_mesh
from PIL import Image

DATA = Path(__file__).resolve().parent.parent / "data"
BONE, PAWN = DATA / "femur.ply", DATA / "pawn.ply"
THICKNESS, CELL = 5.0, 1.6  # mm: wide cells, so that they can be seen
VIEW = (-0.75, 0.6, 0.25)  # that the eye looks in
SIZE = (620, 560)
REGIONS = np.array([(236, 201, 92), (110, 150, 205), (200, 82, 70)], float)
REGION_NAMES = ("original surface", "shell", "wall")
NODES = {"i": (90, 160, 90), "f": (110, 150, 205), "b": (236, 201, 92), "r": (200, 82, 70)}
NODE_NAMES = {"i": "inside", "f": "too far", "b": "before S", "r": "beyond the rim"}


class Plane(NamedTuple):
    """Keeps what lies on the side that the normal points away from."""

    point: np.ndarray
    normal: np.ndarray


def draw(vertices, triangles, colours, towards, size, cut: Plane | None = None) -> Image.Image:
    return draw_mesh(vertices, triangles, colours, towards=towards, size=size, cut=cut)


def read_ply(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and triangles of a binary little-endian PLY of floats or doubles."""
    head, body = path.read_bytes().split(b"end_header\n", 1)
    words = head.split()
    vertices = int(words[words.index(b"vertex") + 1])
    faces = int(words[words.index(b"face") + 1])
    real = "<f8" if b"property double x" in head else "<f4"
    positions = np.frombuffer(body, real, 3 * vertices).reshape(-1, 3).astype(float)
    start = 3 * vertices * np.dtype(real).itemsize
    rows = np.frombuffer(body, np.dtype([("count", "u1"), ("corner", "<i4", 3)]), faces, start)
    assert (rows["count"] == 3).all()
    return positions, rows["corner"].copy()


def write_ply(path: Path, vertices: np.ndarray, triangles: np.ndarray) -> None:
    used, corners = np.unique(triangles, return_inverse=True)
    rows = np.zeros(len(triangles), np.dtype([("count", "u1"), ("corner", "<i4", 3)]))
    rows["count"], rows["corner"] = 3, corners.reshape(-1, 3)
    head = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(used)}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    path.write_bytes(head.encode() + vertices[used].astype("<f8").tobytes() + rows.tobytes())


def cubes(lowest: np.ndarray, side: float) -> tuple[np.ndarray, np.ndarray]:
    """Triangles of cubes with these lowest corners."""
    corner = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float) * side
    quads = np.array([(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    vertices = (lowest[:, None, :] + corner[None]).reshape(-1, 3)
    triangles = (8 * np.arange(len(lowest))[:, None, None] + faces[None]).reshape(-1, 3)
    return vertices, triangles


def together(*parts: tuple[np.ndarray, np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Several meshes with their colours as one."""
    offsets = np.cumsum([0] + [len(vertices) for vertices, _, _ in parts[:-1]])
    return (
        np.concatenate([vertices for vertices, _, _ in parts]),
        np.concatenate([triangles + offset for (_, triangles, _), offset in zip(parts, offsets)]),
        np.concatenate([colours for _, _, colours in parts]),
    )


def plain(triangles: np.ndarray, colour) -> np.ndarray:
    return np.tile(np.asarray(colour, float), (len(triangles), 1))


def facing(vertices: np.ndarray, triangles: np.ndarray, towards) -> np.ndarray:
    """The triangles of an open surface, turned so that none shows its back."""
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    away = normals @ np.asarray(towards) > 0
    return np.where(away[:, None], triangles[:, ::-1], triangles)


def save(image: Image.Image, path: Path) -> None:
    image.quantize(256, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(path, optimize=True)
    print(path, image.size)


def node_picture(folder: Path, surface, plane: Plane) -> Image.Image:
    """The nodes that were evaluated, in a slice of a cell's width behind the plane (Figure 5)."""
    rows = [line.split() for line in (folder / "nodes.txt").read_text().splitlines()]
    places = np.array([row[:3] for row in rows], float)
    letters = np.array([row[3] for row in rows])
    depth = (places - plane.point) @ plane.normal
    slice_ = (depth <= 0) & (depth > -CELL)
    side = 0.45 * CELL
    parts = []
    for letter, colour in NODES.items():
        mesh = cubes(places[slice_ & (letters == letter)] - side / 2, side)
        parts.append((*mesh, plain(mesh[1], colour)))
    vertices, triangles, colours = together(*parts)
    return draw(vertices, triangles, colours, -plane.normal, SIZE)


def cell_picture(folder: Path, surface) -> Image.Image:
    """Cells that the carrier's rim passes (Figure 6)."""
    lines = (folder / "cells.txt").read_text().splitlines()
    cells = cubes(np.array([line.split() for line in lines[1:]], float), float(lines[0]))
    vertices, triangles = surface
    mesh = together((*cells, plain(cells[1], REGIONS[2])), (vertices, triangles, plain(triangles, REGIONS[0])))
    return draw(*mesh, VIEW, SIZE)


def solid_of(program: Path, source: Path, thickness: float, folder: Path, *words: str):
    out = folder / "solid.ply"
    subprocess.run([program, source, out, "--thickness", str(thickness), "--quiet", *words], check=True)
    return read_ply(out)


def upper_part(path: Path, share: float) -> tuple[np.ndarray, np.ndarray]:
    """The triangles of a closed model above a height, whole."""
    vertices, triangles = read_ply(path)
    low, high = vertices[:, 2].min(), vertices[:, 2].max()
    return vertices, triangles[vertices[triangles][:, :, 2].min(1) > low + share * (high - low)]


def hollowing(program: Path, folder: Path) -> Image.Image:
    """A hollowed closed model, cut, beside its clipped and then thickened upper part, cut (Figure 13)."""
    thickness = 0.03 * float(np.ptp(read_ply(PAWN)[0], axis=0).max())
    whole = solid_of(program, PAWN, thickness, folder)
    clipped = folder / "clipped.ply"
    write_ply(clipped, *upper_part(PAWN, 0.45))
    part = solid_of(program, clipped, thickness, folder)
    view = (0.3, 1, -0.25)
    pictures = []
    for vertices, triangles in (whole, part):
        plane = Plane((vertices.min(0) + vertices.max(0)) / 2, np.array([0.0, -1.0, 0.0]))
        pictures.append(draw(vertices, triangles, plain(triangles, REGIONS[1]), view, (430, 560), plane))
    return beside(pictures, [("left: hollowed", (110, 150, 205)), ("right: clipped, then thickened", (110, 150, 205))])


def deviation(program: Path, folder: Path) -> Image.Image:
    """S, coloured by whether the solid has its triangle bit for bit (Figure 14)."""
    vertices, triangles = read_ply(BONE)
    solid_vertices, solid_triangles = solid_of(program, BONE, THICKNESS, folder)

    def corners(positions: np.ndarray, rows: np.ndarray) -> list[bytes]:
        """Each triangle's coordinates, whichever corner comes first."""
        return [min(np.roll(row, k, axis=0).tobytes() for k in range(3)) for row in positions[rows]]

    there = set(corners(solid_vertices, solid_triangles))
    kept = np.array([key in there for key in corners(vertices, triangles)])
    colours = np.where(kept[:, None], np.array([(90, 160, 90)], float), np.array([(200, 82, 70)], float))
    picture = draw(vertices, triangles, colours, VIEW, SIZE)
    return beside([picture], [(f"deviation 0: {kept.sum()} triangles", (90, 160, 90)),
                              (f"moved: {(~kept).sum()}", (200, 82, 70))])  # fmt: skip


def main() -> None:
    build, out = Path(sys.argv[1]), Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    program = build / "bin" / "thicken"
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run([build / "bin" / "thicken_stages", BONE, str(THICKNESS), str(CELL), folder], check=True)
        surface = read_ply(BONE)
        plane = Plane((surface[0].min(0) + surface[0].max(0)) / 2, np.array([1.0, 0.0, 0.0]))
        legend = [(NODE_NAMES[letter], colour) for letter, colour in NODES.items()]
        save(beside([node_picture(folder, surface, plane)], legend), out / "nodes.png")
        save(beside([cell_picture(folder, surface)], [("cells of the rim", (200, 82, 70))]), out / "rim.png")
        regions = np.array((folder / "faces.txt").read_text().split(), int)
        new = regions != 0
        shaped = []
        for stage in ("faces", "shaped"):
            vertices, triangles = read_ply(folder / f"{stage}.ply")
            height = vertices[triangles][:, :, 2].mean(1)
            seen = new & (height < vertices[:, 2].min() + 0.3 * np.ptp(vertices[:, 2]))
            view = (-0.75, 0.6, 0.9)
            used, corners = np.unique(facing(vertices, triangles[seen], view), return_inverse=True)
            shaped.append(draw(vertices[used], corners.reshape(-1, 3), REGIONS[regions[seen]], view, SIZE))
        names = [(name, tuple(int(x) for x in colour)) for name, colour in zip(REGION_NAMES, REGIONS)]
        save(beside(shaped, names[1:]), out / "shape.png")
        vertices, triangles = read_ply(folder / "shaped.ply")
        save(beside([draw(vertices, triangles, REGIONS[regions], VIEW, SIZE, None)], names), out / "regions.png")
        save(hollowing(program, folder), out / "hollowing.png")
        save(deviation(program, folder), out / "deviation.png")


if __name__ == "__main__":
    main()
