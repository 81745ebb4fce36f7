# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness Regions: a brush is dragged over the mesh, regions get thicknesses, and the field is seen in colours."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
from PySide import QtCore

import ThickenWorkbench
from ThickenWorkbench import mesh_io
from ThickenWorkbench.gui import editing
from gui_case import GuiCase, click, type_text, wait_until
from thicken_surfaces import plate


class Painting(GuiCase):
    def open_panel(self):
        self.scan = self.add_mesh(plate(n=41))
        self.solid = ThickenWorkbench.make_thicken(self.doc, self.scan, 1)
        self.look()
        return self.reopen()

    def reopen(self):
        self.select(self.solid)
        panel = self.run_command("Thicken_Regions")
        self.wait_field(panel)
        return panel

    def wait_field(self, panel):
        wait_until(lambda: not panel._timer.isActive() and panel._job is None and panel.values is not None, "the field is there")

    def pixel(self, x, y):
        return Gui.activeDocument().activeView().getPointOnScreen(App.Vector(x, y, 0))

    def stroke(self, panel, start, end, modifiers=QtCore.Qt.NoModifier):
        self.drag_view(self.pixel(*start), self.pixel(*end), modifiers)
        self.wait_field(panel)

    def middles(self):
        vertices, triangles = mesh_io.arrays_from_mesh(self.scan.Mesh)
        return vertices[triangles].mean(axis=1)

    def test_a_stroke_paints_a_region_and_ok_is_one_step(self):
        panel = self.open_panel()
        before = self.solid.Volume.Value
        type_text(self.child(panel, "Radius"), "2 mm")
        self.stroke(panel, (-6, 0), (6, 0))
        self.assertEqual(panel.lengths, [1.5])
        x, y, _ = self.middles().T
        painted = panel.region_of == 0
        self.assertTrue(painted[(abs(x) < 6) & (abs(y) < 1.2)].all())
        self.assertFalse(painted[(abs(x) > 8.4) | (abs(y) > 2.4)].any())
        self.picture("regions-painted")
        type_text(self.child(panel, "Thickness"), "3 mm")
        type_text(self.child(panel, "Transition"), "2 mm")
        self.wait_field(panel)
        self.assertAlmostEqual(float(panel.values.max()), 3.0)
        self.assertAlmostEqual(float(panel.values.min()), 1.0)
        self.assertIn("3", self.child(panel, "Regions").item(0).text())
        self.picture("regions-field")
        self.assertEqual(list(self.solid.RegionThickness), [], "nothing is written before OK")
        self.press("Ok")
        self.wait_closed()
        self.assertTrue(self.solid.Valid, self.solid.getStatusString())
        self.assertEqual((list(self.solid.RegionThickness), self.solid.Transition.Value), ([3.0], 2.0))
        self.assertEqual(ThickenWorkbench.thickness_regions(self.solid)[0].facets, np.flatnonzero(painted).tolist())
        self.assertGreater(self.solid.Volume.Value, before + 2 * 12 * 2.4)
        self.assertTrue(self.solid.ViewObject.Visibility)
        self.assertEqual(self.scan.ViewObject.Transparency, 0)
        self.doc.undo()
        self.assertEqual(list(self.solid.RegionThickness), [])
        self.assertAlmostEqual(self.solid.Volume.Value, before)

    def test_shift_takes_away_and_regions_are_added_and_removed(self):
        panel = self.open_panel()
        type_text(self.child(panel, "Radius"), "1.5 mm")
        self.stroke(panel, (-6, 3), (6, 3))
        self.stroke(panel, (-6, 3), (0, 3), QtCore.Qt.ShiftModifier)
        x, y, _ = self.middles().T
        self.assertFalse((panel.region_of[(x < 0) & (x > -6) & (abs(y - 3) < 0.7)] >= 0).any())
        self.assertTrue((panel.region_of[(x > 2) & (x < 6) & (abs(y - 3) < 0.7)] == 0).all())
        click(self.child(panel, "Add"))
        type_text(self.child(panel, "Thickness"), "0.7 mm")
        self.stroke(panel, (4, -6), (4, 6))  # takes over what it crosses
        self.assertEqual(panel.lengths, [1.5, 0.7])
        self.assertTrue((panel.region_of[(abs(x - 4) < 0.8) & (abs(y) < 5)] == 1).all())
        self.picture("regions-two")
        self.child(panel, "Regions").setCurrentRow(0)
        click(self.child(panel, "Remove"))
        self.assertEqual(panel.lengths, [0.7])
        self.assertTrue((panel.region_of[(abs(x - 4) < 0.8) & (abs(y) < 5)] == 0).all())
        self.wait_field(panel)
        self.press("Ok")
        self.wait_closed()
        self.assertEqual(list(self.solid.RegionThickness), [0.7])
        panel = self.reopen()
        self.assertEqual(panel.lengths, [0.7])
        click(self.child(panel, "Remove"))
        self.press("Ok")
        self.wait_closed()
        self.assertEqual(list(self.solid.RegionThickness), [])

    def test_a_shape_is_painted(self):
        self.scan = self.doc.addObject("Part::Feature", "Board")
        self.scan.Shape = Part.makePlane(20, 20, App.Vector(-10, -10, 0)).fuse(Part.makePlane(20, 20, App.Vector(10, -10, 0)))
        self.solid = ThickenWorkbench.make_thicken(self.doc, self.scan, 1)
        self.look()
        panel = self.reopen()
        self.stroke(panel, (-3, 0), (3, 0))
        self.assertEqual(panel.lengths, [1.5])
        self.press("Ok")
        self.wait_closed()
        self.assertTrue(self.solid.Valid, self.solid.getStatusString())
        self.assertEqual(list(self.solid.RegionThickness), [1.5])
        self.assertGreater(self.solid.Volume.Value, 801)

    def test_cancel_changes_nothing(self):
        panel = self.open_panel()
        made = self.solid.ComputedFor
        self.stroke(panel, (-3, 0), (3, 0))
        self.press("Cancel")
        self.wait_closed()
        self.assertEqual((list(self.solid.RegionThickness), self.solid.ComputedFor), ([], made))
        self.assertTrue(self.solid.ViewObject.Visibility)
        self.doc.undo()  # what is undone is the making of the solid, not something of the panel

    def test_what_is_refused_is_told_and_the_panel_stays(self):
        panel = self.open_panel()
        self.stroke(panel, (-3, 0), (3, 0))
        type_text(self.child(panel, "Thickness"), "0 mm")
        self.press("Ok")
        self.assertTrue(Gui.Control.activeDialog())
        self.assertIn("above 0 mm", self.child(panel, "Status").text())
        self.press("Cancel")
        self.wait_closed()

    def test_a_region_that_is_gone_is_told_and_can_be_removed(self):
        panel = self.open_panel()
        self.stroke(panel, (-3, 0), (3, 0))
        self.press("Ok")
        self.wait_closed()
        vertices, triangles = plate(n=41)
        self.scan.Mesh = mesh_io.mesh_from_arrays(vertices + np.float32([0, 0, 9]), triangles)
        self.doc.recompute()
        self.assertFalse(self.solid.isValid())
        panel = self.reopen()
        self.assertIn("thickness region 1", self.child(panel, "Status").text())
        click(self.child(panel, "Remove"))
        self.press("Ok")
        self.wait_closed()
        self.assertTrue(self.solid.Valid)

    def test_properties_that_do_not_fit_are_told_and_painted_anew(self):
        panel = self.open_panel()
        self.stroke(panel, (-3, 0), (3, 0))
        self.press("Ok")
        self.wait_closed()
        self.solid.RegionThickness = [2, 3]
        self.doc.recompute()
        panel = self.reopen()
        self.assertIn("RegionThickness has 2", self.child(panel, "Status").text())
        self.stroke(panel, (-3, 2), (3, 2))
        self.press("Ok")
        self.wait_closed()
        self.assertEqual(list(self.solid.RegionThickness), [1.5])
        self.assertTrue(self.solid.Valid)

    def test_a_surface_that_changes_meanwhile_is_told(self):
        panel = self.open_panel()
        self.stroke(panel, (-3, 0), (3, 0))
        vertices, triangles = plate(n=41)
        self.scan.Mesh = mesh_io.mesh_from_arrays(vertices, triangles[::-1])
        self.press("Ok")
        self.assertIn("has changed since", self.child(panel, "Status").text())
        self.press("Cancel")
        self.wait_closed()
        self.assertEqual(list(self.solid.RegionThickness), [])

    def test_the_thicken_panel_previews_and_keeps_the_regions(self):
        panel = self.open_panel()
        self.stroke(panel, (-3, 0), (3, 0))
        self.press("Ok")
        self.wait_closed()
        volume = self.solid.Volume.Value
        Gui.ActiveDocument.setEdit(self.solid.Name, 0)
        panel = editing.current()
        wait_until(lambda: not panel._preview.busy(), "the preview is there")
        (shown,) = panel._preview.solids()
        self.assertAlmostEqual(shown.report["output"]["volume_mm3"], volume, places=6)
        type_text(self.child(panel, "Thickness"), "1.2 mm")
        wait_until(lambda: not panel._preview.busy(), "the preview is there")
        (shown,) = panel._preview.solids()
        self.press("Ok")
        self.wait_closed()
        self.assertAlmostEqual(self.solid.Volume.Value, shown.report["output"]["volume_mm3"], places=6)
        self.assertEqual(list(self.solid.RegionThickness), [1.5])
