# SPDX-License-Identifier: LGPL-2.1-or-later
"""The longest that the progress of a run stands still, and in which stage.

    PYTHONPATH=. python3 libthicken/bench/progress_stalls.py ../shared/data/open/cgal_blade.ply --percent 1 --method auto

Takes surfaces, and runs each on one thread at each thickness (in percent of the diagonal) and method. Seconds are the processor's,
which other programs on the machine hardly lengthen. A row a run; the last column is what a run of 30 s would stand still for.
"""

from __future__ import annotations

import argparse
import threading
import time

import numpy as np
from thicken import RunContext, ThickenError, read_mesh, thicken_mesh


def watched(surface, thickness: float, **options) -> tuple[float, float, str]:
    """Processor seconds of a run, the longest without a move, and the stage that it was in."""
    context, stall, stage = RunContext(), 0.0, ""

    def work() -> None:
        try:
            thicken_mesh(*surface, thickness, threads=1, context=context, **options)
        except ThickenError as error:
            print(f"no solid: {error}")

    thread = threading.Thread(target=work)
    begin = since = time.process_time()
    shown = context.progress
    thread.start()
    while thread.is_alive():
        time.sleep(0.005)
        now, progress, seen = time.process_time(), context.progress, context.stage
        if now - since > stall:
            stall, stage = now - since, seen
        if progress != shown:
            shown, since = progress, now
    return time.process_time() - begin, stall, stage


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="+")
    parser.add_argument("--percent", default="1,3", help="thicknesses in percent of the diagonal")
    parser.add_argument("--method", default="auto,reconstruct")
    parser.add_argument("--tolerance-percent", type=float, help="of the thickness; none is asked for without")
    options = parser.parse_args()
    print("surface\tpercent\tmethod\tseconds\tlongest stall\tstage\tof 30 s")
    for path in options.surfaces:
        surface = read_mesh(path)
        diagonal = float(np.linalg.norm(np.ptp(surface[0], axis=0)))
        for percent in map(float, options.percent.split(",")):
            for method in options.method.split(","):
                r = percent / 100 * diagonal
                asked = {"method": method}
                if options.tolerance_percent:
                    asked["tolerance"] = options.tolerance_percent / 100 * r
                total, stall, stage = watched(surface, r, **asked)
                print(f"{path.rsplit('/', 1)[-1]}\t{percent:g}\t{method}\t{total:.2f}\t{stall:.3f}\t{stage}\t{30 * stall / total:.2f} s", flush=True)


if __name__ == "__main__":
    main()
