# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saving and reopening."""

import os
import zipfile
from pathlib import Path
from unittest import mock

import FreeCAD as App
import numpy as np

import ThickenWorkbench
from thicken import native
from ThickenWorkbench import drain_holes, mesh_io, params, repair_feature
from ThickenWorkbench.part_solid import PartSolidFeature
from thicken_case import DocumentCase
from thicken_surfaces import crossing_plates, fin, plate, saddle, together
from test_thicken_part_solid import box

PLACEMENT = App.Placement(App.Vector(1.1, 2.2, 3.3), App.Rotation(App.Vector(0, 0, 1), 12))


def values(feature) -> dict:
    """All that the feature's own properties hold, in comparable form."""
    result = {}
    for prop in [*params.INPUTS, *params.RESULTS]:
        value = getattr(feature, prop.name)
        value = getattr(value, "Name", None) or getattr(value, "Value", value)
        # FreeCAD writes some of its numbers with 12 digits.
        result[prop.name] = float(f"{value:.9g}") if isinstance(value, float) else value
    result["ThinnestPlace"] = [float(f"{x:.9g}") for x in feature.ThinnestPlace]
    return result


class SaveAndReopen(DocumentCase):
    def reopened(self):
        path = self.folder / "part.FCStd"
        self.doc.saveAs(str(path))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(str(path))
        return self.doc.getObject("Thicken")

    def make(self):
        source = self.add_source(saddle())
        source.Placement = PLACEMENT
        return ThickenWorkbench.make_thicken(self.doc, source, thickness=1.25, side="positive", tolerance=0.4)

    def test_values_and_mesh_are_the_same(self):
        feature = self.make()
        self.assert_solid(feature)
        before, mesh_before = values(feature), mesh_io.arrays_from_mesh(feature.Mesh)
        feature = self.reopened()
        self.assertEqual(values(feature), before)
        for array, array_before in zip(mesh_io.arrays_from_mesh(feature.Mesh), mesh_before):
            self.assertEqual(array.tobytes(), array_before.tobytes())
        for number, saved in zip(feature.Placement.toMatrix().A, PLACEMENT.toMatrix().A):
            self.assertAlmostEqual(number, saved, places=12)
        self.assert_solid(feature)
        self.assertNotIn("Touched", feature.State)

    def test_reopened_feature_recomputes(self):
        self.make()
        feature = self.reopened()
        volume = feature.Volume.Value
        feature.Thickness = 2.5
        self.doc.recompute()
        self.assert_solid(feature)
        self.assertGreater(feature.Volume.Value, 1.5 * volume)
        self.doc.getObject("Scan").Mesh = mesh_io.mesh_from_arrays(*plate())
        self.doc.recompute()
        self.assert_solid(feature)
        self.assertAlmostEqual(feature.Volume.Value, 20 * 20 * 2.5, places=6)

    def test_recomputing_gives_the_same_bytes(self):
        feature = self.make()
        before = mesh_io.arrays_from_mesh(feature.Mesh)
        feature = self.reopened()
        feature.ComputedFor = ""
        feature.touch()
        self.doc.recompute()
        for array, array_before in zip(mesh_io.arrays_from_mesh(feature.Mesh), before):
            self.assertEqual(array.tobytes(), array_before.tobytes())

    def test_editor_modes_and_schema(self):
        self.make()
        feature = self.reopened()
        self.assertEqual(feature.SchemaVersion, params.SCHEMA_VERSION)
        self.assertNotIn("Hidden", feature.getEditorMode("Tolerance"))
        self.assertIn("Hidden", feature.getEditorMode("Cell"))
        self.assertIn("ReadOnly", feature.getEditorMode("Volume"))

    def test_refused_feature_is_saved_without_a_mesh(self):
        feature = self.make()
        self.doc.getObject("Scan").Mesh = mesh_io.mesh_from_arrays(*fin())
        self.doc.recompute()
        self.assert_refused(feature)
        feature = self.reopened()
        self.assertEqual(feature.Mesh.CountFacets, 0)
        self.assertFalse(feature.Valid)
        self.doc.getObject("Scan").Mesh = mesh_io.mesh_from_arrays(*plate())
        self.doc.recompute()
        self.assert_solid(feature)

    def test_file_names_the_frozen_class(self):
        self.make()
        self.reopened()
        with zipfile.ZipFile(self.folder / "part.FCStd") as archive:
            text = archive.read("Document.xml").decode()
        self.assertIn('module="ThickenWorkbench.feature"', text)
        self.assertIn('class="ThickenFeature"', text)

    def test_older_feature_gets_the_properties_that_it_lacks(self):
        feature = self.make()
        for name in ("ThinShare", "Repair"):
            feature.setPropertyStatus(name, "-LockDynamic")
            feature.removeProperty(name)
        feature = self.reopened()
        self.assertEqual((feature.ThinShare, feature.Repair), (0, False))
        feature.touch()
        self.doc.recompute()
        self.assert_solid(feature)

    def test_copy_in_the_document(self):
        feature = self.make()
        copy = self.doc.copyObject(feature, False)
        copy.Thickness = 0.5
        self.doc.recompute()
        self.assert_solid(copy)
        self.assertLess(copy.Volume.Value, feature.Volume.Value)
        self.assertTrue(np.isclose(feature.Thickness.Value, 1.25))

    def test_opens_without_the_extension(self):
        triangles = self.make().TriangleCount
        with mock.patch.object(native, "_loaded", None):
            with mock.patch.dict(os.environ, {native.DIRECTORY_VARIABLE: str(self.folder)}):
                feature = self.reopened()
                self.assertEqual(feature.Mesh.CountFacets, triangles)
                self.assert_solid(feature)


