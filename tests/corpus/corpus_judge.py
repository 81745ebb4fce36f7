# SPDX-License-Identifier: LGPL-2.1-or-later
"""The corpus beside the project, and the judge that belongs to it."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

CORPUS = Path(os.environ["THICKEN_CORPUS"]).resolve()
PROGRAM = os.environ["THICKEN_PROGRAM"]
SKIPPED = 77


def judge_or_reason(needed: Path) -> str | None:
    """The path of the judge, built when it can be; without it or `needed` None, and the reason is printed."""
    script = CORPUS / "solidcheck" / "build.sh"
    if not script.exists() or not needed.exists():
        print(f"skipped: there is no corpus in {CORPUS}")
        return None
    build = subprocess.run([script], stdout=subprocess.PIPE, text=True)
    if build.returncode != 0 or not build.stdout.split():
        print("skipped: the judge cannot be built here (it needs libcgal-dev)")
        return None
    return build.stdout.split()[-1]
