# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric feature: what it makes, and what makes it recompute."""

from unittest import mock

import FreeCAD as App
import numpy as np

import ThickenWorkbench
from ThickenWorkbench import build, mesh_io
from thicken_case import DocumentCase
from thicken_judge import keeps
from thicken_surfaces import plate, saddle
from test_thicken_part_solid import box


def corners(mesh) -> np.ndarray:
    vertices, triangles = mesh_io.arrays_from_mesh(mesh)
    return vertices[triangles]


class Create(DocumentCase):
    def test_makes_a_solid_that_keeps_the_surface(self):
        source = self.add_source(plate(size=20))
        feature = ThickenWorkbench.make_thicken(self.doc, source, thickness=2)
        self.assert_solid(feature)
        self.assertEqual(feature.TypeId, "Mesh::FeaturePython")
        self.assertAlmostEqual(feature.Volume.Value, 20 * 20 * 2, places=6)
        self.assertAlmostEqual(feature.Area.Value, 2 * 20 * 20 + 4 * 20 * 2, places=6)
        self.assertAlmostEqual(feature.ThinnestWall.Value, 2, places=6)
        self.assertAlmostEqual(feature.ShellErrorMax, 0, places=6)
        self.assertEqual(feature.OriginalTriangles, source.Mesh.CountFacets)
        self.assertEqual(
            feature.TriangleCount, feature.OriginalTriangles + feature.ShellTriangles + feature.WallTriangles
        )
        self.assertTrue(keeps(corners(feature.Mesh), corners(source.Mesh)))

    def test_knows_what_it_was_asked_for(self):
        feature = ThickenWorkbench.make_thicken(
            self.doc, self.add_source(saddle()), thickness="1.5 mm", side="positive", method="sweep", tolerance=0.5
        )
        self.assert_solid(feature)
        self.assertEqual((feature.Thickness.Value, feature.Side, feature.Method), (1.5, "Positive", "Sweep"))
        self.assertEqual((feature.Quality, feature.Tolerance.Value), ("Tolerance", 0.5))
        self.assertEqual(feature.UsedMethod, "sweep")

    def test_material_lies_on_the_side_asked_for(self):
        for side, low, high in [("negative", -2, 0), ("positive", 0, 2), ("both", -2, 2)]:
            with self.subTest(side=side):
                source = self.add_source(plate())
                feature = ThickenWorkbench.make_thicken(self.doc, source, thickness=2, side=side)
                self.assert_solid(feature)
                box = feature.Mesh.BoundBox
                self.assertAlmostEqual(box.ZMin, low, places=6)
                self.assertAlmostEqual(box.ZMax, high, places=6)
                if side != "both":
                    kept = keeps(corners(feature.Mesh), corners(source.Mesh), reversed_sense=side == "positive")
                    self.assertTrue(kept)

    def test_join(self):
        """Around a cube edges and corners stay sharp, or are rounded as a ball rolling around it would."""
        source = self.add_source(box((0, 0, 0), (10, 10, 10)))
        feature = ThickenWorkbench.make_thicken(self.doc, source, 2, "positive", join="intersection")
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, 14**3 - 10**3, places=3)
        rounded = 6 * 100 * 2 + 12 * 10 * np.pi + 4 / 3 * np.pi * 8
        feature.Join = "Arc"
        self.doc.recompute()
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, rounded, delta=0.01 * rounded)
        with self.assertRaises(ValueError):
            ThickenWorkbench.make_thicken(self.doc, source, 2, join="bevel")

    def test_rim(self):
        """Corners of the plate are 2 mm apart."""
        feature = ThickenWorkbench.make_thicken(
            self.doc, self.add_source(plate(size=20)), 3, rim_thickness="1 mm", rim_width=4
        )

        def depths():
            points = corners(feature.Mesh).reshape(-1, 3)
            points = points[points[:, 2] < 0]
            from_rim = np.min([points[:, :2] - points[:, :2].min(axis=0), points[:, :2].max(axis=0) - points[:, :2]], axis=(0, 2))
            return [-points[np.isclose(from_rim, d), 2].min() for d in (0, 2, 4, 6)]

        self.assert_solid(feature)
        np.testing.assert_allclose(depths(), [1, 2, 3, 3], atol=1e-4)
        self.assertEqual(list(feature.Warnings), [])
        feature.RimThickness, feature.RimWidth, feature.RimRound = 0, 0, 2
        self.doc.recompute()
        self.assert_solid(feature)
        np.testing.assert_allclose(depths(), [1, 3, 3, 3], atol=1e-4)
        self.assertIn("coarser than asked", "".join(feature.Warnings))
        feature.RimRound = 3
        self.doc.recompute()
        self.assertIn("less than the thickness", feature.getStatusString())

    def test_suggests_a_thickness(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(plate(size=20)))
        self.assertEqual(feature.Thickness.Value, 0.6)  # 2 % of 28.28…, one digit
        self.assert_solid(feature)

    def test_results_are_read_only(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(plate()), thickness=1)
        for name in ("Volume", "Area", "ShellError", "ThinnestWall", "TriangleCount", "Warnings"):
            self.assertIn("ReadOnly", feature.getEditorMode(name), name)

    def test_refuses_arguments_that_make_no_sense_and_leaves_nothing_behind(self):
        source = self.add_source(plate())
        for wrong in [
            {"thickness": 0},
            {"thickness": -1},
            {"thickness": "2 kg"},
            {"side": "up"},
            {"method": "magic"},
            {"cell": 0.1, "tolerance": 0.1},
        ]:
            with self.subTest(wrong=wrong):
                with self.assertRaises((ValueError, TypeError)):
                    ThickenWorkbench.make_thicken(self.doc, source, **{"thickness": 1, **wrong})
                self.assertEqual(self.doc.Objects, [source])

    def test_refuses_what_is_no_mesh(self):
        box = self.doc.addObject("App::FeaturePython", "NoMesh")
        for source in (box, None, "Scan"):
            with self.assertRaises(build.RefusedError):
                ThickenWorkbench.make_thicken(self.doc, source, thickness=1)
        self.assertEqual(self.doc.Objects, [box])


