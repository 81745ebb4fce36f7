# SPDX-License-Identifier: LGPL-2.1-or-later
"""repair_mesh() and thicken_mesh(repair=True)."""

import unittest

import numpy as np

from thicken import ThickenError, check_mesh, divide_into_sheets, repair_mesh, thicken_mesh
from thicken_judge import is_closed_and_oriented, keeps
from thicken_surfaces import crossing_plates, fin, plate, together

# A wall on the middle line of a floor: three triangles at an edge.
TEE = (
    [[0, 0, 0], [2, 0, 0], [4, 0, 0], [0, 4, 0], [2, 4, 0], [4, 4, 0], [2, 0, 2], [2, 4, 2]],
    [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [1, 4, 7], [1, 7, 6]],
)


class Repair(unittest.TestCase):
    def test_removes_what_crosses_and_says_so(self):
        vertices, triangles = crossing_plates()
        mended = repair_mesh(vertices, triangles)
        self.assertEqual(check_mesh(mended.vertices, mended.triangles)["defects"], [])
        (change,) = [c for c in mended.report["changes"] if c["kind"] == "self-intersecting"]
        self.assertTrue(change["removed"])
        self.assertGreater(change["area_mm2"], 0)
        self.assertEqual(mended.report["surface"]["triangles"], len(mended.triangles))
        # what remains is the surface's own, in its order, but for parts that came back
        whole = (mended.vertices[mended.triangles] == vertices[triangles[mended.origin]]).all(axis=(1, 2))
        self.assertEqual(mended.report["removed_triangles"], len(triangles) - whole.sum())
        self.assertTrue(set(change["triangles"]).isdisjoint(mended.origin[whole]))
        self.assertTrue(set(change["triangles"]).issuperset(mended.origin[~whole]))

    def test_leaves_a_valid_surface_as_it_is(self):
        vertices, triangles = plate()
        mended = repair_mesh(vertices, triangles)
        self.assertEqual(mended.report["changes"], [])
        np.testing.assert_array_equal(mended.vertices[mended.triangles], vertices[triangles])
        np.testing.assert_array_equal(mended.origin, np.arange(len(triangles)))

    def test_welds_over_a_stated_distance(self):
        vertices, triangles = plate()
        soup = vertices[triangles].reshape(-1, 3) + np.random.default_rng(1).uniform(-1e-3, 1e-3, (3 * len(triangles), 3))
        mended = repair_mesh(soup, np.arange(len(soup)).reshape(-1, 3), weld=0.01)
        self.assertEqual(mended.report["surface"]["rims"], 1)
        self.assertEqual(len(mended.vertices), len(vertices))
        self.assertEqual(mended.report["weld_distance_mm"], 0.01)

    def test_adds_strips_and_patches(self):
        vertices, triangles = plate()
        holed = np.delete(triangles, [45, 145], 0)  # a cell in the middle
        beside = vertices + [np.ptp(vertices[:, 0]) + 0.5, 0, 0]
        both = together((vertices, holed), (beside, triangles))
        mended = repair_mesh(*both, bridge=1, fill_holes=10)
        added = mended.origin < 0
        self.assertEqual(int(added.sum()), mended.report["added_triangles"])
        np.testing.assert_array_equal(mended.origin[~added], np.arange(len(both[1])))
        self.assertEqual((mended.report["strips"], mended.report["filled_holes"]), (1, 1))
        self.assertEqual(check_mesh(mended.vertices, mended.triangles)["defects"], [])
        solid = thicken_mesh(*both, 1, repair=True, bridge=1, fill_holes=10, method="sweep")
        self.assertEqual(int((solid.region == 0).sum()), len(mended.triangles))

    def test_check_tells_of_near_rims(self):
        vertices, triangles = plate()
        beside = vertices + [np.ptp(vertices[:, 0]) + 0.01, 0, 0]
        near = check_mesh(*together((vertices, triangles), (beside, triangles)))["near_rims"]
        self.assertGreater(near["corners"], 10)
        self.assertAlmostEqual(near["distance_mm"], 0.01, 4)

    def test_strict_refuses_what_lost_much(self):
        lost = repair_mesh(*TEE).report["removed_area_mm2"] / check_mesh(*TEE)["input"]["area_mm2"]
        self.assertGreater(lost, 0.05, "choose a surface that loses more")
        thicken_mesh(*TEE, 0.1, repair=True, method="sweep")
        with self.assertRaises(ThickenError) as caught:
            thicken_mesh(*TEE, 0.1, repair=True, strict=True, method="sweep")
        self.assertEqual(caught.exception.code, "no-solid")

    def test_divides_into_sheets(self):
        sheets = divide_into_sheets(*TEE)
        self.assertEqual([len(t) for _, t in sheets], [4, 2])
        for sheet in sheets:
            self.assertEqual(check_mesh(*sheet)["defects"], [])

    def test_thickens_the_repaired_surface(self):
        vertices, triangles = fin()
        mended = repair_mesh(vertices, triangles)
        self.assertEqual(len(mended.triangles), len(triangles) - 1)
        solid = thicken_mesh(vertices, triangles, 1, repair=True, precision="double")
        corners = solid.vertices[solid.triangles]
        self.assertTrue(is_closed_and_oriented(corners))
        self.assertTrue(keeps(corners, mended.vertices[mended.triangles]))
        self.assertEqual(solid.report["repair"]["removed_triangles"], 3)  # the fin, in as many parts
        self.assertIn("repaired", solid.report["warnings"][0])

    def test_errors_carry_what_is_known(self):
        with self.assertRaises(ThickenError) as caught:
            thicken_mesh(*together(fin(), plate()), 1)
        self.assertEqual(caught.exception.input["triangles"], len(fin()[1]) + len(plate()[1]))
        self.assertIsNone(caught.exception.repair)
        with self.assertRaises(ThickenError) as caught:
            repair_mesh([[0, 0, 0], [1, 1, 1], [2, 2, 2]], [[0, 1, 2]])
        self.assertEqual(caught.exception.code, "degenerate")
        with self.assertRaises(ThickenError) as caught:
            repair_mesh(*plate(), weld=-1)
        self.assertEqual(caught.exception.code, "usage")


if __name__ == "__main__":
    unittest.main()
