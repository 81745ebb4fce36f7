# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guarantee, tried on random surfaces: every valid surface and thickness gives a valid solid that holds the surface.

A result is judged by `solidcheck` where the environment names it (SOLIDCHECK), and by checks of its own besides. Prints a line for
every case that is not ok, keeps its surface, and ends with a sum. Exit status 0: all were ok; 77: skipped.
"""

from __future__ import annotations

import argparse
import collections
import dataclasses
import json
import os
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
SKIPPED = 77
# By the clock, for each second that a run may take of the processor: the machine may be busy with other things.
PATIENCE = 15
SAMPLES = "2000"
FINE = {"ok", "no surface", "skipped"}
REFUSALS = {3, 4}  # exit statuses that are an answer to a surface; see docs/errors.md

try:
    from cases import Case, make_case
    from own_checks import what_is_wrong
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(SKIPPED)


def judged(judge: str, *arguments) -> dict:
    """What the judge says, as a dictionary with "ok"."""
    run = subprocess.run([judge, *map(str, arguments)], capture_output=True, text=True)
    try:
        return json.loads(run.stdout.splitlines()[-1])
    except (IndexError, ValueError):
        return {"ok": False, "error": f"the judge ended with {run.returncode}: {(run.stdout + run.stderr)[-300:]}"}


def failures(judgement: dict) -> str:
    """The figures that make a judgement bad, for people."""
    counts = ("boundary_edges", "nonmanifold_edges", "nonmanifold_vertices", "misoriented_edges", "degenerate",
              "self_intersecting_pairs")  # fmt: skip
    said = [f"{name}={judgement[name]}" for name in counts if judgement.get(name)]
    said += [f"{name}={judgement[name]}" for name in ("solid", "s_kept", "volume") if name in judgement]
    return judgement.get("error") or " ".join(said)


def run_limited(arguments: list[str], seconds: int) -> subprocess.CompletedProcess:
    """Ends with SIGXCPU after so many seconds of the processor; throws TimeoutExpired where the run only waits."""
    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))

    return subprocess.run(arguments, capture_output=True, text=True, timeout=PATIENCE * seconds, preexec_fn=limit)


def is_surface(program: str, judge: str | None, source: Path) -> bool:
    """Rounding to floats may make a sheet cross itself; that is no case then."""
    if judge:
        return bool(judged(judge, "surface", source).get("ok"))
    return subprocess.run([program, "check", source, "--quiet"], capture_output=True).returncode == 0


def command(program: str, case: Case, result: Path) -> list[str]:
    return [program, str(case.source), str(result), "--thickness", repr(case.thickness), "--side", case.side,
            "--threads", "1", "--quiet"]  # fmt: skip


def verdict_of(program: str, judge: str | None, case: Case, result: Path, seconds: int) -> tuple[str, str]:
    """A word and, where it is not ok, what there is to say."""
    try:
        run = run_limited(command(program, case, result), seconds)
    except subprocess.TimeoutExpired:
        return "timeout", f"nothing after {PATIENCE * seconds} s by the clock"
    if run.returncode == -signal.SIGXCPU:
        return "timeout", f"more than {seconds} s"
    last = (run.stderr.splitlines() or [""])[-1]
    if run.returncode in REFUSALS and re.fullmatch(r"thicken: [a-z-]+: .+", last) and not result.exists():
        return ("crashed" if ": internal: " in last else "refused"), last
    if run.returncode != 0:
        return "crashed", f"status {run.returncode}: {run.stderr[-300:]}"
    wrong = what_is_wrong(case.source, result, case.side)
    if not wrong and subprocess.run([program, "check", result, "--quiet"], capture_output=True).returncode != 0:
        wrong = "the program itself finds the solid defective"
    if not wrong and judge:
        judgement = judged(judge, "thicken", case.source, result, case.thickness, "--side", case.side, "--samples", SAMPLES)
        wrong = "" if judgement.get("ok") else failures(judgement)
    return ("invalid", wrong) if wrong else ("ok", "")


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=os.environ.get("THICKEN_PROGRAM", PROJECT / "build/bin/thicken"))
    parser.add_argument("--seed", type=int, default=1, help="another seed gives other cases")
    parser.add_argument("--count", type=int, default=100, help="how many")
    parser.add_argument("--first", type=int, default=0, help="number of the first; with --count 1 a single case again")
    parser.add_argument("--closed", type=Path, default=PROJECT / "../shared/data/closed", help="closed surfaces to cut")
    parser.add_argument("--keep", type=Path, default=PROJECT / "out/property", help="where surfaces with findings go")
    parser.add_argument("--seconds", type=int, default=120, help="of the processor, which a run may take")
    return parser.parse_args()


def keep(program: str, case: Case, verdict: str, note: str, folder: Path) -> None:
    """Copies the surface and prints what was found, with the command that finds it again."""
    folder.mkdir(parents=True, exist_ok=True)
    source = Path(shutil.copy(case.source, folder))
    again = command(program, dataclasses.replace(case, source=source), source.with_name(f"solid{case.suffix}"))
    print(f"{verdict}: {case.name}, {case.triangles} triangles: {note}\n    {shlex.join(again)}", flush=True)


def tried(program: str, judge: str | None, options: argparse.Namespace, number: int) -> str:
    """The verdict on the case of this number."""
    with tempfile.TemporaryDirectory() as folder:
        case = make_case(options.seed, number, options.closed, Path(folder))
        if case is None:
            return "skipped"
        if not is_surface(program, judge, case.source):
            return "no surface"
        verdict, note = verdict_of(program, judge, case, Path(folder) / f"solid{case.suffix}", options.seconds)
        if verdict not in FINE:
            keep(program, case, verdict, note, options.keep)
        return verdict


def main() -> int:
    options = arguments()
    program, judge = str(options.program), os.environ.get("SOLIDCHECK")
    if not options.closed.is_dir():
        print(f"without parts of closed surfaces: there is no {options.closed}")
    if not judge:
        print("without the judge: SOLIDCHECK does not name it")
    numbers = range(options.first, options.first + options.count)
    count = collections.Counter(tried(program, judge, options, number) for number in numbers)
    print(", ".join(f"{n} {word}" for word, n in count.most_common()))
    return 1 if set(count) - FINE else 0


if __name__ == "__main__":
    sys.exit(main())
