# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trim Surface: a mesh and a wire are selected, and the part within the wire appears; or the loop is clicked on the mesh."""

import FreeCAD as App
import FreeCADGui as Gui
import Part

from gui_case import GuiCase, click, process_events, wait_until
from thicken_surfaces import plate


class Trim(GuiCase):
    def select_with_circle(self, place):
        scan = self.add_mesh(plate())
        circle = self.doc.addObject("Part::Feature", "Circle")
        circle.Shape = Part.Wire(Part.makeCircle(5, App.Vector(*place)))
        self.doc.recompute()
        self.select(circle)
        self.assertFalse(Gui.Command.get("Thicken_Trim").isActive(), "there is no surface")
        self.select(scan)
        Gui.Selection.addSelection(circle)
        process_events()
        self.assertTrue(Gui.Command.get("Thicken_Trim").isActive())
        return scan

    def test_one_step_makes_and_undoes_the_part(self):
        scan = self.select_with_circle((0.3, 0.2, 0.1))
        self.run_command("Thicken_Trim")
        (made,) = [obj for obj in self.doc.Objects if obj.Name.startswith("Trim")]
        self.assertTrue(made.Valid)
        self.assertAlmostEqual(made.Area.Value, 78.5, delta=0.5)
        self.assertFalse(scan.ViewObject.Visibility)
        self.assertTrue(made.ViewObject.Visibility)
        self.picture("trimmed")
        self.doc.undo()
        process_events()
        self.assertEqual(len(self.doc.Objects), 2)
        self.assertEqual(self.messages, [])

    def test_a_refusal_is_told_and_leaves_nothing(self):
        self.select_with_circle((0, 8, 0))  # beyond the rim
        self.run_command("Thicken_Trim")
        self.assertEqual(len(self.messages), 1)
        self.assertIn("loop 1", self.messages[0].lower())
        self.assertEqual(len(self.doc.Objects), 2)


CORNERS = [(-4, -4), (4, -4), (4, 4), (-4, 4)]


class Clicks(GuiCase):
    def open_panel(self):
        self.scan = self.add_mesh(plate())
        self.select(self.scan)
        panel = self.run_command("Thicken_Trim")
        wait_until(lambda: panel.paths is not None, "the surface is prepared")
        return panel

    def pixel(self, x, y):
        return Gui.activeDocument().activeView().getPointOnScreen(App.Vector(x, y, 0))

    def set_points(self, places=CORNERS):
        for place in places:
            self.click_view(self.pixel(*place))

    def test_a_loop_is_clicked_and_cut_in_one_step(self):
        panel = self.open_panel()
        self.set_points()
        self.assertEqual(len(panel.points), 4)
        self.picture("trim-points")
        self.click_view(self.pixel(*CORNERS[0]))
        self.assertTrue(self.child(panel, "Closed").isChecked())
        self.picture("trim-closed")
        self.press("Ok")
        self.wait_closed()
        (made,) = [obj for obj in self.doc.Objects if obj.Name.startswith("Trim")]
        self.assertTrue(made.Valid)
        self.assertAlmostEqual(made.Area.Value, 64, delta=3)
        self.doc.undo()
        process_events()
        self.assertEqual(self.doc.Objects, [self.scan])

    def test_points_are_dragged_and_removed(self):
        panel = self.open_panel()
        self.set_points()
        self.drag_view(self.pixel(*CORNERS[2]), self.pixel(6, 2))
        self.assertEqual(len(panel.points), 4)
        self.assertAlmostEqual(panel.points[2].x, 6, delta=0.4)
        self.assertAlmostEqual(panel.points[2].y, 2, delta=0.4)
        self.assertEqual(panel.current, 2)
        click(self.child(panel, "Remove"))
        self.assertEqual(len(panel.points), 3)
        self.assertAlmostEqual(panel.points[2].x, -4, delta=0.4)
        self.click_view(self.pixel(5, 0))  # after the chosen one
        self.assertAlmostEqual(panel.points[2].x, 5, delta=0.4)
        self.press("Cancel")
        self.wait_closed()
        self.assertEqual(self.doc.Objects, [self.scan])

    def test_the_part_that_is_clicked_on_stays_and_a_double_click_edits(self):
        panel = self.open_panel()
        self.set_points()
        self.child(panel, "Closed").setChecked(True)
        self.click_view(self.pixel(8, 0))
        self.assertIsNotNone(panel.keep)
        self.press("Ok")
        self.wait_closed()
        (made,) = [obj for obj in self.doc.Objects if obj.Name.startswith("Trim")]
        outside = made.Area.Value
        self.assertGreater(outside, 200)
        Gui.ActiveDocument.setEdit(made.Name, 0)
        from ThickenWorkbench.gui import editing

        panel = editing.current()
        wait_until(lambda: panel.paths is not None, "the surface is prepared")
        self.assertEqual(len(panel.points), 4)
        click(self.child(panel, "Inside"))
        self.press("Ok")
        self.wait_closed()
        self.assertAlmostEqual(made.Area.Value, 64, delta=3)

    def test_a_loop_of_two_points_is_no_loop(self):
        panel = self.open_panel()
        self.set_points(CORNERS[:2])
        self.assertFalse(self.child(panel, "Closed").isEnabled())
        self.press("Ok")
        self.assertTrue(Gui.Control.activeDialog())
        self.assertIn("three points", self.child(panel, "Status").text())
        self.press("Cancel")
        self.wait_closed()
