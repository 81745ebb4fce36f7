# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench. What they do to documents are lines that a recorded macro can repeat.

Panels are imported when a command runs: activating the workbench must cost next to nothing.
"""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

from .. import runs
from ..view_provider import ICONS
from . import chosen

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class Command:
    """What all have in common. The texts are marked for translation under the command's name."""

    name = ""
    icon = ""
    menu = ""
    tip = ""
    help = ""

    def GetResources(self) -> dict[str, str]:
        return {
            "Pixmap": str(ICONS / self.icon),
            "MenuText": self.menu,
            "ToolTip": self.tip,
            "StatusTip": self.tip,
            "WhatsThis": self.help,
        }

    def IsActive(self) -> bool:
        return App.ActiveDocument is not None and self.is_usable() and not Gui.Control.activeDialog()

    def is_usable(self) -> bool:
        """Whether targets() would find something; FreeCAD asks all the time, so this has to be quick."""
        return chosen.anything()

    def explain_link(self) -> bool:
        """Whether there is nothing but links, about which the user is told."""
        links = chosen.links()
        if not links or self.targets():
            return False
        from . import messages

        messages.tell_link(links[0])
        return True

    def targets(self) -> list[Any]:
        """What of the selection the command can use."""
        raise NotImplementedError

    def Activated(self) -> None:
        """What FreeCAD calls."""
        if not self.explain_link():
            self.activate()

    def activate(self) -> None:
        """Do it with the targets()."""
        raise NotImplementedError


class PanelCommand(Command):
    """Opens the task panel of the one object that it can use."""

    panel = ("", "")  #: the module here and its class

    def activate(self) -> None:
        from . import editing

        module, name = self.panel
        panel = getattr(import_module(f".{module}", __package__), name)
        target = self.targets()[0]
        editing.show(lambda: panel(target))


class MakeCommand(Command):
    name = "Thicken_Make"
    icon = "thicken.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Make", "Thicken...")
    tip = QT_TRANSLATE_NOOP("Thicken_Make", "Turn the selected open surfaces into printable solids")
    help = QT_TRANSLATE_NOOP(
        "Thicken_Make",
        "Select meshes, shapes or faces. A panel asks for the thickness and the side and previews the solid, "
        "which keeps every triangle of the surface and follows it afterwards.",
    )

    def targets(self) -> list[Any]:
        return chosen.surfaces()

    def activate(self) -> None:
        from . import editing
        from .thicken_panel import ThickenPanel

        targets = self.targets()
        editing.show(lambda: ThickenPanel(targets))


class CheckCommand(PanelCommand):
    panel = ("check_panel", "CheckPanel")
    name = "Thicken_Check"
    icon = "check_surface.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Check", "Check Surface")
    tip = QT_TRANSLATE_NOOP("Thicken_Check", "Find and mark everything that keeps a surface from being thickened")
    help = QT_TRANSLATE_NOOP(
        "Thicken_Check",
        "Select a mesh or a shape. All defects are listed and marked in the view; a click on one goes there.",
    )

    def targets(self) -> list[Any]:
        return chosen.surfaces()[:1]


class RepairCommand(Command):
    name = "Thicken_Repair"
    icon = "repair_surface.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Repair", "Repair Surface")
    tip = QT_TRANSLATE_NOOP("Thicken_Repair", "Make a mended copy of the selected surfaces, and list every change")
    help = QT_TRANSLATE_NOOP(
        "Thicken_Repair",
        "Select a mesh or a shape. The new object follows it without its defects; its properties list what was changed.",
    )

    def targets(self) -> list[Any]:
        return chosen.surfaces()

    def activate(self) -> None:
        from .repairing import repair

        repair([item.source for item in self.targets()])


class TrimCommand(Command):
    name = "Thicken_Trim"
    icon = "trim_surface.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Trim", "Trim Surface")
    tip = QT_TRANSLATE_NOOP("Thicken_Trim", "Cut a part out of a surface, along a loop that is clicked or closed wires")
    help = QT_TRANSLATE_NOOP(
        "Thicken_Trim",
        "Select a mesh or a shape, and click points of a loop on it. Or select sketches or wires near it, too. The new object follows them; its rim is where the loop is on the surface.",
    )

    def targets(self) -> list[Any]:
        """The surface, and the wires after it; without wires the loop is clicked."""
        surfaces = chosen.surface_objects()[:1]
        return [*surfaces, *chosen.wires()] if surfaces else []

    def is_usable(self) -> bool:
        return bool(self.targets())

    def activate(self) -> None:
        from . import editing
        from .trim_panel import TrimPanel
        from .trimming import trim

        source, *wires = self.targets()
        if wires:
            trim(source, wires)
        else:
            editing.show(lambda: TrimPanel(source))


class MapCommand(PanelCommand):
    panel = ("map_panel", "MapPanel")
    name = "Thicken_Map"
    icon = "thickness_map.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Map", "Thickness Map")
    tip = QT_TRANSLATE_NOOP("Thicken_Map", "Colour a solid by the thickness of its wall or by its deviation")
    help = QT_TRANSLATE_NOOP(
        "Thicken_Map",
        "Select a thickened or drained solid. A panel shows the scale, the least and the largest value and a histogram.",
    )

    def targets(self) -> list[Any]:
        return chosen.made_solids()[:1]

    def is_usable(self) -> bool:
        return bool(self.targets())


