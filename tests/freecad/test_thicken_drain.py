# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drain holes and their plugs."""

import math

import FreeCAD as App
import numpy as np
import Part

import ThickenWorkbench
from ThickenWorkbench import drain_holes, mesh_io
from ThickenWorkbench.sources import RefusedError
from thicken_case import DocumentCase
from thicken_judge import is_closed_and_oriented
from thicken_surfaces import plate, together
from test_thicken_part_solid import box


def prism(diameter: float, sides: int = drain_holes.SIDES) -> float:
    """The area of the cross-section of a hole."""
    return sides * diameter**2 / 4 * math.tan(math.pi / sides)


class HollowBox(DocumentCase):
    """A box of 20 mm with a cavity of 16 mm."""

    def setUp(self):
        super().setUp()
        self.solid = self.add_source(together(box((0, 0, 0), (20, 20, 20)), box((2, 2, 2), (18, 18, 18), inward=True)))
        self.volume = 20**3 - 16**3

    def drill(self, *args, **arguments):
        return ThickenWorkbench.make_drain_holes(self.doc, self.solid, *args, **arguments)

    def assert_drilled(self, feature, volume, delta=1e-3):
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertTrue(feature.Valid)
        vertices, triangles = mesh_io.arrays_from_mesh(feature.Mesh)
        self.assertTrue(is_closed_and_oriented(vertices[triangles]))
        self.assertAlmostEqual(feature.Volume.Value, volume, delta=delta)

    def test_hole_in_the_middle_of_the_floor(self):
        feature = self.drill(3)
        self.assert_drilled(feature, self.volume - 2 * prism(3))
        self.assertEqual((feature.HoleCount, feature.Trapped), (1, 0))
        (place,), (axis,) = feature.HolePlaces, feature.HoleAxes
        self.assertTrue(place.isEqual(App.Vector(10, 10, 2), 0.1))
        self.assertTrue(axis.isEqual(App.Vector(0, 0, -1), 1e-9))
        self.assertAlmostEqual(feature.HoleLengths[0], 2, places=6)

    def test_direction(self):
        feature = self.drill("2.5 mm", direction=(-3, 0, 0))
        self.assert_drilled(feature, self.volume - 2 * prism(2.5))
        self.assertTrue(feature.HolePlaces[0].isEqual(App.Vector(18, 10, 10), 0.1))

    def test_direction_is_global(self):
        self.solid.Placement = App.Placement(App.Vector(5, 0, 0), App.Rotation(App.Vector(0, 1, 0), 90))
        feature = self.drill(3)
        self.assert_drilled(feature, self.volume - 2 * prism(3))
        self.assert_same_place(feature.Placement, self.solid.Placement)
        down = self.solid.Placement.Rotation.multVec(feature.HoleAxes[0])
        self.assertTrue(down.isEqual(App.Vector(0, 0, -1), 1e-9))

    def test_several_holes(self):
        feature = self.drill(2, count=3)
        self.assert_drilled(feature, self.volume - 3 * 2 * prism(2))
        places = feature.HolePlaces
        for i in range(3):
            for other in places[:i]:
                self.assertGreater(places[i].distanceToPoint(other), 3)

    def test_places(self):
        feature = self.drill(2, places=[(10, 10, 20), (20, 5, 15)])
        self.assert_drilled(feature, self.volume - 2 * 2 * prism(2))
        self.assertTrue(feature.HoleAxes[0].isEqual(App.Vector(0, 0, -1), 1e-9))
        self.assertTrue(feature.HoleAxes[1].isEqual(App.Vector(-1, 0, 0), 1e-9))

    def test_what_stays_below_a_place_is_told(self):
        feature = self.drill(3, places=[(10, 0, 10)])  # into a side: a cavity of 16 mm from z = 2 on
        self.assertEqual(feature.HoleCount, 1)
        self.assertRegex(" ".join(feature.Warnings), r"6\.5 mm of resin, about 1\.66 mL, stay below")
        facts = ThickenWorkbench.printability(feature)
        (pool,) = facts["pools"]
        self.assertAlmostEqual(pool["depth_mm"], 6.5, delta=0.01)
        self.assertAlmostEqual(pool["volume_ml"], 16 * 16 * 6.5 / 1000, delta=0.003)
        self.assertAlmostEqual(pool["lowest_place_mm"][2], 2, places=5)
        self.assertFalse(facts["printable"])
        self.assertRegex(" ".join(facts["warnings"]), "1.66 mL of resin stay")
        self.assertEqual(ThickenWorkbench.printability(feature, direction=(0, 1, 0))["pools"], [])

    def test_edges_of_holes_are_no_thin_walls(self):
        feature = self.drill(3, places=[(10, 0, 4)])
        walls = ThickenWorkbench.thickness_map(feature)
        self.assertAlmostEqual(walls.minimum, 2, places=4)

    def test_regions_stay(self):
        from ThickenWorkbench.regions import facet_regions

        feature = self.drill(3)
        regions = facet_regions(feature)
        self.assertEqual(len(regions), feature.Mesh.CountFacets)
        self.assertEqual(set(regions), {0, 2})
        vertices, triangles = mesh_io.arrays_from_mesh(feature.Mesh)
        middles = vertices[triangles].mean(axis=1)
        within = np.hypot(middles[:, 0] - 10, middles[:, 1] - 10) < 1.6
        np.testing.assert_array_equal(regions == 2, within & (middles[:, 2] > 0.01) & (middles[:, 2] < 1.99))

    def test_places_are_global_and_follow_the_solid(self):
        self.solid.Placement = App.Placement(App.Vector(100, 0, 0), App.Rotation())
        feature = self.drill(2, places=[(110, 10, 20)])
        self.assert_drilled(feature, self.volume - 2 * prism(2))
        self.solid.Placement = App.Placement()
        self.doc.recompute()
        self.assert_drilled(feature, self.volume - 2 * prism(2))
        self.assertTrue(feature.HolePlaces[0].isEqual(App.Vector(10, 10, 20), 0.1))

    def test_changes_recompute(self):
        feature = self.drill(2)
        feature.Diameter = 4
        self.doc.recompute()
        self.assert_drilled(feature, self.volume - 2 * prism(4))
        self.solid.Mesh = mesh_io.mesh_from_arrays(
            *together(box((0, 0, 0), (20, 20, 20)), box((3, 3, 3), (17, 17, 17), inward=True))
        )
        self.doc.recompute()
        self.assert_drilled(feature, 20**3 - 14**3 - 3 * prism(4))

    def test_refusals(self):
        for arguments, words in (
            ({"diameter": 25}, "smaller diameter"),
            ({"diameter": 3, "places": [(0.5, 0.5, 20)]}, "cannot be drilled"),
        ):
            feature = self.drill(**arguments)
            self.assertFalse(feature.isValid())
            self.assertIn(words, feature.getStatusString())
            self.assertEqual((feature.Mesh.CountFacets, feature.Valid, feature.HoleCount), (0, False, 0))
            self.doc.removeObject(feature.Name)

    def test_refused_solid_leaves_no_stale_holes(self):
        surface = together(box((0, 0, 0), (20, 20, 20)), box((2, 2, 2), (18, 18, 18), inward=True))
        mended = ThickenWorkbench.make_repair(self.doc, self.add_source(surface, "Broken"))
        feature = ThickenWorkbench.make_drain_holes(self.doc, mended, 3, plug=True)
        plugs = self.doc.getObject("Plugs")
        self.assertTrue(plugs.Valid)
        flat = np.float32([[0, 0, 0], [1, 0, 0], [2, 0, 0]]), [[0, 1, 2]]
        self.doc.getObject("Broken").Mesh = mesh_io.mesh_from_arrays(*flat)
        self.doc.recompute()
        for obj in (feature, plugs):
            self.assertEqual((obj.Mesh.CountFacets, obj.Valid), (0, False))
        self.doc.getObject("Broken").Mesh = mesh_io.mesh_from_arrays(*surface)
        self.doc.recompute()
        self.assertTrue(feature.Valid and plugs.Valid)

    def test_solid_without_a_cavity(self):
        block = self.add_source(box((0, 0, 0), (9, 9, 9)), "Block")
        feature = ThickenWorkbench.make_drain_holes(self.doc, block, 3)
        self.assertIn("no cavity", feature.getStatusString())
        through = ThickenWorkbench.make_drain_holes(self.doc, block, 3, places=[(4.5, 4.5, 9)])
        self.assert_drilled(through, 9**3 - 9 * prism(3))

    def test_open_mesh(self):
        feature = ThickenWorkbench.make_drain_holes(self.doc, self.add_source(plate(), "Plate"), 3)
        self.assertIn("no valid solid", feature.getStatusString())

    def test_arguments_that_make_no_sense(self):
        for wrong in ({"diameter": 0}, {"diameter": "1 kg"}, {"count": 0}, {"direction": (0, 0, 0)},
                      {"plug": True, "clearance": -1}):  # fmt: skip
            with self.assertRaises(ValueError):
                self.drill(**{"diameter": 3, **wrong})
        with self.assertRaises(RefusedError):
            ThickenWorkbench.make_drain_holes(self.doc, None, 3)
        self.assertEqual(self.doc.Objects, [self.solid])

    def test_plug_fits_its_hole(self):
        feature = self.drill(3, plug=True, clearance=0.2)
        plugs = self.doc.getObject("Plugs")
        self.assertTrue(plugs.isValid(), plugs.getStatusString())
        self.assertTrue(plugs.Mesh.isSolid())
        self.assertAlmostEqual(plugs.Mesh.Volume, 2 * prism(3 - 2 * 0.2), delta=1e-3)
        hole = Part.makeCylinder(1.5, 2, feature.HolePlaces[0], feature.HoleAxes[0])
        for point in plugs.Mesh.Points:
            self.assertTrue(hole.isInside(App.Vector(point.x, point.y, point.z), 1e-4, True))
        plugs.Clearance = 2
        self.doc.recompute()
        self.assertIn("Clearance", plugs.getStatusString())
        self.assertEqual(plugs.Mesh.CountFacets, 0)

    def test_saved_and_reopened(self):
        self.drill(3, plug=True, count=2)
        path = self.folder / "part.FCStd"
        self.doc.saveAs(str(path))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(str(path))
        feature, plugs = self.doc.getObject("DrainHoles"), self.doc.getObject("Plugs")
        self.assertEqual((feature.Diameter.Value, feature.Count, feature.HoleCount), (3, 2, 2))
        before = [array.tobytes() for array in mesh_io.arrays_from_mesh(feature.Mesh)]
        feature.touch()
        self.doc.recompute()
        self.assertEqual([array.tobytes() for array in mesh_io.arrays_from_mesh(feature.Mesh)], before)
        self.assertTrue(plugs.isValid())


