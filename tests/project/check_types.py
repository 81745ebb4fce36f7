# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs mypy with the project's settings: `check_types.py CACHE`. Ends with 77 where there is no mypy."""

import sys
from importlib.util import find_spec
from subprocess import run

from project_sources import PROJECT

if find_spec("mypy") is None:
    print("no mypy: types are not checked")
    sys.exit(77)
sys.exit(run([sys.executable, "-m", "mypy", "--cache-dir", sys.argv[1]], cwd=PROJECT).returncode)
