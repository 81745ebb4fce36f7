# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thickness map and the check of a surface."""

import FreeCAD as App
import numpy as np

import ThickenWorkbench
from ThickenWorkbench import mesh_io
from ThickenWorkbench.sources import RefusedError
from thicken_case import DocumentCase
from thicken_surfaces import crossing_plates, fin, grid, plate, saddle, together

PLACEMENT = App.Placement(App.Vector(10, -20, 30), App.Rotation(App.Vector(1, 1, 0), 70))


class WallMap(DocumentCase):
    def test_plate_is_as_thick_everywhere(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(plate()), 2)
        found = ThickenWorkbench.thickness_map(feature)
        known = ~np.isnan(found.facet_values)
        self.assertEqual(int(known.sum()), feature.OriginalTriangles + feature.ShellTriangles)
        for number in (found.minimum, found.maximum, found.mean, *found.percentiles.values()):
            self.assertAlmostEqual(number, 2, places=6)
        self.assertAlmostEqual(found.histogram.shares.sum(), 1, places=9)
        self.assertEqual(len(found.histogram.edges), len(found.histogram.shares) + 1)

    def test_thinner_place_is_found_in_global_coordinates(self):
        below = plate()[0] + [[0, 0, -1.5]], plate()[1]
        source = self.add_source(together(saddle(), (below[0].astype("f4") + np.float32([50, 0, 0]), below[1])))
        wedge = grid(lambda x, y: 0 * x, n=9)
        solid = self.doc.addObject("Mesh::Feature", "Wedge")
        solid.Mesh = mesh_io.mesh_from_arrays(*self.wedge(wedge))
        solid.Placement = PLACEMENT
        found = ThickenWorkbench.thickness_map(solid)
        place = PLACEMENT.inverse().multVec(found.minimum_place)
        self.assertLess(place.x, -7)  # the thin end
        self.assertLess(found.minimum, 1.4)
        self.assertGreater(found.mean, 1.8)
        self.assertIsNotNone(source)

    @staticmethod
    def wedge(surface):
        """A closed solid between a plate and a slanted copy, 1 mm thick at one end and 3 mm at the other."""
        vertices, triangles = surface
        lower = vertices - np.column_stack([0 * vertices[:, 0], 0 * vertices[:, 0], 2 + vertices[:, 0] / 10])
        count = len(vertices)
        edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
        backwards = {(b, a) for a, b in edges.tolist()}
        rim = [edge for edge in edges.tolist() if tuple(edge) not in backwards]
        walls = [t for a, b in rim for t in ([b, a, count + a], [b, count + a, count + b])]
        every = np.vstack([triangles, triangles[:, ::-1] + count, walls])
        return np.vstack([vertices, lower]).astype(np.float32), every

    def test_values_at_points_are_those_around(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1)
        found = ThickenWorkbench.thickness_map(feature)
        points, facets = mesh_io.arrays_from_mesh(feature.Mesh)
        self.assertEqual((len(found.facet_values), len(found.vertex_values)), (len(facets), len(points)))
        around = found.facet_values[(facets == 100).any(axis=1)]
        self.assertGreaterEqual(found.vertex_values[100], np.nanmin(around))
        self.assertLessEqual(found.vertex_values[100], np.nanmax(around))

    def test_what_has_no_walls_is_refused(self):
        with self.assertRaisesRegex(RefusedError, "not closed"):
            ThickenWorkbench.thickness_map(self.add_source(plate()))
        with self.assertRaises(ValueError):
            ThickenWorkbench.thickness_map(self.add_source(plate()), "colour")
        with self.assertRaises(RefusedError):
            ThickenWorkbench.thickness_map(self.doc.addObject("Mesh::Feature", "Empty"))


class DeviationMap(DocumentCase):
    def test_agrees_with_the_report(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1.5)
        found = ThickenWorkbench.thickness_map(feature, "deviation")
        self.assertAlmostEqual(np.nanmean(np.abs(found.facet_values)), 1.5 * feature.ShellErrorMean, delta=2e-3)
        self.assertLessEqual(np.nanmax(np.abs(found.facet_values)), 1.5 * feature.ShellErrorMax + 1e-6)
        regions = ThickenWorkbench.facet_regions(feature)
        self.assertTrue(np.isnan(found.facet_values[regions != 1]).all())

    def test_a_gap_is_no_deviation(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1.5, gap=0.7)
        found = ThickenWorkbench.thickness_map(feature, "deviation")
        self.assertLess(abs(found.mean), 0.02)

    def test_too_thin_places_are_negative(self):
        below = plate()[0] + [[0, 0, -1.5]], plate()[1]
        source = self.add_source(together(plate(), (below[0].astype("f4"), below[1])))
        feature = ThickenWorkbench.make_thicken(self.doc, source, 1)
        found = ThickenWorkbench.thickness_map(feature, "deviation")
        self.assertLess(found.minimum, -0.2)

    def test_needs_a_thicken_feature(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(plate()), 1)
        copy = self.add_source(mesh_io.arrays_from_mesh(feature.Mesh), "Copy")
        with self.assertRaisesRegex(RefusedError, "no Thicken feature"):
            ThickenWorkbench.thickness_map(copy, "deviation")


class Check(DocumentCase):
    def test_good_surface_has_no_defects(self):
        self.assertEqual(ThickenWorkbench.check_surface(self.add_source(saddle())), [])
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        self.assertEqual(ThickenWorkbench.check_surface(box, faces=["Face1"]), [])

    def test_places_are_global(self):
        source = self.add_source(crossing_plates())
        source.Placement = PLACEMENT
        (defect,) = ThickenWorkbench.check_surface(source)
        self.assertEqual(defect.code, "self-intersecting")
        local = PLACEMENT.inverse().multVec(defect.place)
        self.assertLess(abs(local.x), 1)  # they cross along the y axis
        self.assertLess(abs(local.z), 1)
        self.assertEqual(len(defect.facets), 2 * defect.count)
        self.assertEqual(defect.triangles.shape, (len(defect.facets), 3, 3))
        vertices, triangles = crossing_plates()
        for facet, corners in zip(defect.facets, defect.triangles):
            for index, corner in zip(triangles[facet], corners):
                placed = PLACEMENT.multVec(App.Vector(*vertices[index].tolist()))
                self.assertTrue(placed.isEqual(App.Vector(*corner), 1e-9))

    def test_every_kind_is_listed(self):
        shifted = crossing_plates()[0] + np.array([100, 0, 0], np.float32), crossing_plates()[1]
        defects = ThickenWorkbench.check_surface(self.add_source(together(fin(), shifted)))
        self.assertEqual({defect.code for defect in defects} & {"not-manifold", "self-intersecting"},
                         {"not-manifold", "self-intersecting"})  # fmt: skip
        manifold = next(defect for defect in defects if defect.code == "not-manifold")
        self.assertEqual(manifold.edges.shape, (1, 2, 3))
        self.assertRegex(manifold.sentence, r"^[A-Z].*\.$")

    def test_only_what_is_chosen_is_checked(self):
        source = self.add_source(crossing_plates())
        self.assertEqual(ThickenWorkbench.check_surface(source, facets=range(200)), [])
        defects = ThickenWorkbench.check_surface(source, facets=range(20, 592))
        defect = next(defect for defect in defects if defect.code == "self-intersecting")
        self.assertGreaterEqual(min(defect.facets), 20)  # numbers of the whole mesh

    def test_nothing_to_check(self):
        with self.assertRaises(RefusedError):
            ThickenWorkbench.check_surface(None)
