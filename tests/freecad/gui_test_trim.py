# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trim Surface: a mesh and a wire are selected, and the part within the wire appears."""

import FreeCAD as App
import FreeCADGui as Gui
import Part

from gui_case import GuiCase, process_events
from thicken_surfaces import plate


class Trim(GuiCase):
    def select_with_circle(self, place):
        scan = self.add_mesh(plate())
        circle = self.doc.addObject("Part::Feature", "Circle")
        circle.Shape = Part.Wire(Part.makeCircle(5, App.Vector(*place)))
        self.doc.recompute()
        self.select(scan)
        self.assertFalse(Gui.Command.get("Thicken_Trim").isActive(), "there is no loop")
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
