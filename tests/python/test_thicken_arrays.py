# SPDX-License-Identifier: LGPL-2.1-or-later
"""thicken_mesh() and its companions: what they take, what they return, what they refuse."""

import math
import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np

from thicken import (
    Region,
    RunContext,
    ThickenError,
    check_mesh,
    forecast_mesh,
    read_mesh,
    size_of,
    thicken_mesh,
    weld_mesh,
    write_mesh,
)
from thicken_judge import is_closed_and_oriented, keeps, volume
from thicken_surfaces import crossing_plates, fin, plate, saddle, together


class Result(unittest.TestCase):
    def test_is_a_solid_that_keeps_the_surface(self):
        vertices, triangles = saddle()
        for side in ("negative", "positive"):
            with self.subTest(side=side):
                solid = thicken_mesh(vertices, triangles, 2, side=side)
                corners = solid.vertices[solid.triangles]
                self.assertTrue(is_closed_and_oriented(corners))
                self.assertTrue(keeps(corners, vertices[triangles], reversed_sense=side == "positive"))
                self.assertAlmostEqual(volume(corners), solid.report["output"]["volume_mm3"], places=6)

    def test_thickness_may_vary(self):
        vertices, triangles = plate()
        plain = thicken_mesh(vertices, triangles, 1.5)
        same = thicken_mesh(vertices, triangles, np.full(len(vertices), 1.5))
        self.assertTrue(np.array_equal(plain.vertices, same.vertices))
        self.assertTrue(np.array_equal(plain.triangles, same.triangles))
        along = vertices[:, 0]
        solid = thicken_mesh(vertices, triangles, 1 + (along - along.min()) / (2 * np.ptp(along)))
        self.assertTrue(is_closed_and_oriented(solid.vertices[solid.triangles]))
        told = solid.report["parameters"]["thickness_map"]
        self.assertAlmostEqual(told["least_mm"], 1)
        self.assertAlmostEqual(told["most_mm"], 1.5)
        self.assertLess(volume(solid.vertices[solid.triangles]), volume(plain.vertices[plain.triangles]))

    def test_rim_may_have_a_profile(self):
        vertices, triangles = plate(20.0, 41)
        solid = thicken_mesh(vertices, triangles, 2, rim_thickness=1.5, rim_width=4, rim_round=1)
        corners = solid.vertices[solid.triangles]
        self.assertTrue(is_closed_and_oriented(corners))
        self.assertTrue(keeps(corners, vertices[triangles]))
        self.assertEqual(solid.report["parameters"]["rim"],
                         {"thickness_mm": 1.5, "width_mm": 4, "round_mm": 1, "row_mm": 0.5})  # fmt: skip
        low, high = vertices[:, :2].min(axis=0), vertices[:, :2].max(axis=0)
        shell = solid.vertices[np.unique(solid.triangles[solid.region == Region.SHELL])]
        for d, depth in ((0, 0.5), (0.5, 1.5625 - (1 - np.sqrt(0.75))), (1, 1.625), (2, 1.75), (4, 2), (8, 2)):
            at = np.isclose(np.minimum(shell[:, :2] - low, high - shell[:, :2]).min(axis=1), d)
            self.assertTrue(at.any())
            np.testing.assert_allclose(np.abs(shell[at, 2]), depth, atol=1e-5)
        with self.assertRaisesRegex(ThickenError, "belong together"):
            thicken_mesh(vertices, triangles, 2, rim_thickness=1)

    def test_is_forecast(self):
        surface = saddle()
        for side in ("negative", "both"):
            seconds, most = forecast_mesh(size_of(*surface), 2, side=side, threads=1)
            report = thicken_mesh(*surface, 2, side=side, threads=1).report
            self.assertAlmostEqual(seconds / report["predicted_seconds"], 1)
            self.assertLessEqual(most, report["memory"]["predicted_bytes"])
        self.assertGreater(forecast_mesh(size_of(*surface), 1, method="reconstruct", cell=0.1)[0],
                           forecast_mesh(size_of(*surface), 1, method="reconstruct", cell=0.2)[0])  # fmt: skip
        with self.assertRaises(ValueError):
            forecast_mesh(size_of(*surface), 2, side="left")

    def test_types_and_shapes(self):
        vertices, triangles = plate()
        solid = thicken_mesh(vertices, triangles, 2)
        self.assertEqual((solid.vertices.dtype, solid.vertices.shape[1]), (np.float64, 3))
        self.assertEqual((solid.triangles.dtype, solid.triangles.shape[1]), (np.int64, 3))
        self.assertEqual((solid.region.dtype, len(solid.region)), (np.uint8, len(solid.triangles)))
        self.assertEqual((solid.depth.dtype, len(solid.depth)), (np.float64, len(vertices)))
        for array in solid[:4]:
            self.assertTrue(array.flags.c_contiguous and array.flags.writeable)

    def test_plate(self):
        vertices, triangles = plate(size=20)
        solid = thicken_mesh(vertices, triangles, 2)
        # The surface comes first: its triangles in their order, its vertices in that of first use.
        kept = solid.triangles[: len(triangles)]
        np.testing.assert_array_equal(solid.vertices[kept], vertices[triangles])
        self.assertEqual(set(kept.ravel()), set(range(len(vertices))))
        np.testing.assert_allclose(solid.depth, 2)
        self.assertAlmostEqual(solid.report["output"]["volume_mm3"], 800, places=6)
        counts = np.bincount(solid.region, minlength=3)
        self.assertEqual(counts[Region.ORIGINAL], len(triangles))
        self.assertEqual(counts[Region.SHELL], solid.report["output"]["shell_triangles"])
        self.assertEqual(counts[Region.WALL], solid.report["output"]["wall_triangles"])
        wall = solid.vertices[solid.triangles[solid.region == Region.WALL]]
        self.assertTrue((np.abs(wall[..., :2]).max(axis=(1, 2)) == 10).all())

    def test_simplify(self):
        x, y = np.meshgrid(np.arange(11.0), np.arange(11.0))
        vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
        corner = np.array([11 * row + column for row in range(10) for column in range(10)])
        triangles = np.vstack([corner + [[0], [1], [12]], corner + [[0], [12], [11]]]).reshape(2, 3, -1)
        triangles = triangles.transpose(0, 2, 1).reshape(-1, 3)
        counts = {}
        for word in ("off", "shell"):
            solid = thicken_mesh(vertices, triangles, 2, simplify=word)
            self.assertTrue(keeps(solid.vertices[solid.triangles], vertices[triangles]))
            self.assertEqual(solid.report["simplify"]["triangles_after"], len(solid.triangles))
            counts[word] = np.count_nonzero(solid.region == Region.SHELL)
        self.assertEqual(counts["off"], len(triangles))
        self.assertLess(5 * counts["shell"], counts["off"])
        with self.assertRaisesRegex(ValueError, "simplify must be one of"):
            thicken_mesh(vertices, triangles, 2, simplify="much")

    def test_double_precision_keeps_doubles(self):
        vertices, triangles = saddle()
        vertices = vertices.astype(float) * math.pi
        for precision, expected in [("double", vertices), ("single", vertices.astype(np.float32))]:
            solid = thicken_mesh(vertices, triangles, 2, precision=precision)
            kept = solid.vertices[solid.triangles[: len(triangles)]]
            np.testing.assert_array_equal(kept, expected[triangles], precision)

    def test_result_outlives_the_call(self):
        vertices = thicken_mesh(*plate(), 2).vertices
        copy = vertices.copy()
        [thicken_mesh(*saddle(), 1) for _ in range(3)]
        np.testing.assert_array_equal(vertices, copy)

    def test_same_bytes_for_any_number_of_threads(self):
        one, four = (thicken_mesh(*saddle(), 2, threads=threads) for threads in (1, 4))
        for a, b in zip(one[:4], four[:4]):
            self.assertEqual(a.tobytes(), b.tobytes())


