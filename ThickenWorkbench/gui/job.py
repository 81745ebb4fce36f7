# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls of the library in a thread of their own, while FreeCAD stays alive.

The library releases the interpreter's lock and never calls back, so the main thread polls. Only the
main thread touches documents and widgets: steps are those of runs.py, which hold arrays and return arrays.
"""

from __future__ import annotations

import threading
from typing import Any, Callable

from thicken import native

from .. import runs
from . import modal_run
from .qt import QtCore

_POLL_MS = 50

Step = Callable[[Any], Any]  # takes a RunContext


class Job:
    """Runs steps one after the other; `done` is called in the main thread, whatever came of them."""

    def __init__(
        self,
        steps: list[Step],
        done: Callable[[Job], None],
        tick: Callable[[float, str], None] | None = None,
    ) -> None:
        self.results: list[Any] = []
        self.error: BaseException | None = None
        self.cancelled = False
        self._steps, self._done, self._tick = steps, done, tick
        self._contexts = [native.load().RunContext() for _ in steps]
        self._thread = threading.Thread(target=self._work, name="thicken", daemon=True)
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._poll)

    def start(self) -> Job:
        self._thread.start()
        self._timer.start(_POLL_MS)
        return self

    def running(self) -> bool:
        return self._timer.isActive()

    def cancel(self) -> None:
        """Ask the run to stop; `done` is still called, within a second, and finds `cancelled`."""
        self.cancelled = True
        for context in self._contexts:
            context.cancel()

    def abandon(self) -> None:
        """As cancel(), but `done` is not called any more: its owner is gone."""
        self.cancel()
        self._timer.stop()

    def _work(self) -> None:
        try:
            for step, context in zip(self._steps, self._contexts):
                if self.cancelled:
                    return
                with runs.tracked(context):
                    self.results.append(step(context))
        except BaseException as error:  # shown by the main thread
            self.error = error

    def _poll(self) -> None:
        if modal_run.waits():  # within a recompute: what `done` does to documents has to wait
            return
        if self._thread.is_alive():
            if self._tick is not None:
                finished = min(len(self.results), len(self._steps) - 1)
                context = self._contexts[finished]
                self._tick((finished + context.progress) / len(self._steps), context.stage)
            return
        self._timer.stop()
        self._done(self)
