# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a change of the program does to the shells that it makes: one row a run, the programs side by side.

    python3 libthicken/bench/shell_errors.py ../shared/data/open build/bin/thicken other/bin/thicken --percent 3 --every 4

Only surfaces whose shell is a sweep with a contour in places are listed (`output.made_by`). For every program: triangles of the solid,
p99 and maximum of the shell's error where the solid is as deep as asked, in percent of the thickness, and places left to the sweep.
"""

from __future__ import annotations

import argparse
import json
import statistics
import subprocess
import tempfile
from pathlib import Path


def report_of(program: str, surface: Path, thickness: str) -> dict:
    with tempfile.TemporaryDirectory() as folder:
        command = ["bash", "-c", 'ulimit -t 120; exec "$@"', "run", program, surface, f"{folder}/solid.ply", "--thickness", thickness,
                   "--threads", "1", "--quiet", "--report", f"{folder}/report.json"]  # fmt: skip
        done = subprocess.run(command, stderr=subprocess.DEVNULL, check=False)
        return json.loads(Path(folder, "report.json").read_text()) if done.returncode == 0 else {}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--percent", type=float, default=3, help="thickness in percent of the diagonal")
    parser.add_argument("--every", type=int, default=1, help="take every nth surface")
    options = parser.parse_args()
    medians: list[list[float]] = [[] for _ in options.programs]
    for surface in sorted(options.folder.glob("*.ply"))[:: options.every]:
        with tempfile.TemporaryDirectory() as folder:
            checked = Path(folder, "check.json")
            subprocess.run([options.programs[0], "check", surface, "--quiet", "--report", checked], check=False)
            diagonal = json.loads(checked.read_text())["input"]["diagonal_mm"]
        row = [surface.stem]
        for i, program in enumerate(options.programs):
            report = report_of(program, surface, repr(options.percent / 100 * diagonal))
            if report.get("output", {}).get("made_by") != "sweep-and-contour":
                break
            error = report["shell_error_full_depth"]
            row.append(f"{report['output']['triangles']}\t{100 * error['p99']:.3f}\t{100 * error['max']:.2f}\t{len(report['fallbacks'])}")
            medians[i].append(100 * error["p99"])
        else:
            print(*row, sep="\t", flush=True)
    print("median p99", *(f"{statistics.median(m):.3f}" if m else "-" for m in medians), sep="\t")


if __name__ == "__main__":
    main()
