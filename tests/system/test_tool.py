"""gorizont-tool against simulated sensors: what it prints, what it writes, its exit codes, and that it never hangs."""
import json
import os
import pty
import select
import signal
import subprocess
import time
import unittest

from site_under_test import PROGRAMS, Program, Site

INI = """[Common]
NumOfPorts=3
[Port1]
Num=1
On=1
NumOfSensors=3
Name1=Inclinometer (IN-D3)
N1=1
On1=1
adr1=1
SND31=1887
Name2=Inclinometer (IN-D3)
N2=2
On2=1
adr2=4
SND32=3592
Name3=Inclinometer (IN-D3)
N3=3
On3=1
adr3=6
Protocol3=modbus
SND33=5264
[Port2]
Num=2
On=1
NumOfSensors=2
Name1=Accelerometer (AN-D3, TMP05)
N1=4
On1=1
adr1=3
Name2=Accelerometer (AN-D3, TMP05)
N2=5
On2=1
adr2=7
"""
GOOD, REFUSED, USAGE, NO_ANSWER = 0, 1, 2, 3
TOOL = str(PROGRAMS / "gorizont-tool")
ENOUGH = 60  # seconds for anything on a busy machine


def tool(*arguments, language="en"):
    return subprocess.run(
        [TOOL, *map(str, arguments), "--lang", language], capture_output=True, text=True, timeout=ENOUGH,
        stdin=subprocess.DEVNULL)


class Line:
    """A port of a site and the options that belong to it."""

    def __init__(self, site, com, kind, *options, timeout=500):
        """Patient by default: the machine may be busy."""
        self.options = ["--device", site.ports / f"COM{com}", "--type", kind, "--timeout", timeout, *options]

    def run(self, *arguments):
        return tool(*arguments, *self.options)

    def json(self, *arguments):
        """Exit code and the objects printed."""
        done = self.run(*arguments, "--json")
        return done.returncode, [json.loads(line) for line in done.stdout.splitlines()]

    def info(self, address, *options):
        code, objects = self.json("info", "--address", address, *options)
        assert code == GOOD, objects
        return objects[0]


class AtTerminal:
    """The tool with a terminal on stdin and stderr."""

    def __init__(self, *arguments):
        self.master, slave = pty.openpty()
        self.process = subprocess.Popen(
            [TOOL, *map(str, arguments), "--lang", "en"], stdin=slave, stdout=subprocess.PIPE, stderr=slave,
            start_new_session=True)
        os.close(slave)
        self.shown = b""

    def wait_for(self, text):
        deadline = time.monotonic() + ENOUGH
        while text.encode() not in self.shown:
            assert time.monotonic() < deadline, self.shown
            if select.select([self.master], [], [], 0.2)[0]:
                self.shown += os.read(self.master, 4096)

    def type(self, text):
        os.write(self.master, text.encode())

    def end(self):
        """Exit code and what stood on stdout."""
        output = self.process.communicate(timeout=ENOUGH)[0].decode()
        os.close(self.master)
        return self.process.returncode, output


