# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Thicken command and its task panel."""

import os
import time
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import Part
from PySide import QtCore, QtGui

import ThickenWorkbench
from ThickenWorkbench import mesh_io, preferences
from ThickenWorkbench.gui import editing
from gui_case import GuiCase, click, process_events, type_text, wait_until
from thicken_surfaces import fin, grid, plate, saddle


# Points along a side of a plate that takes many seconds.
LONG = 350

# A run ends within a second of the machine's processors, however many other programs share them.
STOP_LIMIT = 1.0 * (os.cpu_count() or 1)


class Panel(GuiCase):
    def open(self, *objects):
        self.select(*objects)
        return self.run_command("Thicken_Make")

    def wait_preview(self, panel):
        wait_until(lambda: not panel._preview.busy(), "the preview is there")

    def ok(self):
        self.press("Ok")
        self.wait_closed()

    def test_a_click_makes_a_solid(self):
        source = self.add_mesh(saddle())
        panel = self.open(source)
        self.wait_preview(panel)
        self.assertIn("mL", self.child(panel, "Status").text())
        self.assertRegex(self.child(panel, "Status").text(), r"[\d,]+ triangles")
        self.assertIn("at once", self.child(panel, "Forecast").text())
        self.picture("thicken-panel")
        self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertTrue(feature.Valid, feature.getStatusString())
        self.assertTrue(feature.ViewObject.Visibility)
        self.assertFalse(source.ViewObject.Visibility)
        self.assertEqual(source.ViewObject.Transparency, 0)

    def test_ok_takes_the_previewed_solid(self):
        panel = self.open(self.add_mesh(saddle()))
        self.assertIn("about", self.child(panel, "Forecast").text())
        self.wait_preview(panel)
        (solid,) = panel._preview.solids()
        with mock.patch("ThickenWorkbench.gui.thicken_panel.thicken_mesh", side_effect=AssertionError("computed again")):
            with mock.patch("ThickenWorkbench.core.precomputed.thicken_mesh", side_effect=AssertionError("computed again")):
                self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertTrue(feature.Valid, feature.getStatusString())
        self.assertEqual(feature.TriangleCount, len(solid.triangles))

    def test_edited_inputs_are_computed_anew(self):
        panel = self.open(self.add_mesh(plate()))
        self.wait_preview(panel)
        type_text(self.child(panel, "Thickness"), "1.5 mm")
        self.assertIsNone(panel._preview.solids())
        self.ok()
        self.assertAlmostEqual(self.doc.getObject("Thicken").Volume.Value, 20 * 20 * 1.5, delta=1e-3)

    def test_qualities_have_names(self):
        panel = self.open(self.add_mesh(plate()))
        self.child(panel, "Quality").setCurrentIndex(0)
        self.assertEqual(panel.form_parts.inputs()["quality"], "draft")
        self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertEqual(feature.Quality, "Draft")
        Gui.getDocument(self.doc.Name).setEdit(feature.Name, 0)
        process_events()
        panel = editing.current()
        self.assertEqual(self.child(panel, "Quality").currentIndex(), 0)
        self.assertFalse(self.child(panel, "Advanced").isChecked())
        self.assertFalse(self.child(panel, "Output").isEnabled())
        self.assertIn("Part Solid", self.child(panel, "Output").toolTip())
        self.child(panel, "Grid").setCurrentIndex(2)
        self.child(panel, "QualityCells").setValue(40)
        self.assertFalse(self.child(panel, "Quality").isEnabled())
        self.ok()
        self.assertEqual((feature.Quality, feature.Resolution), ("Resolution", 40))

    def test_join_is_asked_for_and_shown_again(self):
        panel = self.open(self.add_mesh(saddle()))
        self.child(panel, "Join").setCurrentIndex(2)
        self.wait_preview(panel)
        with mock.patch("ThickenWorkbench.core.precomputed.thicken_mesh", side_effect=AssertionError("computed again")):
            self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertTrue(feature.Valid, feature.getStatusString())
        self.assertEqual(feature.Join, "Arc")
        Gui.getDocument(self.doc.Name).setEdit(feature.Name, 0)
        process_events()
        panel = editing.current()
        self.assertEqual(self.child(panel, "Join").currentIndex(), 2)
        self.assertTrue(self.child(panel, "Advanced").isChecked())
        self.child(panel, "Join").setCurrentIndex(0)
        self.ok()
        self.assertEqual(feature.Join, "Automatic")

    def test_a_rim_is_asked_for_and_shown_again(self):
        panel = self.open(self.add_mesh(plate()))
        for name, value in (("Thickness", 3.0), ("RimThickness", 1.0), ("RimWidth", 4.0)):
            self.child(panel, name).setProperty("rawValue", value)
        self.child(panel, "Advanced").setChecked(True)
        self.wait_preview(panel)
        self.picture("thicken-rim")
        with mock.patch("ThickenWorkbench.core.precomputed.thicken_mesh", side_effect=AssertionError("computed again")):
            self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertTrue(feature.Valid, feature.getStatusString())
        self.assertEqual([feature.getPropertyByName(f"Rim{name}").Value for name in ("Thickness", "Width", "Round")], [1, 4, 0])
        Gui.getDocument(self.doc.Name).setEdit(feature.Name, 0)
        process_events()
        panel = editing.current()
        self.assertTrue(self.child(panel, "Advanced").isChecked())
        self.assertEqual(self.child(panel, "RimWidth").property("rawValue"), 4)
        for name in ("RimThickness", "RimWidth"):
            self.child(panel, name).setProperty("rawValue", 0.0)
        self.ok()
        self.assertEqual((feature.RimThickness.Value, feature.RimWidth.Value), (0, 0))
        self.assertAlmostEqual(feature.Volume.Value, 20 * 20 * 3, delta=0.1)

    def test_merging_is_asked_for_and_shown_again(self):
        panel = self.open(self.add_mesh(plate()))
        self.child(panel, "Simplify").setCurrentIndex(1)
        self.wait_preview(panel)
        with mock.patch("ThickenWorkbench.core.precomputed.thicken_mesh", side_effect=AssertionError("computed again")):
            self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertEqual(feature.Simplify, "Off")
        unmerged = feature.TriangleCount
        Gui.getDocument(self.doc.Name).setEdit(feature.Name, 0)
        process_events()
        panel = editing.current()
        self.assertEqual(self.child(panel, "Simplify").currentIndex(), 1)
        self.assertTrue(self.child(panel, "Advanced").isChecked())
        self.child(panel, "Simplify").setCurrentIndex(0)
        self.ok()
        self.assertEqual(feature.Simplify, "Auto")
        self.assertLess(feature.TriangleCount, unmerged)

    def test_an_empty_mesh_is_told(self):
        empty = self.doc.addObject("Mesh::Feature", "Empty")
        self.look()
        self.assertIsNone(self.open(empty))
        self.assertEqual(len(self.messages), 1)
        self.assertIn("“Empty” has no triangles", self.messages[0])

    def test_another_unit_is_asked_about(self):
        tiny = self.add_mesh(grid(lambda x, y: 0 * x, size=0.1), "Metres")
        panel = self.open(tiny)
        self.assertIn("Is it in m?", self.child(panel, "Forecast").text())
        self.press("Cancel")
        self.wait_closed()
        self.assertNotIn("Is it in", self.child(self.open(self.add_mesh(plate())), "Forecast").text())

    def test_a_link_and_a_group(self):
        part = self.doc.addObject("App::Part", "Part")
        scan = self.add_mesh(plate())
        part.addObject(scan)
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = scan
        self.doc.recompute()
        self.assertIsNone(self.open(link))
        self.assertIn("“Link” is a link", self.messages[0])
        panel = self.open(part)
        self.assertEqual([item.source for item in panel.chosen], [scan])

    def test_a_part_solid_of_a_mesh(self):
        source = self.add_mesh(plate())
        feature = ThickenWorkbench.make_thicken(self.doc, source, 1)
        self.select(feature)
        self.run_command("Thicken_Solid")
        solid = ThickenWorkbench.part_solid_of(feature)
        self.assertAlmostEqual(solid.Shape.Volume, 400, delta=1e-3)
        self.assertEqual(self.doc.UndoCount, 1)
        self.doc.undo()
        self.assertIsNone(ThickenWorkbench.part_solid_of(feature))

    def test_thickness_is_typed_with_a_unit(self):
        panel = self.open(self.add_mesh(plate()))
        type_text(self.child(panel, "Thickness"), "0.05 in")
        self.assertAlmostEqual(panel.form_parts.inputs()["thickness"], 1.27)
        self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertAlmostEqual(feature.Thickness.Value, 1.27)
        self.assertAlmostEqual(feature.Volume.Value, 20 * 20 * 1.27, delta=1e-3)

    def test_preview_follows_the_edits(self):
        panel = self.open(self.add_mesh(plate()))
        type_text(self.child(panel, "Thickness"), "1 mm")
        self.wait_preview(panel)
        first = self.child(panel, "Status").text()
        self.assertIn("0.4 mL", first)
        type_text(self.child(panel, "Thickness"), "2 mm")
        self.wait_preview(panel)
        self.assertIn("0.8 mL", self.child(panel, "Status").text())
        self.assertEqual([obj.Name for obj in self.doc.Objects if obj.isDerivedFrom("Mesh::Feature")], ["Scan"])

    def test_nothing_is_previewed_for_no_thickness(self):
        panel = self.open(self.add_mesh(plate()))
        type_text(self.child(panel, "Thickness"), "0 mm")
        self.assertIn("above 0", self.child(panel, "Status").text())
        self.press("Ok")
        self.assertTrue(Gui.Control.activeDialog())
        self.assertFalse(panel._preview.busy())

    def test_side_is_flipped_by_button_and_by_a_click_on_the_arrow(self):
        panel = self.open(self.add_mesh(plate()))
        self.wait_preview(panel)
        self.assertEqual(panel.form_parts.inputs()["side"], "negative")
        click(self.child(panel, "Flip"))
        self.assertEqual(panel.form_parts.inputs()["side"], "positive")
        self.wait_preview(panel)
        self.picture("arrow-positive")
        self.click_view(panel._arrow.middle_on_screen())
        self.assertEqual(panel.form_parts.inputs()["side"], "negative")
        self.click_view(panel._arrow.middle_on_screen())
        self.ok()
        self.assertEqual(self.doc.getObject("Thicken").Side, "Positive")
        self.assertAlmostEqual(self.doc.getObject("Thicken").Mesh.BoundBox.ZMin, 0)

    def test_thickness_by_an_expression(self):
        sheet = self.doc.addObject("Spreadsheet::Sheet", "Sizes")
        sheet.set("A1", "1.5 mm")
        source = self.add_mesh(plate())
        panel = self.open(source)
        panel._bound.setExpression("Thickness", "Sizes.A1 * 2")
        self.doc.recompute([panel._bound])
        wait_until(lambda: panel.form_parts.inputs()["thickness"] == 3, "the field follows the expression")
        self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertEqual(feature.Thickness.Value, 3)
        self.assertEqual(feature.ExpressionEngine[0][:2], ("Thickness", "Sizes.A1 * 2"))
        sheet.set("A1", "1 mm")
        self.doc.recompute()
        self.assertAlmostEqual(feature.Volume.Value, 20 * 20 * 2, delta=1e-3)

    def test_several_objects_at_once(self):
        sources = [self.add_mesh(plate(), "First"), self.add_mesh(saddle(), "Second")]
        panel = self.open(*sources)
        type_text(self.child(panel, "Thickness"), "1 mm")
        self.wait_preview(panel)
        self.ok()
        made = [obj for obj in self.doc.Objects if hasattr(obj, "ThinnestWall")]
        self.assertEqual([obj.Source for obj in made], sources)
        self.assertTrue(all(obj.Valid for obj in made))
        self.doc.undo()
        self.assertEqual(self.doc.Objects, sources)

    def test_faces_of_a_shape_become_a_part_solid(self):
        box = self.doc.addObject("Part::Feature", "Box")
        box.Shape = Part.makeBox(10, 10, 10)
        self.doc.recompute()
        self.look()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(box, "Face6")
        panel = self.run_command("Thicken_Make")
        type_text(self.child(panel, "Thickness"), "1 mm")
        self.child(panel, "Output").setCurrentIndex(1)
        self.wait_preview(panel)
        self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertAlmostEqual(feature.Volume.Value, 100, delta=1e-3)
        (solid,) = [obj for obj in self.doc.Objects if obj.isDerivedFrom("Part::Feature") and obj != box]
        self.assertTrue(solid.Shape.isValid())
        self.assertAlmostEqual(solid.Shape.Volume, 100, delta=1e-3)
        self.assertTrue(solid.ViewObject.Visibility)
        self.assertFalse(feature.ViewObject.Visibility)
        self.picture("part-solid")

    def test_a_region_is_picked_by_clicks(self):
        source = self.add_mesh(grid(lambda x, y: abs(x), n=21))  # two planes that meet at a right angle
        panel = self.open(source)
        self.wait_preview(panel)
        click(self.child(panel, "Pick"))
        view = Gui.activeDocument().activeView()
        view.viewTop()
        Gui.SendMsgToActiveView("ViewFit")
        self.click_view(view.getPointOnScreen(App.Vector(6.1, 5.3, 6.1)))
        self.assertEqual(len(panel.chosen[0].facets), 400)
        self.assertIn("400", self.child(panel, "Title").text())
        self.click_view(view.getPointOnScreen(App.Vector(-6.1, 5.3, 6.1)))
        self.assertEqual(len(panel.chosen[0].facets), 800)
        self.click_view(view.getPointOnScreen(App.Vector(-6.1, 5.3, 6.1)))
        self.assertEqual(len(panel.chosen[0].facets), 400)
        self.picture("pick-region")
        click(self.child(panel, "Pick"))
        self.wait_preview(panel)
        type_text(self.child(panel, "Thickness"), "1 mm")
        self.ok()
        feature = self.doc.getObject("Thicken")
        self.assertEqual((len(feature.Facets), feature.OriginalTriangles), (400, 400))
        self.assertAlmostEqual(feature.Volume.Value, 20 * 10 * 2**0.5, delta=1e-2)

    def test_a_large_part_solid_is_warned_of(self):
        panel = self.open(self.add_mesh(plate(n=200)))
        self.assertNotIn("Part solid", self.child(panel, "Forecast").text())
        self.child(panel, "Output").setCurrentIndex(1)
        text = self.child(panel, "Forecast").text()
        self.assertIn("A Part solid of", text)
        self.assertRegex(text, r"about \d+ s")

    def test_refusal_is_told_in_the_panel(self):
        panel = self.open(self.add_mesh(fin()))
        self.press("Ok")
        wait_until(lambda: panel._job is None, "the run has ended")
        self.assertIn("shared by 3 triangles", self.child(panel, "Status").text())
        self.assertTrue(Gui.Control.activeDialog())
        self.picture("refused")
        self.press("Cancel")
        self.wait_closed()
        self.assertEqual([obj.Name for obj in self.doc.Objects], ["Scan"])


