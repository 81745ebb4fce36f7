# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ctrl-C and SIGTERM, and the progress that is shown on a terminal."""

import os
import pathlib
import pty
import re
import resource
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


def processor_seconds(pid: int) -> float:
    """What a process has taken of the processors until now; other programs do not lengthen it."""
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def ended_children() -> float:
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


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
        """A run that the signal met at work, what it printed, and the seconds of the processors that it still took."""
        for delay in (0.6, 0.3, 0.1):
            process = subprocess.Popen([PROGRAM, *ARGUMENTS, *more], cwd=self.folder, text=True,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)  # fmt: skip
            self.addCleanup(process.stderr.close)
            self.addCleanup(process.kill)
            time.sleep(delay)
            before = processor_seconds(process.pid) + ended_children()
            process.send_signal(number)
            text = process.communicate(timeout=60)[1]
            if process.returncode != 0:
                return process, text, ended_children() - before
            (self.folder / "out.stl").unlink()
            (self.folder / "report.json").unlink(missing_ok=True)
        self.fail("the machine is too fast for this surface")

    def test_a_signal_ends_the_run_within_a_second_and_leaves_its_report_alone(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number.name):
                process, text, seconds = self.interrupted(number, "--report", "report.json")
                self.assertEqual(process.returncode, 5, text)
                self.assertRegex(text.splitlines()[-1], r"^thicken: cancelled: .+")
                self.assertLess(seconds, 1.0 * (os.cpu_count() or 1))
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
        shown = [float(n) for n in re.findall(r"([\d.]+) % [a-z]+", terminal.text)]
        self.assertGreater(len(shown), 3)
        self.assertEqual(shown, sorted(shown))
        self.assertLessEqual(shown[-1], 100)
        after = re.split(r"[\d.]+ % [a-z]+(?:, about \d+ s in all)?", terminal.text)[-1]
        self.assertTrue(after.startswith("\r\x1b[K"), repr(after))

    def test_no_fifth_of_a_run_passes_without_a_move(self):
        """What is compared is the processor's time, which other programs do not lengthen."""
        for name, more in {"sweep": (), "contour": ("--method", "reconstruct")}.items():
            with self.subTest(name):
                terminal = self.start("--threads", "1", *more)
                since, stall, shown, last = 0.0, 0.0, "", 0.0
                while terminal.process.poll() is None:
                    terminal.read_to_end(0.02)
                    steps = re.findall(r"([\d.]+) % [a-z]+", terminal.text)
                    try:
                        now = processor_seconds(terminal.process.pid)
                    except OSError:  # it has just ended
                        break
                    if steps and steps[-1] == shown:
                        stall = max(stall, now - since)
                    elif steps:
                        shown, since = steps[-1], now
                    last = max(last, now)
                self.assertEqual(terminal.process.wait(timeout=60), 0, terminal.text)
                self.assertGreater(last, 0.5, "too short to tell")
                self.assertLess(stall, last / 5, f"of {last} s")

    def test_quiet_shows_none(self):
        terminal = self.start("--quiet")
        terminal.read_to_end(100)
        self.assertEqual(terminal.process.wait(timeout=20), 0, terminal.text)
        self.assertEqual(terminal.text, "")


if __name__ == "__main__":
    unittest.main()
