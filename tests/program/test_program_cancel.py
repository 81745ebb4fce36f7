# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ctrl-C and SIGTERM, on a terminal of the test's own, where progress is shown."""

import os
import pty
import re
import select
import signal
import subprocess
import time
import unittest

from program_case import PROGRAM, ProgramCase
from surfaces import wave, write_ply

# Large enough to be interrupted on any machine: some seconds of work.
SURFACE = wave(250, size=200, height=30)


class Terminal:
    """The program with its stderr on a terminal."""

    def __init__(self, folder, *arguments) -> None:
        self.master, slave = pty.openpty()
        self.process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=folder, stderr=slave,
                                        stdout=subprocess.DEVNULL)  # fmt: skip
        os.close(slave)
        self.text = ""

    def read_until(self, word: str, seconds: float) -> bool:
        """Collect what is shown until `word` is; an empty word stands for the end."""
        end = time.monotonic() + seconds
        while not (word and word in self.text) and time.monotonic() < end:
            if select.select([self.master], [], [], 0.05)[0]:
                try:
                    self.text += os.read(self.master, 65536).decode(errors="replace")
                except OSError:  # the program has closed it
                    break
        return bool(word) and word in self.text

    def close(self) -> None:
        os.close(self.master)
        self.process.kill()
        self.process.wait()


class Cancel(ProgramCase):
    def start(self, *arguments) -> Terminal:
        write_ply(self.folder / "in.ply", SURFACE)
        terminal = Terminal(self.folder, "in.ply", "out.stl", "--thickness", 8, *arguments)
        self.addCleanup(terminal.close)
        return terminal

    def test_a_signal_ends_the_run_within_a_second_and_leaves_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number.name):
                terminal = self.start("--report", "report.json")
                self.assertTrue(terminal.read_until("sweeping", 60), terminal.text)
                sent = time.monotonic()
                terminal.process.send_signal(number)
                terminal.process.wait(timeout=30)
                self.assertLess(time.monotonic() - sent, 2)
                terminal.read_until("", 1)
                self.assertEqual(terminal.process.returncode, 5, terminal.text)
                last = re.sub(r"\x1b\[K", "", terminal.text).replace("\r", "\n").strip().split("\n")[-1]
                self.assertRegex(last, r"^thicken: cancelled: .+")
                self.assert_leaves({"in.ply"})

    def test_progress_goes_up_only(self):
        terminal = self.start()
        terminal.read_until("", 100)
        self.assertEqual(terminal.process.wait(timeout=20), 0, terminal.text)
        shown = [int(n) for n in re.findall(r"(\d+) % [a-z]+", terminal.text)]
        self.assertGreater(len(shown), 3)
        self.assertEqual(shown, sorted(shown))
        self.assertLessEqual(shown[-1], 100)

    def test_quiet_shows_no_progress(self):
        terminal = self.start("--quiet")
        self.assertFalse(terminal.read_until("%", 1.5), terminal.text)
        terminal.process.send_signal(signal.SIGINT)
        terminal.process.wait(timeout=30)
        terminal.read_until("", 1)
        self.assertRegex(terminal.text, r"^thicken: cancelled: [^\n]+\n$")


if __name__ == "__main__":
    unittest.main()
