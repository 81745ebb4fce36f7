# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way to the printer: the exported STL, judged without FreeCAD and without the library."""

import Mesh

import ThickenWorkbench
from ThickenWorkbench import mesh_io
import thicken_judge
from thicken_case import DocumentCase
from thicken_surfaces import plate, saddle, together


class ExportedStl(DocumentCase):
    def export(self, surface, **arguments):
        source = self.add_source(surface)
        feature = ThickenWorkbench.make_thicken(self.doc, source, **arguments)
        self.assert_solid(feature)
        path = self.folder / "solid.stl"
        Mesh.export([feature], str(path))
        return source, feature, path

    def judge(self, surface, **arguments):
        source, feature, path = self.export(surface, **arguments)
        corners = thicken_judge.read_stl(path)
        vertices, triangles = surface
        self.assertEqual(len(corners), feature.TriangleCount)
        self.assertTrue(thicken_judge.is_closed_and_oriented(corners))
        self.assertAlmostEqual(thicken_judge.volume(corners), feature.Volume.Value, delta=1e-6 * feature.Volume.Value)
        positive = arguments.get("side") == "positive"
        self.assertTrue(thicken_judge.keeps(corners, vertices[triangles], reversed_sense=positive))
        return path

    def test_negative_side(self):
        self.judge(saddle(), thickness=2)

    def test_positive_side(self):
        self.judge(saddle(), thickness=2, side="positive")

    def test_two_components(self):
        far = plate()[0] + 30, plate()[1]
        self.judge(together(saddle(), far), thickness=1)

    def test_tight_sheets(self):
        """Two sheets closer than twice the thickness: the solid is cut back between them."""
        below = plate()[0] + [[0, 0, -1.5]], plate()[1]
        self.judge(together(plate(), (below[0].astype("f4"), below[1])), thickness=1)

    def test_file_is_read_back_as_a_solid(self):
        _, feature, path = self.export(saddle(), thickness=2)
        mesh = Mesh.Mesh(str(path))
        self.assertEqual(mesh.CountFacets, feature.TriangleCount)
        self.assertTrue(mesh.isSolid())
        self.assertFalse(mesh.hasSelfIntersections())

    def test_independent_judge(self):
        program = thicken_judge.independent_judge()
        if program is None:
            self.skipTest("no solidcheck: set SOLIDCHECK to its path")
        for side in ("negative", "positive"):
            with self.subTest(side=side):
                source, feature, path = self.export(saddle(), thickness=2, side=side)
                surface_path = self.folder / "surface.stl"
                source.Mesh.write(str(surface_path))
                status, facts = thicken_judge.judgement(program, surface_path, path, 2, side)
                self.assertEqual(status, 0, facts)

    def test_judge_notices_damage(self):
        """The checks above can fail."""
        _, feature, path = self.export(saddle(), thickness=2)
        corners = thicken_judge.read_stl(path).copy()
        self.assertFalse(thicken_judge.is_closed_and_oriented(corners[1:]))
        flipped = corners.copy()
        flipped[3] = flipped[3, ::-1]
        self.assertFalse(thicken_judge.is_closed_and_oriented(flipped))
        moved, _ = mesh_io.arrays_from_mesh(feature.Mesh)
        moved = corners.copy()
        moved[0, 0, 0] += 1e-6
        surface = saddle()[0][saddle()[1]]
        self.assertTrue(thicken_judge.keeps(corners, surface))
        self.assertFalse(thicken_judge.keeps(moved, surface))
