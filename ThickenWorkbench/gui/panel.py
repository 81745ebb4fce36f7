# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels have in common of what FreeCAD calls."""

from __future__ import annotations

from typing import Any

from .job import Job
from .qt import standard_buttons


class Panel:
    """Shown by Gui.Control.showDialog()."""

    buttons = ("Close",)
    _job: Job | None = None  #: the run whose result the panel waits for

    def getStandardButtons(self) -> Any:
        return standard_buttons(*self.buttons)

    def isAllowedAlterSelection(self) -> bool:
        return True

    def reject(self) -> bool:
        if self._job is not None:
            self._job.abandon()
        self.leave_view()
        return True

    def leave_view(self) -> None:
        """Take away all that is drawn over the objects."""
        raise NotImplementedError
