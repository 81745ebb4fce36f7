# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field cases with two versions of the program: a table in Markdown.

    python3 libthicken/bench/field_table.py ../shared/data/field BEFORE build/bin/thicken

FOLDER holds the cases, BEFORE and AFTER are the programs. Runs have one thread, and seconds are the processor's, which other programs
on the machine hardly lengthen. A cell tells what was made, or the exit status and what was said; warnings follow.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import tempfile
from pathlib import Path

from measured_run import measured_run

CASES = (
    ("ring_quads.ply", ".ply", "--thickness 2 --side positive"),
    ("hem.ply", ".ply", "--thickness 0.7"),
    ("terrain_utm.ply", ".ply", "--thickness 40"),
    ("terrain_utm.ply", ".stl", "--thickness 40"),
    ("hull.ply", ".ply", "--thickness 1.6"),
    ("hull.ply", ".ply", "--thickness 1.6 --repair"),
    ("rooms.ply", ".ply", "--thickness 2"),
    ("rooms.ply", ".ply", "--thickness 2 --repair"),
    ("panels_n2.ply", ".ply", "--thickness 1"),
    ("panels_n2.ply", ".ply", "--thickness 1 --repair --weld 0.0578"),
    ("tee_curved.ply", ".ply", "--thickness 1"),
    ("tee_curved.ply", ".ply", "--thickness 1 --repair --weld 0.117"),
    ("two_passes.ply", ".ply", "--thickness 1 --repair"),
    ("two_passes.ply", ".ply", "--thickness 1 --repair --strict"),
    *(("dome.ply", ".ply", f"--thickness {r}") for r in ("2", "70", "90", "1e9")),
    ("dome.ply", ".ply", "--thickness 2,5"),
    *((name, ".stl", "--thickness 0.5") for name in ("fmt_tail.stl", "fmt_no_end.stl", "fmt_unknown_lines.obj", "fmt_one_line.ply",
                                                       "fmt_zip.stl", "fmt_utf16.stl")),
)  # fmt: skip


def facts(report: dict) -> str:
    """What was made, from a report of either version."""
    output, wall = report["output"], report.get("thinnest_wall") or {}
    told = [f"{output['triangles']:,} triangles"]
    if output.get("parts", 1) > 1:
        told.append(f"{output['parts']} parts")
    mended = report.get("repair") or {}
    if mended.get("removed_area_mm2"):
        told.append(f"{100 * mended['removed_area_mm2'] / report['input']['area_mm2']:.3g} % removed")
    if "mm" in wall:
        told.append(f"wall {wall['mm']:.3g} mm")
    if report.get("thin_share"):
        told.append(f"{100 * report['thin_share']:.3g} % thin")
    return ", ".join(told)


def verdict(judge: str, solid: Path, surface: Path, asked: str) -> str:
    """What the judge says of a solid on a surface."""
    words = asked.split()
    side = words[words.index("--side") :][:2] if "--side" in words else []
    judged = subprocess.run([judge, "thicken", surface, solid, words[words.index("--thickness") + 1], "--samples", "1000", *side],
                            capture_output=True)  # fmt: skip
    return "valid" if judged.returncode == 0 else "INVALID"


def cell(program: str, source: Path, suffix: str, asked: str, limit: int, judge: str) -> str:
    with tempfile.TemporaryDirectory() as folder:
        solid, report, repaired = Path(folder, "solid" + suffix), Path(folder, "report.json"), Path(folder, "repaired.ply")
        command = [program, source, solid, *asked.split(), "--threads", "1", "--report", report]
        run = measured_run(command + (["--repaired", repaired] if "--repair" in asked else []), limit)
        said = run.said.replace(f'"{source}": ', "").replace(str(source), source.name)
        warnings = re.findall(r"^thicken: warning: (.*)", said, re.MULTILINE)
        if run.status < 0:
            return f"ended after {limit} s"
        if run.status:
            sentences = re.findall(r"^thicken: (?!warning)(.*)", said, re.MULTILINE)
            return f"{run.status}: {sentences[-1] if sentences else said.strip()}"
        made = f"{facts(json.loads(report.read_text()))}, {run.seconds:.2g} s"
        if judge:
            made += f", judged {verdict(judge, solid, repaired if repaired.exists() else source, asked)}"
        return "; ".join([made, *("*" + warning + "*" for warning in warnings)])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--only", default="", help="cases with this in their name")
    parser.add_argument("--judge", default="", help="the judge, as developing.md builds it")
    parser.add_argument("--seconds", type=int, default=300, help="of the processor, after which a run is ended")
    options = parser.parse_args()
    print("| case | asked | before | after |\n|---|---|---|---|")
    for name, suffix, asked in CASES:
        if options.only in name:
            cells = [cell(program, options.folder / name, suffix, asked, options.seconds, options.judge).replace("|", "\\|")
                     for program in (options.before, options.after)]  # fmt: skip
            print(f"| `{name}` to `{suffix}` | `{asked}` | {cells[0]} | {cells[1]} |", flush=True)


if __name__ == "__main__":
    main()
