# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random surfaces that are valid, or nearly always so: oriented, manifold, and free of self-intersection by construction.

Each family takes a random generator and gives (vertices, triangles), of a size about 1.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from mesh_files import read_mesh

Surface = tuple[np.ndarray, np.ndarray]


def compact(vertices: np.ndarray, triangles: np.ndarray) -> Surface:
    """Without the vertices that no triangle uses."""
    used, index = np.unique(triangles, return_inverse=True)
    return vertices[used], index.reshape(-1, 3)


def manifold_again(triangles: np.ndarray) -> np.ndarray:
    """Of what is left of a manifold surface: without the triangles at vertices where fans only touch."""
    while len(triangles):
        starts = triangles.ravel()
        ends = np.roll(triangles, -1, axis=1).ravel()
        size = triangles.max() + 1
        rim = ~np.isin(starts * size + ends, ends * size + starts)
        pinched = np.flatnonzero(np.bincount(starts[rim], minlength=size) > 1)
        if len(pinched) == 0:
            break
        triangles = triangles[~np.isin(triangles, pinched).any(axis=1)]
    return triangles


def kept(surface: Surface, keep: np.ndarray) -> Surface:
    """The part of `surface` of the triangles `keep`; all of it when that part is empty."""
    vertices, triangles = surface
    part = manifold_again(triangles[keep])
    return compact(vertices, part) if len(part) else surface


def centres(surface: Surface) -> np.ndarray:
    return surface[0][surface[1]].mean(axis=1)


def cut(random: np.random.Generator, surface: Surface, planes: int) -> Surface:
    """Along whole triangles, so that the rims are jagged."""
    for _ in range(planes):
        normal = random.normal(size=3)
        height = centres(surface) @ (normal / np.linalg.norm(normal))
        surface = kept(surface, height < np.quantile(height, random.uniform(0.3, 0.95)))
    return surface


def holes(random: np.random.Generator, surface: Surface, count: int) -> Surface:
    for _ in range(count):
        points = centres(surface)
        distance = np.linalg.norm(points - points[random.integers(len(points))], axis=1)
        surface = kept(surface, distance > random.uniform(0.01, 0.15) * np.ptp(points, axis=0).max())
    return surface


def moth_eaten(random: np.random.Generator, surface: Surface) -> Surface:
    return kept(surface, random.random(len(surface[1])) > random.uniform(0.005, 0.1))


def grid(random: np.random.Generator, most: int = 45) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """u and v in [0, 1] of a triangulated rectangle, its corners shaken and its diagonals either way."""
    columns, rows = random.integers(2, most, 2)
    u, v = np.meshgrid(np.arange(columns + 1.0), np.arange(rows + 1.0))
    # Below a quarter of a cell to any side every triangle keeps its sense.
    shake = random.choice([0, 0.05, 0.22])
    u = (u + random.uniform(-shake, shake, u.shape)) / columns
    v = (v + random.uniform(-shake, shake, v.shape)) / rows
    i, j = (x.ravel() for x in np.meshgrid(np.arange(columns), np.arange(rows)))
    a = j * (columns + 1) + i
    b, c, d = a + 1, a + columns + 2, a + columns + 1
    other = (random.random(len(a)) < random.choice([0, 0.5, 1]))[:, None]
    first = np.where(other, np.stack([a, b, d], 1), np.stack([a, b, c], 1))
    second = np.where(other, np.stack([b, c, d], 1), np.stack([a, c, d], 1))
    return u.ravel(), v.ravel(), np.concatenate([first, second])


def cell_of(u: np.ndarray, v: np.ndarray) -> float:
    """The width of a square cell of as many vertices."""
    return float(np.sqrt(np.ptp(u) * np.ptp(v) / len(u)))


def relief(random: np.random.Generator, u: np.ndarray, v: np.ndarray, cell: float) -> np.ndarray:
    """Waves, bumps, a step and noise, the noise below the width of a cell and the rest some cells wide."""
    height = np.zeros_like(u)
    for _ in range(random.integers(0, 4)):
        f, g, phase = random.normal(0, min(8, 0.5 / cell), 3)
        height += 10 ** random.uniform(-3, -0.5) * np.sin(f * u + g * v + phase)
    for _ in range(random.integers(0, 4)):
        x, y, width = *random.random(2), max(10 ** random.uniform(-1.5, -0.3), 3 * cell)
        height += random.normal(0, width) * np.exp(-((u - x) ** 2 + (v - y) ** 2) / width**2)
    if random.random() < 0.2:
        height += 10 ** random.uniform(-3, -0.5) * (u > random.uniform(0.2, 0.8))
    if random.random() < 0.5:
        height += 10 ** random.uniform(-3, -0.5) * cell * random.normal(size=u.shape)
    return height


def height_field(random: np.random.Generator) -> Surface:
    """A graph cannot cross itself, whatever its heights."""
    u, v, triangles = grid(random)
    v = v * 10 ** random.uniform(-0.5, 0)
    return np.stack([u, v, relief(random, u, v, cell_of(u, v))], 1), triangles


def spiky_field(random: np.random.Generator) -> Surface:
    """The same with needles: noise and single vertices far higher than a cell is wide, and narrow cells."""
    u, v, triangles = grid(random, 25)
    v = v * 10 ** random.uniform(-1.5, 0)
    height = relief(random, u, v, cell_of(u, v)) + 10 ** random.uniform(-4, -0.5) * random.normal(size=u.shape)
    height[random.integers(len(u), size=3)] += random.normal(0, 0.5, 3)
    return np.stack([u, v, height], 1), triangles


