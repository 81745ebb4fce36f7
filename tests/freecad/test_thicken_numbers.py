# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers for readers, and volumes below a level."""

import unittest
from unittest import mock

import numpy as np

from ThickenWorkbench import numbers
from ThickenWorkbench.core.drain_pools import volume_below
from test_thicken_part_solid import box


class Shown(unittest.TestCase):
    def test_few_digits_and_no_powers_of_ten(self):
        for value, text in ((0, "0"), (2.0, "2"), (69.325, "69.3"), (303628.4, "304,000"), (6.7e-5, "0.0001"), (1e-7, "0"),
                            (-1e-9, "0"), (0.00366, "0.0037"), (float("nan"), "–")):  # fmt: skip
            self.assertEqual(numbers.number(value), text, value)
        self.assertEqual(numbers.count(303628), "303,628")

    def test_hardly_any_per_cent_is_not_none(self):
        self.assertEqual([numbers.percent(share) for share in (0, 6.7e-7, 0.0042, 0.5, 0.997, 1)],
                         ["0 %", "< 0.01 %", "0.42 %", "50 %", "> 99 %", "100 %"])  # fmt: skip

    def test_marks_of_the_language(self):
        with mock.patch.object(numbers, "_marks", return_value=(",", ".")):
            self.assertEqual(numbers.number(1234.5, 5), "1.234,5")
            self.assertEqual(numbers.place((1.5, 2, -3)), "(1,5; 2; -3) mm")
            self.assertEqual(numbers.percent(1e-9), "< 0,01 %")


class Below(unittest.TestCase):
    def test_of_a_box(self):
        vertices, triangles = box((0, 0, 0), (2, 3, 5))
        corners = np.asarray(vertices, float)[triangles]
        for level, volume in ((-1, 0), (0, 0), (1, 6), (2.5, 15), (5, 30), (9, 30)):
            self.assertAlmostEqual(volume_below(corners, np.array([0.0, 0, 1]), level), volume, places=9)
        slanted = np.array([1.0, 0, 1]) / 2**0.5
        self.assertAlmostEqual(volume_below(corners, slanted, 2**0.5), 6, places=9)  # half of a cube of 2 mm, 3 mm long
        self.assertAlmostEqual(volume_below(corners[:, ::-1], slanted, 2**0.5), 6, places=9)
