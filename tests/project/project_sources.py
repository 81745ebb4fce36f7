# SPDX-License-Identifier: LGPL-2.1-or-later
"""The project's files, and graphs of what includes or imports what."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Callable

PROJECT = Path(__file__).resolve().parents[2]
SOURCES = (".h", ".cpp", ".py", ".pyi", ".cmake", ".h.in", ".cmake.in")

Graph = dict[str, set[str]]


def sources(*folders: str) -> list[Path]:
    files = [f for folder in folders for f in (PROJECT / folder).rglob("*") if f.is_file()]
    return [f for f in files if f.name.endswith(SOURCES) or f.name == "CMakeLists.txt"]


def cycles(graph: Graph) -> list[str]:
    """Those nodes of a graph from which a way leads back to them."""

    def reachable(start: str) -> set[str]:
        seen: set[str] = set()
        waiting = list(graph[start])
        while waiting:
            node = waiting.pop()
            if node not in seen:
                seen.add(node)
                waiting += graph.get(node, ())
        return seen

    return sorted(node for node in graph if node in reachable(node))


def include_graph() -> Graph:
    """Which file of the library's sources includes which, by their paths below `libthicken/src`."""
    root = PROJECT / "libthicken/src"
    files = {f.relative_to(root).as_posix(): f for f in root.rglob("*") if f.suffix in (".h", ".cpp")}
    included = {name: set(re.findall(r'^#include "(.+)"', f.read_text(), re.MULTILINE)) for name, f in files.items()}
    return {name: found & set(files) for name, found in included.items()}


def joined(graph: Graph, node_of: Callable[[str], str]) -> Graph:
    """The graph of what `node_of` puts the nodes into; no node leads to itself."""
    whole: Graph = {}
    for name, following in graph.items():
        own = node_of(name)
        whole.setdefault(own, set()).update({node_of(other) for other in following} - {own})
    return whole


def folder_graph() -> Graph:
    """Which folder of the library's sources includes which; "." is what lies beside the folders."""
    return joined(include_graph(), lambda name: name.rpartition("/")[0] or ".")


def reduced(graph: Graph) -> Graph:
    """A graph without circles, and without what follows from the rest of it."""

    def reaches(start: str, goal: str) -> bool:
        return any(node == goal or reaches(node, goal) for node in graph[start])

    return {a: {b for b in following if not any(reaches(c, b) for c in following if c != b)} for a, following in graph.items()}


def module_of(file: Path) -> str:
    """The name by which Python imports a file of this project."""
    parts = file.relative_to(PROJECT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imports(file: Path) -> set[str]:
    """All that a Python file imports, wherever it does: modules, and names that may be modules."""
    package = module_of(file) if file.name == "__init__.py" else module_of(file).rpartition(".")[0]
    found: set[str] = set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            above = package.split(".")[: len(package.split(".")) + 1 - node.level] if node.level else []
            home = ".".join([*above, *([node.module] if node.module else [])])
            found |= {f"{home}.{alias.name}" for alias in node.names}
    return found


def python_graph(*packages: str) -> Graph:
    """Which module of the packages imports which. Naming a module in a package is no import of the package."""
    files = {module_of(f): f for package in packages for f in (PROJECT / package).rglob("*.py")}
    graph: Graph = {}
    for module, file in files.items():
        known = {name if name in files else name.rpartition(".")[0] for name in imports(file)}
        graph[module] = {name for name in known if name in files and name != module}
    return graph
