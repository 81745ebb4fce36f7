# SPDX-License-Identifier: LGPL-2.1-or-later
"""--repair, --weld and --repaired."""

import struct
import unittest

from program_case import ProgramCase
from surfaces import SQUARE, TEE, wave, with_extra, write_off

THORN = with_extra([(1, 1, -1), (1.2, 1, -1), (1.1, 1.1, 1)], [(4, 5, 6)])
FLIPPED = (SQUARE[0], [(0, 1, 2), (0, 3, 2)])


def read_stl(path):
    """The corners of the triangles of a binary STL file."""
    data = path.read_bytes()[84:]
    return {tuple(sorted(struct.unpack_from("<9f", data, i + 12)[k : k + 3] for k in (0, 3, 6)))
            for i in range(0, len(data), 50)}  # fmt: skip


class Repair(ProgramCase):
    def test_is_off_by_default(self):
        write_off(self.folder / "in.off", THORN)
        self.assert_fails(self.run_program("in.off", "out.stl", "--thickness", 0.2), 3, "self-intersecting")
        self.assert_leaves({"in.off"})

    def test_writes_the_solid_and_the_repaired_surface(self):
        write_off(self.folder / "in.off", THORN)
        run = self.run_program("in.off", "out.stl", "--thickness", 0.2, "--repair", "--repaired", "mended.stl",
                               "--report", "report.json")  # fmt: skip
        self.assert_ok(run)
        self.assert_leaves({"in.off", "out.stl", "mended.stl", "report.json"})
        self.assertRegex(run.stderr, r"thicken: warning: the surface was repaired \(1 self-intersecting\): 1 triangle")
        repair = self.report()["repair"]
        self.assertEqual([c["kind"] for c in repair["changes"]], ["self-intersecting"])
        self.assertEqual((repair["changes"][0]["triangles"], repair["changes"][0]["removed"]), ([2], True))
        self.assertEqual((self.report()["input"]["triangles"], repair["surface"]["triangles"]), (3, 2))
        mended = read_stl(self.folder / "mended.stl")
        self.assertEqual(len(mended), 2)
        self.assertLessEqual(mended, read_stl(self.folder / "out.stl"))

    def test_turns_triangles_over(self):
        write_off(self.folder / "in.off", FLIPPED)
        self.assert_ok(self.run_program("in.off", "out.ply", "--thickness", 0.2, "--repair", "--report", "report.json"))
        self.assertEqual([c["kind"] for c in self.report()["repair"]["changes"]], ["turned"])

    def test_changes_no_byte_for_a_valid_surface(self):
        write_off(self.folder / "in.off", wave(8))
        self.assert_ok(self.run_program("in.off", "plain.stl", "--thickness", 1))
        self.assert_ok(self.run_program("in.off", "out.stl", "--thickness", 1, "--repair", "--report", "report.json"))
        self.assertEqual((self.folder / "plain.stl").read_bytes(), (self.folder / "out.stl").read_bytes())
        self.assertEqual(self.report()["repair"]["changes"], [])

    def test_wrong_options_are_usage_errors(self):
        write_off(self.folder / "in.off", THORN)
        good = ["in.off", "out.stl", "--thickness", 0.2]
        for wrong in (
            ["--repaired", "mended.stl"],
            ["--weld", 0.1],
            ["--repair", "--weld", -1],
            ["--bridge", 1],
            ["--repair", "--bridge", 0],
            ["--fill-holes", 1],
            ["--repair", "--fill-holes", -2],
            ["--repair", "--sheets", "--repaired", "mended.stl"],
            ["--repair", "--repaired", "in.off"],
            ["--repair", "--repaired", "out.stl"],
            ["--repair", "--repaired", "r.off", "--report", "r.off"],
        ):
            with self.subTest(wrong):
                self.assert_fails(self.run_program(*good, *wrong), 2, "usage")
        for unwritable in ("mended.xyz", "nowhere/mended.stl"):
            self.assert_fails(self.run_program(*good, "--repair", "--repaired", unwritable), 6, "unwritable")
        self.assert_leaves({"in.off"})

    def test_bridges_gaps_and_fills_holes(self):
        vertices, triangles = wave(8)
        holed = [t for i, t in enumerate(triangles) if i not in (54, 55)]
        beside = [(x + 20.25, y, z) for x, y, z in vertices]
        both = vertices + beside, holed + [tuple(v + len(vertices) for v in t) for t in triangles]
        write_off(self.folder / "in.off", both)
        self.assert_ok(self.run_program("in.off", "out.ply", "--thickness", 0.5, "--repair", "--report", "report.json"))
        self.assertEqual(self.report()["repair"]["changes"], [])
        self.assert_ok(self.run_program("in.off", "out.ply", "--thickness", 0.5, "--repair", "--report", "report.json",
                                        "--bridge", 0.5, "--fill-holes", 20))  # fmt: skip
        repair = self.report()["repair"]
        self.assertEqual((repair["surface"]["components"], repair["surface"]["rims"]), (1, 1))
        self.assertEqual((repair["strips"], repair["filled_holes"], repair["left_holes"]), (1, 1, 0))
        self.assertEqual(sum(change["count"] for change in repair["changes"]), repair["added_triangles"])
        self.assertEqual(repair["surface"]["triangles"], self.report()["output"]["original_triangles"])

    def test_makes_a_solid_of_each_sheet(self):
        write_off(self.folder / "in.off", TEE)
        self.assert_fails(self.run_program("in.off", "out.stl", "--thickness", 0.2), 3, "not-manifold")
        run = self.run_program("in.off", "out.stl", "--thickness", 0.2, "--sheets")
        self.assert_ok(run)
        self.assert_leaves({"in.off", "out-1.stl", "out-2.stl"})
        self.assertEqual(len(run.stdout.splitlines()), 2)
        floor, wall = read_stl(self.folder / "out-1.stl"), read_stl(self.folder / "out-2.stl")
        for t in TEE[1]:
            corners = tuple(sorted(tuple(map(float, TEE[0][v])) for v in t))
            self.assertIn(corners, floor | wall)

    def test_a_sheet_without_a_solid_leaves_nothing(self):
        write_off(self.folder / "in.off", with_extra([(1, 1, -1), (1.2, 1, -1), (1.1, 1.1, 1)], [(8, 9, 10)], TEE))
        self.assert_ok(self.run_program("in.off", "out.stl", "--thickness", 0.2, "--sheets"))
        vertices, triangles = TEE
        write_off(self.folder / "in.off", (vertices, [*triangles, triangles[0]]))
        for name in ("out-1.stl", "out-2.stl", "out-3.stl"):
            (self.folder / name).unlink()
        sentence = self.assert_fails(self.run_program("in.off", "out.stl", "--thickness", 0.2, "--sheets"), 3, "degenerate")
        self.assertRegex(sentence, r"sheet 1 of \d")
        self.assert_leaves({"in.off"})

    def test_what_no_repair_helps_keeps_its_code(self):
        write_off(self.folder / "in.off", ([(0, 0, 0), (1, 1, 1), (2, 2, 2)], [(0, 1, 2)]))
        self.assert_fails(self.run_program("in.off", "out.stl", "--thickness", 0.2, "--repair"), 3, "degenerate")
        self.assert_leaves({"in.off"})

    def test_a_refusal_says_what_is_known_of_the_surface(self):
        write_off(self.folder / "in.off", THORN)
        self.run_program("in.off", "out.stl", "--thickness", 0.2, "--report", "report.json")
        self.assertEqual(self.report()["input"]["triangles"], 3)
        self.assertIsNone(self.report()["repair"])


if __name__ == "__main__":
    unittest.main()