class Arguments(unittest.TestCase):
    def test_any_real_type_and_layout_of_vertices(self):
        vertices, triangles = plate(n=5)  # whole halves: exact in every type below
        expected = thicken_mesh(vertices, triangles, 1).vertices
        wide = np.zeros((len(vertices), 7))
        wide[:, 1:7:2] = vertices
        for given in [
            vertices.astype(float),
            vertices.astype(np.float16),
            vertices.astype(">f8"),
            vertices.astype(np.longdouble),
            vertices.astype(np.int32),
            np.asfortranarray(vertices),
            wide[:, 1:7:2],
            vertices.tolist(),
            vertices[::-1][::-1],
        ]:
            np.testing.assert_array_equal(thicken_mesh(given, triangles, 1).vertices, expected)

    def test_any_integer_type_and_layout_of_triangles(self):
        vertices, triangles = plate()
        expected = thicken_mesh(vertices, triangles, 1).triangles
        for given in [
            triangles.astype(np.uint8),
            triangles.astype(np.int16),
            triangles.astype(">u4"),
            triangles.astype(np.uint64),
            np.asfortranarray(triangles),
            np.repeat(triangles, 2, axis=0)[::2],
            triangles.tolist(),
        ]:
            np.testing.assert_array_equal(thicken_mesh(vertices, given, 1).triangles, expected)

    def test_input_is_not_changed(self):
        vertices, triangles = saddle()
        vertices.flags.writeable = triangles.flags.writeable = False
        copies = vertices.copy(), triangles.copy()
        thicken_mesh(vertices, triangles, 1)
        np.testing.assert_array_equal(vertices, copies[0])
        np.testing.assert_array_equal(triangles, copies[1])

    def test_wrong_types(self):
        vertices, triangles = plate()
        for v, t in [
            (vertices.astype(complex), triangles),
            (vertices.astype(str), triangles),
            (vertices.astype(object), triangles),
            (vertices > 0, triangles),
            (vertices, triangles.astype(float)),
            (vertices, triangles > 0),
            (None, triangles),
        ]:
            with self.assertRaises(TypeError):
                thicken_mesh(v, t, 1)

    def test_wrong_shapes(self):
        vertices, triangles = plate()
        for v, t in [
            (vertices[:, :2], triangles),
            (vertices.ravel(), triangles),
            (vertices[None], triangles),
            (vertices, triangles[:, :2]),
            (vertices, triangles.ravel()),
            ([[0, 0, 0], [1]], triangles),
        ]:
            with self.assertRaises(ValueError):
                thicken_mesh(v, t, 1)

    def test_indices_out_of_range(self):
        vertices, triangles = plate()
        for index in (-1, len(vertices), 2**32, -(2**63), 2**63 - 1):
            wrong = triangles.astype(np.int64)
            wrong[7, 1] = index
            with self.assertRaisesRegex(ValueError, f"triangle 7 .*{index}"):
                thicken_mesh(vertices, wrong, 1)
        with self.assertRaises(ValueError):
            thicken_mesh(vertices, np.full((1, 3), 2**64 - 1, np.uint64), 1)

    def test_thickness(self):
        for thickness in (0, -1, math.nan, math.inf):
            with self.assertRaisesRegex(ValueError, "thickness"):
                thicken_mesh(*plate(), thickness)
        with self.assertRaises(TypeError):
            thicken_mesh(*plate(), "2 mm")
        thicken_mesh(*plate(), np.float32(1))

    def test_thickness_for_each_vertex(self):
        vertices, triangles = plate()
        for wrong in (np.ones(len(vertices) - 1), np.ones((len(vertices), 1)), np.zeros(len(vertices))):
            with self.assertRaisesRegex(ValueError, "for each vertex"):
                thicken_mesh(vertices, triangles, wrong)

    def test_words(self):
        for wrong in ({"side": "up"}, {"method": "magic"}, {"precision": "half"}):
            with self.assertRaisesRegex(ValueError, next(iter(wrong))):
                thicken_mesh(*plate(), 1, **wrong)

    def test_options_out_of_range_are_the_library_s_to_refuse(self):
        for wrong in ({"cell": 0.6}, {"cell": -1}, {"tolerance": 0}, {"resolution": 0}, {"smooth": 101}, {"threads": -1}):
            with self.assertRaises(ThickenError) as caught:
                thicken_mesh(*plate(), 1, **wrong)
            self.assertEqual(caught.exception.code, "usage", wrong)

    def test_memory(self):
        with self.assertRaises(ThickenError) as caught:
            thicken_mesh(*plate(n=200), 1, memory=1)
        self.assertEqual(caught.exception.code, "memory-limit")
        self.assertGreater(caught.exception.memory["enough_bytes"], 1 << 20)
        with self.assertRaises(ValueError):
            thicken_mesh(*plate(), 1, memory=0)
        context = RunContext()
        thicken_mesh(*plate(), 1, memory=0.5 * 1024, context=context)
        self.assertEqual(context.memory_limit, 512 << 20)


