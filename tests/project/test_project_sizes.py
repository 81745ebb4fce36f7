# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files and functions that are read in one go: none is longer than CONTRIBUTING.md says."""

import ast
import re
import unittest
from pathlib import Path

from project_sources import PROJECT, sources

MOST_LINES = 60
MOST_LINES_OF_FILE = 400

# What is longer so far, and may not grow.
LONGER = {
    "libthicken/src/reconstruct/window.cpp": 420,
}

# The line that begins the body of a function, as clang-format leaves it.
BODY = re.compile(r"^ *(?!(?:if|for|while|switch|else|catch)\b|\} else).*(?:\)|\)(?: const| noexcept| override| mutable)+|\) -> [^()]+) \{$")


def long_in_cpp(text: str) -> list[tuple[str, int]]:
    """The functions of a C++ text that are too long: what the line of their body begins with, and their lines."""
    lines = text.splitlines()
    found = []
    for start in (number for number, line in enumerate(lines) if BODY.match(line)):
        depth, end = 0, start
        while end < len(lines):
            depth += lines[end].count("{") - lines[end].count("}")
            if depth <= 0:
                break
            end += 1
        if end - start + 1 > MOST_LINES:
            found.append((lines[start].strip(), end - start + 1))
    return found


def long_in_python(text: str) -> list[tuple[str, int]]:
    """The functions of a Python text whose code is too long: what a docstring says does not count."""
    functions = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.FunctionDef)]
    sizes = [(node.name, (node.end_lineno or 0) - node.lineno + 1 - docstring_lines(node)) for node in functions]
    return [(name, size) for name, size in sizes if size > MOST_LINES]


def docstring_lines(function: ast.FunctionDef) -> int:
    first = function.body[0]
    return (first.end_lineno or 0) - first.lineno + 1 if ast.get_docstring(function) is not None else 0


class Sizes(unittest.TestCase):
    def files(self) -> list[Path]:
        """All but tests, which are lists of cases."""
        every = sources("libthicken", "thicken", "ThickenWorkbench", "examples")
        return [file for file in every if file.suffix in (".h", ".cpp", ".py") and "tests" not in file.parts]

    def test_no_file_is_too_long(self):
        sizes = {file.relative_to(PROJECT).as_posix(): len(file.read_text().splitlines()) for file in self.files()}
        self.assertGreater(len(sizes), 300)
        self.assertEqual({name: n for name, n in sizes.items() if n > LONGER.get(name, MOST_LINES_OF_FILE)}, {})

    def test_no_function_is_too_long(self):
        found = {}
        for file in self.files():
            look = long_in_python if file.suffix == ".py" else long_in_cpp
            found |= {f"{file.relative_to(PROJECT)}: {name}": size for name, size in look(file.read_text())}
        self.assertEqual({name: n for name, n in found.items() if n > LONGER.get(name, 0)}, {})

    def test_long_functions_are_found(self):
        body = "  work();\n" * MOST_LINES
        self.assertEqual([size for _, size in long_in_cpp(f"void f(int a) {{\n{body}}}\n")], [MOST_LINES + 2])
        self.assertEqual(long_in_cpp(f"namespace a {{\n{body}}}\nvoid f() {{\n}}\n"), [])
        self.assertEqual([name for name, _ in long_in_python("def f():\n" + "    pass\n" * MOST_LINES)], ["f"])


if __name__ == "__main__":
    unittest.main()
