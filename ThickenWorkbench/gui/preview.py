# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows in the view what the inputs of a panel would give, as they are being edited.

A request waits until the user pauses, cancels a run that is not wanted any more, and computes in
another thread. What is shown was computed for the inputs shown beside it, or is taken away.
"""

from __future__ import annotations

from typing import Any, Callable

from .. import preferences, runs
from thicken.arrays import Region, ThickenedMesh, thicken_mesh
from .job import Job
from .overlay import faces, over_object
from .qt import QtCore

_PAUSE_MS = 300
_TRANSPARENCY = 0.35


class Preview:
    """One preview over some objects. `told` gets the solids, or the error, of the latest request."""

    def __init__(self, objects: list[Any], told: Callable[[list[ThickenedMesh], BaseException | None], None]) -> None:
        self._overlays = [over_object(obj) for obj in objects]
        self._told = told
        self._runs: list[tuple[Any, dict[str, Any]]] = []
        self._solids: list[ThickenedMesh] | None = None
        self._job: Job | None = None
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._start)

    def request(self, runs: list[tuple[Any, dict[str, Any]]]) -> None:
        """Preview surfaces with arguments of thicken_mesh(), in the order of the objects."""
        self.cancel()
        self._runs = runs
        self._timer.start(_PAUSE_MS)

    def cancel(self) -> None:
        """Stop computing, and forget the solids; what is shown stays until hide()."""
        self._solids = None
        self._timer.stop()
        if self._job is not None:
            self._job.abandon()
            self._job = None

    def busy(self) -> bool:
        return self._timer.isActive() or self._job is not None

    def solids(self) -> list[ThickenedMesh] | None:
        """Those of the latest request, once they are there: the very ones that a run with its inputs would make."""
        return self._solids

    def hide(self) -> None:
        for overlay in self._overlays:
            overlay.show()

    def remove(self) -> None:
        self.cancel()
        for overlay in self._overlays:
            overlay.remove()

    def _start(self) -> None:
        def step(surface: Any, arguments: dict[str, Any]) -> Callable[[Any], ThickenedMesh]:
            return lambda context: thicken_mesh(*surface, **arguments, **limits, context=context)

        limits = {"threads": runs.threads(), "memory": runs.memory()}

        self._job = Job([step(*run) for run in self._runs], self._finished).start()

    def _finished(self, job: Job) -> None:
        self._job = None
        if job.error is None:
            self._solids = job.results
            for overlay, solid in zip(self._overlays, job.results):
                overlay.show(*_nodes(solid))
        else:
            self.hide()
        self._told(job.results, job.error)


def _nodes(solid: ThickenedMesh) -> list[Any]:
    """What the solid adds to the surface, which the object itself shows."""
    colours = {Region.SHELL: "ColorShell", Region.WALL: "ColorWall"}
    return [
        faces(solid.vertices, solid.triangles[solid.region == region], preferences.colour(key), _TRANSPARENCY)
        for region, key in colours.items()
        if (solid.region == region).any()
    ]
