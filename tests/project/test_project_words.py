# SPDX-License-Identifier: LGPL-2.1-or-later
"""One name for one thing: what docs/glossary.md says is not used is nowhere in sources and pages."""

import re
import unittest

from project_sources import PROJECT, sources

GLOSSARY = PROJECT / "docs/glossary.md"

# Benchmarks use the words of the programs that they run.
STILL = ("libthicken/bench/",)

# An adjective stands for itself: whatever it is said of.
ALONE = {"crowded edge": "crowded", "pinched vertex": "pinched"}


def banned() -> list[str]:
    table = GLOSSARY.read_text().partition("## Words that are not used")[2]
    rows = re.findall(r"^\| ([^|]+) \| [^|]+ \|$", table, re.MULTILINE)
    return [ALONE.get(word, word) for row in rows if row != "not" for word in row.split(", ")]


def pattern_of(word: str) -> re.Pattern[str]:
    """Whatever a word's parts are joined by: giveOver, give_over, give over."""
    return re.compile(r"[\s_-]?".join(map(re.escape, word.split())), re.IGNORECASE)


class Words(unittest.TestCase):
    def test_words_that_are_not_used(self):
        words = {word: pattern_of(word) for word in banned()}
        self.assertGreater(len(words), 8)
        self.assertRegex("isPinched", words["pinched"])
        self.assertRegex("giveOver()", words["give over"])
        pages = [file for file in (PROJECT / "docs").rglob("*.md") if file != GLOSSARY]
        files = [*sources("libthicken", "thicken", "ThickenWorkbench", "examples"), *pages, PROJECT / "README.md"]
        found = []
        for file in files:
            name, text = file.relative_to(PROJECT).as_posix(), file.read_text()
            if not name.startswith(STILL):
                found += [f"{name}: {word}" for word, pattern in words.items() if pattern.search(text)]
        self.assertEqual(found, [])


if __name__ == "__main__":
    unittest.main()
