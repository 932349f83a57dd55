"""Keys of the ini whose effect only the whole program shows: what a second copy does, when the program begins and ends,
what it serves and saves."""
import fcntl
import os
import pathlib
import signal
import socket
import statistics
import subprocess
import tempfile
import time
import unittest
from datetime import datetime

from site_under_test import PROGRAMS, ModbusClient, Program, Site, annex, free_port, read_tilt

F_SETPIPE_SZ = 1031
LONG = 600000  # ms: longer than any test may last


def ini(more="", **changes):
    """The annex with a free port for its server; `more` are lines of [Common] that the annex does not have."""
    changes.setdefault("IPPort1", free_port())
    return annex(Name="GorizontServer\r\n" + more, **changes)


def is_served(port):
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


def open_files(program):
    """Names of the files that a process holds open."""
    names = []
    for link in pathlib.Path(f"/proc/{program.process.pid}/fd").iterdir():
        try:
            names.append(os.readlink(link))
        except FileNotFoundError:
            pass
    return names


class Copies(unittest.TestCase):
    def copy(self, site, *options):
        return Program("gorizont-server", "--config", site.ini, "--lang", "en", *options)

    def test_can_copy_0_gives_way_to_the_window_of_the_first(self):
        with Site(ini(CanCopy=0), faults=None) as site:
            site.server = self.copy(site)
            site.server.wait_until(lambda: "started" in site.file_text("log"), what="first copy")
            second = self.copy(site)
            self.assertEqual(second.process.wait(60), 3)
            second.stop()
            # It asked the first one to come forward and was answered: nothing is left to tell the user.
            self.assertEqual([line for line in second.errors if "already works" in line], [])
            self.assertEqual(site.server.stop(), 0)

    def test_can_copy_0_without_a_window_says_why(self):
        with Site(ini(CanCopy=0), faults=None) as site:
            server = site.start()
            server.wait_until(lambda: site.history.exists(), what="first copy")
            second = self.copy(site, "--headless")
            self.assertEqual(second.process.wait(60), 3)
            second.stop()
            self.assertTrue(any("already works" in line for line in second.errors), second.errors)
            self.assertEqual(server.stop(), 0)

    def test_can_copy_1_runs_and_does_not_write(self):
        with Site(ini(CanCopy=1, TmSave=100), faults=None) as site:
            first = site.start()
            first.wait_until(lambda: site.file_text("data").count("\n") > 2, what="records")
            second = self.copy(site, "--headless")
            second.wait_until(lambda: any("does not save" in line for line in second.errors), what="sentence")
            before = site.file_text("data").count("\n")
            first.wait_until(lambda: site.file_text("data").count("\n") > before + 10, what="records")
            self.assertTrue(any("History" in name for name in open_files(first)))
            self.assertEqual([name for name in open_files(second) if "History" in name], [])
            self.assertEqual(second.stop(), 0)
            self.assertEqual(first.stop(), 0)
            self.assertEqual(site.file_text("log").count("\n"), len(first.errors))


