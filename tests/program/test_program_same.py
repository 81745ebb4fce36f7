# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report's key, and --skip-if-same."""

import hashlib
import json
import unittest

from program_case import ProgramCase
from surfaces import wave, write_off


class Same(ProgramCase):
    def setUp(self) -> None:
        super().setUp()
        write_off(self.folder / "in.off", wave(6))

    def thicken(self, *options, output: str = "out.stl", thickness=1):
        return self.run_program("in.off", output, "--thickness", thickness, "--report", "report.json", *options)

    def assert_made_again(self, is_made: bool, *options, **arguments) -> None:
        """Whether a run that may skip does the work: a report that it writes has lost the mark of the last one."""
        path = self.folder / "report.json"
        path.write_text(json.dumps({**json.loads(path.read_text()), "mark": 1}))
        self.assert_ok(self.thicken("--skip-if-same", *options, **arguments))
        self.assertEqual("mark" not in self.report(), is_made)

    def test_what_is_there_is_not_made_again(self):
        self.assert_ok(self.thicken("--skip-if-same"))
        before = (self.folder / "out.stl").stat()
        self.assert_made_again(False)
        self.assert_made_again(False, "--threads", 1, "--timeout", 1000)
        after = (self.folder / "out.stl").stat()
        self.assertEqual((before.st_ino, before.st_mtime_ns), (after.st_ino, after.st_mtime_ns))

    def test_other_bytes_and_options_are_made(self):
        self.assert_ok(self.thicken())
        self.assert_made_again(True, thickness=2)
        self.assert_made_again(True, "--side", "both", thickness=2)
        self.assert_made_again(True, "--side", "both", "--memory", 900, thickness=2)
        self.assert_made_again(True)
        write_off(self.folder / "in.off", wave(7))
        self.assert_made_again(True)
        self.assert_made_again(False)
        self.assert_made_again(True, output="out.ply")

    def test_an_output_that_is_cut_short_or_gone_is_made_again(self):
        self.assert_ok(self.thicken())
        whole = (self.folder / "out.stl").read_bytes()
        for spoil in (lambda p: p.write_bytes(whole[:-50]), lambda p: p.write_bytes(whole[:-1] + b"x"), lambda p: p.unlink()):
            spoil(self.folder / "out.stl")
            self.assert_made_again(True)
            self.assertEqual((self.folder / "out.stl").read_bytes(), whole)

    def test_reports_that_do_not_tell_of_it_are_no_reason_to_skip(self):
        self.assert_ok(self.thicken())
        whole = (self.folder / "report.json").read_text()
        for text in ("", "[]", "{}", whole[: len(whole) // 2], whole.replace('"ok"', '"refused"', 1),
                     json.dumps({**json.loads(whole), "output": 5}), json.dumps({**json.loads(whole), "key": None})):  # fmt: skip
            with self.subTest(text[:40]):
                (self.folder / "report.json").write_text(text)
                self.assert_ok(self.thicken("--skip-if-same"))
                self.assertEqual(self.report()["status"], "ok")
                self.assertIn("audit", self.report())

    def test_the_digests_are_those_of_others(self):
        self.assert_ok(self.thicken())
        digest = hashlib.sha256((self.folder / "out.stl").read_bytes()).hexdigest()
        self.assertEqual(self.report()["output"]["sha256"], digest)
        key = self.report()["key"]
        (self.folder / "in.off").rename(self.folder / "other.off")
        self.assert_ok(self.run_program("other.off", "b.stl", "--thickness", 1, "--report", "b.json", "--threads", 2))
        self.assertEqual(self.report("b.json")["key"], key)

    def test_refusals_have_the_key_and_are_looked_at_again(self):
        vertices, triangles = wave(6)
        write_off(self.folder / "in.off", (vertices, triangles + triangles[:1]))
        for _ in range(2):
            self.assert_fails(self.thicken("--skip-if-same"), 3, "degenerate")
            self.assertRegex(self.report()["key"], "^[0-9a-f]{64}$")

    def test_it_wants_a_report_and_one_output(self):
        for options in ((), ("--report", "r.json", "--repair", "--repaired", "mended.stl")):
            run = self.run_program("in.off", "out.stl", "--thickness", 1, "--skip-if-same", *options)
            self.assert_fails(run, 2, "usage")


if __name__ == "__main__":
    unittest.main()
