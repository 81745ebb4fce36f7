#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the program over the surfaces of a folder and prints medians of what its reports say.

usage: medians.py PROGRAM FOLDER PERCENT [METHOD]

PERCENT: the thickness, in percent of the diagonal of each surface's bounding box. One line a surface, then the
medians: error of the shell where the solid is as deep as asked and over all of it (99th percentile, relative to the
thickness), share of the area below 0.9 of the thickness, seconds.
"""
import json
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path


def run(command):
    """The exit status of a command and its report; the report is None where it wrote none."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        status = subprocess.run([*command(folder), "--report", report], capture_output=True, check=False).returncode
        return status, json.loads(report.read_text()) if report.exists() else None


def main():
    program, folder, percent = sys.argv[1], Path(sys.argv[2]), float(sys.argv[3])
    method = sys.argv[4] if len(sys.argv) > 4 else "auto"
    rows = []
    for path in sorted(folder.iterdir()):
        _, checked = run(lambda _folder: [program, "check", path])
        if checked is None or "input" not in checked:
            continue
        thickness = checked["input"]["diagonal_mm"] * percent / 100
        status, report = run(lambda out: [program, path, f"{out}/solid.ply", "--thickness", f"{thickness:.6g}",
                                          "--method", method, "--quiet"])
        if status != 0:
            print(f"{path.name}: exit status {status}")
            continue
        rows.append((report["shell_error_full_depth"]["p99"], report["shell_error"]["p99"], report["thin_share"],
                     report["seconds"]["total"]))
        print(f"{path.name}: full depth {rows[-1][0]:.5f}, all {rows[-1][1]:.5f}, thin {rows[-1][2]:.4f}, "
              f"{rows[-1][3]:.2f} s")
    medians = [statistics.median(column) for column in zip(*rows)]
    print(f"medians of {len(rows)}: shell error p99 {medians[0]:.5f} at full depth, {medians[1]:.5f} in all; "
          f"thin share {medians[2]:.4f}; {medians[3]:.2f} s, at most {max(row[3] for row in rows):.2f} s")


if __name__ == "__main__":
    main()