class Refusals(unittest.TestCase):
    def refused(self, vertices, triangles, **arguments):
        with self.assertRaises(ThickenError) as caught:
            thicken_mesh(vertices, triangles, 1, **arguments)
        self.assertIsInstance(caught.exception, RuntimeError)
        self.assertGreater(len(str(caught.exception)), 20)
        return caught.exception

    def test_not_manifold(self):
        error = self.refused(*fin())
        self.assertEqual(error.code, "not-manifold")
        _, welded = weld_mesh(*fin())
        self.assertEqual([sorted(edge) for edge in error.defects[0]["edges"]], [sorted(welded[-1, :2])])

    def test_self_intersecting(self):
        error = self.refused(*crossing_plates())
        self.assertEqual(error.code, "self-intersecting")
        (defect,) = error.defects
        self.assertLess(abs(defect["place_mm"][0]), 2.0)
        self.assertEqual(len(defect["triangles"]) % 2, 0)

    def test_all_defects_at_once(self):
        far = crossing_plates()[0] + [100, 0, 0], crossing_plates()[1]
        codes = [defect["code"] for defect in self.refused(*together(fin(), far)).defects]
        self.assertEqual(sorted(codes), ["not-manifold", "self-intersecting"])

    def test_not_finite(self):
        for value in (math.nan, math.inf, 1e300):
            vertices = plate()[0].astype(float)
            vertices[3, 1] = value
            self.assertEqual(self.refused(vertices, plate()[1]).code, "not-finite")

    def test_empty(self):
        for vertices, triangles in [([], []), (plate()[0], []), (np.empty((0, 3)), np.empty((0, 3), int))]:
            self.assertEqual(self.refused(vertices, triangles).code, "empty")

    def test_error_can_be_pickled(self):
        error = self.refused(*fin())
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.code, again.defects), (str(error), error.code, error.defects))


