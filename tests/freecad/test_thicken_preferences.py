# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preferences and what is predicted from them, and that the documents name every key and command."""

import ast
import unittest
from pathlib import Path

import ThickenWorkbench
from ThickenWorkbench import prediction, preferences
from thicken_case import DocumentCase
from thicken_surfaces import saddle

ROOT = Path(__file__).resolve().parents[2]


class Forecast(DocumentCase):
    def setUp(self):
        super().setUp()
        self.addCleanup(preferences.put, "SecondsPerTriangle", preferences.get("SecondsPerTriangle"))

    def test_memory_is_the_librarys_own_forecast(self):
        for side in ("negative", "positive", "both"):
            solid = ThickenWorkbench.thicken_mesh(*saddle(), 1.0, side=side)
            forecast = prediction.forecast(len(saddle()[1]), side)
            self.assertEqual(forecast.bytes, solid.report["memory"]["predicted_bytes"])

    def test_time_follows_the_runs(self):
        preferences.put("SecondsPerTriangle", 1e-4)
        self.assertAlmostEqual(prediction.forecast(10_000, "negative").seconds, 1)
        for _ in range(30):
            prediction.learn(10_000, "negative", 5.0)
        self.assertAlmostEqual(prediction.forecast(10_000, "negative").seconds, 5, delta=0.1)
        self.assertAlmostEqual(prediction.forecast(10_000, "both").seconds, 7.5, delta=0.1)

    def test_tiny_runs_teach_nothing(self):
        before = preferences.get("SecondsPerTriangle")
        prediction.learn(10, "negative", 3.0)
        self.assertEqual(preferences.get("SecondsPerTriangle"), before)

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
        tutorial = (ROOT / "docs" / "tutorial.md").read_text()
        pictures = list((ROOT / "docs" / "pictures").glob("*.png"))
        self.assertGreater(len(pictures), 5)
        for picture in pictures:
            self.assertIn(f"(pictures/{picture.name})", tutorial)
        self.assertEqual(tutorial.count("](pictures/"), len(pictures))
        self.assertLess(sum(picture.stat().st_size for picture in pictures), 1_500_000)
