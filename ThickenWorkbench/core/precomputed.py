# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids that were computed ahead, such as by a task panel in another thread, for the recompute that wants them.

The library gives the same bytes for the same surface and arguments, so that a recompute which takes
one of them ends with what it would have computed itself.
"""

from __future__ import annotations

import hashlib
import json
from typing import TYPE_CHECKING, Any

import numpy as np

from thicken.arrays import thicken_mesh

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from thicken.arrays import ThickenedMesh

_offered: dict[str, ThickenedMesh] = {}


def key(surface: tuple[ArrayLike, ArrayLike], arguments: dict[str, Any]) -> str:
    """What a solid depends on, as a short text. Threads and memory limits do not change it."""
    digest = hashlib.blake2b(digest_size=20)
    for array, kind in zip(surface, ("<f8", "<i8")):
        digest.update(np.ascontiguousarray(array, kind).tobytes())
    digest.update(json.dumps(arguments, sort_keys=True, default=np.ndarray.tolist).encode())
    return digest.hexdigest()


def offer(surface: tuple[ArrayLike, ArrayLike], arguments: dict[str, Any], solid: ThickenedMesh) -> None:
    """Keep `solid` until withdraw() is called."""
    _offered[key(surface, arguments)] = solid


def withdraw() -> None:
    """Forget all that was offered, and free the memory."""
    _offered.clear()


def thicken(surface: tuple[ArrayLike, ArrayLike], arguments: dict[str, Any], **limits: Any) -> ThickenedMesh:
    """As thicken_mesh(), or the solid that was offered for the same surface and arguments."""
    if _offered:
        solid = _offered.get(key(surface, arguments))
        if solid is not None:
            return solid
    vertices, triangles = surface
    return thicken_mesh(vertices, triangles, **arguments, **limits)
