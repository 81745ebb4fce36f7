# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that are refused: status, code, sentence, and nothing left behind."""

import unittest

from program_case import ProgramCase
from surfaces import SQUARE, wave, with_extra, write_off, write_ply

NAN = float("nan")

# Each is the square with one thing wrong.
DEFECTIVE = {
    "empty": (SQUARE[0], []),
    "not-finite": (SQUARE[0][:3] + [(NAN, 4, 0)], SQUARE[1]),
    "not-manifold": with_extra([(2, 2, 3), (1, 3, 3)], [(0, 2, 4), (2, 0, 5)]),
    "not-oriented": (SQUARE[0], [(0, 1, 2), (0, 3, 2)]),
    "degenerate": with_extra([(8, 0, 0)], [(1, 0, 4)]),
    "self-intersecting": with_extra([(1, 1, -1), (3, 1, -1), (2, 1.5, 1)], [(4, 5, 6)]),
}


class Usage(ProgramCase):
    def test_wrong_command_lines_are_usage_errors(self):
        write_off(self.folder / "in.off", SQUARE)
        good = ["in.off", "out.stl", "--thickness", "1"]
        for arguments in (
            [],
            ["in.off"],
            ["check"],
            good[:2],
            [*good, "--frobnicate"],
            [*good, "third.stl"],
            ["in.off", "out.stl", "--thickness", "thick"],
            ["in.off", "out.stl", "--thickness", "2mm"],
            ["in.off", "out.stl", "--thickness", "0"],
            ["in.off", "out.stl", "--thickness", "-1"],
            ["in.off", "out.stl", "--thickness", "nan"],
            ["in.off", "out.stl", "--thickness", "inf"],
            ["in.off", "out.stl", "--thickness"],
            [*good, "--side", "left"],
            [*good, "--method", "magic"],
            [*good, "--threads", "-1"],
            [*good, "--threads", "1.5"],
            [*good, "--memory", "0"],
            [*good, "--smooth", "101"],
            [*good, "--resolution", "0"],
            [*good, "--tolerance", "0"],
            [*good, "--cell", "-0.1"],
            [*good, "--cell", "0.1", "--resolution", "9"],
            [*good, "--resolution", "9", "--tolerance", "0.1"],
            [*good, "--report", "in.off"],
            [*good, "--report", "./out.stl"],
        ):
            with self.subTest(arguments=arguments):
                sentence = self.assert_fails(self.run_program(*arguments), 2, "usage")
                self.assertGreater(len(sentence), 10)
                self.assert_leaves({"in.off"})

    def test_a_cell_of_half_the_thickness_is_a_usage_error(self):
        write_off(self.folder / "in.off", SQUARE)
        run = self.run_program("in.off", "out.stl", "--thickness", 1, "--cell", 0.5)
        self.assert_fails(run, 2, "usage")
        self.assert_leaves({"in.off"})


class Numbers(ProgramCase):
    def test_a_decimal_comma_is_told_as_one(self):
        write_off(self.folder / "in.off", SQUARE)
        for option in ("--thickness", "--cell", "--tolerance"):
            with self.subTest(option):
                run = self.run_program("in.off", "out.stl", "--thickness", "1", option, "0,25")
                sentence = self.assert_fails(run, 2, "usage")
                self.assertIn("with a point: 0.25, not 0,25", sentence)
        sentence = self.assert_fails(self.run_program("in.off", "out.stl", "--thickness", "2mm"), 2, "usage")
        self.assertIn("2mm", sentence)
        self.assertIn("millimetres", sentence)


