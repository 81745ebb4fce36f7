# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares the forecast of time and memory with what runs really take, over a folder of surfaces.

    python3 libthicken/bench/forecast_table.py build/bin/thicken ../shared/data/open --percent 1,3

`--percent`: thicknesses, in percent of the diagonal. Runs have one thread, and seconds are the processor's, which other
programs on the machine hardly lengthen. A row a run, and a line that sums up: the median of real over forecast, the median factor
that a forecast is off by, and the share of runs that are within twice of it. Ends with 1 where the median factor is above 2.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path


def run(command: list[str], limit: float) -> tuple[int, float]:
    """The exit status and the processor seconds; status −1 where it was ended after `limit` seconds of the processor."""
    process = subprocess.Popen(["bash", "-c", 'ulimit -t "$0"; exec "$@"', str(round(limit)), *command], stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return max(process.returncode, -1), usage.ru_utime + usage.ru_stime


def factor(ratio: float) -> float:
    return max(ratio, 1 / ratio)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--percent", default="1,3", help="thicknesses in percent of the diagonal")
    parser.add_argument("--every", type=int, default=1, help="take every nth surface")
    parser.add_argument("--seconds", type=float, default=300, help="of the processor, after which a run is left out")
    parser.add_argument("more", nargs="*", help="after --: options of the program, such as --method sweep")
    options = parser.parse_args()
    ratios, memory = [], []
    print("surface\tpercent\ttriangles\tarea/r²\tmethod\tforecast s\treal s\treal/forecast\tforecast MiB\treal MiB")
    with tempfile.TemporaryDirectory() as folder:
        report_path, solid = Path(folder, "report.json"), Path(folder, "solid.ply")
        for surface in sorted(options.folder.glob("*.ply"))[:: options.every]:
            checked = subprocess.run([options.program, "check", surface, "--report", report_path, "--quiet"], check=False)
            if checked.returncode:
                continue
            diagonal = json.loads(report_path.read_text())["input"]["diagonal_mm"]
            for percent in map(float, options.percent.split(",")):
                command = [options.program, str(surface), str(solid), "--thickness", repr(percent / 100 * diagonal),
                           "--threads", "1", "--quiet", "--report", str(report_path), *options.more]  # fmt: skip
                status, seconds = run(command, options.seconds)
                if status != 0:
                    print(f"{surface.stem}\t{percent:g}\tno solid: status {status} after {seconds:.2f} s", flush=True)
                    continue
                report = json.loads(report_path.read_text())
                told, given = report["predicted_seconds"], report["input"]
                peak, most = report["memory"]["peak_bytes"], report["memory"]["predicted_bytes"]
                ratios.append(seconds / told)
                memory.append(peak / most)
                print(f"{surface.stem}\t{percent:g}\t{given['triangles']}\t{given['area_mm2'] / report['parameters']['thickness_mm'] ** 2:.0f}\t"
                      f"{report['parameters']['method']}\t{told:.2f}\t{seconds:.2f}\t{ratios[-1]:.2f}\t{most / 2**20:.0f}\t"
                      f"{peak / 2**20:.0f}", flush=True)  # fmt: skip
    if not ratios:
        print("no run made a solid")
        return 1
    off = statistics.median(map(factor, ratios))
    within = sum(factor(ratio) <= 2 for ratio in ratios) / len(ratios)
    print(f"\n{len(ratios)} runs: real/forecast {statistics.median(ratios):.2f} at the median; off by a factor of {off:.2f} at the "
          f"median; {100 * within:.0f} % within twice; memory {max(memory):.2f} of the forecast at the most")  # fmt: skip
    return int(off > 2)


if __name__ == "__main__":
    sys.exit(main())