class Check(unittest.TestCase):
    def test_valid_surface(self):
        found = check_mesh(*plate(size=20))
        self.assertEqual((found["status"], found["defects"]), ("ok", []))
        self.assertEqual(found["input"]["triangles"], len(plate()[1]))
        self.assertEqual(found["input"]["rims"], 1)
        self.assertAlmostEqual(found["input"]["area_mm2"], 400)

    def test_defects(self):
        self.assertEqual(check_mesh(*fin())["defects"][0]["code"], "not-manifold")

    def test_equal_corners_are_one_vertex(self):
        vertices, triangles = plate()
        soup = vertices[triangles].reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)
        self.assertEqual(check_mesh(*soup)["input"]["vertices"], len(vertices))


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_round_trip(self):
        vertices, triangles = saddle()
        for name in ("a.stl", "ä b.ply", "a.obj", "a.off"):
            path = self.folder / name
            write_mesh(path, vertices, triangles)
            read_vertices, read_triangles = read_mesh(str(path))
            np.testing.assert_array_equal(read_vertices[read_triangles], vertices[triangles], name)

    def test_missing_file(self):
        with self.assertRaises(ThickenError) as caught:
            read_mesh(self.folder / "missing.stl")
        self.assertEqual(caught.exception.code, "unreadable")
        self.assertIn("missing.stl", str(caught.exception))

    def test_folder_that_is_not_there(self):
        with self.assertRaises(ThickenError) as caught:
            write_mesh(self.folder / "no" / "a.stl", *saddle())
        self.assertEqual(caught.exception.code, "unwritable")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_path_of_another_type(self):
        with self.assertRaises(TypeError):
            read_mesh(7)


if __name__ == "__main__":
    unittest.main()
