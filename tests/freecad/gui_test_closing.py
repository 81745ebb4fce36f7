# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels that something else closes, such as a macro, and what clicks on what they draw leave behind."""

import FreeCAD as App
import FreeCADGui as Gui
import Mesh
import numpy as np
from pivy import coin

import ThickenWorkbench
from thicken import native
from ThickenWorkbench.gui import editing
from ThickenWorkbench.gui.region_colours import painted
from ThickenWorkbench.gui.repair_marks import ADDED, REMOVED, WELDED, marks
from ThickenWorkbench.repair_feature import repair_step
from ThickenWorkbench.sources import surface_arrays
from gui_case import GuiCase, dark_sheet, process_events, wait_until
from thicken_surfaces import crossing_plates, plate, saddle, together


def _colour(node):
    """Of the material that a node of triangles begins with."""
    return tuple(round(part, 2) for part in node.getChild(0).diffuseColor[0].getValue())


class ClosedByAMacro(GuiCase):
    def hollow(self):
        source = self.doc.addObject("Mesh::Feature", "Cube")
        source.Mesh = Mesh.createBox(20, 20, 20)
        feature = ThickenWorkbench.make_thicken(self.doc, source, thickness=2)
        self.look()
        return feature

    def assert_nothing_is_left(self, panel, obj):
        """The panel goes with its dialog, no run is waited for, and clicks in the view select again."""
        Gui.Control.closeDialog()
        wait_until(lambda: panel._closed, "the panel has closed itself")
        self.assertIsNone(panel._job)
        Gui.activeDocument().activeView().viewFront()
        Gui.SendMsgToActiveView("ViewFit")
        process_events()
        view = Gui.activeDocument().activeView()
        self.click_view(view.getPointOnScreen(obj.Mesh.BoundBox.Center))
        self.assertEqual([found.Name for found in Gui.Selection.getSelection()], [obj.Name])

    def test_drain_holes(self):
        solid = self.hollow()
        self.select(solid)
        panel = self.run_command("Thicken_Drain")
        self.assert_nothing_is_left(panel, solid)

    def test_thickness_map(self):
        solid = self.hollow()
        before = painted(solid.ViewObject)
        self.select(solid)
        panel = self.run_command("Thicken_Map")
        wait_until(lambda: panel.map is not None, "the map is there")
        self.assertNotEqual(painted(solid.ViewObject), before)
        self.assert_nothing_is_left(panel, solid)
        self.assertEqual(painted(solid.ViewObject), before)

    def test_thickness_regions(self):
        solid = self.hollow()
        self.select(solid)
        panel = self.run_command("Thicken_Regions")
        self.assertFalse(solid.ViewObject.Visibility)
        self.assert_nothing_is_left(panel, solid)
        self.assertEqual(list(solid.RegionThickness), [])

    def test_report_and_check_while_they_compute(self):
        solid = self.hollow()
        for command in ("Thicken_Report", "Thicken_Check"):
            with self.subTest(command):
                self.select(solid)
                self.assert_nothing_is_left(self.run_command(command), solid)

    def test_thicken_while_its_preview_computes(self):
        source = self.add_mesh(plate())
        self.select(source)
        panel = self.run_command("Thicken_Make")
        self.assertTrue(panel._preview.busy())
        busy = []
        panel.form.destroyed.connect(lambda *_: busy.append(panel._preview.busy()))
        Gui.Control.closeDialog()
        wait_until(lambda: panel._closed, "the panel has closed itself")
        self.assertEqual(busy, [False], "a result would be told to widgets that are gone")
        self.assertEqual(self.doc.Objects, [source])
        self.assertEqual(source.ViewObject.Transparency, 0)


class Arrow(GuiCase):
    def test_a_click_on_it_selects_nothing_behind_it(self):
        source = self.add_mesh(saddle())
        view = Gui.activeDocument().activeView()
        view.viewTop()
        Gui.SendMsgToActiveView("ViewFit")
        self.select(source)
        panel = self.run_command("Thicken_Make")
        side = self.child(panel, "Side").currentIndex()
        self.click_view(panel._arrow.middle_on_screen())
        self.assertNotEqual(self.child(panel, "Side").currentIndex(), side)
        wait_until(lambda: Gui.Selection.getSelection() == [], "what the click selected is not selected any more")
        # Beside the arrow a click selects, as ever.
        self.click_view(view.getPointOnScreen(App.Vector(8, 8, 0)))
        process_events()
        self.assertEqual(Gui.Selection.getSelection(), [source])
        self.press("Cancel")