class Refusal(ProgramCase):
    def test_every_kind_of_defect_is_named_and_nothing_written(self):
        for code, surface in DEFECTIVE.items():
            with self.subTest(code):
                write_off(self.folder / "in.off", surface)
                run = self.run_program("in.off", "out.stl", "--thickness", 1)
                self.assert_fails(run, 3, code)
                self.assert_fails(self.run_program("check", "in.off"), 3, code)
                self.assert_leaves({"in.off"})

    def test_a_refusal_names_the_option_that_may_help(self):
        for code in ("not-manifold", "not-oriented", "degenerate", "self-intersecting"):
            with self.subTest(code):
                write_off(self.folder / "in.off", DEFECTIVE[code])
                for arguments in (("in.off", "out.stl", "--thickness", 1), ("check", "in.off")):
                    self.assertIn("; --repair mends", self.assert_fails(self.run_program(*arguments), 3, code))
        write_off(self.folder / "in.off", wave(10, height=4))
        run = self.run_program("in.off", "out.stl", "--thickness", 2, "--tolerance", 1e-9)
        self.assertNotIn("--repair", self.assert_fails(run, 4, "no-solid"), "where no repair helps")

    def test_a_refusal_names_the_distance_that_rims_are_apart(self):
        """The square and another beside it with a gap of 0.003, and a sheet that crosses it."""
        beside = [(4.003, 0, 0), (8, 0, 0), (8, 4, 0), (4.003, 4, 0), (6, 1, -1), (6, 3, -1), (6, 2, 1)]
        write_off(self.folder / "in.off", with_extra(beside, [(4, 5, 6), (4, 6, 7), (8, 9, 10)]))
        for arguments in (("in.off", "out.stl", "--thickness", 1), ("check", "in.off")):
            sentence = self.assert_fails(self.run_program(*arguments), 3, "self-intersecting")
            self.assertRegex(sentence, r"corners of rims lie within 0\.003\d* mm of another rim: --repair --weld 0\.003")

    def test_quiet_keeps_the_last_line_only(self):
        write_off(self.folder / "in.off", DEFECTIVE["not-manifold"])
        run = self.run_program("in.off", "out.stl", "--thickness", 1, "--quiet")
        self.assert_fails(run, 3, "not-manifold")
        self.assertEqual(len(run.stderr.splitlines()), 1)

    def test_the_report_of_a_refusal_lists_the_defects(self):
        write_off(self.folder / "in.off", DEFECTIVE["not-oriented"])
        for arguments in (("in.off", "out.stl", "--thickness", 1), ("check", "in.off")):
            with self.subTest(arguments):
                self.assert_fails(self.run_program(*arguments, "--report", "report.json"), 3, "not-oriented")
                report = self.report()
                self.assertEqual((report["status"], report["code"]), ("refused", "not-oriented"))
                self.assertEqual(report["exit_status"], 3)
                self.assertEqual([d["code"] for d in report["defects"]], ["not-oriented"])
                self.assertGreaterEqual(report["defects"][0]["count"], 1)
                self.assert_leaves({"in.off", "report.json"})

    def test_all_defects_are_found_at_once(self):
        vertices, triangles = DEFECTIVE["self-intersecting"]
        k = len(vertices)
        write_off(self.folder / "in.off", (vertices + [(9, 9, 9), (10, 9, 9), (11, 9, 9)], triangles + [(k, k + 1, k + 2)]))
        self.run_program("check", "in.off", "--report", "report.json")
        codes = {d["code"] for d in self.report()["defects"]}
        self.assertTrue({"self-intersecting", "degenerate"} <= codes, codes)

    def test_a_tolerance_that_cannot_be_reached_gives_no_solid(self):
        write_off(self.folder / "in.off", wave(10, height=4))
        run = self.run_program("in.off", "out.stl", "--thickness", 2, "--tolerance", 1e-9, "--report", "report.json")
        self.assert_fails(run, 4, "no-solid")
        self.assertEqual(self.report()["code"], "no-solid")
        self.assert_leaves({"in.off", "report.json"})

    def test_a_memory_limit_is_kept(self):
        write_ply(self.folder / "in.ply", wave(60))
        run = self.run_program("in.ply", "out.stl", "--thickness", 1, "--memory", 0.5)
        sentence = self.assert_fails(run, 4, "memory-limit")
        self.assertIn("MiB", sentence)
        self.assert_leaves({"in.ply"})


if __name__ == "__main__":
    unittest.main()
