# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part solids of meshes: valid, closed, of the mesh's own triangles, and fast."""

import FreeCAD as App
import MeshPart
import numpy as np
import Part

import ThickenWorkbench
from ThickenWorkbench import mesh_io
from ThickenWorkbench.part_solid import size_warning
from ThickenWorkbench.sources import RefusedError
from bench_part_solid import compare
from thicken_case import DocumentCase
from thicken_surfaces import grid, plate, saddle, together


def box(low, high, inward=False):
    """A closed box of 12 triangles."""
    corners = np.array([[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)], np.float32)
    triangles = np.array([[0, 3, 1], [0, 2, 3], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
                          [2, 7, 3], [2, 6, 7], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]])  # fmt: skip
    return corners, triangles[:, ::-1] if inward else triangles


class FromArrays(DocumentCase):
    def assert_part_solid(self, shape, volume, kind="Solid"):
        self.assertEqual(shape.ShapeType, kind)
        self.assertTrue(shape.isValid())
        self.assertTrue(shape.isClosed())
        self.assertAlmostEqual(shape.Volume, volume, delta=1e-5 * volume)

    def test_vertices_and_edges_are_shared(self):
        vertices, triangles = box((0, 0, 0), (1, 2, 3))
        shape = ThickenWorkbench.part_solid(vertices, triangles)
        self.assert_part_solid(shape, 6)
        self.assertEqual((len(shape.Vertexes), len(shape.Edges), len(shape.Faces)), (8, 18, 12))
        self.assertEqual(len(shape.Shells), 1)

    def test_normals_point_outwards(self):
        shape = ThickenWorkbench.part_solid(*box((0, 0, 0), (2, 2, 2)))
        for face in shape.Faces:
            outwards = face.CenterOfMass - App.Vector(1, 1, 1)
            self.assertGreater(face.normalAt(0, 0).dot(outwards), 0)
        self.assertTrue(shape.isInside(App.Vector(1, 1, 1), 1e-6, False))
        self.assertFalse(shape.isInside(App.Vector(3, 1, 1), 1e-6, False))

    def test_faces_are_the_triangles(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1)
        vertices, triangles = mesh_io.arrays_from_mesh(feature.Mesh)
        shape = ThickenWorkbench.part_solid(vertices, triangles)
        self.assert_part_solid(shape, feature.Volume.Value)
        self.assertAlmostEqual(shape.Area, feature.Area.Value, delta=1e-6 * shape.Area)
        self.assertEqual(len(shape.Faces), len(triangles))
        self.assertEqual(len(shape.Edges), 3 * len(triangles) // 2)

    def test_cavities_and_several_parts(self):
        mesh = together(box((0, 0, 0), (10, 10, 10)), box((2, 2, 2), (8, 8, 8), inward=True))
        shape = ThickenWorkbench.part_solid(*mesh)
        self.assert_part_solid(shape, 1000 - 216)
        self.assertEqual(len(shape.Shells), 2)
        island = together(mesh, box((4, 4, 4), (5, 5, 5)), box((20, 0, 0), (21, 1, 1)))
        shape = ThickenWorkbench.part_solid(*island)
        self.assert_part_solid(shape, 1000 - 216 + 2, "Compound")
        self.assertEqual(sorted(round(solid.Volume, 6) for solid in shape.Solids), [1, 1, 784])

    def test_can_be_used_in_booleans(self):
        shape = ThickenWorkbench.part_solid(*box((0, 0, 0), (10, 10, 10)))
        cut = shape.cut(Part.makeCylinder(2, 20, App.Vector(5, 5, -5)))
        self.assertTrue(cut.isValid())
        self.assertAlmostEqual(cut.Volume, 1000 - 10 * np.pi * 4, places=3)

    def test_what_bounds_no_solid_is_refused(self):
        vertices, triangles = box((0, 0, 0), (1, 1, 1))
        for wrong in (triangles[1:], triangles[:, ::-1], np.vstack([triangles, triangles[:1]])):
            with self.assertRaisesRegex(RefusedError, "bounds no solid"):
                ThickenWorkbench.part_solid(vertices, wrong)

    def test_warning_before_a_large_one(self):
        self.assertEqual(size_warning(1000), "")
        self.assertRegex(size_warning(2_000_000), r"takes about \d+ s")


class Merged(DocumentCase):
    def merged(self, vertices, triangles, counts):
        shape = ThickenWorkbench.part_solid(vertices, triangles, merge_coplanar=True)
        plain = ThickenWorkbench.part_solid(vertices, triangles)
        self.assertTrue(shape.isValid())
        self.assertTrue(shape.isClosed())
        self.assertAlmostEqual(shape.Volume, plain.Volume, delta=1e-6 * plain.Volume)
        self.assertEqual((len(shape.Vertexes), len(shape.Edges), len(shape.Faces)), counts)
        return shape

    def test_box(self):
        self.merged(*box((0, 0, 0), (1, 2, 3)), (8, 12, 6))

    def test_plate_of_many_triangles(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(plate(n=21)), 2)
        self.merged(*mesh_io.arrays_from_mesh(feature.Mesh), (8, 12, 6))

    def test_faces_with_holes(self):
        shape = Part.makeBox(20, 20, 5).cut(Part.makeBox(4, 4, 9, App.Vector(3, 3, -2)))
        shape = shape.cut(Part.makeBox(4, 4, 9, App.Vector(12, 12, -2)))
        mesh = MeshPart.meshFromShape(Shape=shape, LinearDeflection=0.1)
        merged = self.merged(*mesh_io.arrays_from_mesh(mesh), (24, 36, 14))
        self.assertEqual(sorted(len(face.Wires) for face in merged.Faces), [1] * 12 + [3, 3])

    def test_slanted_planes_of_rounded_points(self):
        shape = Part.makeBox(20, 30, 5).cut(Part.makeBox(4, 4, 9, App.Vector(3, 3, -2)))
        shape.Placement = App.Placement(App.Vector(100, 2, 3), App.Rotation(10, 20, 30))
        mesh = MeshPart.meshFromShape(Shape=shape, LinearDeflection=0.1)
        self.merged(*mesh_io.arrays_from_mesh(mesh), (16, 24, 10))

    def test_curved_parts_stay_triangles(self):
        roof = grid(lambda x, y: np.where(x > 0, x * x / 40, 0), n=21)
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(roof), 1)
        vertices, triangles = mesh_io.arrays_from_mesh(feature.Mesh)
        shape = ThickenWorkbench.part_solid(vertices, triangles, merge_coplanar=True)
        self.assertTrue(shape.isValid())
        self.assertLess(len(shape.Faces), 0.5 * len(triangles))
        self.assertAlmostEqual(shape.Volume, feature.Volume.Value, delta=1e-5 * feature.Volume.Value)


