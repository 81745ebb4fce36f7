# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a closed part to the printer: hollowed, drained, exported, judged by others, sliced."""

import shutil
import subprocess
import zipfile
from pathlib import Path

import numpy as np

import ThickenWorkbench
from thicken_case import DocumentCase
from thicken_judge import assert_judged_solid
from test_thicken_printing import hollow_box

CLOSED = Path(__file__).resolve().parents[3] / "shared" / "data" / "closed"


class FromPartToPrinter(DocumentCase):
    """A part is hollowed, drained and exported; others judge the file."""

    def exported(self, name):
        path = CLOSED / f"{name}.ply"
        if not path.is_file():
            self.skipTest(f"no {path}: the corpus is not beside the project")
        vertices, triangles = ThickenWorkbench.read_mesh(path)
        vertices = vertices * (40 / np.ptp(vertices, axis=0).max())
        source = self.add_source((vertices.astype(np.float32), triangles), "Part")
        hollow = ThickenWorkbench.make_thicken(self.doc, source, 2)
        self.assertTrue(hollow.isValid(), hollow.getStatusString())
        drained = ThickenWorkbench.make_drain_holes(self.doc, hollow, 3)
        self.assertTrue(drained.isValid(), drained.getStatusString())
        self.assertGreater(drained.HoleCount, 0)
        written = self.folder / f"{name}.stl"
        ThickenWorkbench.export_for_printing(drained, written)
        return written

    def slice(self, path):
        program = shutil.which("prusa-slicer")
        if program is None:
            self.skipTest("no prusa-slicer: apt-get install prusa-slicer")
        info = subprocess.run([program, "--info", path], capture_output=True, text=True)
        self.assertIn("manifold = yes", info.stdout)
        self.assertNotRegex(info.stdout + info.stderr, r"(?i)repaired|open edges|errors")
        sliced = path.with_suffix(".sl1")
        run = subprocess.run(
            [program, "--export-sla", "--output", sliced, path], capture_output=True, text=True, timeout=240
        )
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertNotRegex(run.stdout + run.stderr, r"(?i)repair|non-manifold")
        with zipfile.ZipFile(sliced) as archive:
            layers = [name for name in archive.namelist() if name.endswith(".png")]
        self.assertGreater(len(layers), 50)

    def test_hollow_box(self):
        drained = ThickenWorkbench.make_drain_holes(self.doc, hollow_box(self), 4, count=2)
        path = self.folder / "box.stl"
        ThickenWorkbench.export_for_printing(drained, path)
        assert_judged_solid(self, path)
        self.slice(path)

    def test_bunny(self):
        path = self.exported("igltut_bunny")
        assert_judged_solid(self, path)
        self.slice(path)

    def test_hand(self):
        assert_judged_solid(self, self.exported("gel_hand"))
