# SPDX-License-Identifier: LGPL-2.1-or-later
"""What programs make of defective surfaces with --repair: a row for each file and program, between tabs.

    repair_table.py PROGRAM[,PROGRAM…] FILE… [-- OPTIONS]

PROGRAM may be an older one; it is given the options that its --help lists. Thickness: 1 % of the diagonal of the
bounding box, or `FILE=THICKNESS`. Seconds are processor time on one thread, so that a busy machine tells the same. At
the end a line for each program: its sum of seconds, solved and refused files, and those of which it removed more than the
first program did.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from measured_run import measured_run

SECONDS = 600  # of the processor, for a run
LEAST_MORE = 1e-9  # share of the area: less is the rounding of a sum
COLUMNS = ("file", "program", "status", "components before", "components after", "removed %", "added %", "thinnest wall / r",
           "thin %", "seconds")  # fmt: skip


def read_json(path: Path) -> dict[str, Any]:
    try:
        return json.loads(path.read_text())
    except (OSError, ValueError):
        return {}


def run(command: list[Any]) -> tuple[int, float, str]:
    """Exit status, seconds of the processor, and the last line of what it said."""
    made = measured_run(command, SECONDS)
    return made.status, made.seconds, (made.said.splitlines() or [""])[-1]


def facts_of(program: str, path: Path, folder: Path) -> dict[str, Any]:
    run([program, "check", path, "--quiet", "--report", folder / "check.json"])
    return read_json(folder / "check.json").get("input") or {}


def row_of(program: str, given: str, options: list[str], folder: Path) -> dict[str, Any]:
    file, _, thickness = given.partition("=")
    solid, repaired, report = folder / "solid.ply", folder / "repaired.ply", folder / "report.json"
    for left in (solid, repaired, report, folder / "check.json"):
        left.unlink(missing_ok=True)
    before = facts_of(program, Path(file), folder)
    thickness = thickness or f"{before.get('diagonal_mm', 100) / 100:.6g}"
    help_text = subprocess.run([program, "--help"], capture_output=True, text=True).stdout
    known = set(re.findall(r"--[a-z-]+", help_text))
    status, seconds, said = run([program, file, solid, "--thickness", thickness, "--repair", "--threads", "1", "--quiet", "--repaired",
                                 repaired, "--report", report, *(o for o in options if o.partition("=")[0] in known)])  # fmt: skip
    told = read_json(report)
    area, mended = before.get("area_mm2") or 0, told.get("repair") or {}
    after = facts_of(program, repaired, folder) if status == 0 else {}
    wall = told.get("thinnest_wall") or {}
    return {
        "file": Path(file).name,
        "program": Path(program).name,
        "status": "ok" if status == 0 else f"{told.get('code') or status}: {said[:120]}",
        "components before": before.get("components"),
        "components after": after.get("components"),
        "removed %": 100 * mended.get("removed_area_mm2", 0) / area if area and mended else None,
        "added %": 100 * mended.get("added_area_mm2", 0) / area if area and mended else None,
        "thinnest wall / r": wall["mm"] / float(thickness) if "mm" in wall else None,
        "thin %": 100 * told["thin_share"] if "thin_share" in told else None,
        "seconds": seconds,
        "exit": status,
    }


def cell(value: Any) -> str:
    return "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)


def main(arguments: list[str]) -> int:
    end = arguments.index("--") if "--" in arguments else len(arguments)
    programs, files, options = arguments[0].split(","), arguments[1:end], arguments[end + 1 :]
    print("\t".join(COLUMNS))
    rows: dict[str, list[dict[str, Any]]] = {program: [] for program in programs}
    with tempfile.TemporaryDirectory() as name:
        for file in files:
            for program in programs:
                row = row_of(program, file, options, Path(name))
                rows[program].append(row)
                print("\t".join(cell(row[column]) for column in COLUMNS), flush=True)
    for program, own in rows.items():
        solved = sum(row["exit"] == 0 for row in own)
        more = [row["file"] for row, first in zip(own, rows[programs[0]])
                if (row["removed %"] or 0) > (first["removed %"] or 0) + LEAST_MORE]  # fmt: skip
        print(f"{program}: {sum(row['seconds'] for row in own):.1f} s; {solved} of {len(own)} solved, "
              f"{sum(row['exit'] in (3, 4) for row in own)} refused; removed more than {Path(programs[0]).name} of: "
              f"{', '.join(more) or 'none'}")  # fmt: skip
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
