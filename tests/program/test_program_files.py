# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that cannot be read or written, and files that must not be lost."""

import json
import os
import resource
import subprocess
import unittest

from program_case import PROGRAM, UNDER_WINE, ProgramCase
from surfaces import SQUARE, read_stl, wave, write_off


class Unreadable(ProgramCase):
    def test_missing_unknown_and_broken_inputs(self):
        (self.folder / "garbage.stl").write_bytes(b"this is no mesh at all")
        (self.folder / "short.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n")
        (self.folder / "notes.txt").write_text("v 0 0 0")
        (self.folder / "nothing.ply").write_bytes(b"")
        (self.folder / "folder.stl").mkdir()
        before = self.names()
        for name in ("missing.stl", "garbage.stl", "short.off", "notes.txt", "nothing.ply", "folder.stl", "in.3mf", "in.vtp"):
            with self.subTest(name):
                sentence = self.assert_fails(self.run_program(name, "out.stl", "--thickness", 1), 6, "unreadable")
                self.assertIn(name, sentence)
                self.assert_fails(self.run_program("check", name), 6, "unreadable")
                self.assert_leaves(before)

    def test_the_report_says_what_could_not_be_read(self):
        run = self.run_program("missing.stl", "out.stl", "--thickness", 1, "--report", "report.json")
        self.assert_fails(run, 6, "unreadable")
        self.assertEqual(self.report()["code"], "unreadable")

    def test_a_file_name_with_a_line_break_does_not_break_the_last_line(self):
        name = "a\nthicken: usage: forged\x1b[31m.stl"
        run = self.run_program(name, "out.stl", "--thickness", 1)
        self.assert_fails(run, 6, "unreadable")
        self.assertEqual(len(run.stderr.splitlines()), 1)
        self.assertNotIn("\x1b", run.stderr)


class Unwritable(ProgramCase):
    def setUp(self) -> None:
        super().setUp()
        write_off(self.folder / "in.off", SQUARE)

    def test_outputs_that_cannot_be_made_are_found_before_the_work(self):
        (self.folder / "folder.stl").mkdir()
        before = self.names()
        for name in ("out.xyz", "out", "nowhere/out.stl", "folder.stl"):
            with self.subTest(name):
                # The input is no surface: were it read first, the code would be another one.
                (self.folder / "in.off").write_text("OFF\n0 0 0\n")
                run = self.run_program("in.off", name, "--thickness", 1)
                self.assert_fails(run, 6, "unwritable")
                self.assert_leaves(before)

    def test_a_report_that_cannot_be_made_is_found_before_the_work(self):
        run = self.run_program("in.off", "out.stl", "--thickness", 1, "--report", "nowhere/report.json")
        self.assert_fails(run, 6, "unwritable")
        self.assert_leaves({"in.off"})

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_locked_folder_is_named(self):
        locked = self.folder / "locked"
        locked.mkdir(mode=0o500)
        self.assert_fails(self.run_program("in.off", "locked/out.stl", "--thickness", 1), 6, "unwritable")

    @unittest.skipIf(UNDER_WINE, "the limit would be that of Wine's server, too")
    def test_a_disk_without_room_leaves_nothing(self):
        write_off(self.folder / "in.off", wave(12))
        # A limit on the size of files stands for the full disk; with its signal ignored, as Python
        # does, writing fails instead.
        run = subprocess.run(
            [PROGRAM, "in.off", "out.stl", "--thickness", "1"], cwd=self.folder, capture_output=True, text=True,
            timeout=60, restore_signals=False,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)),
        )  # fmt: skip
        self.assert_fails(run, 6, "unwritable")
        self.assert_leaves({"in.off"})


