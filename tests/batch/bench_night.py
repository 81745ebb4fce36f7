# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the workflow costs beside the bare program, over every surface of a folder at several thicknesses.

    bench_night.py PROGRAM FOLDER [PARTS]: the first PARTS (300) of the table, on two cores

`xargs -P 2` with the bare program and the workflow run in turn, ten seconds each while the other one stands still:
what else the machine does then slows both alike. A workflow that is killed at half and started again comes after.
Prints throughputs, the largest job beside its limit, and whether the bytes are the same; ends with status 1 where they
are not. Not a test: it takes minutes.
"""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SNAKEFILE = Path(__file__).resolve().parents[2] / "examples/batch/Snakefile"
PERCENT = (1, 2, 3, 5)  # thicknesses, of the diagonal of the bounding box
SLICE = 10.0  # seconds


def parts_of(program: str, surfaces: Path, folder: Path, count: int) -> list[tuple[str, str]]:
    """File and thickness: all surfaces at the first thickness, then at the next."""
    sizes = []
    for path in sorted(surfaces.absolute().glob("*.ply"))[:count]:
        subprocess.run([program, "check", path, "--quiet", "--report", folder / "check.json"], capture_output=True, check=True)
        facts = json.loads((folder / "check.json").read_text())["input"]
        sizes.append((str(path), facts["diagonal_mm"]))
    return [(path, f"{percent / 100 * size:.6g}") for percent in PERCENT for path, size in sizes][:count]


class Side:
    """A process and its children, which can be made to stand still, and its times once it is over."""

    def __init__(self, command: list[str], stdin: Path | None = None) -> None:
        source = open(stdin, "rb") if stdin else subprocess.DEVNULL
        self.process = subprocess.Popen(command, stdin=source, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                        start_new_session=True)  # fmt: skip
        self.is_over = False
        self.wall = self.cpu = 0.0

    def wait(self, seconds: float = float("inf")) -> Side:
        """Until it is over, but no longer than that."""
        begun = time.monotonic()
        while not self.is_over and time.monotonic() - begun < seconds:
            pid, _, used = os.wait4(self.process.pid, os.WNOHANG)
            if pid:
                self.is_over, self.cpu = True, used.ru_utime + used.ru_stime
            else:
                time.sleep(0.02)
        self.wall += time.monotonic() - begun
        return self

    def send(self, what: signal.Signals) -> None:
        if not self.is_over:
            os.killpg(self.process.pid, what)


def in_turn(sides: list[Side]) -> None:
    """Lets one of them go on at a time until all are over."""
    try:
        for side in sides:
            side.send(signal.SIGSTOP)
        while not all(side.is_over for side in sides):
            for side in sides:
                side.send(signal.SIGCONT)
                side.wait(SLICE)
                side.send(signal.SIGSTOP)
    finally:  # nothing is left that stands still
        for side in sides:
            side.send(signal.SIGKILL)


def run_all(program: str, folder: Path, parts: list[tuple[str, str]]) -> tuple[Side, Side]:
    """The bare program and the workflow; folder/bare, folder/night and folder/killed hold what was made."""
    table, arguments = folder / "parts.tsv", folder / "arguments"
    table.write_text("file\tthickness\n" + "".join(f"{file}\t{thickness}\n" for file, thickness in parts))
    (folder / "bare").mkdir()
    words = [(file, str(folder / f"bare/{i}.stl"), f"--thickness={thickness}") for i, (file, thickness) in enumerate(parts)]
    arguments.write_bytes("".join(f"{word}\0" for line in words for word in line).encode())

    def workflow(out: str) -> Side:
        return Side(["snakemake", "-s", str(SNAKEFILE), "--cores", "2", "--config", f"parts={table}", f"out={folder / out}",
                     f"program={program}"])  # fmt: skip

    bare = Side(["xargs", "-0", "-n", "3", "-P", "2", program, "--quiet", "--threads=1"], arguments)
    night = workflow("night")
    in_turn([bare, night])
    killed = workflow("killed")
    while len(list((folder / "killed").glob("*.stl"))) < len(parts) // 2:
        if killed.wait(0.1).is_over:
            raise SystemExit("bench: fewer than half of the parts can be made; give surfaces that are valid")
    killed.send(signal.SIGKILL)
    killed.wait()
    workflow("killed").wait()
    return bare, night


def solids(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.glob("*.stl")}


def main(program: str, surfaces: Path, count: int) -> int:
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # what stands still then is ended, too
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        parts = parts_of(program, surfaces, folder, count)
        bare, night = run_all(os.path.abspath(program), folder, parts)
        with open(folder / "night/summary.tsv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))
        for what, side in (("xargs -P 2", bare), ("workflow", night)):
            print(f"{what}: {len(parts)} parts in {side.wall:.0f} s, {side.cpu:.0f} s of processor time")
        print(f"throughput of the workflow: {bare.wall / night.wall:.2f} of the bare program by the clock, "
              f"{bare.cpu / night.cpu:.2f} by processor time")  # fmt: skip
        peaks = [(float(row["memory_mib"]), float(row["memory_limit_mib"])) for row in rows if row["memory_mib"]]
        print(f"largest job: {max(peaks)[0]:.0f} MiB; {sum(peak > limit for peak, limit in peaks)} above their limits")
        made = solids(folder / "night")
        bare_solids = [path.read_bytes() for path in (folder / "bare").glob("*.stl")]
        same = made == solids(folder / "killed"), sorted(made.values()) == sorted(bare_solids)
        print(f"{len(rows)} rows, {len(made)} solids; killed at half and started again: "
              f"{'the same bytes' if same[0] else 'OTHER BYTES'}; bare program: {'the same bytes' if same[1] else 'OTHER BYTES'}")  # fmt: skip
    return 0 if all(same) and len(rows) == len(parts) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], Path(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 300))