class Stop(GuiCase):
    def long_run(self):
        source = self.add_mesh(plate(n=LONG))
        preferences.put("Preview", False)
        self.addCleanup(preferences.put, "Preview", True)
        self.select(source)
        panel = self.run_command("Thicken_Make")
        self.press("Ok")
        wait_until(lambda: self.child(panel, "Progress").value() > 0, "it has begun")
        self.assertTrue(self.child(panel, "Stop").isVisible())
        for name in ("Output", "Whole", "Quality", "Grid"):
            self.assertFalse(self.child(panel, name).isEnabled(), name)
        return source, panel

    def test_a_long_run_stops_within_a_second(self):
        source, panel = self.long_run()
        self.picture("running")
        begin = time.process_time()
        click(self.child(panel, "Stop"))
        wait_until(lambda: panel._job is None, "the run has stopped")
        self.assertLess(time.process_time() - begin, STOP_LIMIT)
        self.assertIn("Stopped", self.child(panel, "Status").text())
        self.assertFalse(self.child(panel, "Stop").isVisible())
        self.assertTrue(self.child(panel, "Thickness").isEnabled())
        self.assertTrue(self.child(panel, "Output").isEnabled())
        self.assertFalse(self.child(panel, "Whole").isEnabled(), "no part is chosen")
        self.press("Cancel")
        self.wait_closed()
        self.assertEqual(self.doc.Objects, [source])

    def test_cancel_ends_the_run_and_the_panel(self):
        source, panel = self.long_run()
        job = panel._job
        self.press("Cancel")
        self.wait_closed()
        wait_until(lambda: not job._thread.is_alive(), "the thread has ended")
        self.assertEqual(self.doc.Objects, [source])
        self.assertEqual(self.doc.UndoCount, 0)


