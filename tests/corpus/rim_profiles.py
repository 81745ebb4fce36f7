#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickens surfaces of a folder with profiles of the rim, and has the judge look at every solid.

usage: rim_profiles.py PROGRAM FOLDER --judge JUDGE [--count 20] [--percent 2] [-- OPTION...]

The thickness is --percent of the diagonal. In turn surfaces get an edge of half of that as its radius, a taper to half
of it over twice of it, and a taper to 0.8 of it with an edge of 0.5. The judge is told the thickness of each vertex, by
the formulas of docs/program.md, written here once more. What follows `--` goes to the program. A line a surface, then
medians and the largest; the exit status is 1 unless all solids are right.
"""

from __future__ import annotations

import argparse
import heapq
import itertools
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np
from thickness_maps import judged, read_mesh, survey, thickness_of

# Shares of the thickness: that of the rim, width, radius.
PROFILES = itertools.cycle([(None, None, 0.5), (0.5, 2, None), (0.8, 2, 0.5)])


def distances_to_rim(points: np.ndarray, triangles: np.ndarray, reach: float) -> np.ndarray:
    """Of each vertex, from the edge of the rim that its neighbours are nearest to; infinite far beyond `reach`."""
    edges = {(int(t[k]), int(t[(k + 1) % 3])) for t in triangles for k in range(3)}
    around = defaultdict(set)
    for a, b in edges:
        around[a].add(b)
        around[b].add(a)
    distance = np.full(len(points), np.inf)
    waiting = [(0.0, v, edge) for edge in edges if edge[::-1] not in edges for v in edge]
    distance[[v for _, v, _ in waiting]] = 0
    heapq.heapify(waiting)
    while waiting:
        far, v, (a, b) = heapq.heappop(waiting)
        if far > min(distance[v], reach):
            continue
        along = points[b] - points[a]
        for other in around[v]:
            share = np.clip((points[other] - points[a]) @ along / (along @ along), 0, 1)
            there = float(np.linalg.norm(points[a] + share * along - points[other]))
            if there < distance[other]:
                distance[other] = there
                heapq.heappush(waiting, (there, other, (a, b)))
    return distance


def profiled(distance: np.ndarray, rim: float | None, width: float | None, radius: float | None) -> np.ndarray:
    """The thickness so far from the rim, where it is 1 elsewhere."""
    r = np.ones(len(distance))
    if rim and width:
        r = rim + (1 - rim) * np.clip(distance / width, 0, 1)
    if radius:
        inward = np.clip(radius - distance, 0, None)
        r -= radius - np.sqrt(radius**2 - inward**2)
    return r


def judge_profiled(asked: argparse.Namespace, source: Path) -> dict[str, object]:
    points, triangles = read_mesh(source)
    r, profile = thickness_of(points, asked.percent), next(PROFILES)
    lengths = [share and float(f"{share * r:.6g}") for share in profile]
    distance = distances_to_rim(points, triangles, max(filter(None, lengths)))
    factors = profiled(distance / r, *(length and length / r for length in lengths))
    flags = zip(("--rim-thickness", "--rim-width", "--rim-round"), lengths)
    return judged(asked, (points, triangles), r, factors, [word for flag, mm in flags if mm for word in (flag, repr(mm))])


if __name__ == "__main__":
    sys.exit(survey(__doc__.splitlines()[0], judge_profiled))
