# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that succeed: formats, report, what is kept, what is printed."""

import math
import re
import unittest

from program_case import UNDER_WINE, ProgramCase
from surfaces import SQUARE, read_stl, turned_to_start, wave, write_off, write_ply


class Success(ProgramCase):
    def test_every_format_gives_a_closed_valid_solid(self):
        write_off(self.folder / "in.off", wave(12))
        for suffix in (".stl", ".ply", ".obj", ".off"):
            with self.subTest(suffix):
                self.assert_ok(self.run_program("in.off", "out" + suffix, "--thickness", 1))
                self.assert_ok(self.run_program("check", "out" + suffix, "--report", "report.json"))
                self.assertTrue(self.report()["input"]["closed"])
        self.assert_ok(self.run_program("in.off", "out.3mf", "--thickness", 1))
        self.assertEqual((self.folder / "out.3mf").read_bytes()[:2], b"PK", "a 3MF is a zip archive")

    @unittest.skipIf(UNDER_WINE, "where no locale but C is installed, Wine takes other letters for these")
    def test_names_in_any_writing(self):
        write_off(self.folder / "Fläche 面.off", SQUARE)
        run = self.run_program("Fläche 面.off", "Körper 体.stl", "--thickness", 1)
        self.assert_ok(run)
        self.assertIn("Körper 体.stl: ", run.stdout)
        self.assertEqual(self.names(), {"Fläche 面.off", "Körper 体.stl"})

    def test_every_triangle_of_the_surface_is_in_the_stl_bit_for_bit(self):
        vertices, triangles = wave(15)
        write_ply(self.folder / "in.ply", (vertices, triangles))
        surface = {turned_to_start(tuple(vertices[i] for i in t)) for t in triangles}
        reversed_surface = {turned_to_start((a, c, b)) for a, b, c in surface}
        for side, kept in (("negative", surface), ("positive", reversed_surface)):
            with self.subTest(side):
                self.assert_ok(self.run_program("in.ply", "out.stl", "--thickness", 0.8, "--side", side))
                solid = {turned_to_start(t) for t in read_stl(self.folder / "out.stl")}
                self.assertEqual(kept - solid, set())

    def test_a_plate_has_the_volume_of_area_times_thickness(self):
        write_off(self.folder / "in.off", SQUARE)
        for side, thickness in (("negative", 0.5), ("positive", 0.5), ("both", 1.0)):
            with self.subTest(side):
                run = self.run_program("in.off", "out.stl", "--thickness", 0.5, "--side", side, "--report", "report.json")
                self.assert_ok(run)
                self.assertAlmostEqual(self.report()["output"]["volume_mm3"], 16 * thickness, places=5)

    def test_the_report_holds_facts_that_fit_the_files(self):
        write_off(self.folder / "in.off", wave(12))
        self.assert_ok(self.run_program("in.off", "out.stl", "--thickness", 1, "--threads", 1, "--report", "report.json"))
        report = self.report()
        self.assertEqual(report["status"], "ok")
        self.assertEqual(report["input"], report["input"] | {"triangles": 288, "rims": 1, "components": 1, "closed": False})
        self.assertEqual(report["parameters"]["thickness_mm"], 1)
        self.assertEqual(report["parameters"]["threads"], 1)
        output = report["output"]
        self.assertEqual(output["triangles"], len(read_stl(self.folder / "out.stl")))
        self.assertEqual(output["original_triangles"], 288)
        self.assertEqual(output["triangles"],
                         sum(output[k + "_triangles"] for k in ("original", "shell", "wall")))  # fmt: skip
        self.assertAlmostEqual(output["volume_ml"] * 1000, output["volume_mm3"])
        self.assertEqual(report["surface_deviation_mm"], 0)
        self.assertTrue(all(report["audit"].values()), report["audit"])
        self.assertLessEqual(report["shell_error"]["mean"], report["shell_error"]["p99"])
        self.assertLessEqual(report["shell_error"]["p99"], report["shell_error"]["max"])
        self.assertLessEqual(report["shell_error_full_depth"]["max"], report["shell_error"]["max"])
        self.assertTrue(0 < report["thinnest_wall"]["share_of_thickness"] <= 1 + 1e-6)
        self.assertTrue(0 <= report["thin_share"] <= 1)
        self.assertGreater(report["memory"]["peak_bytes"], 1 << 20)
        stages = {k: v for k, v in report["seconds"].items() if k != "total"}
        self.assertTrue({"read", "write"} <= stages.keys())
        self.assertTrue(math.isclose(sum(stages.values()), report["seconds"]["total"], rel_tol=1e-9))

    def assert_stayed_below(self, limit):
        if not UNDER_WINE:  # it counts some MiB of its own as the program's
            self.assertLessEqual(self.report()["memory"]["peak_bytes"], limit)

    def test_a_memory_limit_is_obeyed_and_changes_no_byte(self):
        write_ply(self.folder / "in.ply", wave(20))

        def run(output, *more, simplify="off"):
            return self.run_program("in.ply", output, "--thickness", 1, "--method", "reconstruct", "--cell", 0.05,
                                    "--simplify", simplify, "--report", "report.json", *more)  # fmt: skip

        self.assert_ok(run("out.ply"))
        memory = self.report()["memory"]
        self.assertLess(memory["peak_bytes"], memory["predicted_bytes"])
        expected = (self.folder / "out.ply").read_bytes()
        # Far too little is refused, and what is said to be needed is enough.
        self.assertEqual(run("lean.ply", "--memory", 30).returncode, 4)
        least = int(re.search(r"would need about (\d+) MiB", self.report()["sentence"])[1])
        self.assertLess(least << 20, 0.7 * memory["peak_bytes"])
        for limit, threads in ((least, 1), (least, 2), (least + 10, 2), (least + 40, 2)):
            with self.subTest(limit=limit, threads=threads):
                self.assert_ok(run("lean.ply", "--memory", limit, "--threads", threads))
                self.assert_stayed_below(limit << 20)
                self.assertLessEqual(self.report()["memory"]["predicted_bytes"], limit << 20)
                self.assertEqual((self.folder / "lean.ply").read_bytes(), expected)
        # Where triangles cannot be merged within the limit, that is said, and it is the only difference.
        self.assert_ok(run("lean.ply", "--memory", least, simplify="auto"))
        self.assert_stayed_below(least << 20)
        report = self.report()
        self.assertTrue(any("more triangles than it needs" in sentence for sentence in report["warnings"]))
        self.assertEqual((self.folder / "lean.ply").read_bytes(), expected)

    def test_quiet_says_nothing(self):
        write_off(self.folder / "in.off", wave(8))
        run = self.run_program("in.off", "out.stl", "--thickness", 1, "--quiet")
        self.assert_ok(run)
        self.assertEqual(run.stdout + run.stderr, "")

    def test_without_a_terminal_there_is_no_progress(self):
        write_off(self.folder / "in.off", wave(8))
        run = self.run_program("in.off", "out.stl", "--thickness", 0.2)
        self.assert_ok(run)
        self.assertNotRegex(run.stderr, r"[\r\x1b%]")

    def test_a_thin_result_is_written_with_a_warning_that_quiet_silences(self):
        # A narrow gutter between two slopes that face each other: no room for 6 mm below it.
        ridge = ([(0, 0, 0), (1, 0, 4), (2, 0, 0), (0, 9, 0), (1, 9, 4), (2, 9, 0)],
                 [(0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4)])  # fmt: skip
        write_off(self.folder / "in.off", ridge)
        arguments = ("in.off", "out.stl", "--thickness", 6, "--side", "positive", "--report", "report.json")
        run = self.run_program(*arguments)
        if run.returncode == 0 and self.report()["thin_share"] == 0:
            arguments = ("in.off", "out.stl", "--thickness", 6, "--report", "report.json")
            run = self.run_program(*arguments)
        self.assert_ok(run)
        warnings = self.report()["warnings"]
        self.assertTrue(warnings)
        for warning in warnings:
            self.assertIn(f"thicken: warning: {warning}", run.stderr)
        self.assertEqual(self.run_program(*arguments, "--quiet").stderr, "")

    def test_a_wall_that_is_thin_everywhere_is_said_to_be_so_on_100_percent(self):
        fold = ([(0, 0, 0), (0, 9, 0), (9, 4, 0), (9, 4, 1)], [(0, 1, 2), (1, 0, 3)])
        write_off(self.folder / "in.off", fold)
        run = self.run_program("in.off", "out.stl", "--thickness", 1, "--method", "sweep")
        self.assert_ok(run)
        self.assertIn(" 100 % of the surface", run.stderr)

    def test_the_same_bytes_for_any_number_of_threads(self):
        write_ply(self.folder / "in.ply", wave(40, height=6))
        outputs = []
        for threads in (1, 2, 5):
            self.assert_ok(self.run_program("in.ply", "out.stl", "--thickness", 2, "--threads", threads))
            outputs.append((self.folder / "out.stl").read_bytes())
        self.assertEqual(outputs[0], outputs[1])
        self.assertEqual(outputs[0], outputs[2])

    def test_help_and_version_succeed(self):
        for arguments, word in ((["--help"], "--thickness"), (["check", "--help"], "--report"), (["-h"], "--side")):
            run = self.run_program(*arguments)
            self.assert_ok(run)
            self.assertIn(word, run.stdout)
        run = self.run_program("--version")
        self.assert_ok(run)
        self.assertRegex(run.stdout, r"^thicken \d+\.\d+\.\d+\n$")

    def test_check_says_what_the_surface_is(self):
        write_off(self.folder / "in.off", wave(5))
        run = self.run_program("check", "in.off", "--report", "report.json")
        self.assert_ok(run)
        self.assertIn("valid open surface", run.stdout)
        self.assertEqual(self.report()["input"]["triangles"], 50)
        self.assertEqual(self.report()["defects"], [])


    def test_a_unit_makes_millimetres_of_the_input(self):
        vertices, triangles = wave(6)
        write_off(self.folder / "inch.off", ([tuple(x / 25.4 for x in v) for v in vertices], triangles))
        write_off(self.folder / "metre.off", ([tuple(x / 1000 for x in v) for v in vertices], triangles))
        for name, unit in (("inch.off", "in"), ("metre.off", "m")):
            run = self.run_program(name, "out.stl", "--thickness", 1, "--unit", unit, "--report", "report.json")
            self.assert_ok(run)
            self.assertAlmostEqual(self.report()["input"]["diagonal_mm"], 20 * 2**0.5, delta=1)
            self.assertAlmostEqual(max(x for t in read_stl(self.folder / "out.stl") for v in t for x in v), 20, delta=0.7)
        self.assertRegex(self.assert_fails(self.run_program("check", "inch.off", "--unit", "ft"), 2, "usage"), "mm, cm, m, in")


if __name__ == "__main__":
    unittest.main()
