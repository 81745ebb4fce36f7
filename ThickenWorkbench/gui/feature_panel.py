# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels have in common that make a feature or change one."""

from __future__ import annotations

from typing import Any

import FreeCADGui as Gui

from . import messages
from .panel import Panel


class FeaturePanel(Panel):
    """With `feature`, that one is edited. Nothing is written before OK."""

    buttons = ("Ok", "Cancel")
    document: Any
    feature: Any  #: None: one is to be made
    status: Any  #: the label that tells why there is none

    def _make(self) -> Any:
        """Make the feature, recomputed, and return it."""
        raise NotImplementedError

    def _change(self) -> Any:
        """The same of the one that is edited."""
        raise NotImplementedError

    def commit(self, title: str) -> bool:
        """Make or change the feature in one step that can be undone, and close; False where it is refused.

        Its recompute shows progress and can be stopped.
        """
        if self._timer is not None:
            self._timer.stop()
        self.abandon()
        self.document.openTransaction(title)
        try:
            made = self._make() if self.feature is None else self._change()
        except Exception as error:  # arguments that make no sense: told here, nothing was made
            self.document.abortTransaction()
            self.status.setText(messages.sentences(error))
            return False
        if not made.isValid():
            self.status.setText(made.getStatusString())
            self.document.abortTransaction()
            return False
        self.document.commitTransaction()
        return self.reject()

    def reject(self) -> bool:
        self.close()
        if self.feature is not None:
            Gui.getDocument(self.document.Name).resetEdit()
        return True