class SeveralCavities(DocumentCase):
    def test_each_gets_its_hole(self):
        solid = together(
            box((0, 0, 0), (40, 20, 20)),
            box((2, 2, 2), (18, 18, 18), inward=True),
            box((22, 2, 5), (38, 18, 18), inward=True),
        )
        feature = ThickenWorkbench.make_drain_holes(self.doc, self.add_source(solid), 2)
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertEqual((feature.HoleCount, feature.Trapped), (2, 0))
        self.assertEqual(sorted(round(length) for length in feature.HoleLengths), [2, 5])

    def test_what_stays_closed_is_named(self):
        solid = together(
            box((0, 0, 0), (40, 20, 20)),
            box((2, 2, 2), (18, 18, 18), inward=True),
            box((25, 5, 9), (26, 6, 10), inward=True),
        )
        feature = ThickenWorkbench.make_drain_holes(self.doc, self.add_source(solid), 4)
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertEqual((feature.HoleCount, feature.Trapped), (1, 1))
        self.assertRegex(" ".join(feature.Warnings), r"stay closed: 1, of 0\.001 mL")


class HollowSphere(DocumentCase):
    def test_through_curved_walls(self):
        sphere = self.doc.addObject("Part::Feature", "Sphere")
        sphere.Shape = Part.makeSphere(15)
        hollow = ThickenWorkbench.make_thicken(self.doc, sphere, 2, deflection=0.05)
        feature = ThickenWorkbench.make_drain_holes(self.doc, hollow, 4)
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertEqual(feature.Trapped, 0)
        self.assertLess(feature.HolePlaces[0].z, -12.7)  # the lowest place of a cavity of 13 mm
        removed = hollow.Volume.Value - feature.Volume.Value
        self.assertAlmostEqual(removed, 2 * prism(4), delta=0.5)