class Locked(DocumentCase):
    def test_properties_cannot_be_deleted_by_the_user(self):
        feature = ThickenWorkbench.make_thicken(self.doc, self.add_source(plate()), 1)
        for name in ("Thickness", "Source", "SchemaVersion"):
            self.assertIn("LockDynamic", [str(word) for word in feature.getPropertyStatus(name)], name)
        self.assertNotIn("LockDynamic", [str(word) for word in feature.getPropertyStatus("Mesh")])


class OlderDocuments(DocumentCase):
    """One document of every schema there has been, made by make_fixtures(): "thicken" with a Thicken feature, "others"
    with the other kinds."""

    FIXTURES = Path(__file__).parent / "fixtures"
    OTHERS = {
        "DrainHoles": drain_holes.DrainHolesFeature,
        "Plugs": drain_holes.PlugFeature,
        "Repair": repair_feature.RepairFeature,
        "HollowSolid": PartSolidFeature,
    }

    def documents(self, kind):
        return sorted(self.FIXTURES.glob(f"{kind}_*.FCStd"))

    def test_every_schema_has_a_document(self):
        latest = max(proxy.schema for proxy in self.OTHERS.values())
        for kind, schema in (("schema", params.SCHEMA_VERSION), ("others", latest)):
            names = [path.name for path in self.documents(kind)]
            self.assertEqual(names, [f"{kind}_{n}.FCStd" for n in range(1, schema + 1)])

    def test_they_open_and_recompute(self):
        for path in self.documents("schema"):
            with self.subTest(path.name):
                doc = App.openDocument(str(path))
                feature = doc.getObject("Thicken")
                self.assertEqual(feature.SchemaVersion, params.SCHEMA_VERSION)
                self.assertEqual((feature.Thickness.Value, feature.Side), (1.5, "Positive"))
                self.assertEqual((feature.Quality, feature.Join), ("Standard", "Automatic"))
                self.assertEqual(feature.getEnumerationsOfProperty("Quality"), list(params.QUALITY_NUMBER))
                self.assert_solid(feature)
                feature.Thickness = 1
                doc.recompute()
                self.assert_solid(feature)
                self.assertAlmostEqual(feature.Volume.Value, 100, places=6)

    def test_those_of_the_other_kinds_do_as_well(self):
        for path in self.documents("others"):
            doc = App.openDocument(str(path))
            for name, proxy in self.OTHERS.items():
                with self.subTest(f"{path.name}, {name}"):
                    feature = doc.getObject(name)
                    self.assertIsInstance(feature.Proxy, proxy)
                    self.assertEqual(feature.SchemaVersion, proxy.schema)
                    feature.touch()
                    doc.recompute()
                    self.assertTrue(feature.isValid(), feature.getStatusString())
            self.assertEqual((doc.DrainHoles.HoleCount, doc.DrainHoles.Count), (2, 2))
            self.assertTrue(doc.Plugs.Mesh.isSolid())
            self.assertEqual(doc.Repair.Weld.Value, 0.25)
            self.assertAlmostEqual(doc.HollowSolid.Shape.Volume, 20**3 - 16**3, places=6)

    def test_a_document_from_before_there_were_schemas(self):
        made = ThickenWorkbench.make_repair(self.doc, self.add_source(plate()))
        made.setPropertyStatus("SchemaVersion", "-LockDynamic")
        made.removeProperty("SchemaVersion")
        self.doc.saveAs(str(self.folder / "old.FCStd"))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(str(self.folder / "old.FCStd"))
        self.assertEqual(self.doc.Repair.SchemaVersion, 1)

    def test_a_newer_programs_document_keeps_its_number(self):
        made = ThickenWorkbench.make_repair(self.doc, self.add_source(plate()))
        made.SchemaVersion = 99
        made.Proxy.onDocumentRestored(made)
        self.assertEqual(made.SchemaVersion, 99)


def make_fixtures() -> None:
    """Write the documents of the present schemas; to be called once, before the next ones are begun."""
    doc = App.newDocument("Fixture")
    source = doc.addObject("Mesh::Feature", "Scan")
    source.Mesh = mesh_io.mesh_from_arrays(*plate(size=10, n=4))
    ThickenWorkbench.make_thicken(doc, source, thickness=1.5, side="positive")
    OlderDocuments.FIXTURES.mkdir(exist_ok=True)
    doc.saveAs(str(OlderDocuments.FIXTURES / f"schema_{params.SCHEMA_VERSION}.FCStd"))
    doc = App.newDocument("Others")
    hollow, scan = (doc.addObject("Mesh::Feature", name) for name in ("Hollow", "Scan"))
    hollow.Mesh = mesh_io.mesh_from_arrays(*together(box((0, 0, 0), (20, 20, 20)), box((2, 2, 2), (18, 18, 18), inward=True)))
    scan.Mesh = mesh_io.mesh_from_arrays(*crossing_plates())
    ThickenWorkbench.make_drain_holes(doc, hollow, 3, count=2, plug=True)
    ThickenWorkbench.make_repair(doc, scan, 0.25)
    ThickenWorkbench.make_part_solid(doc, hollow)
    schema = max(proxy.schema for proxy in OlderDocuments.OTHERS.values())
    doc.saveAs(str(OlderDocuments.FIXTURES / f"others_{schema}.FCStd"))
