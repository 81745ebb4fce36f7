# SPDX-License-Identifier: LGPL-2.1-or-later
"""--gap and --gap-surface."""

import unittest

from program_case import ProgramCase
from surfaces import SQUARE, read_stl, wave, write_off


class Gap(ProgramCase):
    def setUp(self) -> None:
        super().setUp()
        write_off(self.folder / "in.off", SQUARE)

    def thicken(self, *options):
        return self.run_program("in.off", "out.stl", "--thickness", 0.25, *options)

    def test_the_solid_begins_at_the_gap(self):
        self.assert_ok(self.thicken("--gap", 0.5, "--gap-surface", "gap.stl", "--report", "report.json"))
        heights = {corner[2] for triangle in read_stl(self.folder / "out.stl") for corner in triangle}
        self.assertEqual(heights, {-0.75, -0.5})
        self.assertEqual({c[2] for t in read_stl(self.folder / "gap.stl") for c in t}, {-0.5})
        self.assert_ok(self.run_program("check", "gap.stl"))
        report = self.report()
        self.assertEqual(report["gap"]["mm"], 0.5)
        self.assertAlmostEqual(report["gap"]["least_mm"], 0.5)
        self.assertEqual(report["gap"]["short_share"], 0)
        self.assertEqual(report["parameters"]["thickness_mm"], 0.25)
        self.assertEqual(report["output"]["original_triangles"], report["gap"]["surface"]["triangles"])

    def test_the_gap_surface_is_in_the_solid_bit_for_bit(self):
        write_off(self.folder / "in.off", wave(8))
        self.assert_ok(self.thicken("--gap", 1, "--gap-surface", "gap.stl"))
        has = {frozenset(triangle) for triangle in read_stl(self.folder / "out.stl")}
        for triangle in read_stl(self.folder / "gap.stl"):
            self.assertIn(frozenset(triangle), has)

    def test_without_a_gap_the_report_has_none(self):
        self.assert_ok(self.thicken("--report", "report.json"))
        self.assertIsNone(self.report()["gap"])

    def test_what_makes_no_sense_is_told(self):
        for options, words in (
            (("--gap", "-1"), "positive"),
            (("--gap", "1 mm"), "without a unit"),
            (("--gap", "1", "--side", "both"), "one side"),
            (("--gap", "1", "--gap-surface", "g.stl", "--sheets"), "--sheets"),
            (("--gap-surface", "gap.stl"), "give --gap"),
            (("--gap", "1", "--gap-surface", "in.off"), "--gap-surface names a file"),
            (("--gap", "1", "--gap-surface", "out.stl"), "--gap-surface names a file"),
            (("--gap", "1", "--gap-surface", "g.stl", "--report", "r.json", "--skip-if-same"), "--gap-surface"),
        ):
            with self.subTest(options):
                self.assertIn(words, self.assert_fails(self.thicken(*options), 2, "usage"))
                self.assert_leaves({"in.off"})

    def test_a_gap_is_another_run(self):
        options = "--report", "report.json", "--skip-if-same"
        self.assert_ok(self.thicken(*options))
        self.assertNotIn("made before", self.thicken(*options, "--gap", 0.5).stdout)
        self.assertIn("made before", self.thicken(*options, "--gap", 0.5).stdout)


if __name__ == "__main__":
    unittest.main()
