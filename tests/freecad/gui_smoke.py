# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clicks through the workbench in a FreeCAD with windows. Run by run-gui; ends FreeCAD itself.

What happens is written to the file that THICKEN_GUI_LOG names: FreeCAD's own output is full of
other things, and its exit status says nothing.
"""

import os
import sys
import traceback
from pathlib import Path

sys.path.insert(0, str(Path(os.path.abspath(sys.argv[-1])).parent))

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ThickenWorkbench import mesh_io, view_provider
from thicken_surfaces import fin, saddle

LOG = Path(os.environ["THICKEN_GUI_LOG"])
MESSAGES = []  # the texts of message boxes


def require(condition, what):
    if not condition:
        raise AssertionError(what)


def wait(milliseconds=300):
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    loop.exec_() if hasattr(loop, "exec_") else loop.exec()


def close_message():
    """Nobody is there to click: a box that stays open would wait for ever."""
    box = QtGui.QApplication.activeModalWidget()
    if box is not None:
        MESSAGES.append(box.text() if hasattr(box, "text") else box.windowTitle())
        box.close()


def workbench_offers_the_command():
    Gui.activateWorkbench("ThickenWorkbench")
    require(Gui.activeWorkbench().name() == "ThickenWorkbench", "the workbench is not active")
    require("Thicken" in Gui.activeWorkbench().listToolbars(), "no toolbar")
    require(not Gui.Command.get("Thicken_Make").isActive(), "active without a selection")


def command_thickens_the_selection(doc):
    source = doc.addObject("Mesh::Feature", "Scan")
    source.Mesh = mesh_io.mesh_from_arrays(*saddle())
    Gui.Selection.addSelection(source)
    require(Gui.Command.get("Thicken_Make").isActive(), "not active with a mesh selected")
    Gui.runCommand("Thicken_Make")
    feature = doc.getObject("Thicken")
    require(feature is not None and feature.isValid() and feature.Valid, f"no solid: {MESSAGES}")
    require(isinstance(feature.ViewObject.Proxy, view_provider.ThickenViewProvider), "no view provider")
    require(feature.ViewObject.Visibility and not source.ViewObject.Visibility, "wrong object shown")
    return source, feature


def undo_and_redo(doc, source):
    doc.undo()
    require(doc.getObject("Thicken") is None, "undo left the feature")
    require(source.ViewObject.Visibility, "undo left the source hidden")
    doc.redo()
    require(doc.getObject("Thicken").Valid, "redo lost the solid")


def refusal_is_told(doc):
    """The message box has the feature's own sentence."""
    bad = doc.addObject("Mesh::Feature", "Bad")
    bad.Mesh = mesh_io.mesh_from_arrays(*fin())
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(bad)
    Gui.runCommand("Thicken_Make")
    refused = doc.getObject("Thicken001")
    require(refused is not None and not refused.isValid(), "a bad mesh was not refused")
    require(len(MESSAGES) == 1 and refused.getStatusString() in MESSAGES[0], f"messages: {MESSAGES}")


def delete_shows_the_source(doc, source):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(doc.getObject("Thicken"))
    Gui.runCommand("Std_Delete")
    require(doc.getObject("Thicken") is None, "the feature was not deleted")
    require(source.ViewObject.Visibility, "the source stayed hidden")


def leave_picture(feature):
    target = os.environ.get("THICKEN_GUI_PICTURE")
    if not target:
        return
    feature.ViewObject.DisplayMode = "Flat Lines"
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    wait()
    Gui.activeDocument().activeView().saveImage(target, 1000, 700, "White")


def main():
    timer = QtCore.QTimer()
    timer.timeout.connect(close_message)
    timer.start(200)
    workbench_offers_the_command()
    doc = App.newDocument("Smoke")
    source, _ = command_thickens_the_selection(doc)
    undo_and_redo(doc, source)
    feature = doc.getObject("Thicken")
    leave_picture(feature)
    refusal_is_told(doc)
    delete_shows_the_source(doc, source)


try:
    main()
    LOG.write_text("thicken: the window test passed\n")
except BaseException:
    LOG.write_text(traceback.format_exc())
os._exit(0)
