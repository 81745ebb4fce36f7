# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls as text: what a command does goes through here, so that a recorded macro repeats it.

The lines name the document as App.ActiveDocument and use nothing of the Gui, so that they replay in
a FreeCAD without windows as well.
"""

from __future__ import annotations

from typing import Any

import FreeCADGui as Gui

import ThickenWorkbench

DOCUMENT = "App.ActiveDocument"


class Text(str):
    """Text that is put into a call as it is."""


def reference(obj: Any) -> Text:
    """How a macro finds a document object."""
    return Text(f"{DOCUMENT}.getObject({obj.Name!r})")


def call(function: str, *positional: Any, **named: Any) -> str:
    """The text of a call of a function of ThickenWorkbench; named arguments that are None are left out."""
    parts = [_text(value) for value in positional]
    parts += [f"{name}={_text(value)}" for name, value in named.items() if value is not None]
    return f"ThickenWorkbench.{function}({', '.join(parts)})"


def run(line: str) -> None:
    """Execute a line and record it."""
    Gui.addModule("ThickenWorkbench")
    Gui.doCommand(line)


def assign(variable: str, line: str) -> Any:
    """Execute and record the assignment of a call to a variable of the macro, and return its value."""
    import __main__  # where FreeCAD executes recorded lines

    run(f"{variable} = {line}")
    return getattr(__main__, variable)


def record(variable: str, result: Any, function: str, *positional: Any, **named: Any) -> None:
    """Record the assignment of a call whose result another thread has found already.

    FreeCAD 0.20 records only what it executes: so the call is executed, but takes the result as it is.
    """
    line = f"{variable} = {call(function, *positional, **named)}"
    setattr(ThickenWorkbench, function, lambda *_, **__: result)
    try:
        run(line)
    finally:
        delattr(ThickenWorkbench, function)  # the package finds the real one again


def _text(value: Any) -> str:
    if isinstance(value, Text):
        return value
    if isinstance(value, (list, tuple)):
        inner = ", ".join(_text(item) for item in value)
        return f"[{inner}]" if isinstance(value, list) else f"({inner}{',' if len(value) == 1 else ''})"
    if isinstance(value, float):
        return repr(round(value, 12)) if abs(value) < 1e6 else repr(value)
    if hasattr(value, "Document") and hasattr(value, "Name"):
        return reference(value)
    return repr(value)