class EditedAgain(GuiCase):
    def test_drain_holes(self):
        cube = self.doc.addObject("Mesh::Feature", "Cube")
        cube.Mesh = Mesh.createBox(20, 20, 20)
        hollow = ThickenWorkbench.make_thicken(self.doc, cube, thickness=2)
        drained = ThickenWorkbench.make_drain_holes(self.doc, hollow, 3)
        self.look()
        Gui.getDocument(self.doc.Name).setEdit(drained.Name, 0)
        panel = editing.current()
        self.assertAlmostEqual(panel._diameter(), 3)
        wait_until(lambda: panel.found is not None, "the places are shown")
        self.child(panel, "Count").setValue(2)
        self.press("Ok")
        self.wait_closed()
        self.assertEqual((drained.HoleCount, drained.Count), (2, 2))
        self.assertIsNone(Gui.getDocument(self.doc.Name).getInEdit())
        self.assertTrue(drained.ViewObject.Visibility)
        self.assertFalse(hollow.ViewObject.Visibility)

    def test_repair(self):
        repaired = ThickenWorkbench.make_repair(self.doc, self.add_mesh(crossing_plates()))
        Gui.getDocument(self.doc.Name).setEdit(repaired.Name, 0)
        process_events()
        panel = editing.current()
        self.assertIn("met others", self.child(panel, "Status").text())
        self.child(panel, "WeldAutomatically").setChecked(False)
        self.child(panel, "Weld").setProperty("rawValue", 0.01)
        self.press("Ok")
        self.wait_closed()
        self.assertEqual((repaired.WeldAutomatically, repaired.Weld.Value), (False, 0.01))
        self.assertTrue(repaired.Valid)

    def test_repair_is_previewed_in_colours(self):
        vertices, triangles = plate()
        holed = np.delete(triangles, [45, 145], 0)
        crossing, others = crossing_plates()
        panel_beside, other_corners = plate(n=13)
        surface = together(
            (vertices, holed),
            (panel_beside - np.float32([20.2, 0, 0]), other_corners),
            (crossing + np.float32([40, 0, 0]), others),
        )
        repaired = ThickenWorkbench.make_repair(self.doc, self.add_mesh(surface))
        before = repaired.ViewObject.RootNode.getNumChildren()
        Gui.getDocument(self.doc.Name).setEdit(repaired.Name, 0)
        process_events()
        panel = editing.current()
        wait_until(lambda: panel._job is None, "the first preview")
        self.assertEqual(repaired.ViewObject.RootNode.getNumChildren(), before + 1)
        status = self.child(panel, "Status")
        self.assertIn("met others", status.text())
        self.assertNotIn("added", status.text())
        self.child(panel, "FillHoles").setProperty("rawValue", 12.0)
        wait_until(lambda: "added" in status.text(), "the preview of the patch")
        self.assertEqual((repaired.FillHoles.Value, repaired.Added), (0, 0), "before OK nothing is written")
        self.child(panel, "WeldAutomatically").setChecked(False)
        self.child(panel, "Weld").setProperty("rawValue", 0.3)
        wait_until(lambda: "divided at" in status.text(), "the preview of the weld")
        self.look()
        self.picture("repair-colours")
        mended = repair_step(repaired.Source, panel.joins())(native.load().RunContext())
        nodes = marks(surface_arrays(repaired.Source), mended)
        shown = {_colour(node) for node in nodes if isinstance(node.getChild(0), coin.SoMaterial)}
        self.assertEqual(shown, {REMOVED, ADDED, WELDED})
        self.press("Ok")
        self.wait_closed()
        self.assertEqual((repaired.FillHoles.Value, repaired.Weld.Value), (12, 0.3))
        self.assertGreater(repaired.Added, 0)
        self.assertEqual(repaired.ViewObject.RootNode.getNumChildren(), before)


class Narrow(GuiCase):
    """FreeCAD 0.20 gives panels 264 pixels, of which a scroll bar and a frame take some."""

    def test_every_panel_fits(self):
        cube = self.doc.addObject("Mesh::Feature", "Cube")
        cube.Mesh = Mesh.createBox(20, 20, 20)
        solid = ThickenWorkbench.make_thicken(self.doc, cube, thickness=2)
        self.look()
        self.addCleanup(Gui.setLocale, "English")
        for language in ("English", "German", "Chinese Simplified"):
            Gui.setLocale(language)
            for command, target in (("Make", cube), ("Check", cube), ("Map", solid), ("Drain", solid), ("Report", solid), ("Regions", solid)):
                with self.subTest(f"{language}, {command}"):
                    self.select(target)
                    panel = self.run_command(f"Thicken_{command}")
                    wait_until(lambda: panel._job is None, "it has computed")
                    if command == "Make":
                        self.child(panel, "Advanced").setChecked(True)
                        panel.form_parts.show_running(True)
                    process_events()
                    width = panel.form.minimumSizeHint().width()
                    panel.reject()
                    Gui.Control.closeDialog()
                    process_events()
                    self.assertLessEqual(width, 236)


    def test_long_words_squeeze_no_field(self):
        self.select(self.add_mesh(plate()))
        panel = self.run_command("Thicken_Make")
        wait_until(lambda: not panel._preview.busy(), "the preview is there")
        before = [self.child(panel, name).height() for name in ("Thickness", "Gap", "Side", "Flip")]
        panel.form_parts.tell("The solid is thinner than asked in places. " * 12)
        label = self.child(panel, "Status")
        wait_until(lambda: label.height() >= label.heightForWidth(label.width()), "all words are seen")
        self.assertEqual([self.child(panel, name).height() for name in ("Thickness", "Gap", "Side", "Flip")], before)
        self.press("Cancel")
        self.wait_closed()


class Dark(GuiCase):
    """FreeCAD's dark style sheets change colours, not palettes' grounds."""

    def test_errors_and_links_are_light_on_dark(self):
        from PySide import QtGui

        from ThickenWorkbench.gui.tones import tones

        self.select(self.add_mesh(crossing_plates()))
        panel = self.run_command("Thicken_Make")
        light = tones(panel.form_parts.title)
        self.addCleanup(QtGui.QApplication.instance().setStyleSheet, "")
        QtGui.QApplication.instance().setStyleSheet(dark_sheet())
        process_events()
        dark = tones(panel.form_parts.title)
        for name in light:
            self.assertGreater(QtGui.QColor(dark[name]).lightness(), QtGui.QColor(light[name]).lightness())
