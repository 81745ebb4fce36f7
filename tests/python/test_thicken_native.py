# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finding the extension, and what is said when there is none that fits. The stub file, too."""

import ast
import inspect
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import ThickenWorkbench
from ThickenWorkbench import native

ROOT = Path(ThickenWorkbench.__file__).resolve().parent.parent


class Load(unittest.TestCase):
    def setUp(self):
        native.load()  # for real, before the tests pretend
        patch = mock.patch.object(native, "_loaded", None)
        patch.start()
        self.addCleanup(patch.stop)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def failure(self) -> str:
        with mock.patch.dict(os.environ, {native.DIRECTORY_VARIABLE: str(self.folder)}):
            with self.assertRaises(native.NativeError) as caught:
                native.load()
        self.assertIsInstance(caught.exception, ImportError)
        return str(caught.exception)

    def test_missing(self):
        text = self.failure()
        self.assertIn(native.file_name(), text)
        self.assertIn(str(self.folder), text)
        self.assertIn("does not exist", text)
        self.assertIn("CMake", text)

    def test_not_loadable_keeps_the_loader_s_own_words(self):
        (self.folder / native.file_name()).write_bytes(b"not a shared object, but long enough to look at")
        self.assertRegex(self.failure(), "does not load: .*(ELF|file too short|invalid)")

    def test_of_another_version(self):
        with mock.patch.object(native, "__version__", "99.0.0"):
            with self.assertRaises(native.NativeError) as caught:
                native.load()
        self.assertRegex(str(caught.exception), rf"version {re.escape(ThickenWorkbench.__version__)}, .*99\.0\.0")

    def test_loads_once(self):
        self.assertIs(native.load(), native.load())
        self.assertEqual(native.load().__version__, ThickenWorkbench.__version__)

    def test_package_can_be_imported_without_it(self):
        code = "import ThickenWorkbench, sys; assert 'numpy' not in sys.modules; ThickenWorkbench.ThickenError"
        run = subprocess.run(
            [sys.executable, "-B", "-c", code],
            env={**os.environ, "PYTHONPATH": str(ROOT), native.DIRECTORY_VARIABLE: str(self.folder)},
            capture_output=True,
            text=True,
        )
        self.assertEqual(run.returncode, 1)
        self.assertIn("NativeError: Thicken cannot compute", run.stderr)


class Names(unittest.TestCase):
    def test_lazy_names_exist(self):
        of_arrays = ("arrays", "native", "regions")  # the others need FreeCAD, and are tested in it
        for name, home in ThickenWorkbench._HOMES.items():
            if home in of_arrays:
                self.assertTrue(hasattr(ThickenWorkbench, name), name)
        with self.assertRaises(AttributeError):
            ThickenWorkbench.no_such_name

    def test_package_is_typed(self):
        self.assertTrue((Path(ThickenWorkbench.__file__).parent / "py.typed").is_file())

    def test_version_is_that_of_the_project(self):
        text = (ROOT / "CMakeLists.txt").read_text()
        (version,) = re.findall(r"project\(\w+\s+VERSION\s+([\d.]+)", text)
        self.assertEqual(version, ThickenWorkbench.__version__)


class Stub(unittest.TestCase):
    """_thicken.pyi describes the extension as it is built."""

    def setUp(self):
        self.module = native.load()
        stub = Path(ThickenWorkbench.__file__).with_name("_thicken.pyi")
        self.stub = {node.name: node for node in ast.parse(stub.read_text()).body if hasattr(node, "name")}

    def test_names(self):
        built = {name for name in vars(self.module) if not name.startswith("_")}
        self.assertEqual(set(self.stub), built)

    def test_functions(self):
        for name, node in self.stub.items():
            if not isinstance(node, ast.FunctionDef):
                continue
            signature = inspect.getdoc(getattr(self.module, name)).splitlines()[0]
            # pybind11 writes types in its own way: compare names, kinds and defaults.
            (built,) = ast.parse(f"def {signature}: ...").body
            self.assertEqual(self.arguments(node), self.arguments(built), name)

    @staticmethod
    def arguments(node: ast.FunctionDef):
        given = node.args
        return (
            [argument.arg for argument in given.args],
            [argument.arg for argument in given.kwonlyargs],
            [ast.unparse(default) for default in given.defaults],
            [ast.unparse(default) if default else None for default in given.kw_defaults],
        )

    def test_classes(self):
        for name in ("RunContext", "ThickenError"):
            described = {
                item.target.id if isinstance(item, ast.AnnAssign) else item.name for item in self.stub[name].body
            }
            built = {item for item in vars(getattr(self.module, name)) if not item.startswith("_")}
            self.assertEqual(described - {"__init__"}, built, name)


if __name__ == "__main__":
    unittest.main()
