# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ctrl-C and SIGTERM, and the progress that is shown on a terminal."""

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

# Large enough to be interrupted on any machine: a second of work or more.
SURFACE = wave(250, size=200, height=30)
ARGUMENTS = ("in.ply", "out.stl", "--thickness", "8")


def open_terminal() -> tuple[int, int]:
    try:
        return pty.openpty()
    except OSError as error:
        raise unittest.SkipTest(f"this machine has no terminals to open: {error}") from error


class Terminal:
    """The program with its stderr on a terminal."""

    def __init__(self, folder, *arguments: str) -> None:
        self.master, slave = open_terminal()
        self.process = subprocess.Popen([PROGRAM, *arguments], cwd=folder, stderr=slave, stdout=subprocess.DEVNULL)
        os.close(slave)
        self.text = ""

    def read_to_end(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if select.select([self.master], [], [], 0.05)[0]:
                try:
                    self.text += os.read(self.master, 65536).decode(errors="replace")
                except OSError:  # the program has closed it
                    return

    def close(self) -> None:
        os.close(self.master)
        self.process.kill()
        self.process.wait()


class Cancel(ProgramCase):
    def setUp(self) -> None:
        super().setUp()
        write_ply(self.folder / "in.ply", SURFACE)

    def interrupted(self, number: int, *more: str) -> tuple[subprocess.Popen, str, float]:
        """A run that the signal met at work, what it printed, and how long it went on."""
        for delay in (0.6, 0.3, 0.1):
            process = subprocess.Popen([PROGRAM, *ARGUMENTS, *more], cwd=self.folder, text=True,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)  # fmt: skip
            self.addCleanup(process.stderr.close)
            self.addCleanup(process.kill)
            time.sleep(delay)
            sent = time.monotonic()
            process.send_signal(number)
            text = process.communicate(timeout=30)[1]
            if process.returncode != 0:
                return process, text, time.monotonic() - sent
            (self.folder / "out.stl").unlink()
            (self.folder / "report.json").unlink(missing_ok=True)
        self.fail("the machine is too fast for this surface")

    def test_a_signal_ends_the_run_within_a_second_and_leaves_its_report_alone(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number.name):
                process, text, seconds = self.interrupted(number, "--report", "report.json")
                self.assertEqual(process.returncode, 5, text)
                self.assertRegex(text.splitlines()[-1], r"^thicken: cancelled: .+")
                self.assertLess(seconds, 2)
                self.assert_leaves({"in.ply", "report.json"})
                self.assertEqual((self.report()["code"], self.report()["exit_status"]), ("cancelled", 5))

    def test_quiet_prints_the_last_line_alone(self):
        text = self.interrupted(signal.SIGINT, "--quiet")[1]
        self.assertRegex(text, r"^thicken: cancelled: [^\n]+\n$")

    def test_signals_one_after_the_other_leave_nothing_either(self):
        process = subprocess.Popen([PROGRAM, *ARGUMENTS], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        time.sleep(0.1)
        while process.poll() is None:
            process.send_signal(signal.SIGINT)
            time.sleep(0.01)
        self.assertEqual(process.returncode, 5)
        self.assertIn("thicken: cancelled: ", process.stderr.read())
        self.assert_leaves({"in.ply"})


class Progress(ProgramCase):
    def start(self, *more: str) -> Terminal:
        write_ply(self.folder / "in.ply", SURFACE)
        terminal = Terminal(self.folder, *ARGUMENTS, *more)
        self.addCleanup(terminal.close)
        return terminal

    def test_it_goes_up_only_and_is_wiped(self):
        terminal = self.start()
        terminal.read_to_end(100)
        self.assertEqual(terminal.process.wait(timeout=20), 0, terminal.text)
        shown = [int(n) for n in re.findall(r"(\d+) % [a-z]+", terminal.text)]
        self.assertGreater(len(shown), 3)
        self.assertEqual(shown, sorted(shown))
        self.assertLessEqual(shown[-1], 100)
        after = re.split(r"\d+ % [a-z]+", terminal.text)[-1]
        self.assertTrue(after.startswith("\r\x1b[K"), repr(after))

    def test_quiet_shows_none(self):
        terminal = self.start("--quiet")
        terminal.read_to_end(100)
        self.assertEqual(terminal.process.wait(timeout=20), 0, terminal.text)
        self.assertEqual(terminal.text, "")


if __name__ == "__main__":
    unittest.main()
