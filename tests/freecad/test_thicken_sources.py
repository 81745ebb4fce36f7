# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be thickened: meshes, chosen facets, shapes, chosen faces, several objects at once."""

import math

import FreeCAD as App
import numpy as np
import Part

import ThickenWorkbench
from ThickenWorkbench import build, mesh_io
from ThickenWorkbench.sources import RefusedError, face_names, surface_arrays
from thicken_case import DocumentCase
from thicken_judge import keeps
from thicken_surfaces import plate, saddle

PLACEMENT = App.Placement(App.Vector(1.1, 2.2, 3.3), App.Rotation(App.Vector(0, 1, 1), 30))


class Shapes(DocumentCase):
    def add_shape(self, shape, name="Shape"):
        obj = self.doc.addObject("Part::Feature", name)
        obj.Shape = shape
        return obj

    def test_face_of_a_box(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        feature = ThickenWorkbench.make_thicken(self.doc, box, 1, faces=["Face6"])
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, 100, places=6)
        self.assertAlmostEqual(feature.Mesh.BoundBox.ZMin, 9, places=6)  # below the top face

    def test_solid_becomes_hollow(self):
        sphere = self.add_shape(Part.makeSphere(10))
        feature = ThickenWorkbench.make_thicken(self.doc, sphere, 2, deflection=0.02)
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, 4 / 3 * math.pi * (10**3 - 8**3), delta=20)

    def test_faces_that_share_edges_are_joined(self):
        box = self.add_shape(Part.makeBox(10, 10, 10))
        feature = ThickenWorkbench.make_thicken(self.doc, box, 1, faces=[1, "Face3", "Shape.Face6"])
        self.assert_solid(feature)
        self.assertEqual(feature.SourceFaces, (box, ["Face1", "Face3", "Face6"]))
        self.assertEqual(ThickenWorkbench.check_mesh(*build.surface_of(feature))["input"]["rims"], 1)

    def test_shell_of_a_loft(self):
        wires = [Part.Wire(Part.makeCircle(radius, App.Vector(0, 0, z))) for radius, z in ((5, 0), (3, 10))]
        loft = self.add_shape(Part.makeLoft(wires, False))
        for side in ("negative", "positive"):
            self.assert_solid(ThickenWorkbench.make_thicken(self.doc, loft, 1, side=side))

    def test_deflection_bounds_the_tessellation(self):
        sphere = self.add_shape(Part.makeSphere(10))
        counts = []
        for deflection in (0.2, 0.01):
            vertices, triangles = surface_arrays(sphere, deflection=deflection)
            middles = vertices[triangles].astype(float).mean(axis=1)
            self.assertLess(10 - np.linalg.norm(middles, axis=1).min(), deflection)
            counts.append(len(triangles))
        self.assertGreater(counts[1], 4 * counts[0])

    def test_triangles_for_the_screen_do_not_matter(self):
        sphere = self.add_shape(Part.makeSphere(10))
        before = surface_arrays(sphere, deflection=0.1)
        sphere.Shape.tessellate(1.0)
        for array, array_before in zip(surface_arrays(sphere, deflection=0.1), before):
            np.testing.assert_array_equal(array, array_before)

    def test_follows_the_shape_and_its_placement(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        feature = ThickenWorkbench.make_thicken(self.doc, box, 1, faces=["Face6"])
        box.Length = 20
        box.Placement = PLACEMENT
        self.doc.recompute()
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, 200, places=6)
        self.assert_same_place(feature.Placement, PLACEMENT)

    def test_exchanged_shape_recomputes(self):
        part = self.add_shape(Part.makeBox(10, 10, 10))
        feature = ThickenWorkbench.make_thicken(self.doc, part, 1, faces=["Face6"])
        part.Shape = Part.makeBox(10, 30, 10)
        self.doc.recompute()
        self.assertAlmostEqual(feature.Volume.Value, 300, places=6)

    def test_feature_in_a_body(self):
        body = self.doc.addObject("PartDesign::Body", "Body")
        box = self.doc.addObject("PartDesign::AdditiveBox", "Box")
        body.addObject(box)
        body.Placement = PLACEMENT
        self.doc.recompute()
        for source in (body, box):
            feature = ThickenWorkbench.make_thicken(self.doc, source, 1, faces=["Face6"])
            self.assert_solid(feature)
            self.assertIsNone(feature.getParentGeoFeatureGroup())
            placed, wanted = feature.Placement.toMatrix().A, source.getGlobalPlacement().toMatrix().A
            np.testing.assert_allclose(placed, wanted, atol=1e-12)

    def test_saved_choice_is_kept(self):
        box = self.add_shape(Part.makeBox(10, 10, 10), "Box")
        ThickenWorkbench.make_thicken(self.doc, box, 1, faces=["Face6"], deflection=0.3, smooth=2, simplify="off")
        path = self.folder / "part.FCStd"
        self.doc.saveAs(str(path))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(str(path))
        feature = self.doc.getObject("Thicken")
        self.assertEqual(feature.SourceFaces, (self.doc.getObject("Box"), ["Face6"]))
        self.assertEqual((feature.Deflection.Value, feature.Smooth, feature.Simplify), (0.3, 2, "Off"))
        feature.touch()
        self.doc.recompute()
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, 100, places=6)

    def test_face_that_is_gone_is_refused(self):
        box = self.add_shape(Part.makeBox(10, 10, 10))
        feature = ThickenWorkbench.make_thicken(self.doc, box, 1, faces=["Face6"])
        box.Shape = Part.makeSphere(3)
        self.doc.recompute()
        self.assert_refused(feature, "Face6", "the last one is Face1")

    def test_faces_of_an_earlier_source_are_left_aside(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_shape(Part.makeBox(9, 9, 9)), 1, faces=["Face6"])
        feature.Source = self.add_source(plate(size=20))
        self.doc.recompute()
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, 400, places=6)

    def test_shape_without_faces_is_refused(self):
        with self.assertRaises(RefusedError):
            ThickenWorkbench.make_thicken(self.doc, self.add_shape(Part.makeLine((0, 0, 0), (1, 0, 0))), 1)

    def test_face_names(self):
        self.assertEqual(face_names([3, "Face1", "Body.Pad.Face7", "Face1"]), ["Face3", "Face1", "Face7"])
        for wrong in ("Edge1", "Face0", 0, "Face"):
            with self.assertRaises(ValueError):
                face_names([wrong])


