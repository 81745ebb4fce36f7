# SPDX-License-Identifier: LGPL-2.1-or-later
"""The property Repair: a defective source becomes a solid, and the feature says what was removed."""

import numpy as np

import ThickenWorkbench
from thicken_case import DocumentCase
from thicken_judge import is_closed_and_oriented
from thicken_surfaces import crossing_plates, fin, plate


class RepairProperty(DocumentCase):
    def test_makes_a_solid_of_a_defective_source(self):
        for surface in (crossing_plates(), fin()):
            source = self.add_source(surface)
            feature = ThickenWorkbench.make_thicken(self.doc, source, thickness=1)
            self.assert_refused(feature)
            feature.Repair = True
            self.doc.recompute()
            # FreeCAD's own test for intersections is inexact, and takes sheets that nearly touch for some
            self.assertTrue(feature.isValid(), feature.getStatusString())
            self.assertTrue(feature.Valid)
            self.assertTrue(feature.Mesh.isSolid())
            points, facets = feature.Mesh.Topology
            self.assertTrue(is_closed_and_oriented(np.array([[tuple(points[v]) for v in facet] for facet in facets])))
            self.assertLess(feature.OriginalTriangles, len(surface[1]))
            self.assertTrue(any("repaired" in warning for warning in feature.Warnings), feature.Warnings)
            feature.Repair = False
            self.doc.recompute()
            self.assert_refused(feature)

    def test_changes_nothing_for_a_valid_source(self):
        source = self.add_source(plate())
        plain = ThickenWorkbench.make_thicken(self.doc, source, thickness=1)
        mended = ThickenWorkbench.make_thicken(self.doc, source, thickness=1, repair=True)
        self.assert_solid(mended)
        self.assertEqual(mended.Mesh.Topology, plain.Mesh.Topology)
        self.assertEqual(list(mended.Warnings), [])
