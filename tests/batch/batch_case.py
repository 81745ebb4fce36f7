# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of parts, and ways to run the workflow over them."""

from __future__ import annotations

import csv
import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(PROJECT / "tests/program"), str(PROJECT / "examples/batch")]
from surfaces import SQUARE, wave, with_extra, write_off, write_ply  # noqa: E402

PROGRAM = os.environ["THICKEN_PROGRAM"]
SNAKEFILE = PROJECT / "examples/batch/Snakefile"
COLUMNS = ("file", "thickness", "side", "repair", "memory", "timeout")

# What is refused, and its code.
BAD = {
    "nan.off": "not-finite",
    "book.off": "not-manifold",
    "turned.off": "not-oriented",
    "crossed.off": "self-intersecting",
    "text.stl": "unreadable",
    "missing.ply": "unreadable",
    "points.off": "empty",
}


def write_surfaces(folder: Path) -> None:
    (folder / "a b").mkdir(parents=True)
    (folder / "ü").mkdir()
    for k in range(8):
        write_off(folder / f"wave {k}.off", wave(8 + k))
    for place in ("a b", "ü"):  # two files of one name
        write_off(folder / place / "Fläche.off", wave(10, height=1 + len(place)))
    write_ply(folder / "large.ply", wave(250, size=200, height=30))
    write_off(folder / "nan.off", (SQUARE[0][:3] + [(float("nan"), 4, 0)], SQUARE[1]))
    write_off(folder / "book.off", with_extra([(2, 2, 3), (1, 3, 3)], [(0, 2, 4), (2, 0, 5)]))
    write_off(folder / "turned.off", (SQUARE[0], [(0, 1, 2), (0, 3, 2)]))
    write_off(folder / "crossed.off", with_extra([(1, 1, -1), (3, 1, -1), (2, 1.5, 1)], [(4, 5, 6)]))
    write_off(folder / "points.off", (SQUARE[0], []))
    (folder / "text.stl").write_text("this is no surface\n")


def parts() -> list[dict[str, str]]:
    """60 rows: 40 that can be made, with one that needs more memory and one that needs more time than it is given
    first, and 20 that cannot."""
    good = [{"file": f"wave {k}.off", "thickness": str(r)} for k in range(8) for r in (0.3, 0.5, 0.7)]
    good += [{"file": f"{place}/Fläche.off", "thickness": str(r)} for place in ("a b", "ü") for r in (0.4, 0.6, 0.8)]
    good += [{"file": "wave 0.off", "thickness": "0.5", "side": side} for side in ("positive", "both")]
    good += [{"file": "crossed.off", "thickness": "0.2", "repair": yes} for yes in ("1", "yes", "true")]
    good += [{"file": "large.ply", "thickness": "5", "memory": "20"}, {"file": "large.ply", "thickness": "6", "timeout": "0.05"}]
    good += [{"file": "large.ply", "thickness": "8"}, {"file": "wave 1.off", "thickness": "0.9"}, {"file": "wave 1.off", "thickness": "0.9"}]
    bad = [{"file": name, "thickness": str(r)} for name in BAD if name != "points.off" for r in (1, 2, 3)]
    bad = [*bad[:-1], {"file": "points.off", "thickness": "1"}, {"file": "wave 2.off", "thickness": "thick"},
           {"file": "wave 2.off", "thickness": "1", "side": "left"}]  # fmt: skip
    return [row for pair in zip(good[::2], good[1::2], bad) for row in pair]


def write_table(path: Path, rows: list[dict[str, str]], columns=COLUMNS) -> Path:
    lines = ["\t".join(columns), *("\t".join(row.get(name, "") for name in columns) for row in rows)]
    path.write_text("\n".join(lines) + "\n")
    return path


def read_summary(folder: Path) -> list[dict[str, str]]:
    with open(folder / "summary.tsv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))


def read_json(path: Path) -> dict:
    return json.loads(path.read_text("utf-8"))


def solids(folder: Path) -> dict[str, str]:
    """The digest of each: where they differ, unittest would compare the bytes themselves for hours."""
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.glob("*.stl")}


def kill_one(word: str, seconds: float = 600) -> bool:
    """Kills one process of the program that has this word on its command line, as soon as there is one."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for path in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                words = path.read_bytes().decode(errors="replace").split("\0")
                if words[0] == PROGRAM and any(word in each for each in words):
                    os.kill(int(path.parent.name), signal.SIGKILL)
                    return True
            except OSError:
                continue
        time.sleep(0.01)
    return False


class BatchCase(unittest.TestCase):
    more: tuple[str, ...] = ("--cores", "2")
    settings: tuple[str, ...] = ()

    @classmethod
    def setUpClass(cls) -> None:
        if not shutil.which("snakemake"):
            raise unittest.SkipTest("there is no snakemake; scripts/test-batch installs it")
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        write_surfaces(cls.folder / "in")

    @classmethod
    def command(cls, table: Path, out: Path, *config: str) -> list[str]:
        return ["snakemake", "-s", str(SNAKEFILE), *cls.more, "--config", f"parts={table}", f"out={out}",
                f"program={PROGRAM}", *cls.settings, *config]  # fmt: skip

    @classmethod
    def start(cls, table: Path, out: Path, *config: str) -> subprocess.Popen:
        log = open(cls.folder / "log", "ab")
        cls.addClassCleanup(log.close)
        return subprocess.Popen(cls.command(table, out, *config), cwd=cls.folder, stdout=log, stderr=log)

    def run_batch(self, table: Path, out: Path, *config: str) -> subprocess.CompletedProcess:
        return subprocess.run(self.command(table, out, *config), cwd=self.folder, capture_output=True, text=True, timeout=600)

    def assert_ok(self, run: subprocess.CompletedProcess) -> None:
        self.assertEqual(run.returncode, 0, run.stdout[-3000:] + run.stderr[-3000:])
