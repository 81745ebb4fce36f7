# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export for printing, and what is reported before it."""

import json
import re
import shutil
import subprocess
import zipfile
from pathlib import Path
from unittest import mock

import FreeCAD as App
import Mesh
import numpy as np
import Part

import ThickenWorkbench
from thicken import native
from ThickenWorkbench import mesh_io
from ThickenWorkbench.export import read_back
from ThickenWorkbench.sources import RefusedError
from thicken_case import DocumentCase
from thicken_judge import is_closed_and_oriented, keys, read_stl, volume
from thicken_surfaces import plate, saddle, together
from test_thicken_part_solid import box

PLACEMENT = App.Placement(App.Vector(10, -20, 30), App.Rotation(App.Vector(1, 1, 0), 70))


def hollow_box(case, wall=2.0):
    low, high = wall, 20 - wall
    inner = box((low, low, low), (high, high, high), inward=True)
    return case.add_source(together(box((0, 0, 0), (20, 20, 20)), inner), "Hollow")


class Export(DocumentCase):
    def test_stl_has_the_bits_of_the_mesh(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1)
        path = self.folder / "part.stl"
        facts = ThickenWorkbench.export_for_printing(feature, path)
        vertices, triangles = mesh_io.arrays_from_mesh(feature.Mesh)
        self.assertEqual(keys(read_stl(path)), keys(vertices[triangles]))
        self.assertEqual((facts["triangles"], facts["shells"]), (feature.TriangleCount, 1))
        self.assertAlmostEqual(facts["volume_ml"], feature.Volume.Value / 1000, places=9)

    def test_3mf_is_in_millimetres_and_exact(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(saddle()), 1)
        path = self.folder / "part.3mf"
        ThickenWorkbench.export_for_printing(feature, path)
        with zipfile.ZipFile(path) as archive:
            self.assertIn(b'unit="millimeter"', archive.read("3D/3dmodel.model"))
        vertices, triangles = mesh_io.arrays_from_mesh(feature.Mesh)
        read, corners = read_back(path)
        np.testing.assert_array_equal(read[corners], vertices[triangles].astype(float))

    def test_placement_is_exported(self):
        source = hollow_box(self)
        source.Placement = PLACEMENT
        path = self.folder / "part.stl"
        ThickenWorkbench.export_for_printing(source, path)
        corners = read_stl(path)
        self.assertTrue(is_closed_and_oriented(corners))
        self.assertAlmostEqual(volume(corners), 20**3 - 16**3, delta=0.01)
        box_of = source.Mesh.BoundBox
        np.testing.assert_allclose(corners.reshape(-1, 3).min(axis=0), [box_of.XMin, box_of.YMin, box_of.ZMin], atol=1e-4)

    def test_part_solid(self):
        sphere = self.doc.addObject("Part::Feature", "Sphere")
        sphere.Shape = Part.makeSphere(5)
        facts = ThickenWorkbench.export_for_printing(sphere, self.folder / "s.stl", deflection=0.01)
        self.assertAlmostEqual(facts["volume_ml"], 4 / 3 * np.pi * 0.125, delta=0.002)

    def test_invalid_solid_is_not_written(self):
        for surface in (plate(), saddle()):
            path = self.folder / "open.stl"
            with self.assertRaisesRegex(RefusedError, "not a valid solid.*one side"):
                ThickenWorkbench.export_for_printing(self.add_source(surface), path)
            self.assertEqual(list(self.folder.iterdir()), [])

    def test_damaged_file_does_not_get_its_name(self):
        path = self.folder / "part.stl"
        path.write_text("an earlier file")
        solid = hollow_box(self)

        def spoilt(written):
            vertices, triangles = read_back(written)
            return vertices, triangles[1:]

        with mock.patch("ThickenWorkbench.export.read_back", spoilt):
            with self.assertRaisesRegex(RefusedError, "once it is written"):
                ThickenWorkbench.export_for_printing(solid, path)
        self.assertEqual(path.read_text(), "an earlier file")
        self.assertEqual(list(self.folder.iterdir()), [path])

    def test_wrong_paths(self):
        solid = hollow_box(self)
        with self.assertRaisesRegex(ValueError, r"\.stl or \.3mf"):
            ThickenWorkbench.export_for_printing(solid, self.folder / "part.obj")
        with self.assertRaises(OSError):
            ThickenWorkbench.export_for_printing(solid, self.folder / "none" / "part.stl")


