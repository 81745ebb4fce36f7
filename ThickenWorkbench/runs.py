# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computations between reading a document and writing it.

A step is a function of a RunContext that returns a result. The main thread makes it, and reads all that it
needs of the document before; the step itself holds arrays and numbers only, so that any thread may run it.
"""

from __future__ import annotations

import atexit
import threading
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Callable, Iterator, TypeVar

import FreeCAD as App

from . import preferences, prediction, windows
from .numbers import count
from .numbers import place as place_text
from .sources import RefusedError

if TYPE_CHECKING:
    from thicken._thicken import RunContext

translate = App.Qt.translate

Result = TypeVar("Result")
Step = Callable[["RunContext"], Result]


class CancelledError(RefusedError):
    """A step was stopped outside of the library, which has an error of its own for that."""

    code = "cancelled"


_running: list[Any] = []
_lock = threading.Lock()


def threads() -> int:
    """How many the user wants; 0: all that the machine has. Threads belong to the machine, not to a document."""
    return max(0, preferences.get("Threads"))


def memory() -> int | None:
    """The user's limit in MiB, or None."""
    limit = preferences.get("MemoryMiB")
    return limit if limit > 0 else None


def require_room(triangles: int) -> None:
    """Raise RefusedError where checking or measuring so many triangles would pass the user's limit."""
    limit, needed = memory(), prediction.bytes_of(triangles)
    if limit is not None and needed > limit << 20:
        text = translate(
            "Thicken", "{triangles} triangles take about {needed} MiB, and the preferences allow {limit} MiB. "
                       "Allow more there, or simplify the mesh."
        )  # fmt: skip
        raise RefusedError(text.format(triangles=count(triangles), needed=count(needed >> 20), limit=count(limit)))


def run(step: Step[Result]) -> Result:
    """What `step` returns, or raise what it raises.

    In the main thread of a FreeCAD with windows the user sees its progress and can stop it. A FreeCAD that
    recomputes in another thread shows no dialog from there: cancel_all() stops that run.
    """
    shown = windows.connected()
    if shown is not None and threading.current_thread() is threading.main_thread():
        return shown.wait_for(step)
    with started() as context:
        return step(context)


@contextmanager
def started() -> Iterator[RunContext]:
    """A context that cancel_all() reaches as long as the block lasts."""
    from thicken import native

    context = native.load().RunContext()
    with tracked(context):
        yield context


@contextmanager
def tracked(context: RunContext) -> Iterator[None]:
    """The same with a context that is there already."""
    with _lock:
        _running.append(context)
    try:
        yield
    finally:
        with _lock:
            _running.remove(context)


def go_on(context: RunContext | None) -> None:
    """Raise CancelledError where `context` was cancelled; for steps that compute in Python."""
    if context is not None and context.cancelled:
        raise CancelledError("The computation was cancelled.")


def any_running() -> bool:
    return bool(_running)


def cancel_all() -> None:
    """Stop whatever computes now, from any thread. Each run then ends within a second."""
    with _lock:
        for context in _running:
            context.cancel()


# A thread that is inside the library must not outlive the interpreter.
atexit.register(cancel_all)


@contextmanager
def refusing(source: Any) -> Iterator[None]:
    """Turn what the library and FreeCAD's meshes refuse into RefusedError, with sentences for the user."""
    try:
        yield
    except RefusedError:
        raise
    except MemoryError:
        text = translate("Thicken", "There is not enough memory. Simplify the mesh, or choose a coarser quality.")
        raise RefusedError(text) from None
    except ImportError as error:
        raise RefusedError(str(error)) from None
    except RuntimeError as error:
        from .mesh_io import MeshTransferError

        if hasattr(error, "defects"):
            raise RefusedError(sentences(error, source)) from None
        if isinstance(error, MeshTransferError):
            raise RefusedError(str(error)) from None
        raise


def all_parts(error: BaseException) -> list[str]:
    """What an error and its defects say; its own text often begins with the first of them, or ends with it."""
    parts = [defect["sentence"] for defect in getattr(error, "defects", ())]
    text = str(error) or type(error).__name__
    if not parts or parts[0] not in text:
        return [text, *parts]
    return parts if text.startswith(parts[0]) else [text, *parts[1:]]


def sentences(error: Any, source: Any) -> str:
    """All that was found; the library's coordinates are the mesh's own, before the Placement."""
    parts = all_parts(error)
    located = [defect for defect in error.defects if defect["triangles"] or defect["edges"] or defect["vertices"]]
    placement = source.getGlobalPlacement()
    if located and not placement.isIdentity():
        parts.append(in_document(placement, located[0]["place_mm"]))
    return as_sentences(parts)


def in_document(placement: Any, place: Any) -> str:
    """Where a place of a mesh's own coordinates is once its Placement has moved it."""
    at = placement.multVec(App.Vector(*(x or 0.0 for x in place)))
    return translate("Thicken", "in the document the first place is at {place}").format(place=place_text(tuple(at)))


def as_sentences(parts: list[str]) -> str:
    return " ".join(part[:1].upper() + part[1:].rstrip(".") + "." for part in parts)
