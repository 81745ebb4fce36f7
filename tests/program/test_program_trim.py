# SPDX-License-Identifier: LGPL-2.1-or-later
"""`thicken trim`: the part, what stays of the surface, the report, and what is refused."""

import json
import unittest
from pathlib import Path

from json_schema import faults
from program_case import ProgramCase
from surfaces import read_stl, turned_to_start, wave, with_extra, write_off

SCHEMA = json.loads((Path(__file__).parents[2] / "docs/report.schema.json").read_text())

INNER = "# a square\n6.1 6.2 0\n13.8 6.3 0\n13.7 13.9 0\n6.2 13.8 0\n"
OUTER = "3 3 0\n17.1 3 0\n17 17 0\n3 17.1 0\n3 3 0\n"


class Trim(ProgramCase):
    def setUp(self) -> None:
        super().setUp()
        self.surface = wave(12)
        write_off(self.folder / "in.off", self.surface)
        for name, text in (("inner.txt", INNER), ("outer.txt", OUTER)):
            (self.folder / name).write_text(text)

    def trim(self, *options, output="part.stl"):
        return self.run_program("trim", "in.off", output, *options)

    def test_part_is_valid_and_keeps_what_no_path_divides(self):
        self.assert_ok(self.trim("--loop", "inner.txt", "--report", "report.json"))
        report = self.report()
        self.assertEqual(faults(report, SCHEMA, SCHEMA), [])
        vertices, triangles = self.surface
        own = {turned_to_start(tuple(vertices[v] for v in t)) for t in triangles}
        part = [turned_to_start(t) for t in read_stl(self.folder / "part.stl")]
        untouched = report["untouched_triangles"]
        self.assertGreater(untouched, 10)
        self.assertEqual(len(own.intersection(part)), untouched)
        self.assertEqual(len(part), untouched + report["divided_triangles"])
        self.assertEqual((report["surface"]["rims"], report["loops"][0]["points"]), (1, 4))
        self.assert_ok(self.run_program("check", "part.stl"))
        self.assert_ok(self.run_program("part.stl", "solid.stl", "--thickness", 1))

    def test_several_loops_and_a_point_of_the_part(self):
        both = ("--loop", "inner.txt", "--loop", "outer.txt", "--report", "report.json")
        self.assert_ok(self.trim(*both))
        ring = self.report()
        self.assertEqual(ring["surface"]["rims"], 2)
        self.assert_ok(self.trim(*both, "--keep", "-1,-2.5,0"))
        self.assertEqual(self.report()["surface"]["rims"], 2)  # the rim of the surface, and the outer loop
        self.assertEqual(len(self.report()["warnings"]), 1)
        self.assertNotEqual(ring["surface"]["area_mm2"], self.report()["surface"]["area_mm2"])

    def test_smooth_loops_have_more_points(self):
        self.assert_ok(self.trim("--loop", "inner.txt", "--smooth", 2, "--report", "report.json"))
        self.assertEqual(self.report()["loops"][0]["points"], 16)

    def test_refusals_name_the_place_and_write_nothing(self):
        (self.folder / "eight.txt").write_text("4 4 0\n15 15.2 0\n15.1 4 0\n4 15 0\n")
        before = self.names()
        sentence = self.assert_fails(self.trim("--loop", "eight.txt", "--report", "report.json"), 2, "usage")
        self.assertRegex(sentence, r"^loop 1 crosses itself at \([-0-9., e]+\)")
        report = self.report()
        self.assertEqual(faults(report, SCHEMA, SCHEMA), [])
        self.assertAlmostEqual(report["defects"][0]["place_mm"][0], 9.5, delta=1)
        self.assert_leaves(before | {"report.json"})
        self.assert_fails(self.trim("--loop", "inner.txt", "--keep", "1,2"), 2, "usage")
        self.assert_fails(self.trim("--loop", "inner.txt", "--smooth", 9), 2, "usage")
        self.assert_fails(self.trim(), 2, "usage")
        self.assert_fails(self.trim("--loop", "missing.txt"), 6, "unreadable")
        self.assert_fails(self.trim("--loop", "inner.txt", "--report", "inner.txt"), 2, "usage")
        self.assertEqual((self.folder / "inner.txt").read_text(), INNER)

    def test_defects_of_the_surface_are_refused(self):
        write_off(self.folder / "in.off", with_extra([(1, 1, 4)], [(0, 1, 169)], self.surface))
        self.assert_fails(self.trim("--loop", "inner.txt"), 3, "not-oriented")


if __name__ == "__main__":
    unittest.main()
