"""The command line is a contract for scripts; every failure is one clear sentence and a code."""
import socket
import subprocess
import tempfile
import unittest

from site_under_test import DATA, PROGRAMS, Program, Site, annex, free_port


def run(*arguments, program="gorizont-server", seconds=60):
    return subprocess.run(
        [str(PROGRAMS / program), *map(str, arguments)], capture_output=True, text=True, timeout=seconds,
        stdin=subprocess.DEVNULL)


class CommandLine(unittest.TestCase):
    def test_help_and_version_need_no_display(self):
        for option in ("--help", "--version"):
            done = run(option)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("0.", run("--version").stdout)
        for option in ("--config", "--data", "--ports", "--headless", "--demo", "--lang", "--print-readings",
                       "--print-register-map"):
            self.assertIn(option, run("--help").stdout)

    def test_usage_errors_end_with_2(self):
        for arguments in (["--nonsense"], ["stray"], ["--lang", "de"], ["--demo", "--config", "x.ini"]):
            done = run("--headless", *arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_a_missing_ini_is_explained(self):
        done = run("--headless", "--config", "/nonexistent/GorizontServer.ini")
        self.assertEqual(done.returncode, 1)
        self.assertIn("/nonexistent/GorizontServer.ini", done.stderr)

    def test_no_ini_at_all_offers_the_demonstration(self):
        with tempfile.TemporaryDirectory() as home:
            done = subprocess.run(
                [str(PROGRAMS / "gorizont-server"), "--headless", "--lang", "en"], capture_output=True, text=True,
                timeout=60, env={"HOME": home, "PATH": "/usr/bin:/bin"})
        self.assertEqual(done.returncode, 1)
        self.assertIn("--demo", done.stderr)

    def test_a_window_without_a_display_is_refused_in_one_sentence(self):
        done = subprocess.run(
            [str(PROGRAMS / "gorizont-server"), "--demo"], capture_output=True, text=True, timeout=60,
            env={"HOME": "/tmp", "PATH": "/usr/bin:/bin"})
        self.assertEqual(done.returncode, 1)
        self.assertIn("--headless", done.stderr)

    def test_simulator_usage(self):
        self.assertEqual(run(program="gorizont-simulator").returncode, 2)
        done = run("--config", DATA / "config" / "annex-utf8.ini", "--ports", "/tmp", "--fault", "flood=1",
                   program="gorizont-simulator")
        self.assertEqual(done.returncode, 2)
        self.assertIn("flood=1", done.stderr)

    def test_bad_configurations_start_and_complain(self):
        cases = {
            "empty": b"",
            "binary": bytes(range(256)) * 64,
            "mistakes": (DATA / "config" / "mistakes.ini").read_bytes(),
            "ten megabytes": b"[Common]\r\nIPPort1=0\r\n" + b"Key=some text that means nothing\r\n" * 310000,
        }
        for name, content in cases.items():
            with self.subTest(name), Site(content, faults=None) as site:
                server = site.start("--lang", "en")
                server.wait_until(lambda: any("started" in line for line in server.errors), what="start")
                self.assertEqual(server.stop(), 0)
                log = site.file_text("log")
                self.assertGreaterEqual(len(log.splitlines()), 3, name)  # started, something to complain of, ended

    def test_folders_may_be_relative(self):
        with Site(annex(IPPort1=free_port(), TmSave=1000)) as site:
            site.server = Program(
                "gorizont-server", "--config", "GorizontServer.ini", "--ports", "ports", "--data", "kept", "--headless",
                "--print-readings", folder=site.folder)
            site.wait_for(lambda last: last.get(1, {}).get("status", 0x2700) & 0xF000 == 0, what="readings")
            site.server.wait_until(lambda: list((site.folder / "kept" / "History").glob("*_data.txt")), what="files")
            self.assertEqual(site.server.stop(), 0)

    def test_a_second_copy_in_the_same_folder_is_refused(self):
        with Site(annex(IPPort1=free_port()), faults=None) as site:
            server = site.start()
            server.wait_until(lambda: site.history.exists(), what="start")
            second = Program("gorizont-server", "--config", site.ini, "--headless")
            second.process.wait(30)
            self.assertEqual(second.stop(), 3)
            self.assertEqual(server.stop(), 0)

    def test_a_killed_copy_does_not_lock_the_folder(self):
        with Site(annex(IPPort1=free_port()), faults=None) as site:
            server = site.start()
            server.wait_until(lambda: site.history.exists(), what="start")
            server.stop(9)
            server = site.start("--lang", "en")
            server.wait_until(lambda: any("started" in line for line in server.errors), what="second start")
            self.assertEqual(server.stop(), 0)

    def test_a_copy_that_is_allowed_does_not_write_the_same_files(self):
        with Site(annex(IPPort1=free_port(), CanCopy=1, TmSave=1000), faults=None) as site:
            first = site.start()
            first.wait_until(lambda: site.file_text("data").count("\n") > 1, what="data")
            second = Program("gorizont-server", "--config", site.ini, "--headless", "--lang", "en")
            second.wait_until(lambda: any("does not save" in line for line in second.errors), what="sentence")
            self.assertEqual(second.stop(), 0)
            self.assertEqual(first.stop(), 0)

    def test_a_taken_modbus_port_is_told_and_retried(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            with Site(annex(IPPort1=port) , faults=None) as site:
                server = site.start("--lang", "en")
                server.wait_until(lambda: any(str(port) in line for line in server.errors), what="sentence")
                taken.close()
                def served():
                    with socket.socket() as probe:
                        return probe.connect_ex(("127.0.0.1", port)) == 0
                server.wait_until(served, what="port")
                self.assertEqual(server.stop(), 0)

    def test_readings_into_a_closed_pipe_do_not_end_the_program(self):
        with Site(annex(IPPort1=free_port(), TmSave=1000)) as site:
            server = site.start()
            server.wait_until(lambda: len(site.readings()) > 3, what="readings")
            server.process.stdout.close()
            before = site.file_text("data").count("\n")
            server.wait_until(lambda: site.file_text("data").count("\n") > before + 2, what="records")
            self.assertEqual(server.stop(), 0)


if __name__ == "__main__":
    unittest.main()
