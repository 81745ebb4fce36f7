#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trims random loops out of the surfaces of folders, checks every part, and keeps the parts for the judge.

usage: trim_loops.py PROGRAM PARTS COUNT [FOLDER...]

Loops are drawn as a person would: points around a place at about the same way from it along the surface, or along a
cut with a plane, up to 0.2 % of the diagonal off the surface. COUNT loops are spread over all surfaces; each is the
same in every run. Parts are written into the folder PARTS. One line a loop, then the sum:

    valid       the part passes `thicken check`; its untouched triangles are triangles of the surface, bit for bit;
                every new corner is on the surface, and the rim leads through every point of the loop, to rounding
    refused     with its reason
    left out    no closed curve was found on the surface, which does not count
    wrong       what was found; the exit status is 1 then

The parts are then thickened and judged like any surface:
    python3 ../shared/bench/corpus.py trim --set PARTS --r d2 --tool 'build/bin/thicken {in} {out} --thickness {r} --quiet'
"""

from __future__ import annotations

import heapq
import json
import subprocess
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
from thicken import native, read_mesh

SECONDS = 120
TRIES = 20  # of places and planes for a loop
ROUNDING = 17  # steps of float at the farthest coordinate that a corner may be off: 16 and its own rounding


def edges_of(triangles: np.ndarray) -> np.ndarray:
    return np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])


def ways_from(start: int, points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Lengths of the shortest ways along edges from a vertex; infinite where none leads."""
    both = edges_of(triangles)
    both = np.concatenate([both, both[:, ::-1]])
    both = both[np.argsort(both[:, 0], kind="stable")]
    first = np.searchsorted(both[:, 0], np.arange(len(points) + 1))
    lengths = np.linalg.norm(points[both[:, 0]] - points[both[:, 1]], axis=1)
    way = np.full(len(points), np.inf)
    way[start] = 0
    waiting = [(0.0, start)]
    while waiting:
        d, v = heapq.heappop(waiting)
        if d > way[v]:
            continue
        for i in range(first[v], first[v + 1]):
            far, other = d + lengths[i], both[i, 1]
            if far < way[other]:
                way[other] = far
                heapq.heappush(waiting, (far, int(other)))
    return way


def separates(chain: list[tuple[int, int]], triangles: np.ndarray) -> bool:
    """Whether what lies on either side of a curve, given by the edges that it crosses, is connected only through it."""
    crossed = {e for a, b in chain for e in ((a, b), (b, a))}
    around: dict[int, list[int]] = {}
    for a, b in edges_of(triangles).tolist():
        if (a, b) not in crossed:
            around.setdefault(a, []).append(b)
            around.setdefault(b, []).append(a)
    seen, waiting = {chain[0][0]}, [chain[0][0]]
    while waiting:
        for v in around.get(waiting.pop(), ()):
            if v not in seen:
                seen.add(v)
                waiting.append(v)
    return chain[0][1] not in seen


def contours(points: np.ndarray, triangles: np.ndarray, values: np.ndarray, least: float) -> list[np.ndarray]:
    """The closed curves that cut a part off, where a value of each vertex, linear between, is 0, of a length of at least `least`."""
    above = values[triangles] > 0
    ahead: dict[tuple[int, int], tuple[int, int]] = {}
    for t in np.flatnonzero((above.sum(axis=1) % 3) != 0):
        ends = {}
        for k in range(3):
            a, b = int(triangles[t, k]), int(triangles[t, (k + 1) % 3])
            if above[t, k] != above[t, (k + 1) % 3]:
                ends[bool(above[t, k])] = (min(a, b), max(a, b))
        ahead[ends[True]] = ends[False]
    curves, seen = [], set()
    for start in list(ahead):
        chain, at = [], start
        while at not in seen and at in ahead:
            seen.add(at)
            chain.append(at)
            at = ahead[at]
        if len(chain) < 3 or at != start or not np.isfinite(values[np.array(chain)]).all():
            continue
        a, b = np.array(chain).T
        curve = points[a] + (values[a] / (values[a] - values[b]))[:, None] * (points[b] - points[a])
        if length_of(curve) > least and separates(chain, triangles):
            curves.append(curve)
    return curves


def length_of(curve: np.ndarray) -> float:
    return float(np.linalg.norm(np.roll(curve, -1, axis=0) - curve, axis=1).sum())


def sampled(curve: np.ndarray, count: int) -> np.ndarray:
    closed = np.vstack([curve, curve[:1]])
    at = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    places = np.linspace(0, at[-1], count, endpoint=False)
    return np.column_stack([np.interp(places, at, closed[:, k]) for k in range(3)])