class RegionsCommand(PanelCommand):
    panel = ("regions_panel", "RegionsPanel")
    name = "Thicken_Regions"
    icon = "thickness_regions.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Regions", "Thickness Regions...")
    tip = QT_TRANSLATE_NOOP("Thicken_Regions", "Paint where a thickened solid is thicker or thinner")
    help = QT_TRANSLATE_NOOP(
        "Thicken_Regions",
        "Select a thickened solid. A brush paints regions on its surface that have a thickness of their own; around them it changes gradually.",
    )

    def targets(self) -> list[Any]:
        return [obj for obj in chosen.solids() if chosen.is_thicken(obj) and obj.Source is not None][:1]

    def is_usable(self) -> bool:
        return bool(self.targets())


class DrainCommand(PanelCommand):
    panel = ("drain_panel", "DrainPanel")
    name = "Thicken_Drain"
    icon = "drain_holes.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Drain", "Drain Holes...")
    tip = QT_TRANSLATE_NOOP("Thicken_Drain", "Let resin out of the cavities of a solid")
    help = QT_TRANSLATE_NOOP(
        "Thicken_Drain",
        "Select a solid. Holes are placed at the lowest points of each cavity for a print direction, "
        "or where you click.",
    )

    def targets(self) -> list[Any]:
        return [obj for obj in chosen.solids() if chosen.is_mesh(obj)][:1]

    def is_usable(self) -> bool:
        return bool(self.targets())


class ReportCommand(PanelCommand):
    panel = ("report_panel", "ReportPanel")
    name = "Thicken_Report"
    icon = "printability.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Report", "Printability Report...")
    tip = QT_TRANSLATE_NOOP("Thicken_Report", "Volume, thinnest wall, trapped resin and overhangs of a solid")
    help = QT_TRANSLATE_NOOP(
        "Thicken_Report",
        "Select a solid. The facts are shown, and can be saved as a page with pictures or as JSON.",
    )

    def targets(self) -> list[Any]:
        return chosen.printables()[:1]


class ExportCommand(Command):
    name = "Thicken_Export"
    icon = "export.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Export", "Export for Printing...")
    tip = QT_TRANSLATE_NOOP("Thicken_Export", "Write a solid as STL or 3MF, read it again and judge it")
    help = QT_TRANSLATE_NOOP(
        "Thicken_Export",
        "Select a solid. The file is written whole or not at all, in millimetres, and what is in it is proved valid.",
    )

    def targets(self) -> list[Any]:
        return chosen.printables()[:1]

    def activate(self) -> None:
        from .exporting import export

        export(self.targets()[0])


class SolidCommand(Command):
    name = "Thicken_Solid"
    icon = "part_solid.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Solid", "Part Solid")
    tip = QT_TRANSLATE_NOOP("Thicken_Solid", "Make a solid of Part from a closed mesh; it follows the mesh")
    help = QT_TRANSLATE_NOOP(
        "Thicken_Solid",
        "Select thickened or drained solids, or other closed meshes. Each gets a solid with a planar face for each triangle.",
    )

    def targets(self) -> list[Any]:
        return [obj for obj in chosen.solids() if chosen.is_mesh(obj)]

    def is_usable(self) -> bool:
        return bool(self.targets())

    def activate(self) -> None:
        from .solids import make_solids

        make_solids(self.targets())


class StopCommand(Command):
    """For a FreeCAD that recomputes beside its windows, which then have no dialog."""

    name = "Thicken_Stop"
    icon = "stop.svg"
    menu = QT_TRANSLATE_NOOP("Thicken_Stop", "Stop Computing")
    tip = QT_TRANSLATE_NOOP("Thicken_Stop", "Stop whatever Thicken computes at the moment")
    help = QT_TRANSLATE_NOOP("Thicken_Stop", "A feature that was being recomputed is without a solid until the next recompute.")

    def IsActive(self) -> bool:
        return runs.any_running()

    def Activated(self) -> None:
        runs.cancel_all()


COMMANDS = [MakeCommand, CheckCommand, RepairCommand, TrimCommand, RegionsCommand, MapCommand, DrainCommand, ReportCommand,
            ExportCommand, SolidCommand, StopCommand]  # fmt: skip


def register() -> list[str]:
    """Add the commands to FreeCAD and return their names."""
    # Recorded macros import a module of the name of the file that adds a command: let it be the package.
    add = compile("Gui.addCommand(name, command)", f"{Path(__file__).parent.parent}.py", "exec")
    for command in COMMANDS:
        exec(add, {"Gui": Gui, "name": command.name, "command": command()})
    return [command.name for command in COMMANDS]


def usable() -> list[str]:
    """The names of those that can do something with the selection, for a context menu."""
    return [command.name for command in COMMANDS if command().IsActive()]
