# SPDX-License-Identifier: LGPL-2.1-or-later
"""The macro cookbook and the OpenSCAD example, run as they are written."""

import re
import shutil
import subprocess
from pathlib import Path

import FreeCAD as App

import ThickenWorkbench
from thicken import native
from thicken_case import DocumentCase
from thicken_judge import is_closed_and_oriented, read_stl

PROJECT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


class Cookbook(DocumentCase):
    def test_every_block_runs(self):
        text = (PROJECT / "docs" / "macros.md").read_text()
        names = {"femur": str(PROJECT / "examples" / "data" / "femur.ply"), "folder": str(self.folder)}
        blocks = list(BLOCK.finditer(text))
        self.assertGreater(len(blocks), 10)
        for block in blocks:
            line = text[: block.start()].count("\n") + 2
            exec(compile("\n" * (line - 1) + block[1], "docs/macros.md", "exec"), names)
        self.doc = names["doc"]
        self.assertEqual([obj.Label for obj in self.doc.Objects if not obj.isValid()], [])
        self.assertEqual(names["drained"].Trapped, 0)
        self.assertEqual(names["with_solid"].Valid, True)
        self.assertTrue(names["holed"].isValid())
        written = sorted(path.name for path in self.folder.iterdir())
        self.assertEqual(written, ["bowl.3mf", "bowl.html", "bowl.json", "bowl.stl", "femur.ply"])

    def test_every_function_is_described(self):
        text = (PROJECT / "docs" / "macros.md").read_text() + (PROJECT / "docs" / "python.md").read_text()
        for name in ThickenWorkbench.__all__:
            if name[0].islower():
                self.assertIn(name, text)


class OpenScad(DocumentCase):
    EXAMPLE = PROJECT / "examples" / "openscad"

    def run_openscad(self, *arguments):
        program = shutil.which("openscad")
        if program is None:
            self.skipTest("no openscad: apt-get install openscad")
        run = subprocess.run([program, *arguments], capture_output=True, text=True, cwd=self.folder, timeout=240)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotRegex(run.stderr, r"(?i)error|not closed|not a valid 2-manifold")
        return run.stderr

    def test_surface_to_shell_to_model(self):
        self.run_openscad("-o", "bowl.stl", self.EXAMPLE / "surface.scad")
        names = {"__name__": "thicken_bowl", "__file__": str(self.EXAMPLE / "thicken_bowl.py")}
        exec((self.EXAMPLE / "thicken_bowl.py").read_text(), names)
        names["main"](self.folder / "bowl.stl", self.folder / "shell.stl", 1.6)
        corners = read_stl(self.folder / "shell.stl")
        self.assertTrue(is_closed_and_oriented(corners))
        told = self.run_openscad(
            "-o", "whole.stl", "-D", f'shell="{self.folder / "shell.stl"}"', self.EXAMPLE / "bowl.scad"
        )
        self.assertRegex(told, r"Simple:\s+yes")  # CGAL's word for a proper 2-manifold
        found = native.load().inspect(*ThickenWorkbench.read_mesh(self.folder / "whole.stl"))
        alone = native.load().inspect(*ThickenWorkbench.read_mesh(self.folder / "shell.stl"))
        self.assertGreater(found["volume_mm3"], alone["volume_mm3"] + 100)

    def test_the_lines_of_the_readme(self):
        text = (self.EXAMPLE / "README.md").read_text()
        for words in ("openscad -o bowl.stl surface.scad", "thicken_bowl.py bowl.stl shell.stl 1.6", "bowl.scad"):
            self.assertIn(words, text)
        for name in re.findall(r"\S+\.(?:scad|py)\b", text):
            self.assertTrue((self.EXAMPLE / name.strip("`")).is_file(), name)
        self.assertIsNotNone(App)
