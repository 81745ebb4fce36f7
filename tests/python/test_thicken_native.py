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

import thicken
from thicken import native

ROOT = Path(__file__).resolve().parents[2]  # the package that is tested may be an installed one


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
        self.assertIn(native.platform_name(), text)
        self.assertIn(sys.version.split()[0], text)
        self.assertIn("docs/install.md", text)

    def test_what_is_there_for_others_is_told(self):
        package = self.folder / "thicken"
        other = package / "binaries" / "win-amd64" / "_thicken.cp311-win_amd64.pyd"
        other.parent.mkdir(parents=True)
        other.touch()
        with mock.patch.object(native, "PACKAGE_DIR", package):
            self.assertIn("There is: win-amd64/_thicken.cp311-win_amd64.pyd.", self.failure())

    def test_of_the_binaries_the_one_for_this_platform_and_python_is_taken(self):
        package = self.folder / "thicken"
        for platform in (native.platform_name(), "other-cpu"):
            folder = package / "binaries" / platform
            folder.mkdir(parents=True)
            (folder / native.file_name()).touch()
            (folder / "_thicken.cpython-399-other.so").write_bytes(b"of another Python")
        environment = {name: value for name, value in os.environ.items() if name != native.DIRECTORY_VARIABLE}
        with mock.patch.object(native, "PACKAGE_DIR", package), mock.patch.dict(os.environ, environment, clear=True):
            self.assertEqual(native._find(), package / "binaries" / native.platform_name() / native.file_name())

    def test_of_an_installed_package(self):
        """The add-on has none for this Python, but a wheel is installed."""
        wheel = self.folder / "site" / "thicken"
        wheel.mkdir(parents=True)
        (wheel / native.file_name()).touch()
        environment = {name: value for name, value in os.environ.items() if name != native.DIRECTORY_VARIABLE}
        with (
            mock.patch.object(native, "PACKAGE_DIR", self.folder / "thicken"),
            mock.patch.object(sys, "path", [str(wheel.parent)]),
            mock.patch.dict(os.environ, environment, clear=True),
        ):
            self.assertEqual(native._find(), wheel / native.file_name())

    def test_not_loadable_keeps_the_loader_s_own_words(self):
        (self.folder / native.file_name()).write_bytes(b"not a shared object, but long enough to look at")
        self.assertRegex(self.failure(), "does not load: .*(ELF|file too short|invalid)")

    def test_of_another_abi(self):
        with mock.patch.object(native, "ABI", native.ABI + 1):
            with self.assertRaises(native.NativeError) as caught:
                native.load()
        self.assertIn(f"has the ABI {native.ABI}, but this version needs the ABI {native.ABI + 1}", str(caught.exception))

    def test_of_another_version_with_the_same_abi(self):
        with mock.patch.object(thicken, "__version__", "99.0.0"):
            self.assertTrue(native.load())

    def test_loads_once(self):
        self.assertIs(native.load(), native.load())
        self.assertEqual(native.load().__version__, thicken.__version__)

    def test_package_can_be_imported_without_it(self):
        code = "import thicken, sys; assert 'numpy' not in sys.modules; thicken.ThickenError"
        run = subprocess.run(
            [sys.executable, "-B", "-c", code],
            env={**os.environ, native.DIRECTORY_VARIABLE: str(self.folder)},
            capture_output=True,
            text=True,
        )
        self.assertEqual(run.returncode, 1)
        self.assertIn("NativeError: Thicken cannot compute", run.stderr)


class Names(unittest.TestCase):
    def test_lazy_names_exist(self):
        for name in thicken.__all__:
            self.assertTrue(hasattr(thicken, name), name)
        with self.assertRaises(AttributeError):
            thicken.no_such_name

    def test_package_is_typed(self):
        self.assertTrue((Path(thicken.__file__).parent / "py.typed").is_file())

    def test_version_is_that_of_the_project(self):
        text = (ROOT / "CMakeLists.txt").read_text()
        (version,) = re.findall(r"project\(\w+\s+VERSION\s+([\d.]+)", text)
        self.assertEqual(version, thicken.__version__)


@unittest.skipUnless(thicken.__file__.startswith(str(ROOT)), "an installed package has no workbench beside it")
class Workbench(unittest.TestCase):
    def test_has_the_same_objects(self):
        import ThickenWorkbench

        self.assertEqual(ThickenWorkbench.__version__, thicken.__version__)
        for name in thicken.OF_ARRAYS + thicken.OF_EXTENSION:
            self.assertIs(getattr(ThickenWorkbench, name), getattr(thicken, name), name)
        with self.assertRaises(AttributeError):
            ThickenWorkbench.no_such_name


class Stub(unittest.TestCase):
    """_thicken.pyi describes the extension as it is built."""

    def setUp(self):
        self.module = native.load()
        stub = Path(thicken.__file__).with_name("_thicken.pyi")
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
