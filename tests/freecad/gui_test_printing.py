# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a solid to the printer: drain holes, the report, the export; saved and opened again between."""

import FreeCAD as App
import FreeCADGui as Gui
import Mesh
from PySide import QtCore

import ThickenWorkbench
import thicken_judge
from ThickenWorkbench import mesh_io
from gui_case import GuiCase, click, process_events, type_text, wait_until
from thicken_surfaces import saddle


class Printing(GuiCase):
    def hollow(self):
        """A cube of 20 mm with walls of 2 mm."""
        source = self.doc.addObject("Mesh::Feature", "Cube")
        source.Mesh = Mesh.createBox(20, 20, 20)
        feature = ThickenWorkbench.make_thicken(self.doc, source, thickness=2)
        self.assertTrue(feature.Valid)
        self.look()
        return feature


class DrainHoles(Printing):
    def open(self):
        solid = self.hollow()
        self.select(solid)
        return solid, self.run_command("Thicken_Drain")

    def test_a_hole_at_the_lowest_point(self):
        solid, panel = self.open()
        type_text(self.child(panel, "Diameter"), "3 mm")
        self.picture("drain-panel")
        self.press("Ok")
        self.wait_closed()
        drained = self.doc.getObject("DrainHoles")
        self.assertTrue(drained.Valid, drained.getStatusString())
        self.assertEqual((drained.HoleCount, drained.Trapped), (1, 0))
        self.assertLess(drained.HolePlaces[0].z, 2.1)
        self.assertTrue(drained.ViewObject.Visibility)
        self.assertFalse(solid.ViewObject.Visibility)
        Gui.activeDocument().activeView().viewBottom()
        self.picture("drained-below")
        self.assertEqual(self.doc.UndoCount, 1)
        self.doc.undo()
        self.assertIsNone(self.doc.getObject("DrainHoles"))

    def test_a_place_is_clicked(self):
        solid, panel = self.open()
        view = Gui.activeDocument().activeView()
        view.viewFront()
        Gui.SendMsgToActiveView("ViewFit")
        self.click_view(view.getPointOnScreen(App.Vector(1, -10, 3)))
        self.assertEqual(len(panel.places), 1)
        self.assertAlmostEqual(panel.places[0].z, 3, delta=0.3)
        self.assertIn("One place", self.child(panel, "Status").text())
        self.picture("drain-place")
        self.press("Ok")
        self.wait_closed()
        drained = self.doc.getObject("DrainHoles")
        self.assertEqual((drained.HoleCount, drained.Trapped), (1, 0))
        self.assertAlmostEqual(abs(drained.HoleAxes[0].y), 1, places=5)

    def test_what_cannot_be_drilled_is_told(self):
        solid, panel = self.open()
        type_text(self.child(panel, "Diameter"), "19.5 mm")
        self.press("Ok")
        wait_until(lambda: "mm" in self.child(panel, "Status").text() or not Gui.Control.activeDialog(), "it is told")
        self.assertTrue(Gui.Control.activeDialog())
        self.press("Cancel")
        self.wait_closed()
        self.assertIsNone(self.doc.getObject("DrainHoles"))

    def test_plugs_on_request(self):
        solid, panel = self.open()
        click(self.child(panel, "Plug"), QtCore.QPoint(8, 8))
        self.assertTrue(self.child(panel, "Plug").isChecked())
        self.press("Ok")
        self.wait_closed()
        plugs = self.doc.getObject("Plugs")
        self.assertTrue(plugs.Valid, plugs.getStatusString())
        self.assertTrue(plugs.Mesh.isSolid())


class Report(Printing):
    def open(self):
        solid = self.hollow()
        self.select(solid)
        panel = self.run_command("Thicken_Report")
        wait_until(lambda: panel.report is not None, "the report is there")
        return solid, panel

    def test_trapped_resin_is_named_and_gone_to(self):
        solid, panel = self.open()
        text = self.child(panel, "Facts").toPlainText()
        self.assertIn("traps", text)
        self.assertIn("20 × 20 × 20 mm", text)
        self.picture("report")
        camera = Gui.activeDocument().activeView().getCameraNode()
        before = camera.height.getValue()
        (cavity,) = panel.report["trapped"]
        panel.go(QtCore.QUrl("place:" + ",".join(str(part) for part in cavity["lowest_place_mm"])))
        self.assertLess(camera.height.getValue(), before)
        x, y = Gui.activeDocument().activeView().getPointOnScreen(App.Vector(*cavity["lowest_place_mm"]))
        width, height = Gui.activeDocument().activeView().getSize()
        self.assertAlmostEqual(x / width, 0.5, delta=0.05)
        self.press("Close")
        self.wait_closed()

    def test_it_follows_the_inputs(self):
        solid, panel = self.open()
        self.assertNotIn("thinner than 2.5", self.child(panel, "Facts").toPlainText())
        type_text(self.child(panel, "Minimum"), "2.5 mm")
        wait_until(lambda: panel.report is not None, "the report is there again")
        self.assertIn("thinner than 2.5", self.child(panel, "Facts").toPlainText())

    def test_it_is_saved(self):
        solid, panel = self.open()
        target = self.folder / "cube.html"
        self.answer_file_dialog(target)
        click(self.child(panel, "Save"))
        wait_until(target.is_file, "the page is written")
        self.assertIn("<img", target.read_text())
        self.assertTrue(target.with_suffix(".json").is_file())


class Export(Printing):
    def test_a_file_is_written_and_judged(self):
        self.select(self.add_mesh(saddle()))
        self.run_command("Thicken_Make")
        self.press("Ok")
        self.wait_closed()
        path = self.folder / "clicked.FCStd"
        self.doc.saveAs(str(path))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(str(path))
        process_events()
        feature = self.doc.getObject("Thicken")
        self.assertTrue(feature.Valid)
        self.assertFalse(self.doc.isTouched())
        self.select(feature)
        target = self.folder / "clicked.stl"
        self.answer_file_dialog(target)
        self.run_command("Thicken_Export")
        corners = thicken_judge.read_stl(target)
        self.assertTrue(thicken_judge.is_closed_and_oriented(corners))
        vertices, triangles = mesh_io.arrays_from_mesh(self.doc.getObject("Scan").Mesh)
        self.assertTrue(thicken_judge.keeps(corners, vertices[triangles]))
        self.assertEqual(len(self.messages), 1)
        self.assertIn("proved valid", self.messages[0])

    def test_a_surface_is_no_part(self):
        self.select(self.add_mesh(saddle()))
        target = self.folder / "open.stl"
        self.answer_file_dialog(target)
        self.run_command("Thicken_Export")
        self.assertFalse(target.exists())
        self.assertEqual(len(self.messages), 1)
        self.assertIn("not a valid solid", self.messages[0])
