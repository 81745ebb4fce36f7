# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preferences and what is predicted from them, and that the documents name every key and command."""

import ast
import re
import unittest
from pathlib import Path

import ThickenWorkbench
from ThickenWorkbench import prediction, preferences
from thicken.arrays import SurfaceSize, size_of
from thicken_case import DocumentCase
from thicken_surfaces import saddle

ROOT = Path(__file__).resolve().parents[2]


class Forecast(DocumentCase):
    size = SurfaceSize(10_000, 400.0, 30.0)

    def setUp(self):
        super().setUp()
        self.addCleanup(preferences.put, "TimesForecast", preferences.get("TimesForecast"))
        preferences.put("TimesForecast", 1.0)

    def test_it_is_the_librarys_own(self):
        for side in ("negative", "positive", "both"):
            solid = ThickenWorkbench.thicken_mesh(*saddle(), 1.0, side=side)
            told = prediction.forecast([size_of(*saddle())], {"thickness": 1.0, "side": side})
            self.assertLessEqual(told.bytes, solid.report["memory"]["predicted_bytes"])
            self.assertAlmostEqual(told.seconds / solid.report["predicted_seconds"], 1)

    def test_it_goes_with_area_thickness_and_cells(self):
        def seconds(size=self.size, **arguments):
            return prediction.forecast([size], {"thickness": 1.0, **arguments}).seconds

        self.assertGreater(seconds(size=self.size._replace(triangles=20_000)), seconds())
        self.assertGreater(seconds(method="reconstruct", size=self.size._replace(area=800.0)), seconds(method="reconstruct"))
        self.assertGreater(seconds(method="reconstruct", thickness=0.5), seconds(method="reconstruct"))
        self.assertGreater(seconds(method="reconstruct", cell=0.05), seconds(method="reconstruct", cell=0.1))
        self.assertGreater(seconds(method="reconstruct", resolution=512), seconds(method="reconstruct", resolution=256))

    def test_time_follows_the_runs(self):
        arguments = {"thickness": 1.0}
        before = prediction.forecast([self.size], arguments).seconds
        for _ in range(30):
            prediction.learn(self.size, arguments, 5 * before)
        self.assertAlmostEqual(prediction.forecast([self.size], arguments).seconds / before, 5, delta=0.1)
        self.assertAlmostEqual(prediction.forecast([self.size, self.size], arguments).seconds / before, 10, delta=0.2)

    def test_tiny_runs_teach_nothing(self):
        prediction.learn(self.size._replace(triangles=10), {"thickness": 1.0}, 3.0)
        self.assertEqual(preferences.get("TimesForecast"), 1.0)

    def test_sentences_are_short(self):
        shown = [prediction.Forecast(seconds, 123_456_789).sentence() for seconds in (0.042, 12.3, 600)]
        self.assertEqual(shown, [("0.04 s", "123 MB"), ("12 s", "123 MB"), ("10 min", "123 MB")])


class Documents(unittest.TestCase):
    text = (ROOT / "docs" / "freecad.md").read_text()

    def test_every_preference_is_described(self):
        for preference in preferences.PREFERENCES:
            self.assertIn(f"`{preference.key}`", self.text)

    def test_every_command_is_described(self):
        """The names are read from the source: the module needs windows."""
        source = (ROOT / "ThickenWorkbench" / "gui" / "commands.py").read_text()
        menus = [
            node.value.args[1].value
            for node in ast.walk(ast.parse(source))
            if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call)
            if getattr(node.targets[0], "id", None) == "menu"
        ]
        self.assertGreater(len(menus), 6)
        for menu in menus:
            self.assertIn(f"| *{menu.removesuffix('...')}* |", self.text)

    def test_every_picture_is_there_and_small(self):
        pages = "".join(page.read_text() for page in (ROOT / "docs").glob("*.md"))
        pictures = list((ROOT / "docs" / "pictures").glob("*.png"))
        self.assertGreater(len(pictures), 5)
        shown = set(re.findall(r"\]\(pictures/([^)]+)\)", pages))
        self.assertEqual(shown, {picture.name for picture in pictures})
        self.assertLess(sum(picture.stat().st_size for picture in pictures), 1_500_000)
