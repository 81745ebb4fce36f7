# SPDX-License-Identifier: LGPL-2.1-or-later
"""`--thickness-map`: the solid, the report, and what is refused."""

import json
import unittest
from pathlib import Path

from json_schema import faults
from program_case import ProgramCase

SCHEMA = json.loads((Path(__file__).parents[2] / "docs/report.schema.json").read_text())
N = 12  # cells of 1 mm along each side


def write_sheet(path: Path, factor, seam: float = 0) -> None:
    """A flat sheet as text, with a factor for each vertex; triangles with corners of their own, of which those of the
    last triangle have `seam` more."""
    lines, faces = [], []
    for y in range(N):
        for x in range(N):
            for corners in (((x, y), (x + 1, y), (x + 1, y + 1)), ((x, y), (x + 1, y + 1), (x, y + 1))):
                more = seam if (x, y) == (N - 1, N - 1) else 0
                faces.append(f"3 {len(lines)} {len(lines) + 1} {len(lines) + 2}")
                lines += [f"{a} {factor(a) + more} {b} 0" for a, b in corners]
    header = ["ply", "format ascii 1.0", f"element vertex {len(lines)}", "property float x", "property float thick",
              "property float y", "property float z", f"element face {len(faces)}",
              "property list uchar int vertex_indices", "end_header"]  # fmt: skip
    path.write_text("\n".join(header + lines + faces) + "\n")


class Map(ProgramCase):
    def thicken(self, *options, source="in.ply", output="part.ply"):
        return self.run_program(source, output, "--thickness", 0.5, *options)

    def test_solid_is_as_thick_as_the_property_says(self):
        write_sheet(self.folder / "in.ply", lambda x: 1 + x / N)
        self.assert_ok(self.thicken("--thickness-map", "thick", "--report", "report.json"))
        report = self.report()
        self.assertEqual(faults(report, SCHEMA, SCHEMA), [])
        self.assertAlmostEqual(report["output"]["volume_mm3"], 0.75 * N * N, places=3)
        told = report["parameters"]["thickness_map"]
        self.assertAlmostEqual(told["least_mm"], 0.5, places=6)
        self.assertAlmostEqual(told["most_mm"], 1, places=6)
        self.assertEqual(told["lowered_vertices"], 0)

    def test_ones_change_no_byte(self):
        write_sheet(self.folder / "in.ply", lambda x: 1)
        self.assert_ok(self.thicken(output="plain.ply"))
        self.assert_ok(self.thicken("--thickness-map", "thick"))
        plain, mapped = (self.folder / name for name in ("plain.ply", "part.ply"))
        self.assertEqual(plain.read_bytes(), mapped.read_bytes())

    def test_what_makes_no_sense_is_refused(self):
        write_sheet(self.folder / "in.ply", lambda x: 1 + x / N)
        write_sheet(self.folder / "seam.ply", lambda x: 1 + x / N, seam=0.5)
        write_sheet(self.folder / "none.ply", lambda x: x - 3)
        (self.folder / "in.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        for source, name, sentence in (("in.ply", "thin", 'no property "thin"'), ("in.off", "thick", "only .ply files"),
                                       ("seam.ply", "thick", "different values"), ("none.ply", "thick", "positive")):  # fmt: skip
            with self.subTest(source=source, name=name):
                run = self.thicken("--thickness-map", name, source=source)
                self.assertNotEqual(run.returncode, 0)
                self.assertIn(sentence, run.stderr)
                self.assertFalse((self.folder / "part.ply").exists())


if __name__ == "__main__":
    unittest.main()
