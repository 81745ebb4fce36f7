# SPDX-License-Identifier: LGPL-2.1-or-later
"""3MF files: what is written, and what other programs make of it."""

import re
import shutil
import struct
import subprocess
import unittest
import zipfile

from program_case import ProgramCase
from surfaces import read_stl, wave, write_off

MODEL = """<?xml version="1.0"?><model unit="{unit}" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>
<object id="1"><mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh></object></resources>
<build><item objectid="1"/></build></model>"""
RELATIONSHIPS = """<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="a"
Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>"""


def volume(triangles) -> float:
    """Of a closed mesh, of triples of corners."""
    total = 0.0
    for (ax, ay, az), (bx, by, bz), (cx, cy, cz) in triangles:
        total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    return total / 6


class ThreeMf(ProgramCase):
    def setUp(self) -> None:
        super().setUp()
        write_off(self.folder / "in.off", wave(6))

    def thicken(self, *options, output="out.3mf"):
        self.assert_ok(self.run_program("in.off", output, "--thickness", 1, "--report", "report.json", *options))
        return self.report()["output"]

    def write_3mf(self, unit: str, points, triangles) -> None:
        vertices = "".join(f'<vertex x="{x!r}" y="{y!r}" z="{z!r}"/>' for x, y, z in points)
        corners = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in triangles)
        with zipfile.ZipFile(self.folder / "in.3mf", "w") as archive:
            archive.writestr("_rels/.rels", RELATIONSHIPS)
            archive.writestr("3D/3dmodel.model", MODEL.format(unit=unit, vertices=vertices, triangles=corners))

    def test_what_is_written_is_read_again(self):
        made = self.thicken("--colours")
        again = self.run_program("check", "out.3mf")
        self.assert_ok(again)
        self.assertIn(f"closed surface of {made['triangles']} triangles", again.stdout)

    def test_regions_are_colours_and_there_is_a_thumbnail(self):
        made = self.thicken("--colours")
        with zipfile.ZipFile(self.folder / "out.3mf") as archive:
            model = archive.read("3D/3dmodel.model").decode()
            thumbnail = archive.read("Metadata/thumbnail.png")
        counts = [len(re.findall(f'p1="{k}"', model)) for k in range(3)]
        self.assertEqual(counts, [made[f"{name}_triangles"] for name in ("original", "shell", "wall")])
        self.assertEqual(struct.unpack(">II", thumbnail[16:24]), (256, 256))
        self.thicken()
        with zipfile.ZipFile(self.folder / "out.3mf") as archive:
            self.assertNotIn("p1=", archive.read("3D/3dmodel.model").decode())

    def test_the_unit_of_the_file_counts(self):
        points, triangles = wave(6)
        self.write_3mf("inch", [[x / 25.4 for x in p] for p in points], triangles)
        self.assert_ok(self.run_program("check", "in.3mf", "--report", "a.json"))
        self.assert_ok(self.run_program("check", "in.off", "--report", "b.json"))
        areas = [self.report(name)["input"]["area_mm2"] for name in ("a.json", "b.json")]
        self.assertAlmostEqual(areas[0] / areas[1], 1, places=9)
        run = self.run_program("check", "in.3mf", "--unit", "m")
        self.assertIn("names its unit itself", self.assert_fails(run, 2, "usage"))

    def test_colours_are_for_3mf(self):
        run = self.run_program("in.off", "out.stl", "--thickness", 1, "--colours")
        self.assertIn(".3mf", self.assert_fails(run, 2, "usage"))

    def test_prusa_slicer_reads_it(self):
        slicer = shutil.which("prusa-slicer")
        if not slicer:
            self.skipTest("there is no prusa-slicer")
        made = self.thicken("--colours")
        read = subprocess.run([slicer, "--info", "out.3mf"], cwd=self.folder, capture_output=True, text=True, timeout=250)
        told = dict(re.findall(r"(\w+) = (\S+)", read.stdout))
        self.assertEqual(told.get("number_of_facets"), str(made["triangles"]), read.stdout + read.stderr)
        self.assertEqual(told["manifold"], "yes")
        self.assertAlmostEqual(float(told["volume"]) / made["volume_mm3"], 1, places=4)

    def test_openscad_reads_it(self):
        openscad = shutil.which("openscad")
        if not openscad:
            self.skipTest("there is no openscad")
        made = self.thicken("--colours")
        (self.folder / "a.scad").write_text('import("out.3mf");')
        read = subprocess.run([openscad, "-o", "a.stl", "a.scad"], cwd=self.folder, capture_output=True, text=True,
                              timeout=250)  # fmt: skip
        if "was built without" in read.stderr or "not compiled with" in read.stderr:
            self.skipTest("this openscad reads no 3MF")
        self.assertEqual(read.returncode, 0, read.stderr)
        text = (self.folder / "a.stl").read_bytes()
        if text.startswith(b"solid"):
            numbers = [tuple(map(float, v)) for v in re.findall(rb"vertex (\S+) (\S+) (\S+)", text)]
            triangles = [numbers[i : i + 3] for i in range(0, len(numbers), 3)]
        else:
            triangles = read_stl(self.folder / "a.stl")
        self.assertAlmostEqual(volume(triangles) / made["volume_mm3"], 1, places=3)


if __name__ == "__main__":
    unittest.main()