def random_loop(rng: np.random.Generator, points: np.ndarray, triangles: np.ndarray) -> np.ndarray | None:
    """None where no curve that was tried is closed, as on a narrow strip."""
    diagonal = np.linalg.norm(np.ptp(points, axis=0))
    for _ in range(TRIES):
        start = int(triangles[rng.integers(len(triangles)), 0])
        if rng.random() < 0.7:
            way = ways_from(start, points, triangles)
            radius = rng.uniform(0.15, 0.6) * way[np.isfinite(way)].max()
            fields = [way - radius * share for share in (1, 0.5, 0.25)]  # a smaller one where the rim is too near
        else:
            axis = rng.normal(size=3)
            fields = [(points - points[start]) @ (axis / np.linalg.norm(axis)) + 1e-7 * diagonal * rng.random()]
        for values in fields:
            curves = contours(points, triangles, values, 0.1 * diagonal)
            if curves:
                curve = curves[rng.integers(len(curves))]
                count = int(np.clip(length_of(curve) / (rng.uniform(0.01, 0.04) * diagonal), 8, 300))
                return sampled(curve, count) + rng.uniform(-0.001, 0.001, (count, 3)) * diagonal
    return None


def distance_to_rim(places: np.ndarray, points: np.ndarray, triangles: np.ndarray) -> float:
    """The farthest of some places from the rim."""
    directed = {tuple(e) for e in edges_of(triangles).tolist()}
    rim = np.array([e for e in directed if (e[1], e[0]) not in directed])
    a, along = points[rim[:, 0]], points[rim[:, 1]] - points[rim[:, 0]]
    farthest = 0.0
    for p in places:
        share = np.clip(((p - a) * along).sum(axis=1) / (along**2).sum(axis=1), 0, 1)
        farthest = max(farthest, np.linalg.norm(a + share[:, None] * along - p, axis=1).min())
    return farthest


def fault(program: str, loop: np.ndarray, surface: tuple, part_path: Path, report: dict) -> str | None:
    """What is wrong with a part, if anything."""
    check = subprocess.run([program, "check", part_path, "--quiet"], capture_output=True, text=True, timeout=SECONDS)
    if check.returncode != 0:
        return f"no valid surface: {check.stderr.strip()}"
    (points, triangles), (new_points, new_triangles) = surface, read_mesh(part_path)
    own = {corners.tobytes() for k in range(3) for corners in points[np.roll(triangles, k, axis=1)]}
    untouched = report["untouched_triangles"]
    if any(corners.tobytes() not in own for corners in new_points[new_triangles[:untouched]]):
        return "an untouched triangle is none of the surface's"
    rounding = ROUNDING * np.spacing(np.float32(np.abs(points).max()))
    on = native.load().closest_points(points, triangles, new_points)["distance"].max()
    if on > rounding:
        return f"a corner is {on:.3g} mm off the surface"
    foot = native.load().closest_points(points, triangles, loop)["point"]
    off = distance_to_rim(foot, new_points, new_triangles)
    allowed = max(rounding, 2 * report["path_deviation_mm"])
    if off > allowed:
        return f"the rim is {off:.3g} mm off a point of the loop"
    if report["path_deviation_mm"] > rounding:
        print(f"  {part_path.name}: corners were moved by {report['path_deviation_mm']:.3g} mm ({rounding:.3g} is rounding)")
    return None


def trim(program: str, source: Path, surface: tuple, parts: Path, seed: int) -> tuple[str, str]:
    rng = np.random.default_rng([seed, *source.name.encode()])
    loop = random_loop(rng, *surface)
    if loop is None:
        return "left out", "no closed curve"
    name = parts / f"{source.stem}_{seed}"
    np.savetxt(f"{name}.txt", loop)
    part, report = Path(f"{name}.ply"), Path(f"{name}.json")
    run = subprocess.run([program, "trim", source, part, "--loop", f"{name}.txt", "--report", report, "--quiet"],
                         capture_output=True, text=True, timeout=SECONDS)  # fmt: skip
    if run.returncode == 2:
        return "refused", run.stderr.strip().splitlines()[-1]
    if run.returncode != 0:
        return "wrong", f"status {run.returncode}: {run.stderr.strip()}"
    found = fault(program, loop, surface, part, json.loads(report.read_text()))
    return ("wrong", found) if found else ("valid", "")


def main() -> int:
    program, parts, count = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3])
    sources = sorted(path for folder in sys.argv[4:] for path in Path(folder).glob("*.ply"))
    parts.mkdir(parents=True, exist_ok=True)
    tally = {"valid": 0, "refused": 0, "wrong": 0, "left out": 0}
    step = max(1, len(sources) // count)  # of few loops, none is on two surfaces that are neighbours by name
    i = 0
    while sum(tally.values()) - tally["left out"] < count and i < 3 * count + len(sources):
        source, seed = sources[i * step % len(sources)], i * step // len(sources)
        verdict, why = trim(program, source, read_mesh(source), parts, seed)
        tally[verdict] += 1
        print(f"{source.stem} {seed}: {verdict} {why}", flush=True)
        i += 1
    print(", ".join(f"{n} {verdict}" for verdict, n in tally.items()))
    return 1 if tally["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
