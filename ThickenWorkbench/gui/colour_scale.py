# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours for values: red where a wall is thin, blue where it is thick."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

# Stops of ColorBrewer's RdYlBu, which can be told apart by people who do not see red or green.
_STOPS = np.array([
    (165, 0, 38), (215, 48, 39), (244, 109, 67), (253, 174, 97), (254, 224, 144), (255, 255, 191),
    (224, 243, 248), (171, 217, 233), (116, 173, 209), (69, 117, 180), (49, 54, 149),
]) / 255.0  # fmt: skip

UNKNOWN = (0.62, 0.62, 0.62)


def colours(values: ArrayLike, low: float, high: float) -> NDArray[np.float64]:
    """A colour, n × 3, for each value; values beyond the ends have the colour of the end, NaN is grey."""
    values = np.asarray(values, float)
    known = np.isfinite(values)
    span = high - low
    share = np.clip((np.where(known, values, low) - low) / (span if span > 0 else 1.0), 0, 1)
    at = np.linspace(0, 1, len(_STOPS))
    result = np.column_stack([np.interp(share, at, _STOPS[:, channel]) for channel in range(3)])
    result[~known] = UNKNOWN
    return result


def ticks(low: float, high: float, count: int = 5) -> list[float]:
    """Round numbers from `low` to `high`, about `count` of them."""
    span = high - low
    if not span > 0:
        return [low]
    step = 10.0 ** np.floor(np.log10(span / count))
    step *= next(factor for factor in (1, 2, 5, 10) if span / (factor * step) <= count)
    first = np.ceil(low / step - 1e-9)
    return [float(k * step) + 0.0 for k in np.arange(first, np.floor(high / step + 1e-9) + 1)]
