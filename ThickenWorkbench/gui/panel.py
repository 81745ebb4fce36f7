# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels have in common: what FreeCAD calls, and runs beside it."""

from __future__ import annotations

from typing import Any, Callable

from . import messages
from .job import Job
from .qt import QtCore, standard_buttons
from .run_row import RunRow


class Panel:
    """Shown by editing.show()."""

    buttons = ("Close",)
    form: Any
    run_row: RunRow | None = None  #: where a run shows its progress
    _job: Job | None = None  #: the run whose result the panel waits for
    _timer: Any = None  #: until the next run, where there is a pause before it
    _closed = False

    def getStandardButtons(self) -> Any:
        return standard_buttons(*self.buttons)

    def isAllowedAlterSelection(self) -> bool:
        return True

    def reject(self) -> bool:
        self.close()
        return True

    def close(self) -> None:
        """Leave nothing behind; the panel itself goes with FreeCAD's dialog."""
        if self._closed:
            return
        self._closed = True
        self.abandon()
        self.leave_view()

    def watch(self) -> None:
        """Close also when something else, such as a macro, takes the dialog away."""
        self.form.destroyed.connect(self._destroyed)

    def leave_view(self) -> None:
        """Take away all that is drawn over the objects."""
        raise NotImplementedError

    # --- runs ---

    def compute(self, make_step: Callable[[], Any], done: Callable[[Any], None], failed: Callable[[str], None]) -> None:
        """Run the step that `make_step` reads from the document, instead of one that is under way.

        `done` gets its result, `failed` the sentences for the user: those of an error, or none where the user has stopped it.
        """
        self.abandon()
        try:
            step = make_step()
        except Exception as error:  # nothing to compute with: told like an error of the run
            failed(messages.sentences(error))
            return

        def ended(job: Job) -> None:
            self._job = None
            self._show_running(False)
            if job.cancelled or messages.was_cancelled(job.error):
                failed("")
            elif job.error is not None:
                failed(messages.sentences(job.error))
            else:
                done(job.results[0])

        self._show_running(True)
        tick = self.run_row.progressed if self.run_row is not None else None
        self._job = Job([step], ended, tick).start()

    def stop(self) -> None:
        """Ask the run to end; it does within a second."""
        if self._job is not None:
            self._job.cancel()

    def abandon(self) -> None:
        """Forget the run."""
        if self._job is not None:
            self._job.abandon()
            self._job = None
            if not self._closed:
                self._show_running(False)

    def _show_running(self, running: bool) -> None:
        if self.run_row is not None:
            self.run_row.show_running(running)

    def _destroyed(self, *_: Any) -> None:
        """The widgets are gone."""
        if self._closed:
            return
        self.forget_runs()
        QtCore.QTimer.singleShot(0, self.close)  # when FreeCAD has finished with the dialog

    def forget_runs(self) -> None:
        """None of them may tell the widgets anything any more."""
        if self._timer is not None:
            self._timer.stop()
        if self._job is not None:
            self._job.abandon()
            self._job = None
