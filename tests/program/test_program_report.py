# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every report that the program writes fits docs/report.schema.json, and says what is true."""

import copy
import json
import unittest
from pathlib import Path

from json_schema import faults
from program_case import ProgramCase
from surfaces import SQUARE, TEE, wave, with_extra, write_off

SCHEMA = json.loads((Path(__file__).parents[2] / "docs/report.schema.json").read_text())

CROSSED = with_extra([(1, 1, -1), (3, 1, -1), (2, 1.5, 1)], [(4, 5, 6)])


class Schema(ProgramCase):
    def setUp(self) -> None:
        super().setUp()
        write_off(self.folder / "in.off", SQUARE)
        write_off(self.folder / "wave.off", wave(8))
        write_off(self.folder / "crossed.off", CROSSED)

    def report_of(self, status: int, *arguments) -> dict:
        run = self.run_program(*arguments, "--report", "report.json")
        self.assertEqual(run.returncode, status, run.stderr)
        return self.report()

    def assert_fits(self, report: dict) -> None:
        self.assertEqual(faults(report, SCHEMA, SCHEMA), [])

    def test_reports_of_solids_fit(self):
        for options in ((), ("--method", "sweep"), ("--method", "reconstruct"), ("--side", "both"),
                        ("--tolerance", 0.1), ("--repair",)):  # fmt: skip
            with self.subTest(options):
                self.assert_fits(self.report_of(0, "wave.off", "out.ply", "--thickness", 1, *options))
        self.assert_fits(self.report_of(0, "crossed.off", "out.ply", "--thickness", 1, "--repair"))

    def test_reports_of_sheets_fit(self):
        write_off(self.folder / "tee.off", TEE)
        report = self.report_of(0, "tee.off", "out.3mf", "--thickness", 0.2, "--sheets")
        self.assert_fits(report)
        self.assertEqual([sheet["input"]["triangles"] for sheet in report["sheets"]], [4, 2])

    def test_reports_of_refusals_fit(self):
        self.assert_fits(self.report_of(3, "crossed.off", "out.ply", "--thickness", 1))
        self.assert_fits(self.report_of(4, "in.off", "out.ply", "--thickness", 1, "--memory", 1))
        self.assert_fits(self.report_of(6, "missing.off", "out.ply", "--thickness", 1))

    def test_reports_of_checks_fit(self):
        self.assert_fits(self.report_of(0, "check", "in.off"))
        self.assert_fits(self.report_of(3, "check", "crossed.off"))
        self.assert_fits(self.report_of(6, "check", "missing.off"))

    def test_what_is_missing_or_unknown_does_not_fit(self):
        report = self.report_of(0, "in.off", "out.ply", "--thickness", 1)
        for change in (
            lambda r: r.pop("thinnest_wall"),
            lambda r: r["output"].pop("parts"),
            lambda r: r.update(more=1),
            lambda r: r["input"].update(triangles="2"),
            lambda r: r.update(status="fine"),
        ):
            changed = copy.deepcopy(report)
            change(changed)
            self.assertNotEqual(faults(changed, SCHEMA, SCHEMA), [])

    def test_a_method_is_as_asked_and_the_maker_as_it_was(self):
        expected = {"auto": {"sweep", "sweep-and-contour"}, "sweep": {"sweep"}, "reconstruct": {"contour"}}
        for method, makers in expected.items():
            with self.subTest(method):
                report = self.report_of(0, "wave.off", "out.ply", "--thickness", 1, "--method", method)
                self.assertEqual(report["parameters"]["method"], method)
                self.assertIn(report["output"]["made_by"], makers)
                if method == "reconstruct":
                    self.assertEqual(report["output"]["sweep_rounds"], 0, "there was no sweep")
                if method == "sweep":
                    self.assertEqual(report["output"]["contour_attempts"], 0, "there was no contour")


if __name__ == "__main__":
    unittest.main()
