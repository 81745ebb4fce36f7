# SPDX-License-Identifier: LGPL-2.1-or-later
"""--timeout, and what a report says would have been enough."""

import unittest

from program_case import ProgramCase
from surfaces import wave, write_ply

MIB = 1 << 20


class TimeLimit(ProgramCase):
    def test_a_run_that_takes_longer_ends_with_its_report_and_no_output(self):
        write_ply(self.folder / "in.ply", wave(250, size=200, height=30))
        (self.folder / "out.stl").write_bytes(b"precious")
        run = self.run_program("in.ply", "out.stl", "--thickness", 8, "--timeout", 0.05, "--report", "report.json")
        sentence = self.assert_fails(run, 4, "time-limit")
        self.assertIn("0.05 s", sentence)
        self.assertEqual((self.folder / "out.stl").read_bytes(), b"precious")
        self.assertEqual(self.report()["code"], "time-limit")
        self.assertGreater(self.report()["time"]["enough_seconds"], 0.05)
        self.assert_leaves({"in.ply", "out.stl", "report.json"})

    def test_a_check_keeps_it_too(self):
        write_ply(self.folder / "in.ply", wave(250, size=200, height=30))
        self.assert_fails(self.run_program("check", "in.ply", "--timeout", 0.001), 4, "time-limit")

    def test_a_limit_that_is_long_enough_changes_nothing(self):
        write_ply(self.folder / "in.ply", wave(8))
        self.assert_ok(self.run_program("in.ply", "out.stl", "--thickness", 1))
        self.assert_ok(self.run_program("in.ply", "timed.stl", "--thickness", 1, "--timeout", 1000))
        self.assertEqual((self.folder / "out.stl").read_bytes(), (self.folder / "timed.stl").read_bytes())


class Enough(ProgramCase):
    """A limit of memory.enough_bytes is enough."""

    def run_with(self, mebibytes: float, *options):
        return self.run_program("in.ply", "out.stl", "--thickness", 1, "--memory", mebibytes, "--report", "report.json",
                                *options)  # fmt: skip

    def enough(self) -> float:
        return self.report()["memory"]["enough_bytes"] / MIB

    def test_for_what_was_refused(self):
        write_ply(self.folder / "in.ply", wave(100))
        for options in ((), ("--method", "reconstruct", "--cell", 0.1)):
            with self.subTest(options):
                (self.folder / "out.stl").unlink(missing_ok=True)
                self.assert_fails(self.run_with(1, *options), 4, "memory-limit")
                runs = 1
                while not (self.folder / "out.stl").exists() and runs < 4:
                    self.run_with(self.enough(), *options)
                    runs += 1
                self.assertTrue((self.folder / "out.stl").exists(), self.report().get("sentence"))
                self.assertLessEqual(runs, 3, "one retry for the sweep's memory, one for the contour's")

    def test_for_what_was_made_with_the_same_bytes(self):
        write_ply(self.folder / "in.ply", wave(60, height=6))
        for options in ((), ("--method", "reconstruct"), ("--side", "both")):
            with self.subTest(options):
                self.assert_ok(self.run_program("in.ply", "free.stl", "--thickness", 1, "--report", "report.json", *options))
                self.assertGreaterEqual(self.report()["memory"]["enough_bytes"], self.report()["memory"]["peak_bytes"])
                self.assert_ok(self.run_with(self.enough(), *options))
                self.assertEqual((self.folder / "out.stl").read_bytes(), (self.folder / "free.stl").read_bytes())

    def test_is_told_of_other_refusals_and_of_checks(self):
        vertices, triangles = wave(20)
        write_ply(self.folder / "in.ply", (vertices, triangles + [triangles[0]]))
        self.assert_fails(self.run_program("in.ply", "out.stl", "--thickness", 1, "--report", "report.json"), 3, "degenerate")
        self.assertGreater(self.enough(), 1)
        self.run_program("check", "in.ply", "--report", "report.json")
        self.assertGreater(self.enough(), 1)
        self.run_program("missing.ply", "out.stl", "--thickness", 1, "--report", "report.json")
        self.assertIsNone(self.report()["memory"]["enough_bytes"])


if __name__ == "__main__":
    unittest.main()
