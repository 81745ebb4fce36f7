# SPDX-License-Identifier: LGPL-2.1-or-later
#
# FreeCAD executes this file inside a function: names of the top level are not visible in methods,
# and there is no __file__. Hence the imports where they are used.
import FreeCADGui as Gui


class ThickenWorkbench(Gui.Workbench):
    """Printable solids from open mesh surfaces."""

    MenuText = "Thicken"
    ToolTip = "Turn open mesh surfaces into printable solids"

    def __init__(self):
        from ThickenWorkbench.gui import for_features
        from ThickenWorkbench.view_provider import ICONS

        for_features.connect()
        self.__class__.Icon = str(ICONS / "thicken.svg")

    def Initialize(self):
        from ThickenWorkbench.gui import commands, language, preferences_page

        language.load()
        preferences_page.add()
        names = commands.register()
        self.appendToolbar("Thicken", names)
        self.appendMenu("Thicken", names)

    def Activated(self):
        from ThickenWorkbench.gui import notice

        notice.show_if_needed()

    def ContextMenu(self, recipient):
        from ThickenWorkbench.gui import commands

        names = commands.usable()
        if names:
            self.appendContextMenu("Thicken", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


Gui.addWorkbench(ThickenWorkbench())
