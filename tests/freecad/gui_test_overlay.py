# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is handed to the 3D view is what was meant."""

import unittest

import numpy as np
from pivy import coin

from ThickenWorkbench.gui import overlay
from ThickenWorkbench.gui.colour_scale import colours, ticks


def found(root, kind):
    search = coin.SoSearchAction()
    search.setType(kind.getClassTypeId())
    search.setInterest(coin.SoSearchAction.FIRST)
    search.apply(root)
    return search.getPath().getTail()


class Nodes(unittest.TestCase):
    def test_faces_have_the_coordinates_and_the_corners(self):
        random = np.random.default_rng(1)
        vertices, triangles = random.random((50, 3)), random.integers(0, 50, (80, 3))
        root = overlay.faces(vertices, triangles, (1, 0, 0))
        points = np.array([p.getValue() for p in found(root, coin.SoCoordinate3).point.getValues()])
        np.testing.assert_allclose(points, vertices, atol=1e-6)
        index = np.array(found(root, coin.SoIndexedFaceSet).coordIndex.getValues()).reshape(-1, 4)
        np.testing.assert_array_equal(index[:, :3], triangles)
        self.assertTrue((index[:, 3] == -1).all())

    def test_colours_are_replaced(self):
        material = coin.SoMaterial()
        overlay.set_colours(material, np.zeros((9, 3)))
        wanted = [(1, 0.5, 0.25), (0, 1, 0)]
        overlay.set_colours(material, wanted)
        np.testing.assert_allclose([c.getValue() for c in material.diffuseColor.getValues()], wanted)


class Scale(unittest.TestCase):
    def test_ends_have_the_colours_of_the_ends(self):
        shown = colours([-5, 0, 1, 2, 7, np.nan], 0, 2)
        np.testing.assert_array_equal(shown[0], shown[1])
        np.testing.assert_array_equal(shown[3], shown[4])
        self.assertGreater(shown[0, 0], shown[0, 2], "thin is red")
        self.assertGreater(shown[3, 2], shown[3, 0], "thick is blue")
        self.assertEqual(len(set(shown[5])), 1, "unknown is grey")

    def test_ticks_are_round_and_few(self):
        self.assertEqual(ticks(0, 2), [0, 0.5, 1, 1.5, 2])
        self.assertEqual(ticks(3, 3), [3])
        for low, high in [(0.013, 0.9), (-4.2, 17), (1e-6, 3e-6)]:
            found_ticks = ticks(low, high)
            self.assertTrue(2 <= len(found_ticks) <= 6)
            self.assertTrue(low - 1e-12 <= min(found_ticks) and max(found_ticks) <= high + 1e-12)
