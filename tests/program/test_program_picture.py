# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of solids."""

import struct
import unittest

from program_case import ProgramCase
from surfaces import wave, write_off


class Picture(ProgramCase):
    def setUp(self) -> None:
        super().setUp()
        write_off(self.folder / "in.off", wave(6))

    def thicken(self, *options):
        return self.run_program("in.off", "out.stl", "--thickness", 1, *options)

    def size(self, name: str) -> tuple[int, int]:
        png = (self.folder / name).read_bytes()
        self.assertTrue(png.startswith(b"\x89PNG\r\n\x1a\n"))
        return struct.unpack(">II", png[16:24])

    def test_the_solid_is_drawn(self):
        self.assert_ok(self.thicken("--picture", "out.png"))
        self.assertEqual(self.size("out.png"), (1280, 480))
        self.assert_ok(self.thicken("--picture", "small.png", "--picture-size", "96x72"))
        self.assertEqual(self.size("small.png"), (96, 72))

    def test_sheets_are_drawn_together(self):
        self.assert_ok(self.thicken("--picture", "out.png", "--sheets", "--picture-size", "61x30"))
        self.assertEqual(self.size("out.png"), (61, 30))

    def test_a_picture_that_is_missing_is_made_again(self):
        options = "--report", "report.json", "--skip-if-same", "--picture", "out.png", "--picture-size", "9x9"
        self.assert_ok(self.thicken(*options))
        (self.folder / "out.png").unlink()
        self.assert_ok(self.thicken(*options))
        self.assertEqual(self.size("out.png"), (9, 9))
        self.assertIn("made before", self.thicken(*options).stdout)

    def test_refused_solids_leave_no_picture(self):
        self.assertNotEqual(self.thicken("--picture", "out.png", "--memory", 1).returncode, 0)
        self.assert_leaves({"in.off"})

    def test_what_makes_no_sense_is_told(self):
        for size in ("640", "640x", "0x4", "9000x9", "4.5x6"):
            run = self.thicken("--picture", "o.png", "--picture-size", size)
            self.assertIn("pixels", self.assert_fails(run, 2, "usage"))
        self.assertIn("--picture", self.assert_fails(self.thicken("--picture", "in.off"), 2, "usage"))
        self.assert_fails(self.thicken("--picture", "nowhere/o.png"), 6, "unwritable")
        self.assert_leaves({"in.off"})


if __name__ == "__main__":
    unittest.main()
