# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run will take, told before it begins: the library's forecast, with what this machine takes of it."""

from __future__ import annotations

from typing import Any, NamedTuple

from . import preferences
from thicken.arrays import SurfaceSize, forecast_mesh

# How many times the forecast runs take here. It starts with 1 and follows the runs on this machine.
_KEY = "TimesForecast"

# How much a run counts against all before it.
_WEIGHT = 0.3

# The arguments of thicken_mesh() that make a difference.
_NAMES = ("side", "method", "cell", "resolution", "tolerance", "gap", "threads")


class Forecast(NamedTuple):
    """About how long, and how much memory at most."""

    seconds: float
    bytes: int

    def sentence(self) -> tuple[str, str]:
        """The two as short texts: “3 s”, “120 MB”."""
        seconds = self.seconds
        time = f"{seconds:.1g} s" if seconds < 10 else f"{seconds:.0f} s" if seconds < 90 else f"{seconds / 60:.0f} min"
        return time, f"{self.bytes / 1e6:.0f} MB"


def bytes_of(triangles: int) -> int:
    """What checking or measuring so many triangles takes at most."""
    return forecast_mesh(SurfaceSize(triangles, 0.0, 0.0), 1.0)[1]


def _told(size: SurfaceSize, arguments: dict[str, Any]) -> tuple[float, int]:
    given = {name: arguments[name] for name in _NAMES if name in arguments}
    return forecast_mesh(size, arguments["thickness"], **given)


def forecast(sizes: list[SurfaceSize], arguments: dict[str, Any]) -> Forecast:
    """For surfaces that are thickened one after the other, with these arguments of thicken_mesh()."""
    told = [_told(size, arguments) for size in sizes]
    return Forecast(preferences.get(_KEY) * sum(t[0] for t in told), max(t[1] for t in told))


def learn(size: SurfaceSize, arguments: dict[str, Any], seconds: float) -> None:
    """Take in how long a run really took on this machine."""
    if size.triangles < 1000 or not seconds > 0:  # too short to tell
        return
    seen = seconds / _told(size, arguments)[0]
    preferences.put(_KEY, preferences.get(_KEY) ** (1 - _WEIGHT) * seen**_WEIGHT)
