#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time whole runs in the paper's way beside OpenVDB's unsigned narrow band and its mesher.

usage: end_to_end.py PROGRAM FOLDER --rival VDB_OFFSET [--resolution 128,256,512,1024] [--repeat 3]
       end_to_end.py PROGRAM FOLDER --threads 1,2 [--resolution 512]
       both: [--only TEXT] [--thickness-percent P] [--out FILE.json]

FOLDER holds the models of the paper's table as PLY files. The two programs run in alternation, so that
both see the same machine, with the same cell width and thickness; figures are medians.

total    everything from reading to writing, seconds
compute  tree, sweep, field, faces, shape and the exact audit; the others are read, check, measure, write
rival    its grid and its mesh, without reading and writing; it keeps no surface and proves nothing
cpu      seconds of all threads of the whole process, its and ours; others on the machine change them least
"""

import argparse
import json
import resource
import statistics
import subprocess
import tempfile
from pathlib import Path

from models import MODELS, Refused, command_line, reconstruct, surface_facts, table_thickness

COMPUTE = ("tree", "sweep", "field", "faces", "shape", "audit")
GROWING = ("compute", "cpu", "mib", "nodes", "rival", "rival_cpu", "rival_mib")
MIB = 1024 * 1024


def processor_seconds() -> float:
    """Of all programs that were run so far."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def figures(report: dict) -> dict:
    """What is kept of a report."""
    seconds = report["seconds"]
    return {
        **{stage: seconds.get(stage, 0.0) for stage in COMPUTE},
        "total": seconds["total"],
        "compute": sum(seconds.get(stage, 0.0) for stage in COMPUTE),
        "mib": report["memory"]["peak_bytes"] / MIB,
        "triangles": report["output"]["triangles"],
        "cells": report["field"]["cells"],
        "nodes": report["field"]["nodes"],
        "rounds": report["output"]["sweep_rounds"] + report["output"]["contour_attempts"],
        "cell_mm": report["parameters"]["cell_mm"],
    }


def rival_figures(rival: str, model: Path, thickness: float, cell: float) -> dict:
    before = processor_seconds()
    done = subprocess.run([rival, model, repr(thickness), repr(cell)], capture_output=True, text=True, check=True)
    facts = json.loads(done.stdout.strip().splitlines()[-1])
    return {
        "rival": facts["grid_s"] + facts["mesh_s"],
        "rival_cpu": processor_seconds() - before,
        "rival_mib": facts["rss_mb"],
        "rival_active": facts["active"],
    }


def medians(runs: list[dict]) -> dict:
    return {key: statistics.median(run[key] for run in runs) for key in runs[0]}


class Case:
    """One model at one resolution."""

    def __init__(self, options: argparse.Namespace, name: str, thickness: float, resolution: int):
        self.options, self.name, self.thickness, self.resolution = options, name, thickness, resolution
        self.model = options.folder / f"{name}.ply"

    def run(self, *more: str) -> dict:
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out.ply"
            before = processor_seconds()
            report = reconstruct(self.options.program, self.model, out, self.thickness, self.resolution, *more)
            return {**figures(report), "cpu": processor_seconds() - before}

    def beside_rival(self) -> dict:
        runs = []
        for _ in range(self.options.repeat):
            here = self.run()
            here |= rival_figures(self.options.rival, self.model, self.thickness, here["cell_mm"])
            runs.append(here)
        return {"model": self.name, "resolution": self.resolution, "thickness_mm": self.thickness, **medians(runs)}

    def by_threads(self, counts: list[str]) -> dict[str, dict]:
        runs: dict[str, list[dict]] = {count: [] for count in counts}
        for _ in range(self.options.repeat):
            for count in counts:
                runs[count].append(self.run("--threads", count))
        named = {"model": self.name, "resolution": self.resolution}
        return {count: {**named, **medians(of)} for count, of in runs.items()}


def thickness_of(options: argparse.Namespace, name: str, edges: float) -> float:
    facts = surface_facts(options.program, options.folder / f"{name}.ply")
    percent = options.thickness_percent
    return percent / 100 * facts["diagonal_mm"] if percent else table_thickness(facts, edges)


