# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooth patches: what a click chooses."""

import unittest

import numpy as np

from ThickenWorkbench.core.patches import SmoothPatches
from thicken_surfaces import grid, plate, together


class Patches(unittest.TestCase):
    def test_a_patch_ends_at_a_sharp_edge(self):
        roof = grid(lambda x, y: abs(x), n=21)
        patches = SmoothPatches(*roof)
        centres = roof[0][roof[1]].mean(1)
        for facet in (0, 399, 500):
            same_side = np.flatnonzero(np.sign(centres[:, 0]) == np.sign(centres[facet, 0]))
            np.testing.assert_array_equal(patches.around(facet, 20), same_side)
        self.assertEqual(len(patches.around(0, 91)), 800)

    def test_a_patch_ends_at_a_gap(self):
        vertices, triangles = plate()
        both = together((vertices, triangles), (vertices + [0, 0, 5], triangles))
        self.assertEqual(len(SmoothPatches(*both).around(3, 180)), len(triangles))

    def test_facets_without_area_and_shared_edges_do_no_harm(self):
        vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 0, 0], [0, 0, 1]], float)
        triangles = np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]])
        reached = SmoothPatches(vertices, triangles).around(0, 180)
        np.testing.assert_array_equal(reached, [0, 1, 2])
