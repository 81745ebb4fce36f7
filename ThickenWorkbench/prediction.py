# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run will take, told before it begins: seconds of this machine, and memory."""

from __future__ import annotations

from typing import NamedTuple

from . import preferences

_MIB = 1 << 20

# Seconds for a triangle of the surface. The time is close to linear in them, so that one number, which starts
# with a measurement and follows the runs on this machine, is enough for “about”.
_KEY = "SecondsPerTriangle"

# How much a run counts against all before it.
_WEIGHT = 0.3

# As the library's own forecast, which it compares with the limit before it begins (libthicken/src/plan.cpp).
_BYTES_PER_TRIANGLE = 1250
_BYTES = 16 * _MIB


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
    return _BYTES + triangles * _BYTES_PER_TRIANGLE


def forecast(triangles: int, side: str) -> Forecast:
    """For a surface of so many triangles."""
    shells = 2 if side.lower() == "both" else 1
    # Two shells: the surface is checked once, but swept, audited and measured twice.
    seconds = triangles * preferences.get(_KEY) * (1 + shells) / 2
    return Forecast(seconds, _BYTES + triangles * _BYTES_PER_TRIANGLE * (1 + shells) // 2)


def learn(triangles: int, side: str, seconds: float) -> None:
    """Take in how long a run really took on this machine."""
    if triangles < 1000 or not seconds > 0:  # too short to tell
        return
    shells = 2 if side.lower() == "both" else 1
    seen = seconds / (triangles * (1 + shells) / 2)
    preferences.put(_KEY, (1 - _WEIGHT) * preferences.get(_KEY) + _WEIGHT * seen)
