# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trims a few random loops out of surfaces of the corpus; every part has to be right, and thickened ok to the judge.

More of the same: trim_loops.py. Exit status 77: skipped.
"""

from __future__ import annotations

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

from corpus_judge import CORPUS, PROGRAM, SKIPPED, judge_or_reason

LOOPS = 8
TOOL = f"{PROGRAM} {{in}} {{out}} --thickness {{r}} --quiet"


def main() -> int:
    judge_path = judge_or_reason(CORPUS / "bench" / "corpus.py")
    if judge_path is None:
        return SKIPPED
    try:
        import trim_loops

        trim_loops.native.load()
    except ImportError as error:
        print(f"skipped: {error}")
        return SKIPPED
    with tempfile.TemporaryDirectory() as work:
        parts, table = Path(work) / "parts", Path(work) / "rows.tsv"
        done = subprocess.run([sys.executable, "trim_loops.py", PROGRAM, parts, str(LOOPS),
                               CORPUS / "data/open", CORPUS / "data/closed"], stdout=subprocess.PIPE, text=True)  # fmt: skip
        print(done.stdout)
        if done.returncode != 0 or len(list(parts.glob("*.ply"))) < LOOPS:
            return 1
        subprocess.run([sys.executable, CORPUS / "bench" / "corpus.py", "trim", "--tool", TOOL, "--set", parts, "--r", "d2",
                        "--samples", "2000", "--judge", judge_path, "--out", table], check=True)  # fmt: skip
        with table.open(newline="") as rows:
            verdicts = [(row["case"], row["verdict"], row["note"][:200]) for row in csv.DictReader(rows, delimiter="\t")]
    wrong = [verdict for verdict in verdicts if verdict[1] != "ok"]
    print(*wrong, f"{len(verdicts) - len(wrong)} of {len(verdicts)} are ok", sep="\n")
    return 1 if wrong or len(verdicts) < LOOPS else 0


if __name__ == "__main__":
    sys.exit(main())
