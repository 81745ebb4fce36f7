# SPDX-License-Identifier: LGPL-2.1-or-later
"""The feature that mends a surface."""

import re

import FreeCAD as App
import numpy as np

import ThickenWorkbench
from ThickenWorkbench import mesh_io
from ThickenWorkbench.repair_feature import words
from ThickenWorkbench.sources import RefusedError
from thicken_case import DocumentCase
from thicken_surfaces import crossing_plates, fin, plate, together


class Repair(DocumentCase):
    def test_mends_and_says_how(self):
        source = self.add_source(crossing_plates())
        source.Placement = App.Placement(App.Vector(1, 2, 3), App.Rotation(App.Vector(0, 0, 1), 30))
        feature = ThickenWorkbench.make_repair(self.doc, source)
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertTrue(feature.Valid)
        self.assertEqual(ThickenWorkbench.check_surface(feature), [])
        np.testing.assert_allclose(feature.Placement.toMatrix().A, source.Placement.toMatrix().A, atol=1e-12)
        self.assertGreater(feature.Removed, 0)
        # A part of what was removed may come back, divided.
        self.assertGreaterEqual(feature.TriangleCount, source.Mesh.CountFacets - feature.Removed)
        self.assertIn("met others", " ".join(feature.Changes))
        self.assertTrue(ThickenWorkbench.make_thicken(self.doc, feature, 1).Valid)

    def test_good_surface_stays_as_it_is(self):
        source = self.add_source(plate())
        feature = ThickenWorkbench.make_repair(self.doc, source)
        self.assertEqual((feature.Changes, feature.Removed), ([], 0))
        for array, array_before in zip(mesh_io.arrays_from_mesh(feature.Mesh), ThickenWorkbench.weld_mesh(*plate())):
            np.testing.assert_array_equal(array, array_before)

    def test_follows_its_source(self):
        source = self.add_source(plate())
        feature = ThickenWorkbench.make_repair(self.doc, source)
        source.Mesh = mesh_io.mesh_from_arrays(*fin())
        self.doc.recompute()
        self.assertEqual(ThickenWorkbench.check_surface(feature), [])
        self.assertEqual(feature.Removed, 3)  # the fin, in as many parts

    def test_weld_distance(self):
        vertices, triangles = plate()
        apart = np.concatenate([vertices, vertices[:11] + np.float32([0, 0, 0.01])])  # one row of points, twice
        split = np.where(triangles < 11, triangles + len(vertices), triangles)
        halves = np.concatenate([split[:10], split[100:110], triangles[10:100], triangles[110:]])
        source = self.add_source((apart, halves))
        apart_feature = ThickenWorkbench.make_repair(self.doc, source, weld=0)
        welded = ThickenWorkbench.make_repair(self.doc, source, weld="0.02 mm")
        self.assertTrue(welded.isValid() and apart_feature.isValid())
        self.assertEqual(welded.Weld.Value, 0.02)

    def test_bridges_gaps_and_fills_holes(self):
        vertices, triangles = plate()
        holed = np.delete(triangles, [45, 145], 0)  # a cell in the middle
        beside = (vertices + np.float32([np.ptp(vertices[:, 0]) + 0.5, 0, 0])).astype(np.float32)
        source = self.add_source(together((vertices, holed), (beside, triangles)))
        left = ThickenWorkbench.make_repair(self.doc, source)
        self.assertEqual((left.Added, left.Changes), (0, []))
        joined = ThickenWorkbench.make_repair(self.doc, source, bridge=1, fill_holes="10 mm")
        self.assertTrue(joined.isValid(), joined.getStatusString())
        self.assertEqual(joined.Mesh.countComponents(), 1)
        self.assertEqual(joined.TriangleCount, left.TriangleCount + joined.Added)
        self.assertEqual(len(joined.Changes), 2)
        self.assertEqual(ThickenWorkbench.check_surface(joined), [])
        joined.FillHoles = 0
        self.doc.recompute()
        self.assertEqual(len(joined.Changes), 1)

    def test_refusals(self):
        with self.assertRaises(RefusedError):
            ThickenWorkbench.make_repair(self.doc, None)
        with self.assertRaises(ValueError):
            ThickenWorkbench.make_repair(self.doc, self.add_source(plate()), weld=-1)
        vertices = np.float32([[0, 0, 0], [1, 0, 0], [2, 0, 0]])
        feature = ThickenWorkbench.make_repair(self.doc, self.add_source((vertices, [[0, 1, 2]]), "Line"))
        self.assertFalse(feature.isValid())
        self.assertEqual((feature.Valid, feature.Mesh.CountFacets), (False, 0))

    def test_saved_and_reopened(self):
        ThickenWorkbench.make_repair(self.doc, self.add_source(fin()))
        path = self.folder / "part.FCStd"
        self.doc.saveAs(str(path))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(str(path))
        feature = self.doc.getObject("Repair")
        self.assertTrue(feature.Valid)
        feature.touch()
        self.doc.recompute()
        self.assertTrue(feature.isValid())

    def test_every_kind_of_change_has_words(self):
        from pathlib import Path

        text = (Path(__file__).resolve().parents[2] / "docs" / "report.md").read_text()
        kinds = text[text.index("### Kinds of change") : text.index("## Sheet by sheet")]
        self.assertEqual(set(re.findall(r"`([a-z-]+)`", kinds)) - {"count", "triangles"}, set(words()))