class Tool(unittest.TestCase):
    def test_scan_shows_who_is_there(self):
        with Site(INI) as site:
            line = Line(site, 1, "ind3", "--to", 6)
            code, found = line.json("scan")
            self.assertEqual(code, GOOD)
            self.assertEqual([(f["address"], f["serial"], f["version"]) for f in found],
                             [(1, 1887, "v2.11"), (4, 3592, "v2.11")])
            code, found = line.json("scan", "--protocol", "modbus", "--from", 5)
            self.assertEqual([(f["address"], f["serial"], f["version"], f["name"]) for f in found],
                             [(6, 5264, None, None)])
            done = line.run("scan")
            self.assertIn("1887", done.stdout)
            self.assertEqual(len(done.stdout.splitlines()), 2)
            self.assertEqual(len(done.stderr.splitlines()), 1)  # no progress where nobody looks
            code, found = Line(site, 2, "and3", "--to", 8).json("scan")
            self.assertEqual([(f["address"], f["firmware"], f["build"]) for f in found], [(3, "2.3", 12), (7, "2.3", 12)])

    def test_scan_of_an_empty_line(self):
        with Site(INI) as site:
            done = Line(site, 1, "ind3", timeout=100).run("scan", "--from", 100, "--to", 110)
            self.assertEqual((done.returncode, done.stdout), (NO_ANSWER, ""))

    def test_info_has_every_key(self):
        with Site(INI) as site:
            self.assertEqual(Line(site, 1, "ind3").info(1), {
                "type": "ind3", "address": 1, "protocol": "2.11", "version": "v2.11", "revision": 4144, "serial": 1887,
                "baud": 9600, "name": "NO NAME", "offsetX": 0, "offsetY": 0, "ticks": 32, "period": 50, "selfTest": None})
            modbus = Line(site, 1, "ind3", "--protocol", "modbus").info(6)
            self.assertEqual((modbus["serial"], modbus["name"], modbus["version"], modbus["offsetX"]), (5264, None, None, 0))
            shaking = Line(site, 2, "and3").info(3)
            self.assertEqual(set(shaking), {
                "type", "address", "firmware", "build", "configuration", "tiltX", "tiltY", "temperature", "fanFrequency",
                "heaterPower", "rawStatus", "rawMode", "samples"})
            self.assertEqual(shaking["configuration"].split()[4], "03")
            text = Line(site, 1, "ind3").run("info", "--address", 4).stdout
            for part in ("4", "NO NAME", "9600", "v2.11", "4144", "3592", "0.000", "32", "50 ms"):
                self.assertIn(part, text)

    def test_read_as_often_as_wanted(self):
        with Site(INI) as site:
            code, readings = Line(site, 1, "ind3").json("read", "--address", 1, "--count", 3, "--interval", 100)
            self.assertEqual((code, len(readings)), (GOOD, 3))
            for reading in readings:
                self.assertEqual(set(reading), {"type", "address", "time", "tiltX", "tiltY"})
            code, readings = Line(site, 2, "and3").json("read", "--address", 7)
            self.assertEqual((code, len(readings)), (GOOD, 1))
            self.assertGreater(readings[0]["temperature"], -60)
            text = Line(site, 2, "and3").run("read", "--address", 7).stdout
            self.assertRegex(text, r"X -?\d+\.\d{3}″  Y -?\d+\.\d{3}″  T -?\d+\.\d\d °C")

    def test_settings_are_written_and_read_back(self):
        with Site(INI) as site:
            line = Line(site, 1, "ind3")
            written = [
                ("set-name", "Дом }~ №1"), ("set-offset", "200,5", "-300.25"), ("set-averaging", "--ticks", 4, "--period", 100)]
            for command in written:
                done = line.run(*command, "--address", 1, "--yes")
                self.assertEqual(done.returncode, GOOD, done.stderr)
            info = line.info(1)
            self.assertEqual((info["name"], info["offsetX"], info["offsetY"]), ("Дом }~ №1", 200.5, -300.25))
            self.assertEqual((info["ticks"], info["period"]), (4, 100))
            self.assertEqual(line.info(4)["name"], "NO NAME")
            code, objects = line.json("set-offset", "-.5", "−1", "--address", 4, "--yes")
            self.assertEqual((code, objects), (GOOD, [{"type": "ind3", "address": 4, "setting": "offset", "done": True}]))
            self.assertEqual(line.info(4)["offsetX"], -0.5)
            modbus = Line(site, 1, "ind3", "--protocol", "modbus")
            code, objects = modbus.json("set-averaging", "--period", 10, "--ticks", 64, "--address", 6, "--yes")
            self.assertEqual((code, [(o["setting"], o["done"]) for o in objects]),
                             (GOOD, [("ticks", True), ("period", True)]))
            self.assertEqual(modbus.run("set-offset", "-1,25", "2", "--address", 6, "--yes").returncode, GOOD)
            self.assertEqual(modbus.info(6)["offsetX"], -1.25)

    def test_nothing_is_written_without_a_yes(self):
        with Site(INI) as site:
            line = Line(site, 1, "ind3", "--address", 1)
            for command in (["set-name", "x"], ["set-offset", 1, 2], ["set-averaging", "--ticks", 1], ["set-address", 9]):
                done = line.run(*command)
                self.assertEqual(done.returncode, REFUSED)
                self.assertIn("--yes", done.stderr)
            self.assertEqual(Line(site, 2, "and3").run("reset", "--address", 3).returncode, REFUSED)
            info = Line(site, 1, "ind3").info(1)
            self.assertEqual((info["name"], info["offsetX"], info["ticks"]), ("NO NAME", 0, 32))

    def test_somebody_at_a_terminal_is_asked(self):
        with Site(INI) as site:
            arguments = ["set-name", "Tower", "--address", 1, *Line(site, 1, "ind3").options]
            for answer, code in (("n\n", REFUSED), ("\n", REFUSED), ("\x04", REFUSED), ("y\n", GOOD)):
                asked = AtTerminal(*arguments)
                asked.wait_for("[y/N]")
                self.assertIn(b"Tower", asked.shown)
                asked.type(answer)
                self.assertEqual(asked.end()[0], code, answer)
                self.assertEqual(Line(site, 1, "ind3").info(1)["name"], "Tower" if code == GOOD else "NO NAME")

    def test_ctrl_c_at_a_question_is_a_no(self):
        with Site(INI) as site:
            asked = AtTerminal("set-name", "Tower", "--address", 1, *Line(site, 1, "ind3").options)
            asked.wait_for("[y/N]")
            asked.process.send_signal(signal.SIGINT)
            self.assertEqual(asked.end()[0], REFUSED)
            self.assertEqual(Line(site, 1, "ind3").info(1)["name"], "NO NAME")

    def test_address_of_an_inclinometer(self):
        with Site(INI) as site:
            line = Line(site, 1, "ind3", "--yes")
            taken = line.run("set-address", 4, "--address", 1)
            self.assertEqual(taken.returncode, REFUSED)
            self.assertIn("address 4", taken.stderr)
            code, objects = line.json("set-address", 255, "--address", 1)
            self.assertEqual((code, objects), (GOOD, [
                {"type": "ind3", "address": 1, "setting": "address", "newAddress": 255, "done": True}]))
            self.assertEqual(line.info(255)["serial"], 1887)
            self.assertEqual(line.run("read", "--address", 1).returncode, NO_ANSWER)
            self.assertEqual(line.run("set-address", 2, "--address", 1).returncode, NO_ANSWER)

    def test_address_of_an_accelerometer(self):
        with Site(INI) as site:
            line = Line(site, 2, "and3", "--yes")
            self.assertEqual(line.run("set-address", 7, "--address", 3).returncode, REFUSED)
            code, objects = line.json("set-address", 9, "--address", 3)
            self.assertEqual((code, objects[-1]["done"], objects[-1]["newAddress"]), (GOOD, True, 9))
            info = line.info(9)
            self.assertEqual(info["configuration"].split()[4:6], ["09", "01"])
            self.assertEqual(line.run("read", "--address", 3).returncode, NO_ANSWER)
            before = line.info(7)["samples"]
            self.assertEqual(line.run("reset", "--address", 7).returncode, GOOD)
            self.assertLess(line.info(7)["samples"], before + 60)

    def test_a_stored_address_waits_for_the_restart(self):
        with Site(INI) as site:
            asked = AtTerminal("set-address", 9, "--address", 3, *Line(site, 2, "and3").options)
            asked.wait_for("[y/N]")
            asked.type("y\n")
            asked.wait_for("Restart")
            asked.type("n\n")
            self.assertEqual(asked.end()[0], REFUSED)
            line = Line(site, 2, "and3")
            self.assertEqual(line.run("read", "--address", 3).returncode, GOOD)
            self.assertEqual(line.run("reset", "--address", 3, "--yes").returncode, NO_ANSWER)  # not there any more
            self.assertEqual(line.run("read", "--address", 9).returncode, GOOD)

    def test_no_answer_and_no_port(self):
        with Site(INI, faults=["silent=1"]) as site:
            line = Line(site, 1, "ind3", "--address", 1)
            for command in (["info"], ["read"], ["set-name", "x", "--yes"], ["set-address", 9, "--yes"]):
                code, objects = line.json(*command)
                self.assertEqual((code, objects[-1]["fault"]), (NO_ANSWER, "timeout"), command)
        for device in ("/nonexistent/port", "tcp://127.0.0.1:1"):
            done = tool("read", "--device", device, "--type", "and3", "--address", 1, "--json")
            self.assertEqual(done.returncode, NO_ANSWER)
            self.assertIn(device, done.stderr)
            self.assertEqual(json.loads(done.stdout)["fault"], "closed")

    def test_usage_errors_are_one_sentence(self):
        wrong = [
            [], ["nonsense"], ["--nonsense"], ["scan", "--type", "ind3"], ["scan", "--device", "x"],
            ["read", "--device", "x", "--type", "ind3"], ["read", "stray", "--device", "x", "--type", "ind3", "--address", 1]]
        common = ["--device", "x", "--address", 1, "--yes"]
        wrong += [[*command, *common] for command in (
            ["set-name"], ["set-name", ""], ["set-name", "12345678901234567"], ["set-name", "山"],
            ["set-name", "x", "--protocol", "modbus"], ["set-name", "x", "--protocol", "3"], ["set-name", "x", "--type", "and3"],
            ["set-offset", "1"], ["set-offset", "1", "x"], ["set-offset", "1", "nan"], ["set-offset", "1", "1e9"],
            ["set-averaging"], ["set-averaging", "--ticks", 3], ["set-averaging", "--period", 30], ["reset", "--type", "ind3"],
            ["set-address", 0, "--type", "ind3"], ["set-address", 256, "--type", "and3"], ["info", "--type", "dmm"],
            ["info", "--type", "ind3", "--count", 2], ["info", "--type", "and3", "--protocol", "2.11"],
            ["read", "--type", "ind3", "--baud", "fast"], ["read", "--type", "ind3", "--timeout", "-5"],
            ["read", "--type", "ind3", "--count", "-1"], ["info", "--type", "ind3", "--protocol", "2.10"])]
        for arguments in wrong:
            done = tool(*arguments)
            self.assertEqual((done.returncode, done.stdout), (USAGE, ""), arguments)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertEqual(tool("scan", "--device", "tcp://host", "--type", "ind3").returncode, USAGE)
        self.assertEqual(tool("scan", "--from", 9, "--to", 3, "--device", "x", "--type", "ind3").returncode, USAGE)
        self.assertEqual(tool("--help", language="de").returncode, GOOD)

    def test_help_is_complete_in_both_languages(self):
        words = ["scan", "read", "info", "set-address NEW", "set-name TEXT", "set-offset X Y", "set-averaging", "reset",
                 "--device", "--baud", "--parity", "--stop-bits", "--rs485", "--type", "--protocol", "--address", "--timeout",
                 "--from", "--to", "--count", "--interval", "--ticks", "--period", "--yes", "--json", "--lang", "offsetX",
                 "newAddress", "rawStatus"]
        for language, word in (("en", "Commands:"), ("ru", "Команды:")):
            done = tool("--help", language=language)
            self.assertEqual(done.returncode, GOOD)
            for needed in [*words, word]:
                self.assertIn(needed, done.stdout)
        self.assertIn("0.", tool("--version").stdout)

    def test_ctrl_c_ends_a_scan_cleanly(self):
        with Site(INI) as site:
            scan = Program("gorizont-tool", "scan", "--json", *Line(site, 1, "ind3").options)
            scan.wait_until(lambda: scan.lines, what="the first sensor")
            started = time.monotonic()
            self.assertEqual(scan.stop(signal.SIGINT), REFUSED)
            self.assertLess(time.monotonic() - started, 10)
            self.assertEqual(json.loads(scan.lines[0])["serial"], 1887)

    def test_ctrl_c_is_the_end_of_endless_reading(self):
        with Site(INI) as site:
            options = ["--address", 3, "--count", 0, "--interval", 50, *Line(site, 2, "and3").options]
            for number in (signal.SIGINT, signal.SIGTERM):
                reading = Program("gorizont-tool", "read", *options)
                reading.wait_until(lambda: len(reading.lines) > 3, what="readings")
                self.assertEqual(reading.stop(number), GOOD)

    def test_a_scan_shows_at_a_terminal_how_far_it_is(self):
        with Site(INI) as site:
            scan = AtTerminal("scan", "--to", 3, *Line(site, 1, "ind3").options)
            scan.wait_for("address 3")
            code, output = scan.end()
            self.assertEqual((code, len(output.splitlines())), (GOOD, 1))


