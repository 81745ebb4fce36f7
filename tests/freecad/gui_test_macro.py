# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is clicked is recorded, and the recorded macro gives the same bytes in a FreeCAD without windows."""

import hashlib
import os
import shutil
import subprocess
import unittest
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import Mesh
from PySide import QtCore, QtGui

from ThickenWorkbench import mesh_io
from gui_case import GuiCase, process_events, type_text, wait_until
from thicken_surfaces import grid, saddle

FREECADCMD = os.environ.get("FREECADCMD") or shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
ROOT = Path(__file__).resolve().parents[2]

REPLAY = """
import sys
sys.path.insert(0, {root!r})
import FreeCAD as App
App.openDocument({document!r})
exec(compile(open({macro!r}).read(), "macro", "exec"), {{"App": App, "FreeCAD": App, "__name__": "__main__"}})
import hashlib
from ThickenWorkbench import mesh_io
for obj in App.ActiveDocument.Objects:
    if obj.isDerivedFrom("Mesh::Feature"):
        arrays = mesh_io.arrays_from_mesh(obj.Mesh)
        print("\\nreplayed", obj.Name, hashlib.sha256(b"".join(a.tobytes() for a in arrays)).hexdigest())
"""


def digest(obj) -> str:
    return hashlib.sha256(b"".join(array.tobytes() for array in mesh_io.arrays_from_mesh(obj.Mesh))).hexdigest()


@unittest.skipUnless(FREECADCMD, "no freecadcmd to replay with")
class Recorded(GuiCase):
    def start_recording(self, name):
        def fill():
            dialog = QtGui.QApplication.activeModalWidget()
            if dialog is None or isinstance(dialog, QtGui.QMessageBox):
                QtCore.QTimer.singleShot(100, fill)
                return
            dialog.findChild(QtGui.QLineEdit, "lineEditPath").setText(name)
            dialog.findChild(QtGui.QPushButton, "buttonStart").click()

        App.ParamGet("User parameter:BaseApp/Preferences/Macro").SetString("MacroPath", str(self.folder))
        QtCore.QTimer.singleShot(100, fill)
        Gui.runCommand("Std_DlgMacroRecord")
        process_events()

    def stop_recording(self):
        # FreeCAD 1.0 has one command for both.
        stop = "Std_MacroStopRecord" if "Std_MacroStopRecord" in Gui.listCommands() else "Std_DlgMacroRecord"
        Gui.runCommand(stop)
        process_events()

    def thicken(self, source, thickness, side):
        self.select(source)
        panel = self.run_command("Thicken_Make")
        type_text(self.child(panel, "Thickness"), thickness)
        self.child(panel, "Side").setCurrentIndex(side)
        self.press("Ok")
        self.wait_closed()

    def session(self, sources):
        """A bit of everything, by clicks."""
        self.select(sources[0])
        panel = self.run_command("Thicken_Check")
        wait_until(lambda: panel.defects is not None, "the surface is checked")
        self.press("Close")
        self.wait_closed()
        self.thicken(sources[0], "1.2 mm", 0)
        self.thicken(sources[1], "0.8 mm", 1)
        first = self.doc.getObject("Thicken")
        Gui.getDocument(self.doc.Name).setEdit(first.Name, 0)
        from ThickenWorkbench.gui import editing

        type_text(self.child(editing.current(), "Thickness"), "1.5 mm")
        self.child(editing.current(), "Quality").setCurrentIndex(2)
        self.press("Ok")
        self.wait_closed()
        for obj in self.doc.Objects:  # all lie in one place, and the brush paints on what is seen
            obj.ViewObject.Visibility = obj == first
        self.select(first)
        self.run_command("Thicken_Regions")
        view = Gui.activeDocument().activeView()
        self.drag_view(*(view.getPointOnScreen(sources[0].Mesh.BoundBox.Center + App.Vector(x, 0, 0)) for x in (-4, 4)))
        self.press("Ok")
        self.wait_closed()
        self.assertEqual(list(first.RegionThickness), [2.25])
        self.select(first)
        panel = self.run_command("Thicken_Map")
        wait_until(lambda: panel.map is not None, "the map is there")
        self.press("Close")
        self.wait_closed()

    def print_it(self, cube, target):
        """Hollow, drain, report, export: by clicks."""
        self.thicken(cube, "2 mm", 0)
        hollow = self.doc.Objects[-1]
        self.select(hollow)
        self.run_command("Thicken_Drain")
        self.press("Ok")
        self.wait_closed()
        drained = self.doc.getObject("DrainHoles")
        self.assertTrue(drained.Valid)
        self.select(drained)
        panel = self.run_command("Thicken_Report")
        wait_until(lambda: panel.report is not None, "the report is there")
        self.press("Close")
        self.wait_closed()
        self.select(drained)
        self.answer_file_dialog(target)
        self.run_command("Thicken_Export")
        self.assertTrue(target.is_file(), self.messages)

    def replay(self, document, macro):
        code = REPLAY.format(root=str(ROOT), document=str(document), macro=str(macro))
        run = subprocess.run([FREECADCMD, "-c", code], capture_output=True, text=True, stdin=subprocess.DEVNULL)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        lines = [line.split() for line in run.stdout.splitlines() if line.startswith("replayed ")]
        return {name: value for _, name, value in lines}

    def test_a_macro_gives_the_same_bytes(self):
        bump = grid(lambda x, y: 3 * (x * x < 25) * (25 - x * x) / 25)
        sources = [self.add_mesh(saddle(), "First"), self.add_mesh(bump, "Second")]
        cube = self.doc.addObject("Mesh::Feature", "Cube")
        cube.Mesh = Mesh.createBox(20, 20, 20)
        exported = self.folder / "cube.stl"
        document = self.folder / "start.FCStd"
        self.doc.saveAs(str(document))
        self.start_recording("clicked.FCMacro")
        self.session(sources)
        self.print_it(cube, exported)
        self.stop_recording()
        (macro,) = self.folder.glob("clicked*.FCMacro")
        text = macro.read_text()
        for word in ("check_surface(", "make_thicken(", "thickness='1.2 mm'", ".Thickness = '1.5 mm'", "set_thickness_regions(", "thickness_map(",
                     "make_drain_holes(", "printability(", "export_for_printing("):  # fmt: skip
            self.assertIn(word, text)
        meshes = [obj for obj in self.doc.Objects if obj.isDerivedFrom("Mesh::Feature")]
        self.assertGreater(len(meshes), 6)
        content = exported.read_bytes()
        exported.unlink()
        self.assertEqual(self.replay(document, macro), {obj.Name: digest(obj) for obj in meshes})
        self.assertEqual(exported.read_bytes(), content)
