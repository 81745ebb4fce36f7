# SPDX-License-Identifier: LGPL-2.1-or-later
"""The loop of docs/batch.md, as it stands there."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from batch_case import PROGRAM, PROJECT, wave, write_off, write_ply, write_table


class Loop(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_loop(self, rows, change=lambda code: code) -> list[list[str]]:
        write_table(self.folder / "parts.tsv", rows, ("file", "thickness"))
        (code,) = re.findall(r"```python\n(.*?)```", (PROJECT / "docs/batch.md").read_text(), re.DOTALL)
        path = f"{Path(PROGRAM).parent}{os.pathsep}{os.environ['PATH']}"
        run = subprocess.run([sys.executable, "-c", change(code)], cwd=self.folder, env={**os.environ, "PATH": path},
                             capture_output=True, text=True, timeout=300)  # fmt: skip
        self.assertEqual(run.returncode, 0, run.stderr)
        return [line.split("\t") for line in run.stdout.splitlines()]

    def test_good_and_bad_parts_have_a_line_each(self):
        write_off(self.folder / "a.off", wave(8))
        (self.folder / "b.stl").write_text("this is no surface\n")
        rows = [{"file": "a.off", "thickness": r} for r in ("0.5", "1")] + [{"file": name, "thickness": "1"} for name in ("b.stl", "c.ply")]
        self.assertEqual(self.run_loop(rows), [["a.off", "0.5", "ok", ""], ["a.off", "1", "ok", ""],
                                               ["b.stl", "1", "refused", "unreadable"], ["c.ply", "1", "refused", "unreadable"]])  # fmt: skip
        self.assertTrue((self.folder / "a-0.5mm.stl").is_file())

    def test_limits_that_are_too_low_are_raised(self):
        write_ply(self.folder / "a.ply", wave(100))
        def low(code: str) -> str:
            return re.sub(r"memory, timeout = \d+, \d+", "memory, timeout = 15, 900", code)
        self.assertEqual(self.run_loop([{"file": "a.ply", "thickness": "1"}], low), [["a.ply", "1", "ok", ""]])


if __name__ == "__main__":
    unittest.main()
