# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances along a surface and the thickness made of them, beside formulas; and what a brush paints."""

import unittest

import numpy as np

from ThickenWorkbench.core.patches import Brush
from ThickenWorkbench.core.thickness_field import blended, distance_along, region_weights
from thicken_surfaces import grid, plate, together


def uneven(n):
    """A plate whose inner vertices are moved at random, by up to a quarter of an edge."""
    vertices, triangles = plate(n=n)
    vertices = vertices.astype(float)
    inner = (abs(vertices[:, :2]) < 9.999).all(axis=1)
    vertices[inner, :2] += np.random.default_rng(7).uniform(-1, 1, (inner.sum(), 2)) * 20 / (n - 1) / 4
    return vertices, triangles


class Distances(unittest.TestCase):
    def test_a_straight_front_is_exact(self):
        vertices, triangles = plate(n=33)
        x = vertices[:, 0].astype(float)
        found = distance_along(vertices.astype(float), triangles, x <= -5, 8.0)
        near = x <= 3
        np.testing.assert_allclose(found[near], np.maximum(x + 5, 0)[near], atol=1e-12)
        self.assertTrue(np.isinf(found[~near]).all())

    def test_a_straight_front_goes_straight_over_uneven_triangles(self):
        vertices, triangles = uneven(41)
        x = vertices[:, 0]
        found = distance_along(vertices, triangles, x == -10, 12.0)
        np.testing.assert_allclose(found[x < 0], (x + 10)[x < 0], atol=1e-6)

    def test_it_goes_around_a_cylinder(self):
        vertices, triangles = plate(n=81)
        x, y = vertices[:, 0].astype(float), vertices[:, 1]
        rolled = np.column_stack([4 * np.sin(x / 4), y, 4 * np.cos(x / 4)])
        found = distance_along(rolled, triangles, x <= -5, 12.0)
        np.testing.assert_allclose(found[x < 6], np.maximum(x + 5, 0)[x < 6], atol=3e-3)

    def test_a_round_front_comes_nearer_to_the_circle_with_finer_triangles(self):
        worst = []
        for n in (31, 61, 121):
            vertices, triangles = uneven(n)
            away = np.hypot(vertices[:, 0], vertices[:, 1])
            found = distance_along(vertices, triangles, away <= 3, 6.0)
            some = np.flatnonzero((away > 3) & (away < 8))[::5]
            # From the nearest vertex inside; a point of an edge between two may be nearer, by an edge at most.
            front = vertices[(away <= 3) & (away > 3 - 40 / n)]
            of_vertices = np.linalg.norm(vertices[some, None] - front[None], axis=2).min(axis=1)
            self.assertTrue(np.isfinite(found[some]).all())
            worst.append(np.abs(found[some] - of_vertices).max())
        self.assertLess(worst[0], 0.4)
        self.assertLess(worst[2], 0.4 * worst[0])

    def test_it_does_not_jump_over_a_gap(self):
        vertices, triangles = plate(n=21)
        both = together((vertices, triangles), (vertices + np.float32([0, 0, 0.1]), triangles))
        found = distance_along(both[0].astype(float), both[1], np.arange(len(both[0])) < 21, 5.0)
        self.assertTrue(np.isinf(found[len(vertices) :]).all())
        self.assertGreater(np.isfinite(found).sum(), 100)


class Fields(unittest.TestCase):
    def weights(self, surface, *regions, transition=4.0):
        middles = np.asarray(surface[0], float)[surface[1]].mean(axis=1)
        return region_weights(*surface, [np.flatnonzero(chosen(middles[:, 0])) for chosen in regions], transition)

    def test_it_is_linear_over_the_transition(self):
        surface = plate(n=41)
        x = surface[0][:, 0].astype(float)
        weights = self.weights(surface, lambda x: x < -5)
        found = blended(1.0, [3.0], weights)
        np.testing.assert_allclose(found, np.clip(3 - 2 * (x + 5) / 4, 1, 3), atol=1e-9)

    def test_vertices_that_are_not_welded_are_one(self):
        vertices, triangles = plate(n=41)
        split = vertices[triangles].reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)
        welded = self.weights((vertices, triangles), lambda x: x < -5)
        np.testing.assert_allclose(self.weights(split, lambda x: x < -5)[0], welded[0][triangles.ravel()], atol=1e-12)

    def test_between_two_regions_nothing_jumps(self):
        surface = plate(n=41)
        x = surface[0][:, 0].astype(float)
        weights = self.weights(surface, lambda x: x < 0, lambda x: x > 0)
        found = blended(1.0, [2.0, 4.0], weights)
        self.assertAlmostEqual(found[np.argmin(abs(x))], 3.0)
        np.testing.assert_allclose(found[x <= -4], 2.0, atol=1e-12)
        np.testing.assert_allclose(found[x >= 4], 4.0, atol=1e-12)
        near = (x > -4) & (x < 0)
        share = 1 - abs(x[near]) / 4
        np.testing.assert_allclose(found[near], (2 + 4 * share) / (1 + share), atol=1e-9)

    def test_without_a_transition_only_the_region_has_its_thickness(self):
        surface = plate(n=21)
        found = blended(1.0, [3.0], self.weights(surface, lambda x: x < -5, transition=0.0))
        np.testing.assert_array_equal(found, np.where(surface[0][:, 0] <= -5, 3.0, 1.0))

    def test_no_region(self):
        vertices, triangles = plate(n=5)
        np.testing.assert_array_equal(blended(1.5, [], region_weights(vertices, triangles, [], 3.0)), np.full(25, 1.5))


class Brushes(unittest.TestCase):
    def test_it_takes_what_is_connected(self):
        surface = grid(lambda x, y: 0 * x, n=41)
        sheets = together(surface, (surface[0] + np.float32([0, 0, 0.5]), surface[1]))
        brush = Brush(*sheets)
        place = np.array([1.2, 3.3, 0.2])
        middles = sheets[0][sheets[1]].mean(axis=1)
        expected = np.flatnonzero((np.linalg.norm(middles - place, axis=1) <= 2) & (middles[:, 2] == 0))
        np.testing.assert_array_equal(brush.around(place, 2), expected)

    def test_a_large_facet_is_found_from_its_corner(self):
        vertices = np.array([[0, 0, 0], [100, 0, 0], [0, 100, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]], float)
        brush = Brush(vertices, np.array([[0, 1, 2], [3, 4, 5]]))
        self.assertEqual(brush.facet_at([1, 1, 0.1]), 0)
        self.assertEqual(brush.facet_at([0.2, 0.2, 0.8]), 1)
        np.testing.assert_array_equal(brush.around([1, 1, 0.1], 0.5), [0])
