# SPDX-License-Identifier: LGPL-2.1-or-later
"""The feature that cuts a part out of a surface."""

import FreeCAD as App
import numpy as np
import Part

import ThickenWorkbench
from ThickenWorkbench import mesh_io
from ThickenWorkbench.sources import RefusedError
from thicken_case import DocumentCase
from thicken_surfaces import plate, saddle

SQUARE = [(-4.3, -4.1, 0), (5.2, -4.4, 0), (5.1, 4.7, 0), (-4.6, 4.9, 0)]


class Trim(DocumentCase):
    def trimmed(self, *arguments, **options):
        feature = ThickenWorkbench.make_trim(self.doc, *arguments, **options)
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertTrue(feature.Valid)
        self.assertEqual(feature.TriangleCount, feature.Mesh.CountFacets)
        self.assertEqual(ThickenWorkbench.check_surface(feature), [])
        return feature

    def test_cuts_a_part_out_that_can_be_thickened(self):
        source = self.add_source(saddle())
        feature = self.trimmed(source, SQUARE)
        own = {row.tobytes() for row in np.concatenate(self.corners(source))}
        untouched = self.corners(feature)[0][: feature.Untouched]
        self.assertGreater(feature.Untouched, 20)
        self.assertTrue(all(row.tobytes() in own for row in untouched))
        self.assertAlmostEqual(feature.Area.Value, self.measured(feature.Mesh)[1], delta=1e-3)
        self.assertTrue(ThickenWorkbench.make_thicken(self.doc, feature, 1).Valid)

    @staticmethod
    def corners(obj):
        points, facets = mesh_io.arrays_from_mesh(obj.Mesh)
        return [points[np.roll(facets, k, axis=1)] for k in range(3)]

    def test_points_are_the_documents_and_follow_the_source(self):
        source = self.add_source(plate())
        straight = self.trimmed(source, SQUARE).Area.Value
        source.Placement = App.Placement(App.Vector(10, 2, 3), App.Rotation(App.Vector(1, 0, 1), 70))
        moved = [tuple(source.Placement.multVec(App.Vector(*point))) for point in SQUARE]
        feature = self.trimmed(source, moved)
        self.assertAlmostEqual(feature.Area.Value, straight, delta=1e-3)
        self.assert_same_place(feature.Placement, source.Placement)
        source.Mesh = mesh_io.mesh_from_arrays(*saddle())
        self.doc.recompute()
        self.assertTrue(feature.Valid)
        self.assertGreater(abs(feature.Area.Value - straight), 1, "it is cut out of the saddle now")

    def test_keeps_the_part_at_a_point(self):
        source = self.add_source(plate())
        inside, outside = self.trimmed(source, SQUARE), self.trimmed(source, SQUARE, keep=(9, 9, 0))
        self.assertAlmostEqual(inside.Area.Value + outside.Area.Value, 400, delta=1e-2)
        outside.KeepInside = True
        self.doc.recompute()
        self.assertAlmostEqual(outside.Area.Value, inside.Area.Value, delta=1e-4)

    def test_takes_wires_and_follows_them(self):
        source = self.add_source(plate())
        circle = self.doc.addObject("Part::Feature", "Circle")
        circle.Shape = Part.Wire(Part.makeCircle(5, App.Vector(0.3, 0.2, 0.1)))
        feature = self.trimmed(source, wires=[circle])
        self.assertAlmostEqual(feature.Area.Value, np.pi * 25, delta=0.3)
        ring = self.trimmed(source, [(-1, -1.1, 0), (1.2, -1, 0), (1, 1.3, 0), (-1.1, 1, 0)], [circle])
        self.assertLess(ring.Area.Value, feature.Area.Value - 4)
        circle.Placement = App.Placement(App.Vector(1, 0, 0), App.Rotation())
        circle.Shape = Part.Wire(Part.makeCircle(3, App.Vector(0.3, 0.2, 0.1)))
        self.doc.recompute()
        self.assertAlmostEqual(feature.Area.Value, np.pi * 9, delta=0.2)

    def test_refusals(self):
        source = self.add_source(plate())
        with self.assertRaises(RefusedError):
            ThickenWorkbench.make_trim(self.doc, None)
        with self.assertRaises(ValueError):
            ThickenWorkbench.make_trim(self.doc, source, SQUARE, smooth=9)
        crossing = ThickenWorkbench.make_trim(self.doc, source, [SQUARE[k] for k in (0, 2, 1, 3)])
        self.assertFalse(crossing.isValid())
        self.assertIn("crosses itself at", crossing.getStatusString())
        self.assertEqual((crossing.Valid, crossing.Mesh.CountFacets), (False, 0))
        crossing.Points = [App.Vector(*point) for point in SQUARE]
        self.doc.recompute()
        self.assertTrue(crossing.isValid())
        self.assertIn("no loop", ThickenWorkbench.make_trim(self.doc, source).getStatusString())

    def test_saved_and_reopened(self):
        ThickenWorkbench.make_trim(self.doc, self.add_source(saddle()), SQUARE)
        path = self.folder / "part.FCStd"
        self.doc.saveAs(str(path))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(str(path))
        feature = self.doc.getObject("Trim")
        self.assertTrue(feature.Valid)
        feature.touch()
        self.doc.recompute()
        self.assertTrue(feature.isValid())