class StartAndEnd(unittest.TestCase):
    def test_tm_start_is_given_to_files_and_servers(self):
        port = free_port()
        with Site(ini(IPPort1=port, TmStart=LONG, TmSave=100), faults=None) as site:
            server = site.start("--lang", "en")
            server.wait_until(lambda: site.file_text("data").count("\n") > 10, what="records")
            server.wait_until(lambda: is_served(port), what="server")
            self.assertEqual([line for line in server.errors if "COM" in line], [])
            self.assertEqual(server.stop(), 0)

    def test_ports_are_opened_after_tm_start(self):
        for pause in (0, 2500):
            with Site(ini(TmStart=pause), faults=None) as site:
                begin = time.monotonic()
                server = site.start("--lang", "en")
                server.wait_until(lambda: any("COM" in line for line in server.errors), what="attempt to open")
                self.assertGreaterEqual(time.monotonic() - begin, 0.9 * pause / 1000)  # the timer may be 5 % early
                self.assertEqual(server.stop(), 0)

    def test_an_orderly_end_does_not_wait_for_p_exit(self):
        with Site(ini(PExit=LONG, TmRun=100, TmStart=0)) as site:
            server = site.start()
            server.wait_until(lambda: len(site.readings()) > 20, what="readings")
            begin = time.monotonic()
            self.assertEqual(server.stop(), 0)
            self.assertLess(time.monotonic() - begin, 20)
            # What the servers say at their end gets into the file, before the program's own last word.
            last = site.file_text("log").splitlines()[-3:]
            self.assertRegex(last[0] + last[1], "ADC24 TCP: .*Modbus TCP: |Modbus TCP: .*ADC24 TCP: ")
            self.assertIn("Gorizont Server", last[2])

    def test_p_exit_is_the_end_of_all_waiting(self):
        """The thread that prints hangs in the system: nobody reads what it writes."""
        pause = 2.0
        with Site(ini(PExit=int(1000 * pause), TmRun=100, TmSave=100, TmStart=0)) as site:
            reader, writer = os.pipe()
            fcntl.fcntl(writer, F_SETPIPE_SZ, 4096)
            server = subprocess.Popen(
                [str(PROGRAMS / "gorizont-server"), "--config", site.ini, "--ports", site.ports, "--headless",
                 "--print-readings", "--lang", "en"], stdout=writer, stderr=subprocess.DEVNULL)
            os.close(writer)
            deadline = time.monotonic() + 60
            while site.file_text("data").count("\n") < 50:  # five seconds of readings are more than the pipe holds
                self.assertLess(time.monotonic(), deadline)
                time.sleep(0.05)
            begin = time.monotonic()
            server.send_signal(signal.SIGTERM)
            code = server.wait(60)
            elapsed = time.monotonic() - begin
            os.close(reader)
            self.assertEqual(code, 1)
            self.assertGreaterEqual(elapsed, 0.95 * pause)
            self.assertLess(elapsed, 30)
            # The files were closed in time all the same.
            self.assertIn("ended", site.file_text("log").splitlines()[-1])
            self.assertTrue(site.file_text("data").endswith("\r\n"))


class Served(unittest.TestCase):
    def test_ip_port_1(self):
        port, other = free_port(), free_port()
        with Site(ini(IPPort1=port), faults=None) as site:
            server = site.start()
            server.wait_until(lambda: is_served(port), what="server")
            self.assertFalse(is_served(other))
            client = ModbusClient(port)
            read_tilt(client, 8)
            client.close()
            self.assertEqual(server.stop(), 0)

    def test_can_modbus_0_serves_nobody(self):
        port = free_port()
        with Site(ini("CanModbus=0", IPPort1=port, TmSave=100, TmStart=0), faults=None) as site:
            server = site.start()
            server.wait_until(lambda: site.file_text("data").count("\n") > 10, what="records")
            self.assertFalse(is_served(port))
            self.assertEqual(server.stop(), 0)

    def test_on_of_a_port_and_of_a_sensor(self):
        """The first port is off, or only its first sensor."""
        cases = {"On": (0b11, [0x1700, 0x1700]), "On1": (0b00, [0x0F00, None])}
        for key, (channel, words) in cases.items():
            port = free_port()
            with self.subTest(key), Site(ini(IPPort1=port, TmStart=0, **{key: 0})) as site:
                server = site.start()
                site.wait_for(lambda last: {3, 4, 11} <= set(last), what="readings of the others")
                client = ModbusClient(port)
                channels, sensors = read_tilt(client, 8)
                client.close()
                self.assertEqual(channels & 0b11, channel)
                for word, sensor in zip(words, sensors):
                    self.assertIn(sensor[3], [word] if word else [w for w in range(0x10000) if w not in (0x0F00, 0x1700)])
                self.assertNotIn(1, site.last_readings())
                self.assertEqual(server.stop(), 0)

    def test_num_of_ports_decides_how_many_there_are(self):
        with Site(ini(NumOfPorts=2, TmSave=100), faults=None) as site:
            server = site.start()
            server.wait_until(lambda: site.file_text("data").count("\n") > 2, what="records")
            self.assertEqual(site.file_text("data").splitlines()[-1].count("\t"), 1 + 5 * 4)
            self.assertEqual(server.stop(), 0)