class Facets(DocumentCase):
    def setUp(self):
        super().setUp()
        self.surface = plate(size=20, n=11)  # 200 triangles; the first 100 and the last 100 are halves of cells
        self.source = self.add_source(self.surface)
        centres = self.surface[0][self.surface[1]].mean(1)
        self.patch = np.flatnonzero(centres[:, 0] < -6)  # two columns of cells

    def test_patch_is_thickened_and_kept(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.source, 1, facets=self.patch)
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, 4 * 20 * 1, places=6)
        self.assertEqual(feature.OriginalTriangles, len(self.patch))
        vertices, triangles = self.surface
        made, facets = mesh_io.arrays_from_mesh(feature.Mesh)
        self.assertTrue(keeps(made[facets], vertices[triangles[self.patch]]))

    def test_order_and_repetition_do_not_matter(self):
        one = ThickenWorkbench.make_thicken(self.doc, self.source, 1, facets=self.patch)
        other = ThickenWorkbench.make_thicken(self.doc, self.source, 1, facets=[*self.patch[::-1], *self.patch])
        self.assertEqual(one.Facets, other.Facets)
        for a, b in zip(mesh_io.arrays_from_mesh(one.Mesh), mesh_io.arrays_from_mesh(other.Mesh)):
            np.testing.assert_array_equal(a, b)

    def test_patch_is_saved(self):
        ThickenWorkbench.make_thicken(self.doc, self.source, 1, facets=self.patch)
        path = self.folder / "part.FCStd"
        self.doc.saveAs(str(path))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(str(path))
        feature = self.doc.getObject("Thicken")
        self.assertEqual(feature.Facets, self.patch.tolist())
        feature.Thickness = 2
        self.doc.recompute()
        self.assertAlmostEqual(feature.Volume.Value, 160, places=6)

    def test_facets_that_are_gone_are_refused(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.source, 1, facets=[150])
        self.source.Mesh = mesh_io.mesh_from_arrays(*plate(n=5))
        self.doc.recompute()
        self.assert_refused(feature, "Facet 150", "32 facets")

    def test_choices_that_make_no_sense(self):
        for wrong in ({"faces": ["Face1"]}, {"facets": [-1]}):
            with self.assertRaises(ValueError):
                ThickenWorkbench.make_thicken(self.doc, self.source, 1, **wrong)
        self.assertEqual(self.doc.Objects, [self.source])


class Several(DocumentCase):
    def test_a_feature_each(self):
        sources = [self.add_source(plate(size=10)), self.add_source(saddle())]
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        features = ThickenWorkbench.make_thicken(self.doc, [*sources, box], 0.5)
        self.assertEqual([feature.Source for feature in features], [*sources, box])
        for feature in features:
            self.assert_solid(feature)

    def test_all_or_none(self):
        sources = [self.add_source(plate()), self.add_source(saddle())]
        for wrong in ({"side": "up"}, {"facets": [1]}, {"output": "cloud"}, {"smooth": 101}, {"simplify": "much"}):
            with self.assertRaises(ValueError):
                ThickenWorkbench.make_thicken(self.doc, sources, 1, **wrong)
            self.assertEqual(self.doc.Objects, sources)
        with self.assertRaises(RefusedError):
            ThickenWorkbench.make_thicken(self.doc, [*sources, None], 1)
        self.assertEqual(self.doc.Objects, sources)


class Regions(DocumentCase):
    def test_regions_follow_the_counts(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1)
        regions = ThickenWorkbench.facet_regions(feature)
        counts = [feature.OriginalTriangles, feature.ShellTriangles, feature.WallTriangles]
        self.assertEqual(np.bincount(regions).tolist(), counts)
        vertices, triangles = mesh_io.arrays_from_mesh(feature.Mesh)
        self.assertTrue(keeps(vertices[triangles[regions == 0]], saddle()[0][saddle()[1]]))

    def test_refused_feature_has_none(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1)
        feature.Thickness = 0
        self.doc.recompute()
        self.assertEqual(len(ThickenWorkbench.facet_regions(feature)), 0)

    def test_documents_from_before_regions_were_stored(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1)
        stored = ThickenWorkbench.facet_regions(feature)
        feature.removeProperty("RegionRuns")
        np.testing.assert_array_equal(ThickenWorkbench.facet_regions(feature), stored)
