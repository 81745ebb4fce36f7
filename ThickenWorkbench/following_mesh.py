# SPDX-License-Identifier: LGPL-2.1-or-later
"""What features have in common whose mesh is made of another object."""

from __future__ import annotations

from typing import Any

import Mesh

from .beside import placement_in_parent_of
from .proxy import StatelessProxy


class FollowingMesh(StatelessProxy):
    """Proxy of a Mesh::FeaturePython whose mesh is made of its Source, and lies where that does."""

    def make(self, obj: Any) -> tuple[Any, Any]:
        """The mesh, and what show() is to tell of it. Raises where it is refused."""
        raise NotImplementedError

    def show(self, obj: Any, told: Any) -> None:
        """Tell of a mesh in the properties; None: there is none."""
        raise NotImplementedError

    def execute(self, obj: Any) -> None:
        """Make the mesh. When that is refused, nothing of an earlier one stays behind."""
        try:
            mesh, told = self.make(obj)
        except BaseException:
            self.clear(obj)
            raise
        mesh.Placement = placement_in_parent_of(obj, obj.Source)
        obj.Mesh = mesh  # takes over the Placement as well
        self.show(obj, told)

    def clear(self, obj: Any) -> None:
        obj.Mesh = Mesh.Mesh()
        self.show(obj, None)
