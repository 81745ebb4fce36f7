# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad input: the feature says what is wrong and where, and keeps nothing of an earlier solid."""

import os
import tempfile
from unittest import mock

import FreeCAD as App
import numpy as np

import ThickenWorkbench
from thicken import native
from ThickenWorkbench import mesh_io
from thicken_case import DocumentCase
from thicken_surfaces import crossing_plates, fin, plate, saddle, together


class Refusals(DocumentCase):
    def setUp(self):
        super().setUp()
        self.source = self.add_source(plate())
        self.feature = ThickenWorkbench.make_thicken(self.doc, self.source, thickness=1)
        self.assert_solid(self.feature)

    def give(self, surface):
        self.source.Mesh = mesh_io.mesh_from_arrays(*surface)
        self.doc.recompute()

    def recovers(self):
        self.give(saddle())
        self.assert_solid(self.feature)
        self.assertEqual(self.feature.OriginalTriangles, len(saddle()[1]))

    def test_self_intersecting_source(self):
        self.give(crossing_plates())
        self.assert_refused(self.feature, "triangle")
        self.assertRegex(self.feature.getStatusString(), r"(?i)intersect|meet|cross")
        self.recovers()

    def test_non_manifold_source(self):
        self.give(fin())
        self.assert_refused(self.feature, "edge")
        self.assertRegex(self.feature.getStatusString(), r"\d")
        self.recovers()

    def test_all_kinds_of_defect_are_named_at_once(self):
        shifted = crossing_plates()[0] + np.array([100, 0, 0], np.float32), crossing_plates()[1]
        self.give(together(fin(), shifted))
        self.assert_refused(self.feature, "edge")
        self.assertRegex(self.feature.getStatusString(), r"(?i)intersect|meet each|cross")

    def test_flipped_triangle(self):
        vertices, triangles = plate()
        triangles[17] = triangles[17][::-1]
        self.give((vertices, triangles))
        self.assert_refused(self.feature)
        self.recovers()

    def test_not_finite_coordinates(self):
        vertices, triangles = plate()
        vertices[5, 2] = np.nan
        self.source.Mesh = mesh_io.mesh_from_arrays(plate()[0], triangles)
        # FreeCAD's kernel takes what a file or script gives it.
        mesh = self.source.Mesh.copy()
        mesh.setPoint(5, App.Vector(0, 0, float("nan")))
        self.source.Mesh = mesh
        self.doc.recompute()
        self.assert_refused(self.feature)
        self.recovers()

    def test_empty_source(self):
        self.give((np.empty((0, 3)), np.empty((0, 3), int)))
        self.assert_refused(self.feature)
        self.assertGreater(len(self.feature.getStatusString()), 10)
        self.recovers()

    def test_place_is_told_in_the_document_too(self):
        self.source.Placement = App.Placement(App.Vector(1000, 0, 0), App.Rotation())
        self.give(fin())
        # give() replaced the mesh and with it FreeCAD's Placement: set it again
        self.source.Placement = App.Placement(App.Vector(1000, 0, 0), App.Rotation())
        self.doc.recompute()
        self.assert_refused(self.feature, "In the document the first place is at (991, 3, 0) mm.")

    def test_no_source(self):
        self.feature.Source = None
        self.doc.recompute()
        self.assert_refused(self.feature, "Source")
        self.feature.Source = self.source
        self.doc.recompute()
        self.assert_solid(self.feature)

    def test_source_that_is_no_mesh(self):
        self.feature.Source = self.doc.addObject("App::FeaturePython", "NoMesh")
        self.doc.recompute()
        self.assert_refused(self.feature, "NoMesh", "neither a mesh")

    def test_thickness_of_nothing(self):
        self.feature.Thickness = 0
        self.doc.recompute()
        self.assert_refused(self.feature, "Thickness")
        self.feature.Thickness = 1
        self.doc.recompute()
        self.assert_solid(self.feature)

    def test_tolerance_out_of_reach(self):
        self.give(saddle())
        self.feature.Quality = "Tolerance"
        self.feature.Tolerance = 1e-9
        self.doc.recompute()
        self.assert_refused(self.feature, "tolerance")
        self.feature.Quality = "Standard"
        self.doc.recompute()
        self.assert_solid(self.feature)

    def test_memory_preference(self):
        preferences = App.ParamGet("User parameter:BaseApp/Preferences/Mod/Thicken")
        preferences.SetInt("MemoryMiB", 1)
        self.addCleanup(preferences.RemInt, "MemoryMiB")
        self.give(plate(n=200))
        self.assert_refused(self.feature, "memory", "1 MiB")

    def test_nothing_is_lost_in_the_document(self):
        before = mesh_io.arrays_from_mesh(self.source.Mesh)
        self.feature.Side = "Positive"
        self.give(fin())
        self.assert_refused(self.feature)
        self.assertEqual((self.feature.Side, self.feature.Thickness.Value), ("Positive", 1))
        self.source.Mesh = mesh_io.mesh_from_arrays(*before)
        self.doc.recompute()
        self.assert_solid(self.feature)

    def test_missing_extension(self):
        with tempfile.TemporaryDirectory() as empty, mock.patch.object(native, "_loaded", None):
            with mock.patch.dict(os.environ, {native.DIRECTORY_VARIABLE: empty}):
                self.feature.Thickness = 0.7
                self.doc.recompute()
                self.assert_refused(self.feature, "there is no", native.file_name())
        self.feature.touch()
        self.doc.recompute()
        self.assert_solid(self.feature)
