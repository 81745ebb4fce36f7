# SPDX-License-Identifier: LGPL-2.1-or-later
"""One licence line in every source, one version everywhere, and what the library may not do."""

import os
import re
import unittest
from pathlib import Path

from project_sources import PROJECT, cycles, folder_graph, include_graph, joined, sources

VERSION = os.environ["THICKEN_VERSION"]
FOLDERS = ("libthicken", "thicken", "ThickenWorkbench", "packaging", "cmake", "examples", "tests")


def offenders(files: list[Path], pattern: str) -> list[str]:
    return [str(f.relative_to(PROJECT)) for f in files if re.search(pattern, f.read_text(), re.MULTILINE)]


class Rules(unittest.TestCase):
    def test_no_units_of_the_library_include_each_other(self):
        """A unit is a header with its source; what is inline for speed has a header of its own, which belongs to it."""
        graph = joined(include_graph(), lambda name: re.sub(r"(_inline)?\.(h|cpp)$", "", name))
        self.assertGreater(len(graph), 100)
        self.assertEqual(cycles(graph), [])
        self.assertEqual(cycles({"a": {"b"}, "b": {"c"}, "c": {"b"}}), ["b", "c"])

    def test_no_folders_of_the_library_include_each_other(self):
        """What lies beside the folders is what puts them together: no folder but the program's includes it."""
        graph = folder_graph()
        self.assertGreater(len(graph), 15)
        self.assertEqual(cycles(graph), [])
        self.assertEqual({folder for folder in graph if "." in graph[folder]}, {"program"})

    def test_every_folder_of_the_library_has_its_namespace(self):
        """Headers open that of their folder alone; a source opens `thicken`, too, to define what public headers declare."""
        others = {"check": "checking", "repair": "repairing", "trim": "trimming", "src": "pipeline"}
        wrong, seen = [], set()
        for file in (f for f in sources("libthicken/src") if f.suffix in (".h", ".cpp")):
            own = "thicken::" + others.get(file.parent.name, file.parent.name)
            allowed = {own} if file.suffix == ".h" else {own, "thicken"}
            opened = set(re.findall(r"^namespace (thicken[\w:]*) \{", file.read_text(), re.MULTILINE))
            seen |= opened
            wrong += [f"{file.relative_to(PROJECT)} opens {n}" for n in opened if n not in allowed and not n.startswith(own + "::")]
        self.assertEqual(wrong, [])
        self.assertGreater(len(seen), 15)

    def test_every_source_names_the_licence_first(self):
        files = sources(*FOLDERS) + [f for f in (PROJECT / "scripts").iterdir() if f.is_file()]
        self.assertGreater(len(files), 50)
        missing = [str(f.relative_to(PROJECT)) for f in files
                   if "SPDX-License-Identifier: LGPL-2.1-or-later" not in "".join(f.read_text().splitlines()[:2])]  # fmt: skip
        self.assertEqual(missing, [])

    def test_one_version_everywhere(self):
        for name, pattern in (
            ("package.xml", r"<version>([^<]+)</version>"),
            ("ThickenWorkbench/__init__.py", r'__version__ = "([^"]+)"'),
            ("thicken/__init__.py", r'__version__ = "([^"]+)"'),
            ("pyproject.toml", r'^version = "([^"]+)"'),
            ("CHANGELOG.md", r"^## (\d\S+)"),  # below what is not released yet
        ):
            with self.subTest(name):
                found = re.search(pattern, (PROJECT / name).read_text(), re.MULTILINE)
                self.assertIsNotNone(found, f"{name} has no version")
                self.assertEqual(found[1], VERSION)

    def test_the_library_prints_nothing_and_knows_nothing_of_freecad(self):
        library = [f for f in sources("libthicken/src", "libthicken/include") if "program" not in f.parts]
        self.assertGreater(len(library), 20)
        self.assertEqual(offenders(library, r"std::(cout|cerr|clog)|\bprintf\(|#include <iostream>"), [])
        self.assertEqual(offenders(library, r"#include [<\"](FreeCAD|App/|Base/|Mesh/|Python\.h|pybind11)"), [])

    def test_loops_over_threads_go_through_parallel_for(self):
        files = [f for f in sources("libthicken/src") if f.name != "parallel_for.h"]
        self.assertEqual(offenders(files, r"^\s*#pragma omp|#include <omp\.h>"), [])

    def test_what_is_no_standard_cpp_is_in_one_folder(self):
        """The platform's own functions; SSE has guards where it is used, and a fallback."""
        pattern = r"#include <(unistd|fcntl|io|process|windows|psapi|malloc)\.h>|#include <sys/|__builtin_|\bmalloc_trim\(|\bmallopt\("
        files = sources("libthicken/src", "libthicken/include", "libthicken/python")
        self.assertEqual(offenders([f for f in files if "platform" not in f.parts], pattern), [])
        self.assertNotEqual(offenders([f for f in files if "platform" in f.parts], pattern), [])

    def test_headers_are_safe_to_include(self):
        headers = sources("libthicken/include")
        self.assertEqual(offenders(headers, r"using namespace "), [])
        self.assertEqual([str(h) for h in headers if h.name.endswith(".h") and "#pragma once" not in h.read_text()], [])


if __name__ == "__main__":
    unittest.main()
