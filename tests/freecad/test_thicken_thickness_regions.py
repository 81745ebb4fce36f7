# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions of facets with a thickness of their own: of a feature, by macros, when the source changes."""

import FreeCAD as App
import numpy as np
import Part

import ThickenWorkbench
from ThickenWorkbench import mesh_io
from ThickenWorkbench.core.found_again import found_again
from thicken_case import DocumentCase
from thicken_surfaces import crossing_plates, grid, plate, saddle, together


def moved(surface, by):
    return surface[0] + np.float32(by), surface[1]


class RegionsCase(DocumentCase):
    def thickened(self, surface=None, thickness=1.0, **options):
        self.source = self.add_source(surface or plate(n=41))
        return ThickenWorkbench.make_thicken(self.doc, self.source, thickness, **options)

    def below(self, x, surface=None):
        """The facets with a middle where x is less."""
        vertices, triangles = surface or mesh_io.arrays_from_mesh(self.source.Mesh)
        return np.flatnonzero(vertices[triangles][:, :, 0].mean(axis=1) < x)

    def painted(self, feature, regions, transition=None):
        ThickenWorkbench.set_thickness_regions(feature, regions, transition)
        self.doc.recompute()
        return feature


class ThicknessRegions(RegionsCase):
    def test_the_volume_is_that_of_the_formula(self):
        feature = self.painted(self.thickened(), [(self.below(-5), "3 mm")], "4 mm")
        self.assert_solid(feature)
        # 5 mm of 3 mm, 4 mm of 2 mm in the mean, 11 mm of 1 mm, all of them 20 mm long
        self.assertAlmostEqual(feature.Volume.Value, 20 * (5 * 3 + 4 * 2 + 11 * 1), delta=2)
        self.assertEqual(feature.Warnings, [])
        self.assertEqual(ThickenWorkbench.thickness_regions(feature), [(self.below(-5).tolist(), 3.0)])

    def test_thinner_ones_and_drafts_and_both_sides(self):
        for options in ({"quality": "draft"}, {"side": "both"}, {"side": "positive"}):
            with self.subTest(options):
                feature = self.painted(self.thickened(saddle(), 2, **options), [(self.below(-3), 0.9)], 4)
                self.assert_solid(feature)
                self.painted(feature, [])
                self.assert_solid(feature)

    def test_of_a_surface_that_is_repaired_first_and_with_a_gap(self):
        feature = self.thickened(crossing_plates(), repair=True)
        before = feature.Volume.Value
        near = ThickenWorkbench.facets_near(feature, [(6, 6, 0)], 2)
        self.painted(feature, [(near, 2)], 2)
        self.assert_solid(feature)
        self.assertGreater(feature.Volume.Value, before + 10)
        spaced = self.painted(self.thickened(gap=0.5), [(self.below(-5), "3 mm")], "4 mm")
        self.assert_solid(spaced)
        self.assertAlmostEqual(spaced.Volume.Value, 20 * (5 * 3 + 4 * 2 + 11 * 1), delta=2)

    def test_nothing_is_computed_for_the_same_regions(self):
        feature = self.painted(self.thickened(), [(self.below(-5), 3)], 4)
        before = feature.ComputedFor
        feature.touch()
        self.doc.recompute()
        self.assertEqual(feature.ComputedFor, before)
        feature.RegionThickness = [2.5]
        self.doc.recompute()
        self.assertNotEqual(feature.ComputedFor, before)
        self.assertAlmostEqual(feature.Volume.Value, 20 * (5 * 2.5 + 4 * 1.75 + 11), delta=2)

    def test_two_regions_and_where_they_overlap(self):
        feature = self.thickened()
        self.painted(feature, [(self.below(-5), 3), (np.arange(3200)[~np.isin(np.arange(3200), self.below(5))], 2)], 2)
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, 20 * (5 * 3 + 2 * 2 + 6 * 1 + 2 * 1.5 + 5 * 2), delta=2)

    def test_deviation_is_from_the_thickness_of_the_place(self):
        feature = self.painted(self.thickened(), [(self.below(-5), 3)], 4)
        found = ThickenWorkbench.thickness_map(feature, "deviation")
        self.assertLess(max(abs(found.percentiles[1]), abs(found.percentiles[99])), 0.15)
        self.assertLess(abs(found.percentiles[50]), 1e-4)

    def test_saved_reopened_and_copied(self):
        volume = self.painted(self.thickened(), [(self.below(-5), 3)], 4).Volume.Value
        path = self.folder / "part.FCStd"
        self.doc.saveAs(str(path))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(str(path))
        feature = self.doc.getObject("Thicken")
        feature.ComputedFor = ""
        feature.touch()
        self.doc.recompute()
        self.assertAlmostEqual(feature.Volume.Value, volume, places=6)
        copy = self.doc.copyObject(feature, False)
        copy.RegionThickness = [2.0]
        self.doc.recompute()
        self.assert_solid(copy)
        self.assertLess(copy.Volume.Value, volume)

    def test_of_a_part_of_a_mesh_and_of_a_shape(self):
        # each half of the triangles of a plate's squares
        feature = self.thickened(facets=[*range(100, 1600), *range(1700, 3200)])
        with self.assertRaisesRegex(ValueError, "facet 5 "):
            ThickenWorkbench.set_thickness_regions(feature, [([200, 5], 2)])
        self.painted(feature, [([*range(200, 300), *range(1800, 1900)], 2)], 1)
        self.assert_solid(feature)
        self.assertEqual(ThickenWorkbench.thickness_regions(feature)[0].facets, [*range(200, 300), *range(1800, 1900)])
        box = self.doc.addObject("Part::Feature", "Bowl")
        box.Shape = Part.makeSphere(20, App.Vector(), App.Vector(0, 0, 1), -90, 0)
        skin = ThickenWorkbench.make_thicken(self.doc, box, 1, faces=["Face1"])
        before = skin.Volume.Value
        near = ThickenWorkbench.facets_near(skin, [(0, 0, -20)], 8)
        self.painted(skin, [(near, 2)], 3)
        self.assert_solid(skin)
        self.assertGreater(skin.Volume.Value, before + 150)

    def test_a_brush_follows_the_surface_and_the_placement(self):
        sheets = together(plate(n=41), moved(plate(n=41), (0, 0, 1)))
        feature = self.thickened(sheets, 0.3)
        self.source.Placement = App.Placement(App.Vector(10, 2, 3), App.Rotation(App.Vector(1, 0, 1), 70))
        self.doc.recompute()
        place = self.source.Placement.multVec(App.Vector(1, 1, 1.1))
        near = ThickenWorkbench.facets_near(feature, [place], 3)
        middles = sheets[0][sheets[1]].mean(axis=1)
        self.assertTrue((np.array(near) >= 3200).all(), "the other sheet is 1 mm away, and the brush has 3 mm")
        expected = 3200 + np.flatnonzero(np.linalg.norm(middles[3200:] - [1, 1, 1.1], axis=1) <= 3)
        self.assertEqual(near, expected.tolist())
        self.assertEqual(len(ThickenWorkbench.facets_near(feature, [place], 1e-3)), 1, "the one below the brush")
        self.assertEqual(ThickenWorkbench.facets_near(feature, [], 3), [])

    def test_what_makes_no_sense_is_refused(self):
        feature = self.painted(self.thickened(), [(self.below(-5), 3)], 4)
        for regions, transition in (
            ([([], 2)], None), ([([3], 0)], None), ([([3], "2 kg")], None), ([([3], "thick")], None),
            ([([99999], 2)], None), ([([-1], 2)], None), ([([3], 2)], -1), ([([3], 2)], "1 s"), ([([3], float("nan"))], None),
        ):  # fmt: skip
            with self.subTest(f"{regions}, {transition}"), self.assertRaises(ValueError):
                ThickenWorkbench.set_thickness_regions(feature, regions, transition)
        with self.assertRaises(ValueError):
            ThickenWorkbench.set_thickness_regions(self.source, [])
        self.assertEqual(list(feature.RegionThickness), [3.0])
        self.assertEqual(feature.Transition.Value, 4)

    def test_edited_properties_that_do_not_fit_are_refused(self):
        feature = self.painted(self.thickened(), [(self.below(-5), 3)], 4)
        for lengths, word in (([3, 2], "RegionThickness has 2"), ([], "RegionThickness has 0"), ([0], "0 mm"), ([-1], "-1 mm")):
            feature.RegionThickness = lengths
            self.doc.recompute()
            self.assert_refused(feature, word)
        feature.RegionThickness = [3]
        self.doc.recompute()
        self.assert_solid(feature)


