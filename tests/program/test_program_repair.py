# SPDX-License-Identifier: LGPL-2.1-or-later
"""--repair, --weld and --repaired."""

import struct
import unittest

from program_case import ProgramCase
from surfaces import SQUARE, wave, with_extra, write_off

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
            ["--repair", "--repaired", "in.off"],
            ["--repair", "--repaired", "out.stl"],
            ["--repair", "--repaired", "r.off", "--report", "r.off"],
        ):
            with self.subTest(wrong):
                self.assert_fails(self.run_program(*good, *wrong), 2, "usage")
        for unwritable in ("mended.xyz", "nowhere/mended.stl"):
            self.assert_fails(self.run_program(*good, "--repair", "--repaired", unwritable), 6, "unwritable")
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
