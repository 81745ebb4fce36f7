# SPDX-License-Identifier: LGPL-2.1-or-later
"""The models of the paper's Table 1, and one run of the program on one of them."""

import argparse
import json
import subprocess
import tempfile
from pathlib import Path

# model, thickness in mean edge lengths (negative: the other side in the paper), and the paper's
# seconds for grid, faces and shape at 128³ and 256³.
MODELS = [
    ("cut_david_helmet_10k8", 2.5, {128: (1.03, 1.16, 1.33), 256: (6.07, 4.93, 5.37)}),
    ("an_pigtail_204", 0.5, {128: (0.310, 0.180, 0.460), 256: (1.87, 0.980, 1.95)}),
    ("cut_face_scan_23k", 2.5, {128: (0.983, 0.499, 0.734), 256: (5.74, 2.06, 2.79)}),
    ("cut_femur_lower_8k9", 2.5, {128: (1.28, 0.552, 0.828), 256: (8.04, 2.52, 3.31)}),
    ("cut_nefertiti_57k", 3.0, {128: (0.954, 0.538, 0.479), 256: (5.15, 1.92, 1.59)}),
    ("cut_igea_face_134k", 3.0, {128: (0.850, 0.654, 0.743), 256: (4.29, 2.21, 2.33)}),
]


def command_line(description: str, resolutions: str) -> argparse.ArgumentParser:
    """What every command over the models takes; `description` is its docstring."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--resolution", default=resolutions)
    parser.add_argument("--only", default="")
    return parser


class Refused(Exception):
    """The program made no solid; the text is its last line."""


def surface_facts(program: str, model: Path) -> dict:
    """What the program's own check says of a surface: counts, mean edge length, diagonal."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        subprocess.run([program, "check", model, "--report", report], check=True, capture_output=True)
        return json.loads(report.read_text())["input"]


def table_thickness(facts: dict, edges: float) -> float:
    """The thickness of the table for a surface with these facts, mm."""
    return float(f"{edges * facts['mean_edge_mm']:.6g}")


def thicken(program: str, model: Path, out: Path, thickness: float, *options: str) -> dict:
    """The report of one run that leaves its solid at `out`."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        done = subprocess.run(
            [program, model, out, "--thickness", repr(thickness), "--quiet", "--report", report, *options],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        if done.returncode:
            raise Refused((done.stderr.strip().splitlines() or [f"it ended with {done.returncode}"])[-1])
        return json.loads(report.read_text())


def reconstruct(program: str, model: Path, out: Path, thickness: float, resolution: int, *options: str) -> dict:
    """The same in the paper's way."""
    return thicken(program, model, out, thickness, "--method", "reconstruct",
                   "--resolution", str(resolution), *options)  # fmt: skip


def verdict(judge: str, model: Path, out: Path, thickness: float, *options: str) -> str:
    """What the judge says of a solid: ok or NOT VALID."""
    done = subprocess.run([judge, "thicken", model, out, repr(thickness), *options],
                          capture_output=True, text=True, check=False)  # fmt: skip
    lines = done.stdout.strip().splitlines()
    return "ok" if lines and json.loads(lines[-1]).get("ok") else "NOT VALID"
