# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which triangle of a feature's solid is the surface's own, which is shell and which is wall.

A feature stores the regions as runs of equal ones: the library's results have few of them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def runs_of(region: NDArray[np.uint8]) -> list[int]:
    """Region, count, region, count, … of an array of regions."""
    if len(region) == 0:
        return []
    starts = np.concatenate([[0], np.flatnonzero(np.diff(region.astype(np.int16))) + 1])
    counts = np.diff(np.append(starts, len(region)))
    return [int(number) for pair in zip(region[starts], counts) for number in pair]


def facet_regions(feature: Any) -> NDArray[np.uint8]:
    """A value of Region for each facet of the mesh of a Thicken feature, in their order.

    A document from before regions were stored has the numbers of them only: the regions follow one
    another. Without a solid the array is empty.
    """
    runs = list(getattr(feature, "RegionRuns", ()))
    if not runs and not hasattr(feature, "OriginalTriangles"):
        return np.empty(0, np.uint8)
    if not runs:
        counts = (feature.OriginalTriangles, feature.ShellTriangles, feature.WallTriangles)
        runs = [number for pair in enumerate(counts) for number in pair]
    return np.repeat(np.array(runs[::2], np.uint8), runs[1::2])
