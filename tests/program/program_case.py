# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of the program share: a folder of their own and ways to run it."""

from __future__ import annotations

import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["THICKEN_PROGRAM"]
UNDER_WINE = "THICKEN_UNDER_WINE" in os.environ


class ProgramCase(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_program(self, *arguments) -> subprocess.CompletedProcess:
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, encoding="utf-8", errors="replace",
                              cwd=self.folder, timeout=120)  # fmt: skip

    def names(self) -> set[str]:
        return {p.name for p in self.folder.iterdir()}

    def assert_ok(self, run: subprocess.CompletedProcess) -> None:
        self.assertEqual(run.returncode, 0, run.stderr)

    def assert_fails(self, run: subprocess.CompletedProcess, status: int, code: str) -> str:
        """The documented exit status and last line; returns the sentence."""
        self.assertEqual(run.returncode, status, run.stderr)
        lines = run.stderr.splitlines()
        self.assertTrue(lines, "nothing on stderr")
        match = re.fullmatch(r"thicken: ([a-z-]+): (.+)", lines[-1])
        self.assertIsNotNone(match, f"the last line is {lines[-1]!r}")
        self.assertEqual(match[1], code, lines[-1])
        self.assertNotRegex(match[2], r"std::|what\(\)|terminate|Exception")
        return match[2]

    def assert_leaves(self, names: set[str]) -> None:
        self.assertEqual(self.names(), names, "files appeared or vanished")

    def report(self, name: str = "report.json") -> dict:
        return json.loads((self.folder / name).read_text())
