# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judges an STL file by reading its bytes, without FreeCAD and without the library."""

from __future__ import annotations

import json
import os
import subprocess
from collections import Counter
from pathlib import Path

import numpy as np

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def read_stl(path) -> np.ndarray:
    """The corners of a binary STL: m × 3 × 3 floats."""
    content = Path(path).read_bytes()
    (count,) = np.frombuffer(content, "<u4", 1, 80)
    if len(content) != 84 + count * _RECORD.itemsize:
        raise ValueError(f"{path} is no binary STL of {count} triangles")
    return np.frombuffer(content, _RECORD, count, 84)["corners"]


def keys(corners: np.ndarray) -> list[tuple[bytes, bytes, bytes]]:
    """Each triangle as the bits of its corners, the least first, the sense kept; −0 is 0."""
    result = []
    for triangle in corners.astype("<f4") + np.float32(0):
        bits = [corner.tobytes() for corner in triangle]
        first = bits.index(min(bits))
        result.append((bits[first], bits[(first + 1) % 3], bits[(first + 2) % 3]))
    return result


def is_closed_and_oriented(corners: np.ndarray) -> bool:
    """Whether every edge is used once in each direction, corners being the same by their bits."""
    uses = Counter((t[k], t[(k + 1) % 3]) for t in keys(corners) for k in range(3))
    return all(count == 1 and uses[to, start] == 1 for (start, to), count in uses.items())


def volume(corners: np.ndarray) -> float:
    a, b, c = corners.astype(float).transpose(1, 0, 2)
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def keeps(corners: np.ndarray, surface: np.ndarray, reversed_sense: bool = False) -> bool:
    """Whether every triangle of `surface` (m × 3 × 3) is among `corners`, bit for bit."""
    wanted = surface[:, ::-1] if reversed_sense else surface
    return set(keys(wanted)) <= set(keys(corners))


def independent_judge() -> str | None:
    """The program `solidcheck`, where SOLIDCHECK names it or its source lies beside the project."""
    named = os.environ.get("SOLIDCHECK")
    if named:
        return named
    script = Path(__file__).resolve().parents[3] / "shared" / "solidcheck" / "build.sh"
    if not script.is_file():
        return None
    built = subprocess.run(["sh", script], capture_output=True, text=True)
    return built.stdout.strip() if built.returncode == 0 else None


def assert_judged_solid(case, path) -> None:
    """Fail `case` unless the judge finds a solid in the file; skip it where there is no judge."""
    program = independent_judge()
    if program is None:
        case.skipTest("no solidcheck: set SOLIDCHECK to its path")
    run = subprocess.run([program, "solid", path], capture_output=True, text=True)
    case.assertEqual(run.returncode, 0, run.stdout)


def judgement(program: str, surface: Path, solid: Path, thickness: float, side: str) -> tuple[int, dict]:
    """Exit status (0: every hard property holds) and facts of `solidcheck thicken`."""
    run = subprocess.run(
        [program, "thicken", surface, solid, str(thickness), "--side", side], capture_output=True, text=True
    )
    return run.returncode, json.loads(run.stdout)