class Printability(DocumentCase):
    def test_facts_of_a_hollow_box(self):
        facts = ThickenWorkbench.printability(hollow_box(self), minimum_wall=1)
        self.assertTrue(facts["valid"])
        self.assertAlmostEqual(facts["volume_ml"], (20**3 - 16**3) / 1000, places=9)
        (cavity,) = facts["trapped"]
        self.assertAlmostEqual(cavity["volume_ml"], 16**3 / 1000, places=9)
        self.assertAlmostEqual(cavity["lowest_place_mm"][2], 2, places=9)
        self.assertAlmostEqual(facts["trapped_volume_ml"], 4.096, places=9)
        self.assertAlmostEqual(facts["thinnest_wall"]["mm"], 2, places=9)
        self.assertEqual(facts["thinnest_wall"]["share_below_minimum"], 0)
        self.assertEqual(facts["bounding_box"]["size_mm"], [20, 20, 20])
        # the ceiling of the cavity hangs over; the bottom stands on the plate
        self.assertAlmostEqual(facts["overhang"]["area_mm2"], 256, places=6)
        self.assertAlmostEqual(facts["overhang"]["on_plate_mm2"], 400, places=6)
        self.assertFalse(facts["printable"])
        self.assertRegex(" ".join(facts["warnings"]), r"traps 4\.1 mL.*drain holes")
        json.dumps(facts)

    def test_a_link_is_measured_where_it_is(self):
        cube = self.doc.addObject("Mesh::Feature", "Cube")
        cube.Mesh = Mesh.createBox(10, 10, 10)
        cube.Placement.Base = App.Vector(0, 0, 7)
        part = self.doc.addObject("App::Part", "Part")
        part.Placement.Base = App.Vector(1000, 0, 0)
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = cube
        link.Placement = App.Placement(App.Vector(0, 200, 0), App.Rotation(App.Vector(0, 0, 1), 90))
        part.addObject(link)
        self.doc.recompute()
        low, high = (ThickenWorkbench.printability(link)["bounding_box"][key] for key in ("low_mm", "high_mm"))
        np.testing.assert_allclose(np.add(low, high) / 2, (1000, 200, 0), atol=1e-4)
        facts = ThickenWorkbench.export_for_printing(link, self.folder / "link.stl")
        self.assertAlmostEqual(facts["volume_ml"], 1, places=5)
        link.Scale = 2
        with self.assertRaisesRegex(RefusedError, "a link that scales"):
            ThickenWorkbench.printability(link)

    def test_drained_and_thick_enough_is_printable(self):
        drained = ThickenWorkbench.make_drain_holes(self.doc, hollow_box(self), 4)
        facts = ThickenWorkbench.printability(drained)
        self.assertEqual((facts["trapped"], facts["warnings"], facts["printable"]), ([], [], True))

    def test_thin_walls(self):
        facts = ThickenWorkbench.printability(hollow_box(self), minimum_wall="2.5 mm")
        self.assertAlmostEqual(facts["thinnest_wall"]["share_below_minimum"], 1, places=9)
        self.assertRegex(" ".join(facts["warnings"]), "thinner than 2.5 mm")

    def test_direction_and_placement(self):
        solid = hollow_box(self)
        solid.Placement = App.Placement(App.Vector(0, 0, 100), App.Rotation())
        facts = ThickenWorkbench.printability(solid, direction=(0, -2, 0))
        self.assertAlmostEqual(facts["trapped"][0]["lowest_place_mm"][1], 18, places=5)
        self.assertAlmostEqual(facts["bounding_box"]["low_mm"][2], 100, places=5)
        self.assertAlmostEqual(facts["bounding_box"]["height_mm"], 20, places=5)

    def test_what_is_no_solid(self):
        facts = ThickenWorkbench.printability(self.add_source(plate()))
        self.assertEqual((facts["valid"], facts["printable"]), (False, False))
        self.assertIn("one side", facts["defects"][0])
        with self.assertRaises(RefusedError):
            ThickenWorkbench.printability(self.doc.addObject("Mesh::Feature", "Empty"))
        for wrong in ({"direction": (0, 0, 0)}, {"minimum_wall": 0}):
            with self.assertRaises(ValueError):
                ThickenWorkbench.printability(hollow_box(self), **wrong)

    def test_report_is_one_page_with_pictures(self):
        facts = ThickenWorkbench.write_report(hollow_box(self), self.folder / "box.html", minimum_wall=1)
        self.assertEqual(json.loads((self.folder / "box.json").read_text()), facts)
        text = (self.folder / "box.html").read_text()
        self.assertEqual(text.count("data:image/png;base64,"), 4)
        self.assertIn("4.096 mL", text)
        self.assertNotRegex(text, r'(src|href)="(?!data:)')

    def test_pictures_show_the_solid(self):
        import base64
        import io

        from PIL import Image

        ThickenWorkbench.write_report(hollow_box(self), self.folder / "box.html")
        pictures = re.findall(r'base64,([^"]+)"', (self.folder / "box.html").read_text())
        whole, _, cut, _ = (np.array(Image.open(io.BytesIO(base64.b64decode(p))), int) for p in pictures)
        share = (whole != 255).any(axis=2).mean()
        self.assertTrue(0.3 < share < 0.8, share)
        self.assertEqual(tuple(whole[0, 0]), (255, 255, 255))
        # the cut shows the cavity in red, and around it the material as a frame of 2 in 20
        red = (cut[:, :, 0] > 1.6 * cut[:, :, 1]).sum()
        frame = (np.abs(cut - (70, 74, 82)).max(axis=2) < 12).sum()
        self.assertAlmostEqual(frame / (frame + red), 1 - 0.8**2, delta=0.04)

    def test_json_alone(self):
        ThickenWorkbench.write_report(self.add_source(plate()), self.folder / "plate.json")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["plate.json"])

    def test_page_of_what_is_no_solid(self):
        ThickenWorkbench.write_report(self.add_source(plate()), self.folder / "plate.html")
        self.assertIn("no valid solid", (self.folder / "plate.html").read_text())


class StartUp(DocumentCase):
    def test_nothing_is_loaded_before_it_is_used(self):
        """Importing the package loads neither NumPy nor the extension nor a FreeCAD module."""
        code = (
            "import sys; before = set(sys.modules); import ThickenWorkbench; "
            "print(sorted(set(sys.modules) - before - {'ThickenWorkbench', 'importlib', '__future__', 'typing', 'types'}))"
        )
        root = str(Path(__file__).resolve().parents[2])
        python = shutil.which("python3", path="/usr/bin") or shutil.which("python3")
        run = subprocess.run([python, "-S", "-c", code], capture_output=True, text=True, cwd=root)
        self.assertEqual(run.returncode, 0, run.stderr)
        loaded = run.stdout
        for heavy in ("numpy", "FreeCAD", "ThickenWorkbench."):
            self.assertNotIn(heavy, loaded)

    def test_functions_with_the_name_of_their_module(self):
        from ThickenWorkbench.thickness_map import ThicknessMap

        self.assertTrue(callable(ThickenWorkbench.thickness_map))
        for name in ThickenWorkbench.__all__:
            self.assertTrue(callable(getattr(ThickenWorkbench, name)), name)
        self.assertIsNotNone(ThicknessMap)
        self.assertIsNotNone(native)
