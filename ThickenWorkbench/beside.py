# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a feature stands to the object that it is made from: its place, its group, what is shown."""

from __future__ import annotations

from typing import Any

import FreeCAD as App

from . import windows


def put_beside(feature: Any, source: Any) -> None:
    """Add `feature` to the group with a coordinate system that `source` is in, if any.

    A link must not leave its coordinate system. A body takes only features of its own kind: what is
    made from one of them goes beside the body.
    """
    group = source.getParentGeoFeatureGroup()
    while group is not None and group.isDerivedFrom("Part::BodyBase"):
        group = group.getParentGeoFeatureGroup()
    if group is not None:
        group.addObject(feature)


def placement_in_parent_of(feature: Any, source: Any) -> Any:
    """The Placement that puts `feature` where `source` is, whatever groups the two are in."""
    if feature.getParentGeoFeatureGroup() == source.getParentGeoFeatureGroup():
        return source.Placement
    parent = feature.getGlobalPlacement().multiply(feature.Placement.inverse())
    return parent.inverse().multiply(source.getGlobalPlacement())


def show_instead_of(feature: Any, source: Any) -> None:
    """Give `feature` its view provider and hide `source`, where there are windows."""
    windows.attach_view(feature)
    if App.GuiUp:
        source.ViewObject.Visibility = False
