# SPDX-License-Identifier: LGPL-2.1-or-later
"""For proxies that documents name but keep nothing of."""

from __future__ import annotations

from typing import Any


class Stateless:
    """Saves no state, and wants none back."""

    # FreeCAD before 0.21.2 calls the first pair, later ones the second.
    def __getstate__(self) -> None:
        return None

    def __setstate__(self, state: Any) -> None:
        return None

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        return None
