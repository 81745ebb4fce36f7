# SPDX-License-Identifier: LGPL-2.1-or-later
"""The macros that the project ships, and what the documents say of the feature."""

import inspect
from pathlib import Path

import ThickenWorkbench
from ThickenWorkbench import params
import thicken_judge
from thicken_case import DocumentCase
from thicken_surfaces import fin, plate, saddle

MACROS = Path(__file__).resolve().parents[2] / "examples" / "macros"


def run(name: str) -> None:
    path = MACROS / name
    exec(compile(path.read_text(), str(path), "exec"), {"__name__": "__main__"})


class Macros(DocumentCase):
    def test_thicken_all_meshes(self):
        self.doc.saveAs(str(self.folder / "parts.FCStd"))
        for name, surface in [("Plate", plate()), ("Fin", fin()), ("Saddle", saddle())]:
            self.add_source(surface, name)
        run("thicken_all_meshes.FCMacro")
        for name in ("Plate", "Saddle"):
            self.assert_solid(self.doc.getObject(f"{name}_solid"))
            corners = thicken_judge.read_stl(self.folder / f"{name}_solid.stl")
            self.assertTrue(thicken_judge.is_closed_and_oriented(corners))
        self.assert_refused(self.doc.getObject("Fin_solid"))
        self.assertFalse((self.folder / "Fin_solid.stl").exists())
        count = len(self.doc.Objects)
        run("thicken_all_meshes.FCMacro")
        self.assertEqual(len(self.doc.Objects), count, "made twice")

    def test_compare_thicknesses(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(plate()), thickness=1.5)
        run("compare_thicknesses.FCMacro")
        self.assertEqual(feature.Thickness.Value, 1.5)
        self.assert_solid(feature)

    def test_every_macro_is_tested(self):
        tested = Path(__file__).read_text()
        names = [path.name for path in MACROS.glob("*.FCMacro")]
        self.assertGreater(len(names), 0)
        for name in names:
            self.assertIn(f'run("{name}")', tested)


class Documents(DocumentCase):
    def test_every_property_is_described(self):
        text = (MACROS.parents[1] / "docs" / "freecad.md").read_text()
        for prop in [*params.INPUTS, *params.RESULTS]:
            self.assertIn(f"`{prop.name}`", text)
        for word in [*params.SIDES, *params.METHODS, *params.QUALITY_NUMBER]:
            self.assertIn(f"`{word}`", text)

    def test_signature_is_described(self):
        text = " ".join((MACROS.parents[1] / "docs" / "freecad.md").read_text().split())
        for name in inspect.signature(ThickenWorkbench.make_thicken).parameters:
            self.assertRegex(text, rf"make_thicken\([^)]*\b{name}\b")
