# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inspecting and drilling solids held in arrays."""

import unittest

import numpy as np

from thicken import native

CORNERS = np.array([[i >> k & 1 for k in range(3)] for i in range(8)], float)
BOX = np.array([[0, 3, 1], [0, 2, 3], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
                [2, 7, 3], [2, 6, 7], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]])  # fmt: skip


def hollow_box():
    """20 mm outside, 16 mm inside."""
    vertices = np.concatenate([20 * CORNERS, 2 + 16 * CORNERS])
    return vertices, np.concatenate([BOX, 8 + BOX[:, ::-1]])


class Inspect(unittest.TestCase):
    def setUp(self):
        self.extension = native.load()

    def test_shells_of_a_hollow_box(self):
        found = self.extension.inspect(*hollow_box())
        self.assertEqual(found["status"], "ok")
        self.assertAlmostEqual(found["volume_mm3"], 20**3 - 16**3)
        self.assertEqual([shell["cavity"] for shell in found["shells"]], [False, True])
        self.assertEqual(found["shells"][1]["within"], 0)
        np.testing.assert_array_equal(found["shell_of_triangle"], [0] * 12 + [1] * 12)

    def test_defects(self):
        vertices, triangles = hollow_box()
        found = self.extension.inspect(vertices, triangles[1:])
        self.assertEqual(found["status"], "refused")
        self.assertFalse(found["audit"]["closed"])
        self.assertGreater(len(found["defects"]), 0)

    def test_wall_thickness(self):
        np.testing.assert_allclose(self.extension.wall_thickness(*hollow_box()), 2)

    def test_closest_points(self):
        found = self.extension.closest_points(20 * CORNERS, BOX, [[10, 10, 25], [-3, 10, 10], [10, 10, 10]])
        np.testing.assert_allclose(found["distance"], [5, 3, 10])
        np.testing.assert_allclose(found["point"][:2], [[10, 10, 20], [0, 10, 10]])
        self.assertEqual(found["on_rim"].tolist(), [0, 0, 0])
        self.assertIn(found["triangle"][0], (2, 3))
        rim = self.extension.closest_points([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], [[-1, -1, 0]])
        self.assertEqual(rim["on_rim"].tolist(), [1])
        with self.assertRaises(ValueError):
            self.extension.closest_points([], [], [[0, 0, 0]])
        with self.assertRaises(self.extension.ThickenError):
            self.extension.closest_points(CORNERS, BOX, [[np.nan, 0, 0]])

    def test_drill(self):
        places, axes = [[50, 50, 0], [10, 10, 2]], [[0, 0, -1], [0, 0, -2]]
        found = self.extension.drill(*hollow_box(), places, axes, 3, sides=12)
        self.assertEqual((found["candidate"], len(found["outline"])), (1, 12))
        np.testing.assert_allclose(found["axis"], [0, 0, -1])
        np.testing.assert_allclose(found["walled"], [0, 2], atol=1e-6)
        after = self.extension.inspect(found["vertices"], found["triangles"])
        self.assertEqual([shell["cavity"] for shell in after["shells"]], [False])
        area = 12 * 1.5**2 * np.tan(np.pi / 12)
        self.assertAlmostEqual(after["volume_mm3"], 20**3 - 16**3 - 2 * area, places=3)
        old = {row.tobytes() for row in hollow_box()[0][hollow_box()[1]].reshape(-1, 9)}
        kept = found["vertices"][found["triangles"][: found["untouched"]]].reshape(-1, 9)
        self.assertEqual(len(kept), 20)
        self.assertTrue(all(row.tobytes() in old for row in kept))

    def test_drill_refuses(self):
        with self.assertRaises(self.extension.ThickenError) as caught:
            self.extension.drill(*hollow_box(), [[50, 50, 0]], [[0, 0, 1]], 3)
        self.assertEqual(caught.exception.code, "no-solid")
        with self.assertRaises(self.extension.ThickenError) as caught:
            self.extension.drill(*hollow_box(), [[10, 10, 0]], [[0, 0, 1]], -3)
        self.assertEqual(caught.exception.code, "usage")
        with self.assertRaises(ValueError):
            self.extension.drill(*hollow_box(), [[10, 10, 0]], [], 3)


if __name__ == "__main__":
    unittest.main()
