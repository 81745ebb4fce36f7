# SPDX-License-Identifier: LGPL-2.1-or-later
"""--rim-thickness, --rim-width and --rim-round."""

import json
import unittest
from pathlib import Path

from json_schema import faults
from program_case import ProgramCase
from surfaces import read_stl
from test_program_map import N, write_sheet

SCHEMA = json.loads((Path(__file__).parents[2] / "docs/report.schema.json").read_text())


class Rim(ProgramCase):
    """Of a flat sheet of N by N cells of 1 mm."""

    def setUp(self) -> None:
        super().setUp()
        write_sheet(self.folder / "in.ply", lambda x: 1 + x / N)

    def thicken(self, *options, thickness=4):
        return self.run_program("in.ply", "part.stl", "--thickness", thickness, "--report", "report.json", *options)

    def depths(self, distance: float) -> set[float]:
        """Of the corners of the solid so far from the sides of the sheet, but for those of the sheet."""
        corners = {corner for triangle in read_stl(self.folder / "part.stl") for corner in triangle}
        return {round(-z, 4) for x, y, z in corners if z < 0 and min(x, y, N - x, N - y) == distance}

    def test_taper(self):
        self.assert_ok(self.thicken("--rim-thickness", 1, "--rim-width", 3))
        self.assertEqual([max(self.depths(d)) for d in range(5)], [1, 2, 3, 4, 4])
        report = self.report()
        self.assertEqual(faults(report, SCHEMA, SCHEMA), [])
        told = report["parameters"]
        self.assertEqual(told["rim"], {"thickness_mm": 1, "width_mm": 3, "round_mm": None, "row_mm": 1})
        self.assertEqual((told["thickness_map"]["least_mm"], told["thickness_map"]["most_mm"]), (1, 4))
        self.assertEqual(report["warnings"], [])

    def test_round_edge(self):
        self.assert_ok(self.thicken("--rim-round", 2))
        self.assertEqual([max(self.depths(d)) for d in range(4)], [2, round(2 + 3**0.5, 4), 4, 4])
        self.assertEqual(faults(self.report(), SCHEMA, SCHEMA), [])

    def test_profile_of_a_map(self):
        self.assert_ok(self.thicken("--thickness-map", "thick", "--rim-thickness", 1, "--rim-width", 0.5, thickness=2))
        self.assertEqual(max(self.depths(0)), 1)
        self.assertEqual(max(self.depths(1)), round(2 * (1 + (N - 1) / N), 4))

    def test_coarse_triangles_are_told(self):
        run = self.thicken("--rim-round", 0.5)
        self.assert_ok(run)
        self.assertIn("coarser than asked", run.stderr)
        self.assertIn("1 mm from it", run.stderr)

    def test_without_a_profile_the_report_has_none(self):
        self.assert_ok(self.thicken())
        self.assertIsNone(self.report()["parameters"]["rim"])

    def test_what_makes_no_sense_is_told(self):
        for options, words in (
            (("--rim-thickness", 1), "belong together"),
            (("--rim-width", 1), "belong together"),
            (("--rim-thickness", 0, "--rim-width", 1), "positive"),
            (("--rim-round", 4), "less than the thickness"),
            (("--rim-round", "1 mm"), "without a unit"),
            (("--rim-round", 1, "--sheets"), "--sheets"),
        ):
            with self.subTest(options):
                self.assertIn(words, self.assert_fails(self.thicken(*options), 2, "usage"))

    def test_a_profile_is_another_run(self):
        self.assert_ok(self.thicken("--skip-if-same"))
        self.assertNotIn("made before", self.thicken("--skip-if-same", "--rim-round", 2).stdout)
        self.assertIn("made before", self.thicken("--skip-if-same", "--rim-round", 2).stdout)


if __name__ == "__main__":
    unittest.main()
