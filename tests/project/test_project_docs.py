# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pages name is there: options, files, names of the code, other pages and their headings."""

import re
import unittest
from pathlib import Path

from project_sources import PROJECT, sources

PAGES = [*sorted((PROJECT / "docs").rglob("*.md")), PROJECT / "README.md", PROJECT / "CONTRIBUTING.md"]

# Of programs that are not ours: CMake, CTest, GoogleTest, Google Benchmark, Snakemake, perf, and the judge's corpus.
FOREIGN = {
    "--build", "--config", "--install", "--prefix", "--preset", "--target", "--output-on-failure", "--test-dir", "--gtest",
    "--benchmark", "--cores", "--profile", "--call-graph", "--tool", "--set", "--out", "--rotate", "--scale", "--suffix",
}  # fmt: skip

# Where a path in a page may begin.
ROOTS = ("", "libthicken/src", "libthicken/include", "docs", "ThickenWorkbench")

# Folders that builds and runs make, what lies beside the project where there is a corpus, and placeholders.
MADE = ("build", "bin/", "out/", "night/", "../", "tests/fuzz/FORMAT")

# The names of ways to write names.
STYLES = {"UpperCamel", "lowerCamel", "kUpperCamel"}

FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)


def text_of_sources() -> str:
    files = [f for f in sources("libthicken", "thicken", "ThickenWorkbench", "examples", "tests", "cmake", "packaging") if f != Path(__file__)]
    files += [f for folder in ("scripts", "examples") for f in (PROJECT / folder).rglob("*") if f.is_file() and f.suffix in ("", ".sh", ".smk", ".json")]
    files += [PROJECT / "CMakePresets.json", PROJECT / "CMakeLists.txt", PROJECT / "docs/report.schema.json"]
    return "\n".join(f.read_text(errors="replace") for f in files)


def anchor_of(heading: str) -> str:
    """As GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


class Docs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.code = text_of_sources()
        cls.words = set(re.findall(r"\w+", cls.code))

    def each(self, pattern: str) -> list[tuple[str, str]]:
        """What a pattern finds in back quotes of pages."""
        found = []
        for page in PAGES:
            name = page.relative_to(PROJECT).as_posix()
            for quoted in re.findall(r"`([^`\n]+)`", FENCE.sub("", page.read_text())):
                if re.fullmatch(pattern, quoted):
                    found.append((name, quoted))
        return found

    def test_options(self):
        found = [(p.name, option) for p in PAGES for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+", p.read_text())]
        self.assertGreater(len(found), 100)
        ours = set(re.findall(r"--[a-z][a-z-]+", self.code))
        self.assertEqual([pair for pair in found if pair[1] not in FOREIGN | ours], [])

    def test_files(self):
        found = self.each(r"[\w.-]{2,}(/[a-z_0-9][\w.-]*)+/?")
        self.assertGreater(len(found), 40)
        missing = []
        for page, name in found:
            places = [PROJECT / root / name for root in ROOTS]
            if not any(p.exists() or p.with_suffix(".h").exists() or p.with_suffix(".cpp").exists() for p in places):
                missing.append((page, name))
        self.assertEqual([pair for pair in missing if not pair[1].startswith(MADE)], [])

    def test_names_of_the_code(self):
        """Functions, constants, types and environment variables; of FreeCAD's own only those that the workbench uses."""
        pattern = r"[\w.:]*(\w+\(\)|\bk[A-Z]\w+|[A-Z][a-z0-9]+[A-Z]\w*|[A-Z]{3,}_\w+|[a-z]+[A-Z]\w*)"
        found = self.each(pattern)
        self.assertGreater(len(found), 40)
        missing = [(page, name) for page, name in found if re.findall(r"\w+", name)[-1] not in self.words | STYLES]
        self.assertEqual(missing, [])

    def test_formats(self):
        """Each extension in the table of io/formats.cpp is named wherever docs/formats.md says under "Adding a format"."""
        rows = re.findall(r'Format\{"(\.\w+)", (\w+), (\w+)', (PROJECT / "libthicken/src/io/formats.cpp").read_text())
        self.assertGreater(len(rows), 4)
        read, written = ({row[0] for row in rows if row[k] != "nullptr"} for k in (1, 2))
        places = [
            ("docs/formats.md", r"^\| `(\.\w+)` \|.*", read | written),
            ("docs/program.md", r"^\| `INPUT` \|.*", read),
            ("docs/program.md", r"^\| `OUTPUT` \|.*", written),
            ("libthicken/src/program/arguments.cpp", r'"Surface: .*"', read),
            ("libthicken/src/program/arguments.cpp", r'"(?:Solid|Part): .*"', written),
            ("libthicken/python/bind_files.cpp", r'"Read \..*"', read),
            ("libthicken/python/bind_files.cpp", r'"Write \..*"', written),
            ("thicken/arrays.py", r'"""Return the vertices and triangles of a .*', read),
            ("thicken/arrays.py", r'"""Write \..*', written),
        ]
        for name, pattern, extensions in places:
            lines = [match[0] for match in re.finditer(pattern, (PROJECT / name).read_text(), re.MULTILINE)]
            with self.subTest(name, pattern=pattern):
                self.assertNotEqual(lines, [])
                texts = ["\n".join(lines)] if name == "docs/formats.md" else lines  # there each has a row
                self.assertEqual([(e, text) for text in texts for e in sorted(extensions) if not re.search(rf"\{e}\b", text)], [])

    def test_example_in_cpp_is_the_one_that_is_built(self):
        """tests/consume builds it against the installed library."""
        (block,) = re.findall(r"^```cpp\n(.*?)^```", (PROJECT / "docs/cpp.md").read_text(), re.MULTILINE | re.DOTALL)
        example = (PROJECT / "examples/cpp/thicken_example.cpp").read_text()
        self.assertEqual(block, example[example.index("#include") :])

    def test_every_public_header_is_on_its_page(self):
        text = (PROJECT / "docs/cpp.md").read_text()
        headers = [f.name for f in (PROJECT / "libthicken/include/thicken").glob("*.h") if f.name != "surface_facts.h"]
        self.assertGreater(len(headers), 10)
        self.assertEqual([name for name in headers if f"`thicken/{name}`" not in text], [])

    def test_performance_is_a_page_and_no_log(self):
        self.assertLessEqual(len((PROJECT / "docs/performance.md").read_text().splitlines()), 100)

    def test_links(self):
        count = 0
        for page in PAGES:
            for target in re.findall(r"\]\(([^)\s]+)\)", FENCE.sub("", page.read_text())):
                if "://" in target:
                    continue
                count += 1
                name, _, anchor = target.partition("#")
                with self.subTest(page=page.name, target=target):
                    file = (page.parent / name) if name else page
                    self.assertTrue(file.exists())
                    if anchor:
                        headings = re.findall(r"^#+ (.+)$", file.read_text(), re.MULTILINE)
                        self.assertIn(anchor, [anchor_of(heading) for heading in headings])
        self.assertGreater(count, 50)


if __name__ == "__main__":
    unittest.main()
