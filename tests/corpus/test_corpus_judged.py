# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickens a few surfaces of the corpus and has every result judged: each has to be ok.

The sample is spread over the set by order of names, so that no case was picked. Exit status 77: skipped.
"""

from __future__ import annotations

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

from corpus_judge import CORPUS, PROGRAM, SKIPPED, judge_or_reason

SAMPLES = [("open", "d1,d4", 12, ".ply"), ("open", "e2.5", 6, ".stl"), ("closed", "d1", 4, ".ply")]


def run(judge_path: str, folder: str, thicknesses: str, limit: int, suffix: str) -> list[dict]:
    with tempfile.TemporaryDirectory() as work:
        table = Path(work) / "rows.tsv"
        subprocess.run(
            [sys.executable, CORPUS / "bench" / "corpus.py", "sample",
             "--tool", f"{PROGRAM} {{in}} {{out}} --thickness {{r}} --quiet",
             "--set", CORPUS / "data" / folder, "--r", thicknesses, "--limit", str(limit), "--suffix", suffix,
             "--samples", "2000", "--timeout", "120", "--judge", judge_path, "--out", table],
            check=True,
        )  # fmt: skip
        with table.open(newline="") as rows:
            return list(csv.DictReader(rows, delimiter="\t"))


def main() -> int:
    judge_path = judge_or_reason(CORPUS / "bench" / "corpus.py")
    if judge_path is None:
        return SKIPPED
    wrong = []
    for sample in SAMPLES:
        rows = run(judge_path, *sample)
        if len(rows) < sample[2]:
            print(f"only {len(rows)} cases ran of {sample}")
            return 1
        wrong += [f"{r['case']} r={r['r']}: {r['verdict']} {r['note'][:200]}" for r in rows if r["verdict"] != "ok"]
    print("\n".join(wrong) or "every case is ok")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
