# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of tests that need a document."""

from __future__ import annotations

import tempfile
import unittest
from pathlib import Path

import FreeCAD as App
import numpy as np

from ThickenWorkbench import mesh_io, params


class DocumentCase(unittest.TestCase):
    """A fresh document, a folder for files, and what a feature has to be with and without a solid."""

    def setUp(self):
        self.doc = App.newDocument("ThickenTest")
        self.addCleanup(self.close_all)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def close_all(self):
        for name in list(App.listDocuments()):
            App.closeDocument(name)

    def add_source(self, surface, name="Scan"):
        source = self.doc.addObject("Mesh::Feature", name)
        source.Mesh = mesh_io.mesh_from_arrays(*surface)
        return source

    def assert_same_place(self, placement, other):
        """Up to rounding: FreeCAD 1.0 changes the last bit of a rotation that is set."""
        np.testing.assert_allclose(placement.toMatrix().A, other.toMatrix().A, rtol=0, atol=1e-12)

    def assert_solid(self, feature):
        self.assertNotIn("Invalid", feature.State, feature.getStatusString())
        self.assertTrue(feature.isValid())
        self.assertTrue(feature.Valid)
        mesh = feature.Mesh
        self.assertTrue(mesh.isSolid())
        self.assertFalse(mesh.hasNonManifolds())
        self.assertFalse(mesh.hasNonUniformOrientedFacets())
        self.assertEqual(feature.TriangleCount, mesh.CountFacets)
        volume, area = self.measured(mesh)
        self.assertAlmostEqual(feature.Volume.Value, volume, delta=1e-4 * volume)
        self.assertAlmostEqual(feature.Area.Value, area, delta=1e-4 * area)
        self.assertGreater(volume, 0)

    @staticmethod
    def measured(mesh):
        """Volume and area in doubles: FreeCAD's own sums are floats, and off by percents for many facets."""
        points, facets = mesh.Topology
        corners = np.array([[p.x, p.y, p.z] for p in points])[np.array(facets)]
        a, b, c = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        across = np.cross(b, c)
        return float((a * across).sum() / 6), float(np.linalg.norm(across, axis=1).sum() / 2)

    def assert_refused(self, feature, *words):
        self.assertIn("Invalid", feature.State)
        self.assertFalse(feature.isValid())
        for word in words:
            self.assertIn(word, feature.getStatusString())
        self.assertEqual(feature.Mesh.CountFacets, 0, "a stale mesh")
        self.assertEqual(feature.Mesh.CountPoints, 0, "a stale mesh")
        for prop in params.RESULTS:
            value = getattr(feature, prop.name)
            self.assertFalse(any(value) if prop.type.endswith("Vector") else getattr(value, "Value", value), prop.name)