def stack(random: np.random.Generator) -> Surface:
    """Height fields one above another, nearer than most thicknesses; neither do they meet. Some face down."""
    u, v, triangles = grid(random, 25)
    height, gap = relief(random, u, v, cell_of(u, v)), 10 ** random.uniform(-3, -0.5)
    vertices, sheets = [], []
    for k in range(random.integers(2, 4)):
        vertices.append(np.stack([u, v, height + k * gap], 1))
        sheet = triangles if random.random() < 0.6 else triangles[:, ::-1]
        sheets.append(sheet + k * len(u))
    return np.concatenate(vertices), np.concatenate(sheets)


def icosphere(rounds: int) -> Surface:
    g = (1 + 5**0.5) / 2
    vertices = np.array([(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
                         (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)], float)  # fmt: skip
    triangles = np.array([(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
                          (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5),
                          (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)])  # fmt: skip
    for _ in range(rounds):
        edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
        edges, index = np.unique(edges, axis=0, return_inverse=True)
        ab, bc, ca = index.reshape(3, -1) + len(vertices)
        a, b, c = triangles.T
        vertices = np.concatenate([vertices, vertices[edges].mean(axis=1)])
        triangles = np.concatenate([np.stack(t, 1) for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
    return vertices / np.linalg.norm(vertices, axis=1, keepdims=True), triangles


def cut_sphere(random: np.random.Generator) -> Surface:
    """Star-shaped about its middle, so that radii may be what they like; whole, or with pieces cut off."""
    vertices, triangles = icosphere(random.integers(0, 5))
    radius = np.ones(len(vertices))
    for _ in range(random.integers(0, 4)):
        direction = random.normal(size=3)
        radius *= 1 + random.uniform(0, 0.4) * np.sin(3 * vertices @ direction)
    radius *= 1 + 10 ** random.uniform(-5, -1) * random.uniform(-1, 1, len(vertices))
    shape = vertices * radius[:, None] * random.uniform(0.2, 1, 3)
    return cut(random, (shape, triangles), random.integers(0, 4))


def noisy_scan(random: np.random.Generator) -> Surface:
    """A part of a cylinder, a torus or a rolled sheet, shaken in every direction by less than its edges."""
    u, v, triangles = grid(random)
    turn = random.uniform(0.5, 5.5) * u
    kind = random.integers(3)
    if kind == 0:
        points = np.stack([np.cos(turn), np.sin(turn), 2 * v], 1)
    elif kind == 1:
        tube, around = random.uniform(0.1, 0.8), random.uniform(0.5, 5.5) * v
        points = np.stack([(1 + tube * np.cos(around)) * np.cos(turn), (1 + tube * np.cos(around)) * np.sin(turn),
                           tube * np.sin(around)], 1)  # fmt: skip
    else:
        turn *= 3
        radius = 0.3 + random.uniform(0.02, 0.1) * turn
        points = np.stack([radius * np.cos(turn), radius * np.sin(turn), v], 1)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    shortest = min(np.linalg.norm(x - y, axis=1).min() for x, y in ((a, b), (b, c), (c, a)))
    noise = random.uniform(0, 0.2) * shortest
    return points + random.uniform(-noise, noise, points.shape), triangles


def few_triangles(random: np.random.Generator) -> Surface:
    """A fan, flat or steep, down to a single triangle; or most of a tetrahedron."""
    if random.random() < 0.2:
        return random.normal(size=(4, 3)), np.array([(0, 1, 2), (0, 2, 3), (0, 3, 1)])[: random.integers(1, 4)]
    count = random.integers(3, 9)
    angle = np.sort(random.uniform(0, 2 * np.pi, count)) + np.arange(count) * 0.01
    ring = np.stack([np.cos(angle), np.sin(angle), random.normal(0, 0.3, count)], 1)
    ring[:, :2] *= random.uniform(0.05, 1, count)[:, None]
    apex = np.array([[0, 0, random.normal(0, 1)]])
    triangles = np.array([(0, k, k + 1) for k in range(1, count)])
    return np.concatenate([apex, ring]), triangles


def cut_part(files: list[Path]) -> Callable[[np.random.Generator], Surface]:
    """Of a closed surface among `files`, what planes leave of it."""

    def cut_closed(random: np.random.Generator) -> Surface:
        vertices, triangles = read_mesh(files[random.integers(len(files))])
        middle = (vertices.max(axis=0) + vertices.min(axis=0)) / 2
        return cut(random, ((vertices - middle) / np.ptp(vertices, axis=0).max(), triangles), random.integers(1, 5))

    return cut_closed


def families(closed: Path) -> list[Callable[[np.random.Generator], Surface] | None]:
    """All of them. None in the place of the one that cuts closed surfaces, where the folder `closed` has none."""
    files = sorted(closed.glob("*.ply")) if closed.is_dir() else []
    cut_closed = cut_part(files) if files else None
    return [height_field, spiky_field, stack, cut_sphere, noisy_scan, few_triangles, cut_closed]


def placed(random: np.random.Generator, surface: Surface) -> Surface:
    """Turned, scaled and moved anywhere a designer may have it, with float coordinates."""
    vertices, triangles = surface
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turn[:, 0] *= np.sign(np.linalg.det(turn))
    vertices = vertices if random.random() < 0.3 else vertices @ turn.T
    scale = 10 ** random.uniform(-2, 4)
    shift = random.choice([0, 1, 30]) * random.normal(size=3)
    return ((vertices + shift) * scale).astype(np.float32).astype(float), triangles


def surface(random: np.random.Generator, family: Callable[[np.random.Generator], Surface]) -> Surface:
    made = family(random)
    if random.random() < 0.25:
        made = holes(random, made, random.integers(1, 5))
    if random.random() < 0.15:
        made = moth_eaten(random, made)
    if random.random() < 0.3:
        made = made[0], made[1][:, ::-1]
    return placed(random, made)
