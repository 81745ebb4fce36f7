# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every bad file of the corpus: a documented status, no crash, no hang, nothing left on failure.

Exit status 77: skipped.
"""

from __future__ import annotations

import os
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

DATA = Path(os.environ["THICKEN_CORPUS"]).resolve() / "data"
PROGRAM = os.environ["THICKEN_PROGRAM"]
SECONDS = 20
MEMORY = 2 << 30
MOST_FILES = 30  # of the self-intersecting ones, which are large; the rest is small


def limit_memory() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (2 * MEMORY, 2 * MEMORY))  # address space: threads reserve much


def fault(path: Path) -> str | None:
    """What is wrong with how the program takes `path`, if anything."""
    with tempfile.TemporaryDirectory() as folder:
        command = [PROGRAM, path, "out.stl", "--thickness", "1"]
        try:
            run = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=SECONDS,
                                 preexec_fn=limit_memory)  # fmt: skip
        except subprocess.TimeoutExpired:
            return f"took more than {SECONDS} s"
        files = os.listdir(folder)
    if run.returncode == 0:
        return None if files == ["out.stl"] else f"success left {files}"
    if run.returncode not in (3, 4, 6):
        return f"status {run.returncode}: {run.stderr[-200:]}"
    if files:
        return f"a failure left {files}"
    last = (run.stderr.splitlines() or [""])[-1]
    return None if re.fullmatch(r"thicken: [a-z-]+: .+", last) else f"last line {last!r}"


def main() -> int:
    if not (DATA / "bad").is_dir():
        print(f"skipped: there is no corpus in {DATA}")
        return 77
    crossing = sorted((DATA / "selfint").iterdir())
    files = sorted((DATA / "bad").iterdir()) + crossing[:: max(1, len(crossing) // MOST_FILES)]
    faults = {path.name: text for path in files if (text := fault(path))}
    for name, text in faults.items():
        print(f"{name}: {text}")
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    peak = children.ru_maxrss * 1024
    print(f"{len(files)} files, {len(faults)} faults, largest memory {peak >> 20} MiB")
    return 1 if faults or peak > MEMORY else 0


if __name__ == "__main__":
    sys.exit(main())