class Changed(RegionsCase):
    """What becomes of regions when the surface does."""

    def change(self, feature, surface):
        self.source.Mesh = mesh_io.mesh_from_arrays(*surface)
        self.doc.recompute()
        return feature

    def test_other_numbers_of_the_same_facets(self):
        feature = self.painted(self.thickened(), [(self.below(-5), 3)], 4)
        volume = feature.Volume.Value
        vertices, triangles = plate(n=41)
        order = np.random.default_rng(3).permutation(len(triangles))
        self.change(feature, (vertices, np.roll(triangles, 1, axis=1)[order]))
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, volume, places=4)
        self.assertEqual(feature.Warnings, [])

    def test_a_finer_mesh_and_another_scan(self):
        feature = self.painted(self.thickened(), [(self.below(-5), 3)], 4)
        volume = feature.Volume.Value
        self.change(feature, plate(n=121))
        self.assertAlmostEqual(feature.Volume.Value, volume, delta=0.02 * volume)
        self.change(feature, moved(plate(n=73), (0, 0, 0.2)))
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, volume, delta=0.03 * volume)
        self.assertEqual(feature.Warnings, [])

    def test_a_trim_takes_a_part_of_a_region(self):
        scan = self.add_source(plate(n=41))
        loop = [(-7, -9, 0), (9, -9, 0), (9, 9, 0), (-7, 9, 0)]
        part = ThickenWorkbench.make_trim(self.doc, scan, loop)
        feature = ThickenWorkbench.make_thicken(self.doc, part, 1)
        self.source = part
        self.painted(feature, [(self.below(-3), 3)], 2)
        self.assertEqual(feature.Warnings, [])
        part.Points = [App.Vector(*point) for point in [(-5.3, -9, 0), *loop[1:3], (-5.3, 9, 0)]]
        self.doc.recompute()
        self.assert_solid(feature)
        self.assertIn("Only 58 % of thickness region 1 (3 mm) is on the surface, which has changed.", feature.Warnings)
        self.assertAlmostEqual(feature.Volume.Value, 18 * (2.3 * 3 + 2 * 2 + 10), delta=3)
        part.Points = [App.Vector(*point) for point in [(-3.3, -9, 0), *loop[1:3], (-3.3, 9, 0)]]
        self.doc.recompute()
        self.assert_refused(feature, "thickness region 1 (3 mm)", "Paint the region again")

    def test_another_surface_is_refused_and_mended(self):
        feature = self.painted(self.thickened(), [(self.below(-5), 3)], 4)
        self.change(feature, moved(plate(n=41), (0, 0, 9)))
        self.assert_refused(feature, "Only 0 % of thickness region 1")
        vertices, triangles = plate(n=41)
        self.change(feature, (vertices, triangles[:, ::-1]))
        self.assert_solid(feature)  # turned over, but the same facets
        self.painted(self.change(feature, grid(lambda x, y: 9 + 0 * x)), [])
        self.assert_solid(feature)

    def test_facets_that_face_the_other_way_are_not_taken_for_chosen_ones(self):
        vertices, triangles = plate(n=11)
        other = together((vertices + np.float32([0, 0, 0.3]), triangles[:, ::-1]), (vertices + np.float32([0, 0, 0.2]), triangles))
        found = found_again(vertices[triangles[:50]], *other)
        self.assertEqual(found.facets.tolist(), list(range(200, 250)))
        self.assertAlmostEqual(found.share, 1)
