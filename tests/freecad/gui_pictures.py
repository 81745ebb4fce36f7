# SPDX-License-Identifier: LGPL-2.1-or-later
"""Takes the pictures of docs/tutorial.md by clicking through it. Run by scripts/pictures."""

import math
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import Mesh

from gui_case import GuiCase, click, process_events, type_text, wait_until

DATA = Path(__file__).resolve().parents[2] / "examples" / "data"


class Tutorial(GuiCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        # A plain background: what matters stands out, and the pictures are small.
        view = App.ParamGet("User parameter:BaseApp/Preferences/View")
        view.SetBool("Simple", True)
        view.SetBool("Gradient", False)
        view.SetUnsigned("BackgroundColor", 0xF4F6F8FF)

    def from_below(self):
        Gui.activeDocument().activeView().setCameraOrientation(App.Rotation(App.Vector(1, 0.25, 0.1), 125))
        Gui.SendMsgToActiveView("ViewFit")
        Gui.Selection.clearSelection()
        process_events()

    def show(self, *, view="Isometric"):
        getattr(Gui.activeDocument().activeView(), f"view{view}")()
        Gui.SendMsgToActiveView("ViewFit")
        process_events()

    def ok(self):
        self.press("Ok")
        self.wait_closed()

    def close(self):
        self.press("Close")
        self.wait_closed()

    def test_a_jacket_for_a_bone(self):
        Mesh.insert(str(DATA / "bone.stl"), self.doc.Name)
        (scan,) = self.doc.Objects
        scan.Label = "bone"
        self.show()
        self.picture("scan")
        self.select(scan)
        panel = self.run_command("Thicken_Check")
        wait_until(lambda: panel.defects is not None, "the surface is checked")
        self.picture("check")
        self.close()
        self.select(scan)
        panel = self.run_command("Thicken_Make")
        type_text(self.child(panel, "Thickness"), "3 mm")
        click(self.child(panel, "Flip"))
        wait_until(lambda: not panel._preview.busy(), "the preview is there")
        self.picture("thicken")
        self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertTrue(feature.Valid)
        self.from_below()
        self.picture("regions")
        self.select(feature)
        panel = self.run_command("Thicken_Map")
        wait_until(lambda: panel.map is not None, "the map is there")
        self.picture("thickness-map")
        self.close()

    def test_b_hollow_pawn(self):
        Mesh.insert(str(DATA / "pawn.stl"), self.doc.Name)
        (figure,) = self.doc.Objects
        figure.Label = "pawn"
        self.show()
        self.select(figure)
        panel = self.run_command("Thicken_Make")
        type_text(self.child(panel, "Thickness"), "2 mm")
        wait_until(lambda: not panel._preview.busy(), "the preview is there")
        self.picture("hollow")
        self.ok()
        solid = self.doc.getObject("Thicken")
        self.assertTrue(solid.Valid, solid.getStatusString())
        self.select(solid)
        panel = self.run_command("Thicken_Report")
        wait_until(lambda: panel.report is not None, "the report is there")
        self.picture("report")
        self.close()
        self.select(solid)
        panel = self.run_command("Thicken_Drain")
        wait_until(lambda: panel.found is not None, "the place of the hole is shown")
        self.picture("drain")
        self.ok()
        drained = self.doc.getObject("DrainHoles")
        self.assertTrue(drained.Valid, drained.getStatusString())
        self.from_below()
        self.picture("drained")

    def on_shaft(self, x, z):
        """The pixel of a place on the front of the bone's shaft, from the middle of the patch, mm."""
        return Gui.activeDocument().activeView().getPointOnScreen(App.Vector(122 + x, 0, -165 + z))

    def trimmed(self, scan):
        """Clicks eight points of an ellipse, and the first once more."""
        self.select(scan)
        panel = self.run_command("Thicken_Trim")
        wait_until(lambda: panel.paths is not None, "the surface is prepared")
        for turn in range(0, 361, 45):
            self.click_view(self.on_shaft(10 * math.cos(math.radians(turn)), 30 * math.sin(math.radians(turn))))
        self.assertEqual(len(panel.points), 8)
        self.assertTrue(self.child(panel, "Closed").isChecked())
        self.child(panel, "Smooth").setValue(2)
        process_events()
        self.picture("trim")
        self.ok()
        return self.made("Trim")

    def made(self, name):
        feature = self.doc.getObject(name)
        self.assertTrue(feature.Valid, feature.getStatusString())
        return feature

    def test_d_a_part_that_fits(self):
        Mesh.insert(str(DATA / "bone.stl"), self.doc.Name)
        (scan,) = self.doc.Objects
        scan.Label = "bone"
        self.show(view="Front")
        trimmed = self.trimmed(scan)
        self.from_aside()
        self.select(trimmed)
        panel = self.run_command("Thicken_Make")
        type_text(self.child(panel, "Thickness"), "3 mm")
        type_text(self.child(panel, "Gap"), "0.5 mm")
        click(self.child(panel, "Flip"))
        self.child(panel, "Advanced").setChecked(True)
        type_text(self.child(panel, "RimThickness"), "2 mm")
        type_text(self.child(panel, "RimWidth"), "5 mm")
        wait_until(lambda: not panel._preview.busy(), "the preview is there")
        self.picture("gap")
        self.ok()
        part = self.made("Thicken")
        self.show(view="Front")
        self.select(part)
        panel = self.run_command("Thicken_Regions")
        wait_until(lambda: panel.values is not None, "the surface is coloured")
        self.drag_view(self.on_shaft(0, 12), self.on_shaft(0, -12))
        type_text(self.child(panel, "Thickness"), "5 mm")
        type_text(self.child(panel, "Transition"), "6 mm")
        wait_until(lambda: not panel._timer.isActive() and panel._job is None, "the field is there")
        self.picture("thicker")
        self.ok()
        self.assertTrue(part.Valid, part.getStatusString())
        self.from_aside()
        self.select(part)
        panel = self.run_command("Thicken_Map")
        wait_until(lambda: panel.map is not None, "the map is there")
        self.picture("thicker-map")
        self.close()
        scan.ViewObject.Visibility = True
        self.from_aside()
        self.picture("fits")

    def from_aside(self):
        Gui.activeDocument().activeView().setCameraOrientation(App.Rotation(-25, 0, 80))
        Gui.SendMsgToActiveView("ViewFit")
        Gui.Selection.clearSelection()
        process_events()

    def test_c_region(self):
        Mesh.insert(str(DATA / "bracket.stl"), self.doc.Name)
        (scan,) = self.doc.Objects
        self.show()
        self.select(scan)
        panel = self.run_command("Thicken_Make")
        wait_until(lambda: not panel._preview.busy(), "the preview is there")
        click(self.child(panel, "Pick"))
        view = Gui.activeDocument().activeView()
        self.click_view(view.getPointOnScreen(App.Vector(0, 0, 20)))
        self.click_view(view.getPointOnScreen(App.Vector(10.6, -10.6, 14)))
        self.assertGreater(len(panel.chosen[0].facets), 20)
        self.picture("region")
        self.press("Cancel")
        self.wait_closed()