class Recompute(GuiCase):
    """A property was changed outside of the panel."""

    def test_a_long_recompute_shows_progress_and_stops(self):
        source = self.add_mesh(plate())
        feature = ThickenWorkbench.make_thicken(self.doc, source, thickness=1)
        self.assertTrue(feature.Valid)
        source.Mesh = mesh_io.mesh_from_arrays(*plate(n=LONG))
        seen = []

        def stop():
            dialog = QtGui.QApplication.activeModalWidget()
            if isinstance(dialog, QtGui.QProgressDialog) and dialog.value() > 0:
                self.picture_of(dialog, "recompute")
                seen.append(time.process_time())
                self.ticker.stop()
                click(dialog.findChild(QtGui.QPushButton))

        self.ticker = QtCore.QTimer()
        self.ticker.timeout.connect(stop)
        self.ticker.start(50)
        self.doc.recompute()
        self.ticker.stop()
        self.assertEqual(len(seen), 1, "no progress was shown")
        self.assertLess(time.process_time() - seen[0], STOP_LIMIT)
        self.assertFalse(feature.isValid())
        self.assertIn("cancelled", feature.getStatusString())
        source.Mesh = mesh_io.mesh_from_arrays(*plate())
        self.doc.recompute()
        self.assertTrue(feature.Valid)


