# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds and loads the compiled extension `_thicken`, and explains when that fails.

It is looked for in the folder that THICKEN_NATIVE_DIR names (only there, if set). Otherwise in this package, where a
wheel has it; in the workbench beside it, where a build of the sources puts it; in `binaries/<platform>`, where the
add-on brings one for each platform and Python; and in a `thicken` that is installed elsewhere, such as from a wheel.
The first that is there is loaded. What has another ABI than this package is refused: after an update of the add-on, a
stale extension would be the likeliest trouble.
"""

from __future__ import annotations

import importlib.util
import os
import platform
import sys
import sysconfig
from pathlib import Path
from types import ModuleType

# Counts the changes of the extension's interface that this package's Python code cannot do without. CMake compiles
# the number in. Two versions with the same number may be mixed.
ABI = 3

PACKAGE_DIR = Path(__file__).resolve().parent
DIRECTORY_VARIABLE = "THICKEN_NATIVE_DIR"

_loaded: ModuleType | None = None


class NativeError(ImportError):
    """The extension is missing, does not load, or has another ABI; the text says which."""


def load() -> ModuleType:
    """Return the extension module; raise NativeError where there is none that fits."""
    global _loaded
    if _loaded is None:
        module = _load_file(_find())
        _require_abi(module)
        _loaded = module
    return _loaded


def is_there() -> bool:
    """Whether there is an extension for this system and Python; it is not loaded."""
    try:
        return _loaded is not None or _find().is_file()
    except NativeError:
        return False


def place_for_file() -> Path:
    """The folder that a file_name() from elsewhere can be put into."""
    return PACKAGE_DIR / "binaries" / platform_name()


def file_name() -> str:
    """The name of the file that fits this Python, such as _thicken.cpython-311-x86_64-linux-gnu.so."""
    return "_thicken" + (sysconfig.get_config_var("EXT_SUFFIX") or ".so")


def platform_name() -> str:
    """System and processor, such as linux-x86_64, win-amd64, macosx-arm64: file names do not tell all of them apart."""
    parts = sysconfig.get_platform().split("-")
    return f"{parts[0]}-{parts[-1]}" if len(parts) > 1 else parts[0]


def _folders() -> list[Path]:
    chosen = os.environ.get(DIRECTORY_VARIABLE)
    if chosen:
        return [Path(chosen)]
    installed = [Path(entry) / "thicken" for entry in sys.path if entry]
    return [
        PACKAGE_DIR,
        PACKAGE_DIR.parent / "ThickenWorkbench",
        place_for_file(),
        *(folder for folder in installed if folder.resolve() != PACKAGE_DIR),
    ]


def _find() -> Path:
    folders = _folders()
    for folder in folders:
        file = folder / file_name()
        if file.is_file():
            return file
    where = folders[0] if len(folders) == 1 else "the add-on"
    raise NativeError(_explain(f"there is no {file_name()} in {where}"))


def _load_file(file: Path) -> ModuleType:
    # A name within the package: two copies of the extension in one process stay two modules.
    name = f"{__package__}._thicken"
    spec = importlib.util.spec_from_file_location(name, file)
    assert spec is not None and spec.loader is not None, file
    try:
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    except ImportError as error:
        raise NativeError(_explain(f"{file} does not load: {error}")) from error
    sys.modules[name] = module  # so that pickle finds its classes
    return module


def _require_abi(module: ModuleType) -> None:
    built = getattr(module, "__abi__", None)
    if built != ABI:
        raise NativeError(_explain(f"{module.__file__} has the ABI {built}, but this version needs the ABI {ABI}"))


def _brought() -> list[str]:
    """The extensions that are there, for whatever platform and Python."""
    files = [*PACKAGE_DIR.glob("_thicken*"), *PACKAGE_DIR.glob("binaries/*/_thicken*"),
             *(PACKAGE_DIR.parent / "ThickenWorkbench").glob("_thicken*")]  # fmt: skip
    return sorted(
        f"{file.parent.name}/{file.name}" if file.parent.parent.name == "binaries" else file.name
        for file in files
        if file.suffix in {".so", ".pyd"}
    )


def _explain(what: str) -> str:
    version = sys.version.split()[0]
    lines = [
        f"Thicken cannot compute: {what}.",
        f"It needs the compiled part {file_name()} for {platform.system()} ({platform_name()}) and Python {version}.",
        f"There is: {', '.join(_brought()) or 'none'}.",
        "Install the add-on archive of Thicken for this system, or the package freecad-thicken on Debian, or use a FreeCAD whose "
        f"Python is among those above. If you have the file, put it into {place_for_file()}, or set "
        f"{DIRECTORY_VARIABLE} to its folder. How to make it of the sources: docs/install.md.",
    ]
    return "\n".join(lines)
