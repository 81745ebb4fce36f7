# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user sees: colours of the regions, the thickness map, marked defects."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

import ThickenWorkbench
from ThickenWorkbench import preferences
from ThickenWorkbench.gui.region_colours import painted
from gui_case import GuiCase, click, process_events, wait_until
from thicken_surfaces import crossing_plates, fin, grid, plate, saddle

REGION_KEYS = ("ColorOriginal", "ColorShell", "ColorWall")


def palette():
    return {tuple(round(part, 3) for part in preferences.colour(key)) for key in REGION_KEYS}


def hues(image) -> set[str]:
    """Which of red, yellow and blue cover more than a few pixels, whatever the light."""
    red, green, blue = (image[..., channel].astype(int) for channel in range(3))
    masks = {
        "red": (red > 1.8 * green) & (red > 1.8 * blue) & (red > 60),
        "yellow": (red > 1.8 * blue) & (green > 1.4 * blue) & (red > 60),
        "blue": (blue > 1.3 * red) & (blue > 1.1 * green) & (blue > 60),
    }
    return {name for name, mask in masks.items() if mask.sum() > 40}


class Colours(GuiCase):
    def made(self, surface=None, **inputs):
        source = self.add_mesh(saddle() if surface is None else surface)
        feature = ThickenWorkbench.make_thicken(self.doc, source, thickness=2, **inputs)
        self.look()
        return feature

    def test_regions_have_colours_of_their_own(self):
        feature = self.made()
        self.assertEqual(painted(feature.ViewObject), palette())
        self.assertLessEqual({"red", "yellow"}, hues(self.view_image()))
        Gui.activeDocument().activeView().viewBottom()
        # FreeCAD 1.0 turns the view by and by.
        wait_until(lambda: "blue" in hues(self.view_image()), "the shell is seen from below")
        self.picture("regions-below")

    def test_they_survive_saving(self):
        self.made().ViewObject.ShapeColor = (0.0, 1.0, 0.0)
        path = str(self.folder / "coloured.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        feature = App.openDocument(path).getObject("Thicken")
        process_events()
        self.assertEqual(painted(feature.ViewObject), palette())

    def test_they_come_to_documents_made_without_a_display(self):
        from pathlib import Path

        fixture = Path(__file__).parent / "fixtures" / "schema_1.FCStd"
        document = App.openDocument(str(fixture))
        process_events()
        (feature,) = [obj for obj in document.Objects if hasattr(obj, "ThinnestWall")]
        self.assertEqual(painted(feature.ViewObject), palette())

    def test_they_follow_recompute_undo_and_refusal(self):
        feature = self.made()
        self.doc.openTransaction("change")
        feature.Thickness = 9
        self.doc.recompute()
        self.doc.commitTransaction()
        self.assertEqual(painted(feature.ViewObject), palette())
        self.doc.undo()
        process_events()
        self.assertEqual(painted(feature.ViewObject), palette())
        feature.Source = None
        self.doc.recompute()
        process_events()
        self.assertEqual(len(painted(feature.ViewObject)), 1)

    def test_they_can_be_switched_off_and_chosen(self):
        feature = self.made()
        feature.ViewObject.RegionColors = False
        feature.ViewObject.ShapeColor = (0.0, 1.0, 0.0)
        process_events()
        self.assertEqual(painted(feature.ViewObject), {(0.0, 1.0, 0.0)})
        feature.ViewObject.RegionColors = True
        self.addCleanup(preferences.put, "ColorShell", preferences.get("ColorShell"))
        preferences.put("ColorShell", 0x00FF00FF)
        process_events()
        self.assertIn((0.0, 1.0, 0.0), painted(feature.ViewObject))


class ThicknessMap(GuiCase):
    def open(self, surface):
        source = self.add_mesh(surface)
        feature = ThickenWorkbench.make_thicken(self.doc, source, thickness=2)
        self.look()
        self.select(feature)
        panel = self.run_command("Thicken_Map")
        wait_until(lambda: panel.map is not None, "the map is there")
        return feature, panel

    def test_a_plate_is_as_thick_as_asked(self):
        feature, panel = self.open(plate())
        inner = np.median(panel.map.facet_values[:200])
        self.assertAlmostEqual(inner, 2.0, places=5)
        self.assertIn("Least", self.child(panel, "Facts").text())

    def test_the_view_shows_the_map_and_then_the_regions_again(self):
        feature, panel = self.open(grid(lambda x, y: 4 * np.exp(-(x * x + y * y) / 8), n=31))
        colours = painted(feature.ViewObject)
        self.assertGreater(len(colours), 20)
        image = self.child(panel, "Legend").grab().toImage()
        shown = {image.pixelColor(10, y).name() for y in range(15, image.height() - 15, 4)}
        self.assertGreater(len(shown), 20, "the scale is not drawn")
        self.picture("thickness-map")
        self.child(panel, "What").setCurrentIndex(1)
        wait_until(lambda: panel.map is not None, "the deviation is there")
        self.assertEqual(panel.map.what, "deviation")
        self.assertNotEqual(painted(feature.ViewObject), colours)
        self.picture("deviation-map")
        self.press("Close")
        self.wait_closed()
        self.assertEqual(painted(feature.ViewObject), palette())

    def test_a_drained_solid_is_measured_as_well(self):
        import Mesh

        cube = self.doc.addObject("Mesh::Feature", "Cube")
        cube.Mesh = Mesh.createBox(20, 20, 20)
        hollow = ThickenWorkbench.make_thicken(self.doc, cube, thickness=2)
        drained = ThickenWorkbench.make_drain_holes(self.doc, hollow)
        plain = painted(drained.ViewObject)
        self.select(drained)
        panel = self.run_command("Thicken_Map")
        wait_until(lambda: panel.map is not None, "the map is there")
        self.assertEqual(self.child(panel, "What").count(), 1)
        # All walls are as thick as asked, and so of one colour, which is none of the regions'.
        self.assertNotEqual(painted(drained.ViewObject), plain)
        self.assertAlmostEqual(panel.map.minimum, 2, delta=1e-3)
        self.press("Close")
        self.wait_closed()
        self.assertEqual(painted(drained.ViewObject), plain)

    def test_it_goes_to_the_thinnest_place(self):
        feature, panel = self.open(saddle())
        camera = Gui.activeDocument().activeView().getCameraNode()
        before = camera.position.getValue().getValue()
        click(self.child(panel, "ToLeast"))
        self.assertNotEqual(camera.position.getValue().getValue(), before)
        x, y = Gui.activeDocument().activeView().getPointOnScreen(panel.map.minimum_place)
        width, height = Gui.activeDocument().activeView().getSize()
        self.assertAlmostEqual(x / width, 0.5, delta=0.05)
        self.assertAlmostEqual(y / height, 0.5, delta=0.05)


class CheckSurface(GuiCase):
    def open(self, surface):
        self.select(self.add_mesh(surface))
        panel = self.run_command("Thicken_Check")
        wait_until(lambda: panel.defects is not None, "the surface is checked")
        return panel

    def test_a_good_surface(self):
        panel = self.open(saddle())
        self.assertIn("no defect", self.child(panel, "Status").text())
        self.assertEqual(self.doc.UndoCount, 0)

    def test_defects_are_listed_marked_and_gone_to(self):
        panel = self.open(crossing_plates())
        rows = self.child(panel, "Defects")
        (kind,) = [rows.topLevelItem(k) for k in range(rows.topLevelItemCount())]
        self.assertIn("Triangles that cross", kind.text(0))
        self.assertGreater(kind.childCount(), 3)
        self.assertGreater(self.marked(), 100, "the defects are not marked")
        self.picture("check-surface")
        camera = Gui.activeDocument().activeView().getCameraNode()
        before = camera.height.getValue()
        row = kind.child(kind.childCount() - 1)
        click(rows.viewport(), rows.visualItemRect(row).center()) if rows.visualItemRect(row).isValid() else None
        panel.go(row)
        self.assertLess(camera.height.getValue(), before / 2)
        self.assertIn("(", panel.sentence.text())
        self.picture("check-surface-zoomed")
        self.press("Close")
        self.wait_closed()
        self.assertEqual(self.marked(), 0, "marks were left behind")

    def test_edges_are_listed(self):
        panel = self.open(fin())
        rows = self.child(panel, "Defects")
        self.assertEqual(rows.topLevelItemCount(), len(panel.defects))
        self.assertGreater(rows.topLevelItem(0).childCount(), 0)
        self.assertGreater(self.marked(), 5)

    def marked(self):
        """Pixels that have about the colour of marks."""
        image = self.view_image().astype(int)
        wanted = np.array(preferences.colour("ColorDefect")) * 255
        return int((np.abs(image - wanted).max(-1) < 40).sum())


class RepairSurface(GuiCase):
    def test_a_mended_copy_is_made_and_told(self):
        source = self.add_mesh(crossing_plates())
        self.select(source)
        self.run_command("Thicken_Repair")
        (mended,) = [obj for obj in self.doc.Objects if hasattr(obj, "Changes")]
        self.assertTrue(mended.Valid, mended.getStatusString())
        self.assertGreater(mended.Removed, 0)
        self.assertFalse(source.ViewObject.Visibility)
        self.assertEqual(ThickenWorkbench.check_surface(mended), [])
        wait_until(lambda: self.messages, "it is told")
        self.assertIn(mended.Changes[0], self.messages[0])
        self.assertEqual(self.doc.UndoCount, 1)
        self.doc.undo()
        self.assertEqual(self.doc.Objects, [source])

    def test_it_follows_from_the_check(self):
        self.select(self.add_mesh(fin()))
        panel = self.run_command("Thicken_Check")
        wait_until(lambda: panel.defects is not None, "the surface is checked")
        self.assertTrue(panel.repair.isVisible())
        click(panel.repair)
        wait_until(lambda: self.messages, "it is told")
        self.assertFalse(Gui.Control.activeDialog())
        (mended,) = [obj for obj in self.doc.Objects if hasattr(obj, "Changes")]
        self.assertTrue(mended.Valid)
        self.assertEqual(ThickenWorkbench.check_surface(mended), [])
