# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workflow on this machine: bad parts, limits that are too low, kills, and what is made again."""

import os
import re
import signal
import subprocess
import time
import unittest
from urllib.parse import unquote

from batch_case import BAD, PROGRAM, BatchCase, kill_one, parts, read_json, read_summary, solids, write_off, write_table
from run_parts import next_limits
from surfaces import wave


class Night(BatchCase):
    """60 parts in one go: what the other tests compare with."""

    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        cls.table = write_table(cls.folder / "in/parts.tsv", parts())
        cls.out = cls.folder / "out"
        process = cls.start(cls.table, cls.out)
        cls.was_killed = kill_one("large-8mm")
        cls.status = process.wait(timeout=800)
        cls.log = (cls.folder / "log").read_text(errors="replace")
        cls.rows = read_summary(cls.out) if cls.status == 0 else []

    def test_every_part_has_its_row_and_its_report(self):
        self.assertEqual(self.status, 0, self.log[-3000:])
        self.assertEqual([(r["file"], r["thickness"]) for r in self.rows], [(r["file"], r["thickness"]) for r in parts()])
        self.assertEqual([r["status"] for r in self.rows].count("ok"), 40)
        for row in self.rows:
            report = read_json(self.out / row["report"])
            self.assertEqual((report["status"], report.get("code", "")), (row["status"], row["code"]))
            self.assertEqual((self.out / row["solid"]).is_file(), row["status"] == "ok")

    def test_bad_parts_are_rows_with_their_codes(self):
        for row in self.rows:
            if row["file"] in BAD and not row["repair"]:
                self.assertEqual((row["status"], row["code"]), ("refused", BAD[row["file"]]), row)
                self.assertGreater(len(row["sentence"]), 20)
        self.assertEqual([r["code"] for r in self.rows if r["thickness"] == "thick" or r["side"] == "left"], ["usage"] * 2)

    def test_solids_are_those_of_the_program(self):
        for row in self.rows[::7]:
            if row["status"] != "ok":
                continue
            options = [f"--side={row['side']}"] * bool(row["side"]) + ["--repair"] * bool(row["repair"])
            own = self.folder / "own.stl"
            subprocess.run([PROGRAM, self.folder / "in" / row["file"], own, f"--thickness={row['thickness']}", "--quiet", *options],
                           check=True)  # fmt: skip
            self.assertEqual(own.read_bytes(), (self.out / row["solid"]).read_bytes(), row)

    def test_parts_that_need_more_get_what_their_report_says(self):
        memory, time_limit = ([r for r in self.rows if r[name]][0] for name in ("memory", "timeout"))
        self.assertEqual((memory["status"], time_limit["status"]), ("ok", "ok"), (memory, time_limit))
        self.assertIn(memory["runs"], "23")
        self.assertGreater(float(memory["memory_limit_mib"]), 20)
        self.assertIn(time_limit["runs"], "23")
        for row in self.rows:
            if row["status"] == "ok":
                self.assertLessEqual(float(row["memory_mib"]), float(row["memory_limit_mib"]), row)

    def test_a_part_that_was_killed_is_run_again(self):
        self.assertTrue(self.was_killed, "the test found nothing to kill")
        row = next(r for r in self.rows if r["file"] == "large.ply" and r["thickness"] == "8")
        self.assertEqual((row["status"], row["runs"]), ("ok", "2"))

    def test_neighbours_are_in_different_jobs(self):
        """They take alike long: so all jobs take about as long, and no core waits for the last one."""
        made = {(r["file"], r["thickness"]): r["solid"] for r in self.rows if r["solid"]}
        jobs = {f"{part[-1]}.stl": path for path in (self.out / "jobs").glob("0*.json") for part in read_json(path)["parts"]}
        self.assertNotEqual(jobs[made["wave 0.off", "0.3"]], jobs[made["wave 0.off", "0.5"]])

    def test_names_are_told_apart(self):
        made = {r["solid"] for r in self.rows if r["solid"]}
        self.assertEqual(len(made), 39, "one row is there twice")
        self.assertEqual(made, set(solids(self.out)))

    def test_the_page_has_every_part(self):
        page = (self.out / "summary.html").read_text()
        self.assertEqual(page.count("<tr class="), 60)
        self.assertIn("60 parts: 40 ok, 20 refused", page)
        pictures = re.findall(r'src="([^"]+)"', page)
        self.assertEqual(len(pictures), 40)
        for picture in pictures:
            self.assertEqual((self.out / unquote(picture)).read_bytes()[:8], b"\x89PNG\r\n\x1a\n", picture)
        self.assertNotIn("http", page, "it needs no server")

    def test_killed_at_half_and_started_again_the_bytes_are_the_same(self):
        out = self.folder / "killed"
        process = self.start(self.table, out)
        end = time.monotonic() + 300
        while len(list(out.glob("*.stl"))) < 20 and time.monotonic() < end:
            time.sleep(0.02)
        process.send_signal(signal.SIGKILL)
        process.wait()
        before = {path: path.stat().st_mtime_ns for path in out.glob("*.stl")}
        self.assertLess(len(before), 39, "it was too late to kill it")
        self.assertFalse((out / "summary.tsv").exists())
        self.assert_ok(self.run_batch(self.table, out))
        self.assertEqual(solids(out), solids(self.out))
        self.assertEqual([(r["file"], r["status"], r["code"]) for r in read_summary(out)],
                         [(r["file"], r["status"], r["code"]) for r in self.rows])  # fmt: skip
        self.assertEqual({path: path.stat().st_mtime_ns for path in before}, before, "what was there was made again")