def sums(rows: list[dict]) -> str:
    total, compute, cpu, rival, rival_cpu = (
        sum(row[key] for row in rows) for key in ("total", "compute", "cpu", "rival", "rival_cpu"))  # fmt: skip
    return (f"{'sum':24}{rows[0]['resolution']:6} | {total:8.2f} {compute:8.2f} | {rival:8.2f} | "
            f"ratio of the sums: total {total / rival:.2f}, compute {compute / rival:.2f}, "
            f"cpu {cpu / rival_cpu:.2f}; "
            f"memory at most {max(row['mib'] / row['rival_mib'] for row in rows):.2f}")  # fmt: skip


def print_beside_rival(row: dict) -> None:
    stages = " ".join(f"{row[stage]:6.2f}" for stage in COMPUTE)
    print(f"{row['model']:24}{row['resolution']:6} | {row['total']:8.2f} {row['compute']:8.2f} | {row['rival']:8.2f} | "
          f"{row['total'] / row['rival']:5.2f} {row['compute'] / row['rival']:5.2f} "
          f"{row['cpu'] / row['rival_cpu']:5.2f} | {stages} | {row['mib']:6.0f} "
          f"{row['rival_mib']:6.0f} {row['mib'] / row['rival_mib']:5.2f} | "
          f"{row['triangles']:9.0f} {row['cells']:9.0f} "
          f"{row['nodes']:9.0f} {row['rounds']:6.0f} | {row['rival_active']:9.0f}", flush=True)  # fmt: skip


def print_growth(rows: list[dict]) -> None:
    """How figures grow from one resolution of a model to the next."""
    for one, next_ in zip(rows, rows[1:]):
        if one["model"] == next_["model"]:
            growth = ", ".join(f"{key} {next_[key] / one[key]:.2f}" for key in GROWING)
            print(f"{one['model']:24} {one['resolution']} to {next_['resolution']}: {growth}")


def compare_with_rival(options: argparse.Namespace, cases: list[Case]) -> list[dict]:
    print(f"{'model':24}{'cells':>6} | {'total':>8} {'compute':>8} | {'rival':>8} | ratios        cpu | "
          + " ".join(f"{stage:>6}" for stage in COMPUTE)
          + " |    MiB  rival ratio | triangles     cells     nodes rounds | rival's voxels")  # fmt: skip
    rows = []
    for case in cases:
        try:
            rows.append(case.beside_rival())
            print_beside_rival(rows[-1])
        except Refused as why:
            print(f"{case.name:24}{case.resolution:6} | {why}", flush=True)
    for resolution in sorted({row["resolution"] for row in rows}):
        print(sums([row for row in rows if row["resolution"] == resolution]))
    print_growth(sorted(rows, key=lambda row: (row["model"], row["resolution"])))
    return rows


def compare_threads(options: argparse.Namespace, cases: list[Case]) -> list[dict]:
    counts = options.threads.split(",")
    shown = ("total", "compute", *COMPUTE)
    print(f"{'model':24}{'cells':>6} {'threads':>8} | " + " ".join(f"{key:>8}" for key in shown))
    kept = []
    for case in cases:
        of = case.by_threads(counts)
        for count, row in of.items():
            print(f"{case.name:24}{case.resolution:6} {count:>8} | " + " ".join(f"{row[key]:8.2f}" for key in shown))
            kept.append({"threads": count, **row})
        first, last = of[counts[0]], of[counts[-1]]
        print(f"{'':30} {'ratio':>8} | "
              + " ".join(f"{first[key] / last[key] if last[key] else 0:8.2f}" for key in shown), flush=True)  # fmt: skip
    return kept


def main() -> None:
    parser = command_line(__doc__, "128,256,512,1024")
    parser.add_argument("--rival", help="OpenVDB's program: RIVAL IN.ply R VOXEL prints JSON")
    parser.add_argument("--threads", help="compare these numbers of threads instead")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--thickness-percent", type=float, help="of the diagonal, instead of the table's thickness")
    parser.add_argument("--out", type=Path, help="the medians as JSON")
    options = parser.parse_args()
    if not options.rival and not options.threads:
        parser.error("either --rival or --threads")
    thicknesses = {name: thickness_of(options, name, edges) for name, edges, _ in MODELS if options.only in name}
    cases = [Case(options, name, thickness, resolution)
             for resolution in map(int, options.resolution.split(","))
             for name, thickness in thicknesses.items()]  # fmt: skip
    rows = compare_threads(options, cases) if options.threads else compare_with_rival(options, cases)
    if options.out:
        options.out.write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    main()
