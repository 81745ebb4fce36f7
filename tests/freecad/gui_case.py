# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of tests that click: a fresh document, hands and eyes.

Nothing here waits for a fixed time: it waits until something is so, with a limit for a machine that
is busy with other things.
"""

from __future__ import annotations

import os
import tempfile
import time
import unittest
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ThickenWorkbench import mesh_io
from ThickenWorkbench.gui import editing

LIMIT = 90.0  # seconds, far more than anything here takes
PICTURES = os.environ.get("THICKEN_GUI_PICTURES")


def process_events() -> None:
    QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)


def wait_until(condition, what: str, limit: float = LIMIT) -> float:
    """Seconds until `condition` holds; fails after `limit`."""
    begin = time.monotonic()
    while not condition():
        if time.monotonic() - begin > limit:
            raise AssertionError(f"after {limit:g} s still not: {what}")
        process_events()
        time.sleep(0.005)
    return time.monotonic() - begin


def click(widget, position=None) -> None:
    """Press and release the left button."""
    centre = widget.rect().center() if position is None else position
    for kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease):
        buttons = QtCore.Qt.LeftButton if kind == QtCore.QEvent.MouseButtonPress else QtCore.Qt.NoButton
        event = QtGui.QMouseEvent(
            kind, QtCore.QPointF(centre), QtCore.Qt.LeftButton, buttons, QtCore.Qt.NoModifier
        )
        QtGui.QApplication.sendEvent(widget, event)
        process_events()


def type_text(field, text: str) -> None:
    """Replace what is in a field, key by key."""
    line = field if isinstance(field, QtGui.QLineEdit) else field.findChild(QtGui.QLineEdit)
    line.selectAll()
    for letter in text:
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            QtGui.QApplication.sendEvent(line, QtGui.QKeyEvent(kind, 0, QtCore.Qt.NoModifier, letter))
    process_events()


def main_window():
    return Gui.getMainWindow()


def dark_sheet() -> str:
    """The dark style sheet that FreeCAD brings: 0.20 and 1.0 have their own."""
    folder = Path(App.getResourceDir()) / "Gui" / "Stylesheets"
    return next(folder / name for name in ("Behave-dark.qss", "FreeCAD Dark.qss") if (folder / name).is_file()).read_text()


class GuiCase(unittest.TestCase):
    """Closes whatever a test leaves open; message boxes are closed and their texts kept."""

    @classmethod
    def setUpClass(cls):
        Gui.activateWorkbench("ThickenWorkbench")
        window = main_window()
        window.move(0, 0)
        window.resize(1500, 920)
        combo = [dock for dock in window.findChildren(QtGui.QDockWidget) if dock.objectName() == "Combo View"]
        if combo:
            window.resizeDocks(combo[:1], [370], QtCore.Qt.Horizontal)
        for inner in window.findChildren(QtGui.QMdiSubWindow):
            inner.close()  # the start page
        # FreeCAD runs the tests while it "loads" them as a file, and shows its progress: end that.
        progress = App.Base.ProgressIndicator()
        progress.start("", 1)
        progress.next()
        progress.stop()

    def setUp(self):
        self.messages = []
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self._close_message)
        self.timer.start(100)
        self.addCleanup(self.timer.stop)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.doc = App.newDocument("Clicked")
        self.doc.UndoMode = 1
        self.addCleanup(self._close_all)

    def _close_message(self):
        """Nobody is there to click: a box that stays open would wait for ever."""
        box = QtGui.QApplication.activeModalWidget()
        if isinstance(box, QtGui.QMessageBox):
            self.messages.append(box.text())
            box.close()

    def _close_all(self):
        if Gui.Control.activeDialog():
            panel = editing.current()
            if panel is not None:
                panel.reject()
            Gui.Control.closeDialog()
        for name in list(App.listDocuments()):
            App.closeDocument(name)
        process_events()

    # --- documents ---

    def add_mesh(self, surface, name="Scan"):
        obj = self.doc.addObject("Mesh::Feature", name)
        obj.Mesh = mesh_io.mesh_from_arrays(*surface)
        self.doc.recompute()
        self.look()
        return obj

    def select(self, *objects):
        Gui.Selection.clearSelection()
        for obj in objects:
            Gui.Selection.addSelection(obj)
        process_events()

    def look(self):
        view = Gui.activeDocument().activeView()
        view.viewIsometric()
        Gui.SendMsgToActiveView("ViewFit")
        process_events()

    # --- windows ---

    def run_command(self, name):
        """As a click in the toolbar; returns the task panel that it opened, if any."""
        self.assertTrue(Gui.Command.get(name).isActive(), f"{name} is not active")
        (action,) = Gui.Command.get(name).getAction()
        action.trigger()
        process_events()
        return editing.current() if Gui.Control.activeDialog() else None

    def child(self, panel, name):
        """A widget of a panel by its object name."""
        widget = panel.form.findChild(QtCore.QObject, name)
        self.assertIsNotNone(widget, f"no widget {name}")
        return widget

    def press(self, button):
        """Click a standard button of the open task panel, such as "Ok"."""
        code = getattr(QtGui.QDialogButtonBox, button)
        for box in main_window().findChildren(QtGui.QDialogButtonBox):
            if box.isVisible() and box.button(code) is not None:
                click(box.button(code))
                return
        self.fail(f"no button {button}")

    def wait_closed(self):
        """Wait until the open task panel has closed; it stays open with a reason, which ends the wait."""
        form = editing.current().form if Gui.Control.activeDialog() else None
        label = form.findChild(QtGui.QLabel, "Status") if form is not None else None

        def refused():
            try:
                return label is not None and Gui.Control.activeDialog() and "color" in label.styleSheet()
            except RuntimeError:  # the panel is being deleted
                return False

        wait_until(lambda: not Gui.Control.activeDialog() or refused(), "the task panel has closed")
        if Gui.Control.activeDialog():
            self.fail(f"the task panel stays open: {label.text()}")
        process_events()

    def answer_file_dialog(self, path):
        """Type a file name into the dialog that opens next, and accept it."""

        def fill():
            dialog = QtGui.QApplication.activeModalWidget()
            if not isinstance(dialog, QtGui.QFileDialog):
                QtCore.QTimer.singleShot(50, fill)
                return
            dialog.findChild(QtGui.QLineEdit, "fileNameEdit").setText(str(path))
            click(dialog.findChild(QtGui.QDialogButtonBox).button(QtGui.QDialogButtonBox.Save))

        QtCore.QTimer.singleShot(50, fill)

    def viewport(self):
        """The widget that the 3D view is drawn on."""
        area = main_window().findChild(QtGui.QMdiArea)
        # Without a window manager no window may be the active one: then it is the last.
        inner = area.activeSubWindow() or area.subWindowList()[-1]
        view = inner.findChild(QtGui.QGraphicsView)
        port = view.viewport()
        self.kept = [area, inner, view, port]  # PySide forgets a widget with the object that it was found in
        return port

    def click_view(self, pixel):
        """Click in the 3D view; pixels count from the lower left corner, as FreeCAD has them."""
        port = self.viewport()
        ratio = port.devicePixelRatioF()
        click(port, QtCore.QPoint(int(pixel[0] / ratio), int(port.height() - 1 - pixel[1] / ratio)))

    def drag_view(self, start, end, modifiers=QtCore.Qt.NoModifier):
        """Drag in the 3D view with the left button down, from one pixel to another."""
        port = self.viewport()

        def send(kind, pixel, button, buttons):
            ratio = port.devicePixelRatioF()
            place = QtCore.QPointF(int(pixel[0] / ratio), int(port.height() - 1 - pixel[1] / ratio))
            QtGui.QApplication.sendEvent(port, QtGui.QMouseEvent(kind, place, button, buttons, modifiers))
            process_events()

        left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
        send(QtCore.QEvent.MouseButtonPress, start, left, left)
        for share in (0.3, 0.6, 1.0):
            between = [a + share * (b - a) for a, b in zip(start, end)]
            send(QtCore.QEvent.MouseMove, between, none, left)
        send(QtCore.QEvent.MouseButtonRelease, end, left, none)

    def picture(self, name):
        """Leave a picture of FreeCAD's window behind, where THICKEN_GUI_PICTURES names a folder."""
        self.picture_of(main_window(), name)

    def picture_of(self, window, name):
        """The same of any window."""
        for _ in range(3):
            process_events()
        if PICTURES:
            Path(PICTURES).mkdir(parents=True, exist_ok=True)
            target = Path(PICTURES) / f"{name}.png"
            # The window as it is on the screen: a widget's own grab() leaves the 3D view empty.
            shown = QtGui.QGuiApplication.primaryScreen().grabWindow(window.winId())
            self.assertTrue(shown.save(str(target)), f"{target} was not written")

    def view_image(self):
        """What the 3D view shows, as an array of red, green, blue."""
        import numpy as np

        path = self.folder / "view.png"
        Gui.activeDocument().activeView().saveImage(str(path), 300, 240, "White")
        image = QtGui.QImage(str(path)).convertToFormat(QtGui.QImage.Format_RGB888)
        data = np.frombuffer(bytes(image.constBits()), np.uint8)
        return data.reshape(image.height(), image.bytesPerLine())[:, : 3 * image.width()].reshape(image.height(), -1, 3)