class PassedOver(ProgramCase):
    """What is passed over in a file is told, on stderr and in the report, whatever comes of the run."""

    OBJ = "v 0 0 0\nv 4 0 0\nv 0 4 0\nwhatever 1 2\nf 1 2 3\n"

    def test_a_warning_comes_with_the_solid_and_with_the_check(self):
        (self.folder / "in.obj").write_text(self.OBJ)
        for arguments in (("in.obj", "out.stl", "--thickness", 1), ("check", "in.obj")):
            with self.subTest(arguments):
                run = self.run_program(*arguments, "--report", "report.json")
                self.assert_ok(run)
                self.assertIn("thicken: warning: \"in.obj\": line 4: \"whatever\"", run.stderr)
                self.assertIn("whatever", self.report()["warnings"][0])
                self.assertEqual(self.run_program(*arguments, "--quiet").stderr, "")

    def test_a_warning_comes_with_a_refusal(self):
        (self.folder / "in.obj").write_text(self.OBJ + "f 1 2 3\n")
        run = self.run_program("in.obj", "out.stl", "--thickness", 1)
        self.assert_fails(run, 3, "degenerate")
        self.assertIn("whatever", run.stderr)


@unittest.skipIf(UNDER_WINE, "Wine hides links from the program")
class Links(ProgramCase):
    def setUp(self) -> None:
        super().setUp()
        write_off(self.folder / "in.off", SQUARE)
        (self.folder / "real").mkdir()

    def test_outputs_and_reports_are_written_through_links(self):
        (self.folder / "real/old.stl").write_bytes(b"old")
        (self.folder / "real/old.json").write_bytes(b"old")
        for link, target in (("out.stl", "real/old.stl"), ("report.json", "real/old.json"),
                             ("new.stl", "real/new.stl")):  # fmt: skip
            (self.folder / link).symlink_to(target)
        self.assert_ok(self.run_program("in.off", "out.stl", "--thickness", 1, "--report", "report.json"))
        self.assert_ok(self.run_program("in.off", "new.stl", "--thickness", 1))
        for link in ("out.stl", "report.json", "new.stl"):
            self.assertTrue((self.folder / link).is_symlink(), link)
        self.assertGreater(len(read_stl(self.folder / "real/old.stl")), 2)
        self.assertGreater(len(read_stl(self.folder / "real/new.stl")), 2, "there was no such file before")
        self.assertEqual(json.loads((self.folder / "real/old.json").read_text())["status"], "ok")

    def test_links_that_lead_nowhere_are_found_before_the_work(self):
        (self.folder / "in.off").write_text("no surface: were it read first, the code would be another one")
        (self.folder / "a.stl").symlink_to("b.stl")
        (self.folder / "b.stl").symlink_to("a.stl")
        (self.folder / "c.stl").symlink_to("missing/c.stl")
        for name in ("a.stl", "c.stl"):
            self.assert_fails(self.run_program("in.off", name, "--thickness", 1), 6, "unwritable")


class Kept(ProgramCase):
    def test_an_existing_output_survives_a_failure(self):
        write_off(self.folder / "in.off", (SQUARE[0], []))
        (self.folder / "out.stl").write_bytes(b"precious")
        self.assert_fails(self.run_program("in.off", "out.stl", "--thickness", 1), 3, "empty")
        self.assertEqual((self.folder / "out.stl").read_bytes(), b"precious")

    def test_an_existing_output_is_replaced_by_a_success(self):
        write_off(self.folder / "in.off", SQUARE)
        (self.folder / "out.stl").write_bytes(b"old")
        self.assert_ok(self.run_program("in.off", "out.stl", "--thickness", 1))
        self.assertGreater(len(read_stl(self.folder / "out.stl")), 2)
        self.assert_leaves({"in.off", "out.stl"})

    def test_input_and_output_may_be_the_same_file(self):
        write_off(self.folder / "in.off", wave(6))
        self.assert_ok(self.run_program("in.off", "in.off", "--thickness", 1))
        self.assert_ok(self.run_program("check", "in.off", "--report", "report.json"))
        self.assertTrue(self.report()["input"]["closed"])
        self.assert_leaves({"in.off", "report.json"})


if __name__ == "__main__":
    unittest.main()
