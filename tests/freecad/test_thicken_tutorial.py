# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of docs/tutorial.md, without windows: exported, judged by another program, sliced by a third."""

import re
import shutil
import subprocess
import zipfile
from pathlib import Path

import numpy as np

import ThickenWorkbench
from ThickenWorkbench import mesh_io
from thicken_case import DocumentCase
from thicken_judge import assert_judged_solid

DATA = Path(__file__).resolve().parents[2] / "examples" / "data"


class Tutorial(DocumentCase):
    def read(self, name):
        return self.add_source(ThickenWorkbench.read_mesh(DATA / name), Path(name).stem)

    def test_every_file_that_it_names_is_there(self):
        text = (DATA.parents[1] / "docs" / "tutorial.md").read_text()
        names = set(re.findall(r"`(\w+\.(?:stl|ply))`", text))
        self.assertGreaterEqual(len(names), 3)
        for name in names:
            self.assertTrue((DATA / name).is_file(), name)

    def test_a_bracket(self):
        self.assertEqual(ThickenWorkbench.check_surface(self.read("bracket.stl")), [])

    def slice(self, path):
        program = shutil.which("prusa-slicer")
        if program is None:
            self.skipTest("no prusa-slicer: apt-get install prusa-slicer")
        info = subprocess.run([program, "--info", path], capture_output=True, text=True)
        self.assertIn("manifold = yes", info.stdout)
        # Smaller, so that the bone fits the printer; coarse layers are enough to see that all closes.
        sliced = path.with_suffix(".sl1")
        run = subprocess.run(
            [program, "--export-sla", "--layer-height", "0.5", "--max-print-height", "300", "--scale", "0.4",
             "--output", sliced, path],
            capture_output=True, text=True, timeout=240,
        )  # fmt: skip
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIsNone(re.search(r"repair|non-manifold|open edges", run.stdout + run.stderr, re.IGNORECASE))
        with zipfile.ZipFile(sliced) as archive:
            layers = [name for name in archive.namelist() if name.endswith(".png")]
        self.assertGreater(len(layers), 20)

    def test_a_jacket_for_a_bone(self):
        scan = self.read("bone.stl")
        self.assertEqual(ThickenWorkbench.check_surface(scan), [])
        jacket = ThickenWorkbench.make_thicken(self.doc, scan, "3 mm", "positive")
        self.assert_solid(jacket)
        facts = ThickenWorkbench.printability(jacket)
        self.assertTrue(facts["printable"], facts["warnings"])
        self.assertAlmostEqual(facts["thinnest_wall"]["mm"], jacket.ThinnestWall.Value, delta=0.1)
        path = self.folder / "jacket.stl"
        ThickenWorkbench.export_for_printing(jacket, path)
        assert_judged_solid(self, path)
        self.slice(path)

    def test_a_hollow_pawn(self):
        hollow = ThickenWorkbench.make_thicken(self.doc, self.read("pawn.stl"), "2 mm")
        self.assert_solid(hollow)
        report = ThickenWorkbench.printability(hollow)
        self.assertEqual(len(report["trapped"]), 1)
        self.assertGreater(report["thinnest_wall"]["mm"], 1.9)
        drained = ThickenWorkbench.make_drain_holes(self.doc, hollow)
        self.assertTrue(drained.isValid(), drained.getStatusString())
        facts = ThickenWorkbench.printability(drained)
        self.assertEqual((facts["trapped"], facts["pools"], facts["warnings"]), ([], [], []))
        self.assertTrue(facts["printable"])
        self.assertGreater(facts["thinnest_wall"]["mm"], 1.9)  # the edge of the hole is no wall
        path = self.folder / "pawn.stl"
        ThickenWorkbench.export_for_printing(drained, path)
        assert_judged_solid(self, path)
        self.slice(path)

    def test_a_part_that_fits(self):
        scan = self.read("bone.stl")
        # points of an ellipse on the front of the shaft, from before it
        points, _ = mesh_io.arrays_from_mesh(scan.Mesh)
        turns = np.radians(np.arange(0, 360, 45))
        wanted = np.column_stack([122 + 10 * np.cos(turns), np.full(8, -30.0), -165 + 30 * np.sin(turns)])
        loop = [points[np.argmin(np.linalg.norm(points - place, axis=1))] for place in wanted]
        trimmed = ThickenWorkbench.make_trim(self.doc, scan, loop, smooth=2)
        self.assertTrue(trimmed.Valid, trimmed.getStatusString())
        part = ThickenWorkbench.make_thicken(self.doc, trimmed, "3 mm", "positive", gap="0.5 mm")
        self.assert_solid(part)
        plain = part.Volume.Value
        stroke = [(122, -12, -165 + 1.5 * k) for k in range(-8, 9)]
        near = ThickenWorkbench.facets_near(part, stroke, 3)
        ThickenWorkbench.set_thickness_regions(part, [(near, "5 mm")], "6 mm")
        self.doc.recompute()
        self.assert_solid(part)
        painted = trimmed.Mesh.copy()
        painted.removeFacets([k for k in range(trimmed.TriangleCount) if k not in set(near)])
        self.assertGreater(part.Volume.Value, plain + 2 * painted.Area)
        facts = ThickenWorkbench.printability(part)
        self.assertTrue(facts["valid"])
        path = self.folder / "part.stl"
        ThickenWorkbench.export_for_printing(part, path)
        assert_judged_solid(self, path)
        self.slice(path)
