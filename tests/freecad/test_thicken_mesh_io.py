# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD meshes and arrays: bit for bit, in order, nothing lost in silence."""

import sys
import unittest

import FreeCAD as App
import Mesh
import numpy as np

from ThickenWorkbench import mesh_io
from thicken_surfaces import fin, plate, saddle


class RoundTrip(unittest.TestCase):
    def assert_same(self, vertices, triangles):
        points, facets = mesh_io.arrays_from_mesh(mesh_io.mesh_from_arrays(vertices, triangles))
        self.assertEqual(points.dtype, np.float32)
        self.assertEqual(points.tobytes(), np.asarray(vertices, "<f4").tobytes())
        np.testing.assert_array_equal(facets, triangles)

    def test_random_floats_of_all_magnitudes(self):
        random = np.random.default_rng(1)
        bits = random.integers(0, 2**32, (3000, 3), dtype=np.uint32)
        vertices = bits.view(np.float32)
        vertices[~np.isfinite(vertices)] = 1e-42  # denormal
        vertices[0] = [0.0, -0.0, np.float32(0.1)]
        self.assert_same(vertices, random.permutation(3000).reshape(-1, 3))

    def test_doubles_that_are_floats(self):
        vertices, triangles = saddle()
        self.assert_same(vertices.astype(float), triangles.astype(np.uint16))

    def test_equal_points_stay_two(self):
        self.assert_same(np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0], [0, 1, 0], [-1, 0, 1]]),
                         np.array([[0, 1, 2], [3, 4, 5]]))  # fmt: skip

    def test_facets_at_a_non_manifold_edge_stay(self):
        self.assert_same(*fin())

    def test_duplicate_and_degenerate_facets_stay(self):
        vertices, triangles = plate()
        self.assert_same(vertices, np.vstack([triangles, triangles[:2], [[0, 0, 1]]]))

    def test_strided_and_fortran_arrays(self):
        vertices, triangles = saddle()
        self.assert_same(np.asfortranarray(vertices), np.repeat(triangles, 2, axis=0)[::2])

    def test_empty(self):
        mesh = mesh_io.mesh_from_arrays(np.empty((0, 3)), np.empty((0, 3), int))
        self.assertEqual((mesh.CountPoints, mesh.CountFacets), (0, 0))
        points, facets = mesh_io.arrays_from_mesh(mesh)
        self.assertEqual((points.shape, facets.shape), ((0, 3), (0, 3)))

    def test_points_without_facets_are_left_out(self):
        vertices, triangles = saddle()
        mesh = mesh_io.mesh_from_arrays(np.vstack([[[7, 7, 7]], vertices]), triangles + 1)
        points, facets = mesh_io.arrays_from_mesh(mesh)
        np.testing.assert_array_equal(points, vertices)
        np.testing.assert_array_equal(facets, triangles)

    def test_what_needs_doubles_is_refused(self):
        with self.assertRaises(mesh_io.MeshTransferError):
            mesh_io.mesh_from_arrays([[0.1, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])

    def test_malformed_arrays_are_refused(self):
        vertices, triangles = saddle()
        for wrong in [(vertices[:5], triangles), (vertices, triangles - 1), (vertices[:, :2], triangles)]:
            with self.assertRaises(ValueError):
                mesh_io.mesh_from_arrays(*wrong)

    def test_placement_stays_out_of_the_coordinates(self):
        vertices, triangles = saddle()
        mesh = mesh_io.mesh_from_arrays(vertices, triangles)
        placement = App.Placement(App.Vector(0.1, 0.2, 0.3), App.Rotation(App.Vector(1, 1, 1), 77))
        mesh.Placement = placement
        points, _ = mesh_io.arrays_from_mesh(mesh)
        self.assertEqual(points.tobytes(), vertices.tobytes())
        self.assertEqual(mesh.Placement, placement, "the mesh itself was moved")

    def test_agrees_with_freecad_s_own_listing(self):
        mesh = Mesh.createSphere(3.0, 20)
        points, facets = mesh_io.arrays_from_mesh(mesh)
        listed_points, listed_facets = mesh.Topology
        np.testing.assert_array_equal(points.astype(float), [tuple(p) for p in listed_points])
        np.testing.assert_array_equal(facets, listed_facets)

    def test_facets_are_not_passed_one_by_one(self):
        """As many calls of Python for ten times the facets: what goes through a loop of Python takes seconds."""

        def calls(n):
            vertices, triangles = plate(n=n)
            count = 0

            def called(_frame, event, _argument):
                nonlocal count
                count += event in ("call", "c_call")

            sys.setprofile(called)
            try:
                mesh = mesh_io.mesh_from_arrays(vertices, triangles)
                mesh_io.arrays_from_mesh(mesh)
            finally:
                sys.setprofile(None)
            self.assertEqual(mesh.CountFacets, len(triangles))
            return count

        self.assertLess(calls(n=100), calls(n=32) + 50)