class Again(BatchCase):
    def setUp(self) -> None:
        self.rows = [{"file": f"wave {k}.off", "thickness": "0.5"} for k in range(4)] + [{"file": "nan.off", "thickness": "1"}]
        self.out = self.folder / self.id().split(".")[-1]
        self.table = write_table(self.folder / "in" / f"{self.out.name}.tsv", self.rows)
        self.assert_ok(self.run_batch(self.table, self.out))

    def changed_by(self, change) -> set[str]:
        """The files that another run has written after `change`."""
        def stamps():
            return {p.name: p.stat().st_mtime_ns for p in self.out.glob("*-*")}
        before = stamps()
        change()
        self.assert_ok(self.run_batch(self.table, self.out))
        return {name for name, stamp in stamps().items() if before.get(name) != stamp}

    def solid(self, k: int):
        return self.out / read_summary(self.out)[k]["solid"]

    def test_nothing_is_made_twice_and_old_remains_go(self):
        old, young = (self.out / f"pictures/.thicken-{pid}-0.tmp" for pid in (1, 2))
        def leave():
            for path in (old, young):
                path.touch()
            os.utime(old, (0, 0))
        self.assertEqual(self.changed_by(leave), set())
        self.assertEqual((old.exists(), young.exists()), (False, True))

    def test_what_is_cut_short_or_gone_is_made_again(self):
        whole, first, second = solids(self.out), self.solid(0), self.solid(1)
        report = self.out / read_summary(self.out)[4]["report"]
        def spoil():
            first.write_bytes(first.read_bytes()[:100])
            second.unlink()
            report.unlink()
            (self.out / f"pictures/{self.solid(2).stem}.png").unlink()
        again = [first.stem, second.stem, self.solid(2).stem]
        self.assertEqual(self.changed_by(spoil), {f"{stem}.{kind}" for stem in again for kind in ("stl", "json")} | {report.name})
        self.assertEqual({path.stem for path in (self.out / "pictures").iterdir()}, {path.stem for path in self.out.glob("*.stl")})
        self.assertEqual(solids(self.out), whole)

    def test_only_other_rows_and_other_surfaces_are_made(self):
        def change():
            write_table(self.table, [{"file": "wave 0.off", "thickness": "0.6"}, *self.rows[1:]])
            write_off(self.folder / "in/wave 1.off", wave(9, height=1))
        names = self.changed_by(change)
        self.assertEqual(names, {f"{self.solid(k).stem}.{kind}" for k in (0, 1) for kind in ("stl", "json")})
        write_off(self.folder / "in/wave 1.off", wave(9))

    def test_a_run_in_the_same_folder_at_the_same_time_is_refused(self):
        write_table(self.table, [*self.rows, {"file": "large.ply", "thickness": "9"}])
        process = self.start(self.table, self.out)
        end = time.monotonic() + 100
        while not list((self.out / "jobs").glob("*5.lock")) and time.monotonic() < end:
            time.sleep(0.02)
        run = self.run_batch(self.table, self.out)
        self.assertEqual(process.wait(timeout=300), 0)
        self.assertEqual(run.returncode, 1)
        self.assertIn("another run is at work", run.stderr)


class Limits(unittest.TestCase):
    def test_a_retry_has_more_time_and_a_minute_at_least(self):
        """On a busy machine the first runs of a part tell nothing of what it needs."""
        def after(timeout: str, enough: float) -> float:
            told = {"code": "time-limit", "time": {"enough_seconds": enough}}
            return next_limits(4, told, {"memory": "4000", "timeout": timeout, "beside": 100})["timeout"]
        self.assertEqual([after("0.05", 3), after("900", 100), after("900", 5000)], [60, 3600, 5000])


class Tables(BatchCase):
    """What is wrong with a table as a whole is one sentence, before anything runs."""

    def assert_refused(self, word: str, rows: str, *config: str) -> None:
        table = self.folder / "in/wrong.tsv"
        table.write_text(rows)
        run = self.run_batch(table, self.folder / "none", *config)
        self.assertEqual(run.returncode, 1)
        told = [line for line in run.stderr.splitlines() if line]
        self.assertEqual(len(told), 1, run.stderr)
        self.assertRegex(told[0], "^batch: .*" + word)
        self.assertEqual(list((self.folder / "none").glob("*.*")), [])

    def test_they_are_refused(self):
        self.assert_refused('"colour"', "file\tthickness\tcolour\nwave 0.off\t1\tred\n")
        self.assert_refused('"report"', "file\tthickness\treport\nwave 0.off\t1\tr.json\n")
        self.assert_refused('"thickness"', "file\nwave 0.off\n")
        self.assert_refused('"file"', "")
        self.assert_refused("line 3", "file\tthickness\n\nwave 0.off\t1\t2\n")
        self.assert_refused("does not run", "file\tthickness\nwave 0.off\t1\n", "program=/nowhere/thicken")
        self.assert_refused("not the program", "file\tthickness\nwave 0.off\t1\n", "program=/bin/echo")

    def test_a_table_of_a_spreadsheet_is_read(self):
        table = self.folder / "in/sheet.tsv"
        table.write_bytes("\ufefffile\tthickness\tside\r\nwave 0.off\t0.5\t\r\n\r\nwave 1.off\t0.5\r\n".encode())
        self.assert_ok(self.run_batch(table, self.folder / "sheet"))
        self.assertEqual([r["status"] for r in read_summary(self.folder / "sheet")], ["ok", "ok"])


if __name__ == "__main__":
    unittest.main()
