# SPDX-License-Identifier: LGPL-2.1-or-later
"""Translations: complete, with the same blanks to fill in, and shown by FreeCAD."""

import re
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

from ThickenWorkbench.gui.language import FOLDER
from gui_case import GuiCase, process_events
from thicken_surfaces import plate

LANGUAGES = {"de": "German", "zh-CN": "Chinese Simplified"}
LUPDATE = shutil.which("lupdate", path="/usr/lib/qt6/bin")


def messages(path):
    """Context, source and translation of each message of a .ts file."""
    for context in ElementTree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            yield context.findtext("name"), message.findtext("source"), message.find("translation")


class Files(unittest.TestCase):
    def test_everything_is_translated(self):
        for language in LANGUAGES:
            found = list(messages(FOLDER / f"Thicken_{language}.ts"))
            self.assertGreater(len(found), 100)
            for _, source, translation in found:
                self.assertTrue(translation.text and translation.get("type") is None, f"{language}: {source}")
                blanks = [sorted(re.findall(r"{\w*}", text)) for text in (source, translation.text)]
                self.assertEqual(*blanks, f"{language}: {source}")

    @unittest.skipUnless(LUPDATE, "no lupdate of Qt 6")
    def test_no_text_of_the_sources_is_missing(self):
        import tempfile

        package = FOLDER.parent
        sources = sorted(map(str, [*package.glob("*.py"), *(package / "gui").glob("*.py"), *(package / "gui/ui").glob("*.ui")]))
        with tempfile.TemporaryDirectory() as folder:
            fresh = Path(folder) / "fresh.ts"
            subprocess.run([LUPDATE, "-silent", *sources, "-ts", str(fresh)], check=True, capture_output=True)
            wanted = {(context, source) for context, source, _ in messages(fresh)}
        self.assertGreater(len(wanted), 100)
        for language in LANGUAGES:
            stored = {(context, source) for context, source, _ in messages(FOLDER / f"Thicken_{language}.ts")}
            self.assertEqual(stored, wanted, "run scripts/translations, and translate what is new")


class Shown(GuiCase):
    def speak(self, language):
        Gui.setLocale(language)
        process_events()
        self.addCleanup(process_events)
        self.addCleanup(Gui.setLocale, "English")

    def test_german(self):
        self.speak("German")
        self.assertEqual(App.Qt.translate("Thicken", "Flip"), "Umdrehen")
        self.assertEqual(Gui.Command.get("Thicken_Make").getAction()[0].text(), "Verdicken...")
        self.select(self.add_mesh(plate()))
        panel = self.run_command("Thicken_Make")
        self.assertEqual(self.child(panel, "Flip").text(), "Umdrehen")
        self.picture("german")

    def test_chinese(self):
        self.speak("Chinese Simplified")
        self.assertEqual(App.Qt.translate("Thicken", "Flip"), "翻转")
        self.assertEqual(Gui.Command.get("Thicken_Check").getAction()[0].text(), "检查曲面")
