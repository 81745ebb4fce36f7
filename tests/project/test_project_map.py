# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of the code is that of the code there is."""

import html
import re
import unittest

from project_sources import PROJECT, folder_graph, reduced


class Map(unittest.TestCase):
    def test_drawing_is_of_these_includes(self):
        """If this fails, run scripts/code_map."""
        titles = re.findall(r"<title>([^<]*)</title>", (PROJECT / "docs/map.svg").read_text())
        drawn = {title for title in map(html.unescape, titles) if "->" in title}
        self.assertGreater(len(drawn), 15)
        self.assertEqual(drawn, {f"{a}->{b}" for a, following in reduced(folder_graph()).items() for b in following})

    def test_what_follows_is_left_out(self):
        self.assertEqual(reduced({"a": {"b", "c"}, "b": {"c"}, "c": set()}), {"a": {"b"}, "b": {"c"}, "c": set()})

    def test_every_folder_has_a_sentence(self):
        rows = re.findall(r"^\| `([\w.]+)` \| ", (PROJECT / "docs/map.md").read_text(), re.MULTILINE)
        self.assertEqual(sorted(rows), sorted(name for name in folder_graph() if name != "."))


if __name__ == "__main__":
    unittest.main()
