# SPDX-License-Identifier: LGPL-2.1-or-later
"""render_picture() on arrays."""

import struct
import unittest
import zlib

import numpy as np

from thicken import render_picture, thicken_mesh, view_direction

SHEET = np.array([[0, 0, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0.0]]), np.array([[0, 1, 2], [0, 2, 3]])
RED, GREEN = (200, 0, 0), (0, 200, 0)
DOWN = {"towards": (0, 0, -1), "up": (0, 1, 0)}


def pixels(png: bytes) -> np.ndarray:
    """Rows of pixels of a PNG whose rows are stored less those above them."""
    width, height = struct.unpack(">II", png[16:24])
    data, at = b"", 8
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at : at + 8])
        data += png[at + 8 : at + 8 + size] if kind == b"IDAT" else b""
        at += 12 + size
    rows = np.frombuffer(zlib.decompress(data), np.uint8).reshape(height, 1 + 3 * width)
    assert (rows[:, 0] == 2).all()
    return np.cumsum(rows[:, 1:], axis=0, dtype=np.uint8).reshape(height, width, 3)


class Pictures(unittest.TestCase):
    def test_size_and_colours(self):
        image = pixels(render_picture(*SHEET, [RED, GREEN], size=(60, 40), **DOWN))
        self.assertEqual(image.shape, (40, 60, 3))
        self.assertEqual(image[0, 0].tolist(), [255, 255, 255])
        self.assertEqual(image[25, 35, 1:].tolist(), [0, 0])
        self.assertGreater(image[25, 35, 0], 150)
        self.assertGreater(image[15, 25, 1], 150)

    def test_regions_of_a_solid_have_colours_of_their_own(self):
        solid = thicken_mesh(*SHEET, 1)
        image = pixels(render_picture(solid.vertices, solid.triangles, region=solid.region, **DOWN))
        yellow = image[240, 320].astype(int)
        self.assertGreater(yellow[0] - yellow[2], 100)
        below = {"towards": (0, 0, 1), "up": (0, 1, 0)}
        blue = pixels(render_picture(solid.vertices, solid.triangles, region=solid.region, **below))[240, 320].astype(int)
        self.assertGreater(blue[2] - blue[0], 60)

    def test_a_cut_takes_away_what_is_nearer(self):
        solid = thicken_mesh(*SHEET, 1)
        towards = view_direction((0, 0, 1), 30, 35)
        whole, cut = (
            render_picture(solid.vertices, solid.triangles, size=(64, 48), towards=towards, cut=plane)
            for plane in (None, ((4, 4, 0), -towards))
        )
        self.assertNotEqual(whole, cut)

    def test_arguments_that_make_no_sense(self):
        for wrong in ({"size": (0, 4)}, {"up": (0, 0, 2), "towards": (0, 0, 1)}, {"colours": [RED] * 3},
                      {"colours": [[300, 0, 0]]}, {"colours": [RED], "region": [0, 1]}, {"region": [0, 7]},
                      {"cut": ((0, 0, 0), (0, 0, -1))}):  # fmt: skip
            with self.subTest(wrong), self.assertRaises((ValueError, RuntimeError)):
                render_picture(*SHEET, **wrong)


if __name__ == "__main__":
    unittest.main()