class Feature(DocumentCase):
    def test_solid_output(self):
        source = self.add_source(plate(size=20))
        feature = ThickenWorkbench.make_thicken(self.doc, source, 2, output="solid")
        self.assert_solid(feature)
        solid = ThickenWorkbench.part_solid_of(feature)
        self.assertEqual(solid.TypeId, "Part::FeaturePython")
        self.assertTrue(solid.isValid())
        self.assertAlmostEqual(solid.Shape.Volume, 800, places=6)
        self.assertIsNone(ThickenWorkbench.part_solid_of(source))

    def test_follows_its_source(self):
        source = self.add_source(plate(size=20))
        source.Placement = App.Placement(App.Vector(5, 0, 0), App.Rotation(App.Vector(1, 0, 0), 45))
        feature = ThickenWorkbench.make_thicken(self.doc, source, 2)
        solid = ThickenWorkbench.make_part_solid(self.doc, feature, merge_coplanar=True)
        feature.Thickness = 3
        self.doc.recompute()
        self.assertAlmostEqual(solid.Shape.Volume, 1200, places=6)
        self.assertEqual(len(solid.Shape.Faces), 6)
        np.testing.assert_allclose(solid.Placement.toMatrix().A, source.Placement.toMatrix().A, atol=1e-12)
        solid.MergeCoplanar = False
        self.doc.recompute()
        self.assertEqual(len(solid.Shape.Faces), feature.TriangleCount)

    def test_refused_source_leaves_no_stale_solid(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(plate()), 2, output="solid")
        solid = ThickenWorkbench.part_solid_of(feature)
        feature.Thickness = 0
        self.doc.recompute()
        self.assertTrue(solid.Shape.isNull() or not solid.Shape.Faces)
        feature.Thickness = 1
        self.doc.recompute()
        self.assertTrue(solid.isValid())
        self.assertTrue(solid.Shape.isClosed())

    def test_open_mesh_is_refused(self):
        solid = ThickenWorkbench.make_part_solid(self.doc, self.add_source(plate()))
        self.assertIn("Invalid", solid.State)
        self.assertIn("bounds no solid", solid.getStatusString())
        with self.assertRaises(RefusedError):
            ThickenWorkbench.make_part_solid(self.doc, None)

    def test_document_is_saved(self):
        ThickenWorkbench.make_thicken(self.doc, self.add_source(plate(size=20)), 2, output="solid")
        path = self.folder / "part.FCStd"
        self.doc.saveAs(str(path))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(str(path))
        solid = ThickenWorkbench.part_solid_of(self.doc.getObject("Thicken"))
        self.assertAlmostEqual(solid.Shape.Volume, 800, places=6)
        self.doc.getObject("Thicken").Thickness = 1
        self.doc.recompute()
        self.assertAlmostEqual(solid.Shape.Volume, 400, places=6)


class Benchmark(DocumentCase):
    def test_it_compares_the_same_solid(self):
        """compare() throws where sewing makes another volume. How much faster we are is for the benchmark to tell."""
        self.assertGreater(compare(facets=1000)[0], 1000)
