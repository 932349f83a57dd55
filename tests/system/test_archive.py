"""The archive that the program keeps beside its text files: whole after `kill -9`, with the gap that it made."""
import json
import signal
import sqlite3
import subprocess
import time
import unittest

from site_under_test import PROGRAMS, Site, annex, free_port

PROGRAM_STOPPED = 8


def tool(*arguments):
    return subprocess.run(
        [str(PROGRAMS / "gorizont-tool"), "archive", *map(str, arguments)], capture_output=True, text=True, timeout=60)


def tool_export(*arguments):
    return subprocess.run(
        [str(PROGRAMS / "gorizont-tool"), "export", *map(str, arguments)], capture_output=True, text=True, timeout=60)


def rows(file, sql):
    with sqlite3.connect(f"file:{file}?mode=ro", uri=True) as database:
        return database.execute(sql).fetchall()


def is_kept(file, least):
    """At least so many commits are in the archive."""
    try:
        return rows(file, "SELECT count(*) FROM tail")[0][0] >= least
    except sqlite3.OperationalError:
        return False


class Archive(unittest.TestCase):
    def test_a_kill_leaves_a_whole_archive_and_a_gap(self):
        with Site(annex(IPPort1=free_port(), IPPort2=free_port(), TmRun=200)) as site:
            file = site.history / "archive.sqlite"
            server = site.start()
            server.wait_until(lambda: is_kept(file, 4), what="commits")
            server.stop(signal.SIGKILL)
            killed = time.time()
            checked = tool("check", "--archive", file, "--json")
            self.assertEqual(checked.returncode, 0, checked.stderr)
            commits = json.loads(checked.stdout)["tail"]
            self.assertGreaterEqual(commits, 4)
            time.sleep(5)
            server = site.start()
            server.wait_until(
                lambda: rows(file, f"SELECT count(*) FROM gap WHERE reason = {PROGRAM_STOPPED} AND finish IS NOT NULL")[0][0],
                what="the gap")
            copy = site.history / "copy.sqlite"
            done = tool("backup", copy, "--archive", file)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(server.stop(), 0)
            for start, finish in rows(file, f"SELECT start, finish FROM gap WHERE reason = {PROGRAM_STOPPED}"):
                self.assertLessEqual(start / 1e6, killed)
                self.assertGreater(start / 1e6, killed - 10)  # commits are a second apart, on a busy machine more
                self.assertGreater(finish / 1e6 - killed, 5)
            for name in (file, copy):
                self.assertEqual(tool("check", "--archive", name).returncode, 0, name)
            self.assertGreater(len(rows(file, "SELECT id FROM event")), 4)
            self.assertGreaterEqual(rows(file, "SELECT count(*) FROM tail")[0][0], commits)

    def test_the_tool_exports_what_was_printed(self):
        with Site(annex(IPPort1=free_port(), IPPort2=free_port(), TmRun=200)) as site:
            server = site.start()
            server.wait_until(lambda: len([r for r in site.readings() if r["number"] == 3]) > 20, what="readings")
            self.assertEqual(server.stop(), 0)
            printed = {r["time"]: r["tiltX"] for r in site.readings() if r["number"] == 3 and "tiltX" in r}
            begin, end = min(printed), max(printed)
            table = site.folder / "out.csv"
            done = tool_export(
                "--config", site.ini, "--from", begin, "--to", end, "--sensors", "3", "--quantities", "tilt-x",
                "--format", "csv-iso", "--out", table, "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            lines = table.read_text("utf-8").splitlines()[1:]
            self.assertEqual(json.loads(done.stdout)["rows"], len(lines))
            exported = {time: float(value) for time, value in (line.split(",") for line in lines) if value}
            # The times are printed cut off to a millisecond, so the reading at the first one may lie before or behind it.
            self.assertGreaterEqual(len(exported), len(printed) - 2)
            for moment, value in exported.items():
                self.assertAlmostEqual(value, printed[moment], delta=0.0006)
            # Nothing asked for, nothing written.
            self.assertEqual(tool_export("--config", site.ini).returncode, 2)
            self.assertEqual(tool_export("--config", site.folder / "no.ini").returncode, 2)

    def test_old_files_go_into_another_archive(self):
        with Site(annex(IPPort1=free_port(), IPPort2=free_port(), TmRun=200, TmSave=1000)) as site:
            def import_history(*arguments):
                return tool("import-history", *arguments, "--config", site.ini, "--lang", "en", "--json")

            server = site.start()
            server.wait_until(lambda: site.file_text("data").count("\n") > 5, what="records")
            refused = import_history(site.history)
            self.assertEqual(refused.returncode, 1)
            self.assertIn("Another copy of the program writes into", refused.stderr)
            self.assertEqual(server.stop(), 0)
            file = site.folder / "other.sqlite"
            added = []
            for _ in range(2):
                done = import_history(site.history, "--archive", file)
                self.assertEqual(done.returncode, 0, done.stderr)
                told = json.loads(done.stdout)
                self.assertEqual((told["foreign"], told["damaged"], told["failure"]), (0, 0, None))
                self.assertGreater(told["records"], 5)
                added.append(told["added"])
            self.assertGreater(added[0], 5)
            self.assertEqual(added[1], 0)
            sources = [source for source, in rows(file, "SELECT DISTINCT source FROM gap WHERE source <> ''")]
            self.assertTrue(sources and all(source.endswith("data.txt") for source in sources), sources)
            self.assertEqual(tool("check", "--archive", file).returncode, 0)
            nothing = import_history(site.folder / "nowhere", "--archive", file)
            self.assertEqual(nothing.returncode, 1)
            self.assertIn("There are no old records in", nothing.stderr)

    def test_off_keeps_nothing(self):
        with Site(annex(IPPort1=free_port(), IPPort2=free_port()) + "\n[Archive]\nOn=0\n") as site:
            server = site.start()
            server.wait_until(lambda: site.file_text("data").count("\n") > 1, what="records")
            self.assertEqual(server.stop(), 0)
            self.assertFalse((site.history / "archive.sqlite").exists())

    def test_the_tool_explains_what_is_missing(self):
        done = tool("check", "--archive", "/nonexistent/archive.sqlite")
        self.assertEqual(done.returncode, 1)
        self.assertIn("/nonexistent/archive.sqlite", done.stderr)
        self.assertEqual(tool("frobnicate").returncode, 2)
        self.assertEqual(tool("backup").returncode, 2)


if __name__ == "__main__":
    unittest.main()
