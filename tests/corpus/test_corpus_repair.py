# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickens every defective surface of the corpus with --repair and has each solid judged against the repaired surface.

Prints a table: file, thickness, verdict, code, what was removed. Exit status 77: skipped.
usage: test_corpus_repair.py [all] [TEXT]: every file at both thicknesses, not in turn; only files whose name holds TEXT
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from corpus_judge import CORPUS, PROGRAM, SKIPPED, judge_or_reason

SECONDS = 120
PERCENT = (1, 3)  # thickness, of the diagonal of the bounding box
LEAST_SOLVED = 0.95  # of the surfaces that cross themselves
# What a repair cannot help: there is no mesh, or none within what the numbers of a file can hold.
BEYOND_REPAIR = {"unreadable", "empty", "not-finite", "degenerate"}
MOST_REMOVED = 0.5  # of the area: a surface that loses more may be given up as no-solid


def read_json(path: Path) -> dict:
    return json.loads(path.read_text()) if path.exists() else {}


def diagonal(path: Path, folder: Path) -> float:
    """Of the bounding box; 0 where the file holds no mesh."""
    report = folder / "check.json"
    subprocess.run([PROGRAM, "check", path, "--report", report, "--quiet"], capture_output=True, timeout=SECONDS)
    return (read_json(report).get("input") or {}).get("diagonal_mm") or 0


def case(judge_path: str, path: Path, percent: float) -> dict:
    """What became of `path` at a thickness of `percent` of its diagonal."""
    row = {"file": f"{path.parent.name}/{path.name}", "percent": percent, "code": "", "note": "", "seconds": 0.0}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        size = diagonal(path, folder)
        thickness = f"{percent / 100 * size:.6g}" if size > 0 else "1"
        solid, repaired, report = folder / "solid.ply", folder / "repaired.ply", folder / "report.json"
        begin = time.monotonic()
        try:
            run = subprocess.run(
                [PROGRAM, path, solid, "--thickness", thickness, "--repair", "--repaired", repaired,
                 "--report", report, "--quiet"],
                capture_output=True, text=True, errors="replace", timeout=SECONDS,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return row | {"verdict": "timeout"}
        row["seconds"] = time.monotonic() - begin
        facts = read_json(report)
        changes = (facts.get("repair") or {}).get("changes", [])
        area = (facts.get("input") or {}).get("area_mm2") or 0
        removed = (facts.get("repair") or {}).get("removed_area_mm2", 0)
        row["removed"] = removed / area if area else 0
        row["changes"] = ", ".join(f"{change['count']} {change['kind']}" for change in changes)
        if run.returncode < 0 or run.returncode > 128:
            return row | {"verdict": "crashed", "note": run.stderr[-200:]}
        if run.returncode != 0:
            row["code"] = facts.get("code", "")
            return row | {"verdict": "refused", "note": (run.stderr.splitlines() or [""])[-1]}
        judged = subprocess.run([judge_path, "thicken", repaired, solid, thickness, "--samples", "1000"],
                                capture_output=True, text=True, timeout=10 * SECONDS)  # fmt: skip
        return row | {"verdict": "ok" if judged.returncode == 0 else "invalid", "note": ""}


def main() -> int:
    judge_path = judge_or_reason(CORPUS / "data" / "bad")
    if judge_path is None:
        return SKIPPED
    arguments = sys.argv[1:]
    every = "all" in arguments[:1]
    only = "".join(arguments[every:])
    files = [f for name in ("selfint", "bad") for f in sorted((CORPUS / "data" / name).iterdir()) if only in f.name]
    turns = [PERCENT if every else PERCENT[i % 2 : i % 2 + 1] for i in range(len(files))]
    cases = [(path, percent) for path, turn in zip(files, turns) for percent in turn]
    with ThreadPoolExecutor(2) as pool:
        rows = list(pool.map(lambda c: case(judge_path, *c), cases))
    for row in rows:
        print(f"{row['file']}\t{row['percent']} %\t{row['verdict']}\t{row['code']}\t{row['seconds']:.1f} s\t"
              f"{100 * row.get('removed', 0):.3g} % removed\t{row.get('changes', '')}\t{row['note'][:200]}")  # fmt: skip
    return verdict(rows)


def verdict(rows: list[dict]) -> int:
    crossing = [row for row in rows if row["file"].startswith("selfint/")]
    solved = sum(row["verdict"] == "ok" for row in crossing)
    if crossing:
        print(f"surfaces that cross themselves: {solved} of {len(crossing)} solved")
    wrong = [row for row in rows if row["verdict"] not in ("ok", "refused")]
    wrong += [row for row in rows if row["verdict"] == "refused" and row["file"].startswith("bad/")
              and row["code"] not in BEYOND_REPAIR
              and not (row["code"] == "no-solid" and row["removed"] > MOST_REMOVED)]  # fmt: skip
    for row in wrong:
        print(f"wrong: {row['file']} at {row['percent']} %: {row['verdict']} {row['code']}")
    return 1 if wrong or solved < LEAST_SOLVED * len(crossing) else 0


if __name__ == "__main__":
    sys.exit(main())
