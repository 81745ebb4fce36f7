# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run of a program, for tables that compare versions of it."""

from __future__ import annotations

import os
import resource
import subprocess
from typing import Any, NamedTuple


class Run(NamedTuple):
    status: int  # below 0: ended by this signal
    seconds: float  # of the processor, which other programs on the machine hardly lengthen
    said: str  # on stderr


def measured_run(command: list[Any], most_seconds: int) -> Run:
    """Runs `command`, and ends it after `most_seconds` of the processor."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace",
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (most_seconds, most_seconds)))  # fmt: skip
    said = process.stderr.read()
    process.stderr.close()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return Run(process.returncode, used.ru_utime + used.ru_stime, said)
