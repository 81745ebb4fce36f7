# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds and loads the compiled extension `_thicken`, and explains when that fails.

It is looked for in the folder that THICKEN_NATIVE_DIR names (only there, if set), then in this
package, then as an installed module. One that was built for another version of the package is
refused: after an update of the workbench, a stale extension would be the likeliest trouble.
"""

from __future__ import annotations

import importlib
import importlib.util
import os
import sys
import sysconfig
from pathlib import Path
from types import ModuleType

from . import __version__

PACKAGE_DIR = Path(__file__).resolve().parent
DIRECTORY_VARIABLE = "THICKEN_NATIVE_DIR"

_loaded: ModuleType | None = None


class NativeError(ImportError):
    """The extension is missing, does not load, or belongs to another version; the text says which."""


def load() -> ModuleType:
    """Return the extension module; raise NativeError where there is none that fits."""
    global _loaded
    if _loaded is None:
        module = _find()
        _require_version(module)
        _loaded = module
    return _loaded


def file_name() -> str:
    """The name of the file that fits this Python, such as _thicken.cpython-311-x86_64-linux-gnu.so."""
    return "_thicken" + (sysconfig.get_config_var("EXT_SUFFIX") or ".so")


def _find() -> ModuleType:
    chosen = os.environ.get(DIRECTORY_VARIABLE)
    folder = Path(chosen) if chosen else PACKAGE_DIR
    file = folder / file_name()
    if file.is_file():
        return _load_file(file)
    if not chosen:
        try:
            return importlib.import_module("_thicken")
        except ModuleNotFoundError:
            pass
        except ImportError as error:
            raise NativeError(_explain("The installed _thicken does not load", error)) from error
    raise NativeError(_explain(f"{file} does not exist"))


def _load_file(file: Path) -> ModuleType:
    # A name within the package: two copies of the extension in one process stay two modules.
    name = f"{__package__}._thicken"
    spec = importlib.util.spec_from_file_location(name, file)
    assert spec is not None and spec.loader is not None, file
    try:
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    except ImportError as error:
        raise NativeError(_explain(f"{file} does not load", error)) from error
    sys.modules[name] = module  # so that pickle finds its classes
    return module


def _require_version(module: ModuleType) -> None:
    built = getattr(module, "__version__", "unknown")
    if built != __version__:
        raise NativeError(
            _explain(f"{module.__file__} is of version {built}, but the workbench is of version {__version__}")
        )


def _explain(what: str, error: ImportError | None = None) -> str:
    others = sorted(path.name for path in PACKAGE_DIR.glob("_thicken*") if path.suffix in {".so", ".pyd"})
    lines = [
        f"Thicken cannot compute: {what}" + (f": {error}" if error else "."),
        f"Expected: {file_name()} for Python {sys.version.split()[0]}.",
        f"Found in {PACKAGE_DIR}: {', '.join(others) or 'no extension'}.",
        "Build it with CMake (option THICKEN_PYTHON=ON), using the Python that runs this program, "
        f"or set {DIRECTORY_VARIABLE} to the folder that holds it.",
    ]
    return "\n".join(lines)