class Document(GuiCase):
    """What is left in the document: nothing after Cancel, one step after OK."""

    def test_cancel_leaves_the_document_as_it_was(self):
        source = self.add_mesh(saddle())
        self.doc.saveAs(str(self.folder / "before.FCStd"))
        self.select(source)
        panel = self.run_command("Thicken_Make")
        wait_until(lambda: not panel._preview.busy(), "the preview is there")
        before = source.ViewObject.RootNode.getNumChildren()
        self.press("Cancel")
        self.wait_closed()
        self.assertEqual(self.doc.Objects, [source])
        self.assertTrue(source.ViewObject.Visibility)
        self.assertEqual(source.ViewObject.Transparency, 0)
        self.assertEqual(self.doc.UndoCount, 0)
        self.assertFalse(self.doc.isTouched())
        self.assertEqual(source.ViewObject.RootNode.getNumChildren(), before - 2, "the overlays are still there")

    def test_closing_the_document_does_no_harm(self):
        self.select(self.add_mesh(saddle()))
        panel = self.run_command("Thicken_Make")
        App.closeDocument(self.doc.Name)
        self.doc = App.newDocument("Next")
        wait_until(lambda: not panel._preview.busy(), "the preview has ended")
        if Gui.Control.activeDialog():
            self.press("Cancel")
            self.wait_closed()
        self.assertEqual(self.doc.Objects, [])

    def test_deleting_the_source_closes_the_panel(self):
        source = self.add_mesh(saddle())
        self.select(source)
        panel = self.run_command("Thicken_Make")
        wait_until(lambda: not panel._preview.busy(), "the preview is there")
        self.doc.removeObject(source.Name)
        self.wait_closed()
        self.assertEqual([obj.Name for obj in self.doc.Objects if obj.Name != "Scan"], [])

    def test_undo_is_one_step(self):
        source = self.add_mesh(saddle())
        self.select(source)
        self.run_command("Thicken_Make")
        self.press("Ok")
        self.wait_closed()
        self.assertEqual(self.doc.UndoCount, 1)
        self.doc.undo()
        self.assertEqual(self.doc.Objects, [source])
        self.assertTrue(source.ViewObject.Visibility)
        self.doc.redo()
        self.assertTrue(self.doc.getObject("Thicken").Valid)

    def made(self):
        self.select(self.add_mesh(saddle()))
        self.run_command("Thicken_Make")
        self.press("Ok")
        self.wait_closed()
        return self.doc.getObject("Thicken")

    def edit(self, feature):
        self.assertTrue(Gui.getDocument(self.doc.Name).setEdit(feature.Name, 0))
        from ThickenWorkbench.gui import editing

        return editing.current()

    def test_double_click_edits_again(self):
        feature = self.made()
        old = feature.Volume.Value
        panel = self.edit(feature)
        self.assertAlmostEqual(panel.form_parts.inputs()["thickness"], feature.Thickness.Value)
        type_text(self.child(panel, "Thickness"), "1.25 mm")
        self.child(panel, "Side").setCurrentIndex(1)
        self.press("Ok")
        self.wait_closed()
        self.assertEqual((feature.Thickness.Value, feature.Side), (1.25, "Positive"))
        self.assertTrue(feature.Valid)
        self.assertNotEqual(feature.Volume.Value, old)
        self.assertIsNone(Gui.getDocument(self.doc.Name).getInEdit())
        self.assertTrue(feature.ViewObject.Visibility)
        self.doc.undo()
        self.assertEqual(feature.Side, "Negative")
        self.assertEqual(feature.Volume.Value, old)

    def test_cancelled_edit_changes_nothing(self):
        feature = self.made()
        before = (feature.Thickness.Value, feature.Volume.Value, self.doc.UndoCount)
        panel = self.edit(feature)
        type_text(self.child(panel, "Thickness"), "1.25 mm")
        panel._bound.setExpression("Thickness", "1 mm + 2 mm")
        self.press("Cancel")
        self.wait_closed()
        self.assertEqual((feature.Thickness.Value, feature.Volume.Value, self.doc.UndoCount), before)
        self.assertEqual(feature.ExpressionEngine, [])
        self.assertTrue(feature.ViewObject.Visibility)
        self.assertIsNone(Gui.getDocument(self.doc.Name).getInEdit())

    def test_deleting_shows_the_source(self):
        feature = self.made()
        source = feature.Source
        self.select(feature)
        Gui.runCommand("Std_Delete")
        self.assertEqual(self.doc.Objects, [source])
        self.assertTrue(source.ViewObject.Visibility)