class Work(unittest.TestCase):
    def test_can_save_0_leaves_no_files(self):
        with Site(ini(CanSave=0, TmSave=100, TmStart=0)) as site:
            server = site.start()
            server.wait_until(lambda: len(site.readings()) > 20, what="readings")
            self.assertEqual(server.stop(), 0)
            # The archive has a switch of its own.
            self.assertEqual({path.name.split(".")[0] for path in site.history.iterdir()}, {"archive"})
        with Site(ini(CanSave=0, TmSave=100, TmStart=0) + "\r\n[Archive]\r\nOn=0\r\n") as site:
            server = site.start()
            server.wait_until(lambda: len(site.readings()) > 20, what="readings")
            self.assertEqual(server.stop(), 0)
            self.assertFalse(site.history.exists())

    def test_tm_save_is_the_period_of_the_records(self):
        with Site(ini(TmSave=1000, TmStart=LONG), faults=None) as site:
            server = site.start()
            server.wait_until(lambda: site.file_text("data").count("\n") > 3, what="records")
            self.assertEqual(server.stop(), 0)
            times = [datetime.strptime(line[:17], "%H:%M:%S %d.%m.%y") for line in site.file_text("data").splitlines()]
            gaps = [(b - a).total_seconds() for a, b in zip(times, times[1:])]
            self.assertTrue(all(gap >= 1 for gap in gaps), gaps)

    def test_tm_run_is_the_period_of_the_readings(self):
        periods = {}
        for run in (300, 1500):
            with Site(ini(TmRun=run, TmStart=0)) as site:
                server = site.start()
                server.wait_until(
                    lambda: len([r for r in site.readings() if r["number"] == 3]) > 6, what="readings")
                self.assertEqual(server.stop(), 0)
                times = [datetime.fromisoformat(r["time"].replace("Z", "+00:00")).timestamp()
                         for r in site.readings() if r["number"] == 3]
                periods[run] = statistics.median(b - a for a, b in zip(times, times[1:]))
                self.assertGreater(periods[run], run / 1000 - 0.1)
        self.assertLess(periods[300], periods[1500])

    def test_num_r_err_srs_of_the_ini_counts(self):
        with Site(ini(NumRErrSrs=3, TORCom=50, TmRun=100, TmStart=0), faults=["silent=3"]) as site:
            server = site.start()
            site.wait_for(lambda last: last.get(3, {}).get("status") == 0x3700, seconds=30, what="code 3")
            self.assertEqual(server.stop(), 0)

    def test_language(self):
        for language, word in (("en", "started"), ("ru", "запущен")):
            with Site(ini(f"Language={language}"), faults=None) as site:
                server = site.start()
                server.wait_until(lambda: any(word in line for line in server.errors), what=word)
                self.assertEqual(server.stop(), 0)

    def test_legacy_status_bits(self):
        """spec/gorizont.md, section 3: ` 0 0011 0011 1000` of an inclinometer."""
        for value, word in ((0, 0x0300), (1, 0x0338)):
            with Site(ini(f"LegacyStatusBits={value}", TmStart=0)) as site:
                server = site.start()
                site.wait_for(lambda last: last.get(3, {}).get("status") == word, seconds=30, what=f"{word:04x}")
                self.assertEqual(server.stop(), 0)

    def test_can_info_asks_for_the_firmware(self):
        with Site(ini(CanInfo=1, N1=10, TmStart=0)) as site:  # site number 10 is asked first thing
            server = site.start("--lang", "en")
            server.wait_until(lambda: any("Firmware 2.3.12" in line for line in server.errors), seconds=30, what="answer")
            self.assertEqual(server.stop(), 0)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as home:
        os.environ["QT_QPA_PLATFORM"] = "offscreen"
        os.environ["XDG_CONFIG_HOME"] = home
        unittest.main()
