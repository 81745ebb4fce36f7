# SPDX-License-Identifier: LGPL-2.1-or-later
"""trim() and SurfacePaths on arrays."""

import unittest

import numpy as np

from thicken import SurfacePaths, ThickenError, check_mesh, thicken_mesh, trim


def plate(n=12):
    x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0))
    vertices = np.column_stack([x.ravel(), y.ravel(), 0.25 * ((x.ravel() + y.ravel()) % 3)])
    index = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    a, b, c, d = (index[i : n + i, j : n + j].ravel() for i in (0, 1) for j in (0, 1))
    return vertices, np.concatenate([np.column_stack([a, b, d]), np.column_stack([a, d, c])])


SQUARE = np.array([[3.2, 3.3, 0], [8.7, 3.1, 0], [8.6, 8.8, 0], [3.4, 8.6, 0]])


class Trim(unittest.TestCase):
    def test_part_keeps_triangles_and_can_be_thickened(self):
        vertices, triangles = plate()
        part = trim(vertices, triangles, [SQUARE])
        self.assertEqual(check_mesh(part.vertices, part.triangles)["defects"], [])
        untouched = part.report["untouched_triangles"]
        np.testing.assert_array_equal(
            part.vertices[part.triangles[:untouched]], vertices[triangles[part.origin[:untouched]]]
        )
        self.assertEqual(len(part.triangles), untouched + part.report["divided_triangles"])
        self.assertEqual(part.paths[0].shape[1], 3)
        self.assertTrue(thicken_mesh(part.vertices, part.triangles, 0.5).report["audit"]["passed"])

    def test_keep_and_several_loops(self):
        inner = (SQUARE - [6, 6, 0]) / 3 + [6, 6, 0]
        ring = trim(*plate(), [SQUARE, inner])
        disc = trim(*plate(), [SQUARE, inner], keep=(6, 6, 0))
        self.assertEqual((ring.report["surface"]["rims"], disc.report["surface"]["rims"]), (2, 1))

    def test_refusals_have_a_code_and_a_place(self):
        with self.assertRaises(ThickenError) as caught:
            trim(*plate(), [SQUARE[[0, 2, 1, 3]]])
        self.assertEqual(caught.exception.code, "usage")
        self.assertEqual(len(caught.exception.defects), 1)
        with self.assertRaises(ThickenError):
            trim(*plate(), [])
        with self.assertRaises(ValueError):
            trim(*plate(), [SQUARE], precision="half")

    def test_paths_are_those_of_trim(self):
        paths = SurfacePaths(*plate())
        closed = paths.path(SQUARE)
        self.assertGreater(len(closed), 8)
        self.assertLess(len(paths.path(SQUARE, closed=False)), len(closed))
        self.assertEqual(len(paths.path(SQUARE[:1], closed=False)), 1)


if __name__ == "__main__":
    unittest.main()