class Change(DocumentCase):
    def setUp(self):
        super().setUp()
        self.source = self.add_source(plate())
        self.feature = ThickenWorkbench.make_thicken(self.doc, self.source, thickness=2)

    def test_thickness(self):
        self.feature.Thickness = 3
        self.doc.recompute()
        self.assert_solid(self.feature)
        self.assertAlmostEqual(self.feature.Volume.Value, 20 * 20 * 3, places=6)

    def test_side(self):
        self.feature.Side = "Positive"
        self.doc.recompute()
        self.assert_solid(self.feature)
        self.assertAlmostEqual(self.feature.Mesh.BoundBox.ZMax, 2, places=6)

    def test_mesh_of_the_source(self):
        surface = plate(size=30)
        self.source.Mesh = mesh_io.mesh_from_arrays(*surface)
        self.doc.recompute()
        self.assert_solid(self.feature)
        self.assertAlmostEqual(self.feature.Volume.Value, 30 * 30 * 2, places=6)
        self.assertTrue(keeps(corners(self.feature.Mesh), surface[0][surface[1]]))

    def test_source_itself(self):
        other = self.add_source(saddle(), "Other")
        self.feature.Source = other
        self.doc.recompute()
        self.assert_solid(self.feature)
        self.assertTrue(keeps(corners(self.feature.Mesh), corners(other.Mesh)))

    def test_a_chain_of_features(self):
        solid = ThickenWorkbench.make_thicken(self.doc, self.feature, thickness=0.5)
        self.assert_solid(solid)  # the first solid, hollowed
        self.feature.Thickness = 4
        self.doc.recompute()
        self.assert_solid(solid)
        self.assertEqual(solid.OriginalTriangles, self.feature.TriangleCount)

    def test_only_the_number_in_use_is_shown(self):
        self.assertIn("Hidden", self.feature.getEditorMode("Tolerance"))
        self.feature.Quality = "Tolerance"
        self.assertNotIn("Hidden", self.feature.getEditorMode("Tolerance"))
        self.assertIn("Hidden", self.feature.getEditorMode("Cell"))

    def test_undo(self):
        self.doc.UndoMode = 1
        self.doc.openTransaction("thicker")
        self.feature.Thickness = 5
        self.doc.recompute()
        self.doc.commitTransaction()
        self.doc.undo()
        self.doc.recompute()
        self.assertEqual(self.feature.Thickness.Value, 2)
        self.assert_solid(self.feature)
        self.assertAlmostEqual(self.feature.Volume.Value, 20 * 20 * 2, places=6)


class Place(DocumentCase):
    PLACEMENT = App.Placement(App.Vector(100.1, -20.2, 3.3), App.Rotation(App.Vector(1, 2, 3), 40))

    def test_feature_follows_the_source_and_the_mesh_stays_exact(self):
        source = self.add_source(saddle())
        source.Placement = self.PLACEMENT
        feature = ThickenWorkbench.make_thicken(self.doc, source, thickness=1)
        self.assert_solid(feature)
        self.assert_same_place(feature.Placement, self.PLACEMENT)
        self.assertTrue(keeps(corners(feature.Mesh), corners(source.Mesh)))
        source.Placement = App.Placement()
        self.doc.recompute()
        self.assertTrue(feature.Placement.isIdentity())
        self.assert_solid(feature)

    def test_moving_the_source_computes_nothing(self):
        source = self.add_source(saddle())
        feature = ThickenWorkbench.make_thicken(self.doc, source, 1)
        with mock.patch("ThickenWorkbench.core.precomputed.thicken_mesh", side_effect=AssertionError("computed again")):
            source.Placement = self.PLACEMENT
            self.doc.recompute()
            self.assertTrue(feature.isValid(), feature.getStatusString())
            self.assert_same_place(feature.Placement, self.PLACEMENT)
        self.assert_solid(feature)

    def test_an_undone_edit_computes_nothing(self):
        self.doc.UndoMode = 1
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1)
        volume = feature.Volume.Value
        self.doc.openTransaction("Edit")
        feature.Thickness = 2
        self.doc.recompute()
        self.doc.commitTransaction()
        self.assertGreater(feature.Volume.Value, 1.5 * volume)
        self.doc.undo()
        with mock.patch("ThickenWorkbench.core.precomputed.thicken_mesh", side_effect=AssertionError("computed again")):
            self.doc.recompute()
            self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertEqual(feature.Volume.Value, volume)
        self.assert_solid(feature)

    def test_a_mesh_that_was_edited_by_hand_is_computed_again(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1)
        moved = feature.Mesh.copy()
        moved.setPoint(0, App.Vector(50, 0, 0))
        feature.Mesh = moved
        feature.touch()
        self.doc.recompute()
        self.assert_solid(feature)

    def test_inside_a_part(self):
        part = self.doc.addObject("App::Part", "Part")
        part.Placement = App.Placement(App.Vector(0, 0, 50), App.Rotation(App.Vector(0, 1, 0), 90))
        source = self.add_source(saddle())
        part.addObject(source)
        source.Placement = self.PLACEMENT
        feature = ThickenWorkbench.make_thicken(self.doc, source, thickness=1)
        self.assert_solid(feature)
        self.assertEqual(feature.getParentGeoFeatureGroup(), part)
        self.assert_same_place(feature.getGlobalPlacement(), source.getGlobalPlacement())