class Faults(unittest.TestCase):
    TIMEOUT = 0.2
    START_AND_WIRE = 15  # seconds: of a program on a busy machine

    def within(self, exchanges, line, *arguments):
        """Runs, and sees that it took no longer than so many unanswered exchanges may; returns the exit code."""
        started = time.monotonic()
        done = line.run(*arguments)
        self.assertLess(time.monotonic() - started, exchanges * (self.TIMEOUT + 0.1) + self.START_AND_WIRE, arguments)
        self.assertIn(done.returncode, (GOOD, REFUSED, NO_ANSWER), done.stderr)
        self.assertEqual(done.returncode == GOOD, not done.stderr, done.stderr)
        return done.returncode

    def after_the_faults(self, line, address):
        deadline = time.monotonic() + ENOUGH
        while True:
            code, objects = line.json("info", "--address", address)
            if code == GOOD:
                return objects[0]
            self.assertLess(time.monotonic(), deadline)

    def try_inclinometer(self, *faults):
        with Site(INI, faults=faults) as site:
            line = Line(site, 1, "ind3", timeout=round(1000 * self.TIMEOUT))
            self.within(3, line, "read", "--address", 1)
            self.within(24, line, "info", "--address", 1)
            named = self.within(6, line, "set-name", "Tower", "--address", 1, "--yes")
            moved = self.within(24, line, "set-offset", "5", "-7,5", "--address", 1, "--yes")
            if named == GOOD or moved == GOOD:
                info = self.after_the_faults(line, 1)
                self.assertTrue(named != GOOD or info["name"] == "Tower")
                self.assertTrue(moved != GOOD or info["offsetY"] == -7.5)
            return named, moved, self.within(24, line, "set-address", 9, "--address", 1, "--yes")

    def test_silent(self):
        self.assertEqual(self.try_inclinometer("silent=1"), (NO_ANSWER, NO_ANSWER, NO_ANSWER))

    def test_wrong_check_sums(self):
        self.assertEqual(self.try_inclinometer("crc=100"), (NO_ANSWER, NO_ANSWER, NO_ANSWER))
        self.try_inclinometer("crc=30")

    def test_pieces_and_garbage(self):
        self.assertEqual(self.try_inclinometer("pieces=100", "garbage=50"), (GOOD, GOOD, GOOD))

    def test_late_answers(self):
        self.try_inclinometer("late=30")

    def test_accelerometer_with_everything(self):
        with Site(INI, faults=["crc=20", "pieces=30", "garbage=30", "late=10"]) as site:
            line = Line(site, 2, "and3", timeout=round(1000 * self.TIMEOUT))
            self.within(9, line, "info", "--address", 3)
            code = self.within(70 + 5 / self.TIMEOUT + 5 / self.TIMEOUT, line, "set-address", 9, "--address", 3, "--yes")
            if code == GOOD:
                self.assertEqual(self.after_the_faults(line, 9)["configuration"].split()[4], "09")

    def test_a_port_that_vanishes_ends_it(self):
        with Site(INI, faults=["gone=1:60@3"]) as site:
            scan = Program("gorizont-tool", "scan", "--lang", "en", *Line(site, 1, "ind3").options)
            self.assertEqual(scan.process.wait(ENOUGH), NO_ANSWER)
            scan.stop()
            self.assertTrue(any("port" in line for line in scan.errors), scan.errors)


if __name__ == "__main__":
    unittest.main()
