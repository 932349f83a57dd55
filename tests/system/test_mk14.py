"""gorizont-tool mk14 and the server itself against a simulated weather station on a pty."""
import json
import math
import pathlib
import signal
import struct
import subprocess
import tempfile
import time
import unittest

from site_under_test import PROGRAMS, ModbusClient, Site, free_port

GOOD, REFUSED, USAGE, NO_ANSWER = 0, 1, 2, 3
CLIENTS = pathlib.Path(__file__).parent.parent / "foreign"
PYTHON = "/usr/bin/python3"  # packages of Debian are seen by the one of Debian
ENOUGH = 150  # seconds; the machine may be busy


def ini(port, more=""):
    return f"""[Common]
NumOfPorts=1
IPPort1={port}
IPPort2={free_port()}
TmRun=200
TmSave=100
CanSave=1
[Port1]
Num=5
On=1
BaudRate=9600
NumOfSensors=1
Name1=Мачта (МК-14)
N1=7
adr1=3
On1=1
{more}"""


def tool(site, *arguments):
    """Exit code and the objects printed."""
    done = subprocess.run(
        [str(PROGRAMS / "gorizont-tool"), "mk14", *map(str, arguments), "--device", str(site.ports / "COM5"),
         "--address", "3", "--timeout", "3000", "--lang", "en", "--json"],
        capture_output=True, text=True, timeout=ENOUGH, stdin=subprocess.DEVNULL)
    return done.returncode, [json.loads(line) for line in done.stdout.splitlines()]


class Mk14Tool(unittest.TestCase):
    def setUp(self):
        self.site = self.enterContext(Site(ini(free_port())))

    def test_read(self):
        keys = {1: set(), 2: {"instant"}, 3: {"min", "max"}, 4: {"instant", "min", "max"},
                5: {"instant", "min", "max", "voltage"},
                6: {"instant", "min", "max", "voltage", "voltageInstant"}, 7: {"maxPeriod", "deviation"}}
        for command, more in keys.items():
            code, found = tool(self.site, "read", "--cmd", command)
            self.assertEqual((code, found[0]["type"], found[0]["address"], found[0]["cmd"]), (GOOD, "MK-14", 3, command))
            self.assertEqual([p["code"] for p in found[0]["parameters"]], list("UTPHAM"))
            for parameter in found[0]["parameters"]:
                self.assertEqual(set(parameter), {"code", "number", "name", "unit", "mean"} | more)
        code, found = tool(self.site, "read", "--cmd", 8, "--params", "U,T,P,H,A,M2")
        self.assertEqual(code, GOOD)
        self.assertEqual(found[0]["parameters"][5]["number"], 2)
        self.assertIn("deviation", found[0]["parameters"][4])
        self.assertIsInstance(found[0]["events"], list)

    def test_actions(self):
        self.assertEqual(tool(self.site, "set-outputs", "0x5")[0], REFUSED)  # nobody agreed
        code, found = tool(self.site, "set-outputs", "0x5", "--yes")
        self.assertEqual((code, found[0]["done"], found[0]["outputs"]), (GOOD, True, 5))
        self.assertEqual(found[0]["digital"] >> 16, 5)
        self.assertEqual(tool(self.site, "read", "--outputs", 9)[1][0]["digital"] >> 16, 9)
        self.assertEqual(tool(self.site, "read")[1][0]["digital"] >> 16, 0)
        code, found = tool(self.site, "set-time", "--utc", "--yes")
        self.assertEqual((code, found[0]["setting"], found[0]["done"]), (GOOD, "time", True))
        self.assertLess(abs(found[0]["time"] - time.time()), 60)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "ACK.PAR"
            path.write_bytes(b'"Air" V - T 2 A 0 %5.1f -60 60 1 0 1\r\nx - - M 1 A 0 %5.1f 0 60 1 0 1\r\n' + b"\xbb" * 9)
            code, found = tool(self.site, "send-file", path, "--yes")
            self.assertEqual((code, found[0]["done"], found[0]["name"]), (GOOD, True, "ACK.PAR"))
            path.write_bytes(b"x" * (64 * 1024 + 1))
            code, found = tool(self.site, "send-file", path, "--yes")
            self.assertEqual((code, found[0]["done"], found[0]["fault"]), (REFUSED, False, "refused"))

    def test_usage(self):
        for wrong in ((), ("dance",), ("read", "--cmd", 9), ("read", "--cmd", 0), ("read", "more"), ("set-outputs",),
                      ("set-outputs", "many"), ("send-file",), ("read", "--params", "7"), ("read", "--parity", "x")):
            self.assertEqual(tool(self.site, *wrong)[0], USAGE, wrong)
        done = subprocess.run(
            [str(PROGRAMS / "gorizont-tool"), "mk14", "set-time", "--yes", "--json", "--device",
             str(self.site.ports / "COM5"), "--address", "4", "--lang", "en"],
            capture_output=True, text=True, timeout=ENOUGH, stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, NO_ANSWER)
        self.assertIn("not confirmed", done.stderr)
        self.assertEqual((json.loads(done.stdout)["done"], json.loads(done.stdout)["fault"]), (False, "timeout"))


class Mk14Server(unittest.TestCase):
    def setUp(self):
        self.port = free_port()
        self.site = self.enterContext(Site(ini(self.port, "Outputs1=0x8001\n")))
        self.site.start()
        self.site.wait_for(
            lambda r: any("deviation" in p and "instant" in p for p in r.get(7, {}).get("parameters", [])),
            what="both commands")

    def reading(self):
        return [r for r in self.site.readings() if r.get("parameters")][-1]

    def mean(self, code):
        return next(p["mean"] for p in self.reading()["parameters"] if p["code"] == code)

    def test_readings(self):
        reading = self.reading()
        self.assertEqual((reading["type"], reading["number"], reading["status"]), ("MK-14", 7, 0x0500))
        self.assertEqual([(p["code"], p["number"]) for p in reading["parameters"]], [(c, 1) for c in "UTPHAM"])
        self.assertEqual(reading["digital"] >> 16, 0x8001)
        values = {p["code"]: p for p in reading["parameters"]}
        self.assertAlmostEqual(values["U"]["mean"], 12.4, delta=0.2)
        self.assertAlmostEqual(reading["temperature"], values["T"]["mean"], places=3)
        self.assertTrue({"mean", "instant", "min", "max", "maxPeriod", "deviation"} <= set(values["M"]))

    def test_unit_four_and_one(self):
        client = ModbusClient(self.port)
        raw = client.read(4, 0, 9)
        channels, speed, direction, maximum, of_maximum, deviation, turning, status = struct.unpack("<I7H", raw)
        self.assertEqual((channels, of_maximum, status), (0, 0, 0x0500))
        values = {p["code"]: p for p in self.reading()["parameters"]}
        self.assertAlmostEqual(speed / 100, values["M"]["mean"], delta=2)
        self.assertLess(direction, 3600)
        turned = (direction / 10 - values["A"]["mean"] + 180) % 360 - 180
        self.assertLess(abs(turned), 60)
        self.assertTrue(0 < maximum < 3000, maximum)  # of the last turns: the mean of a minute may be above it
        self.assertLess(deviation, 1000)
        self.assertLess(turning, 36000)
        wind = struct.unpack(">6fI", client.read(1, 3080, 14, function=3))
        self.assertFalse(any(map(math.isnan, wind[:6])), wind)
        self.assertAlmostEqual(wind[4], values["P"]["mean"], delta=1)
        self.assertEqual(wind[6] >> 16, 0x8001)

    def test_pymodbus(self):
        done = subprocess.run(
            [PYTHON, str(CLIENTS / "read_pymodbus.py"), str(self.port), "4:4:0:9", "4:4:8:2", "4:3:0:1"],
            capture_output=True, text=True, timeout=ENOUGH, check=True)
        registers, beyond, other = json.loads(done.stdout)
        self.assertEqual((beyond, other), ({"exception": 2}, {"exception": 1}))
        words = struct.unpack("<I7H", struct.pack(">9H", *registers))
        self.assertEqual((words[0], words[4], words[7]), (0, 0, 0x0500))
        self.assertAlmostEqual(words[1] / 100, self.mean("M"), delta=2)

    def test_month_file_is_whole_after_a_kill(self):
        self.site.server.wait_until(lambda: self.site.file_text("wdata").count("\n") >= 5, ENOUGH, "records")
        self.site.server.stop(signal.SIGKILL)
        path = next(self.site.history.glob("*_wdata.txt"))
        with path.open("ab") as file:
            file.write(b"18:33:03 07.02.18\t33")  # a kill may leave this
        self.site.start()
        before = path.read_bytes().count(b"\n")
        self.site.server.wait_until(lambda: path.read_bytes().count(b"\n") >= before + 3, ENOUGH, "new records")
        self.site.server.stop()
        lines = path.read_bytes().decode("ascii").split("\r\n")
        self.assertEqual(lines.pop(), "")
        full = 0
        for line in lines:
            fields = line.split("\t")
            self.assertRegex(fields[0], r"^\d\d:\d\d:\d\d \d\d\.\d\d\.\d\d$")
            self.assertEqual(fields[2], "7")
            self.assertRegex(fields[3], r"^[ 1]\d [01]{4} [01]{4} [01]{4}$")
            self.assertIn(len(fields), (6, 6 + 7 * 6))
            if len(fields) > 6:
                self.assertEqual(fields[6::7], ["U1", "T1", "P1", "H1", "A1", "M1"])
                self.assertEqual(fields[4], "80010001" if fields[4].endswith("1") else "80010003")
                full += fields[-1] != "" and fields[-4] != ""
        self.assertGreater(full, 0)


class Mk14Quiet(unittest.TestCase):
    def test_no_file_without_can_save_and_no_unit_without_a_station(self):
        port = free_port()
        with Site(ini(port).replace("CanSave=1", "CanSave=0")) as site:
            site.start()
            site.wait_for(lambda r: "parameters" in r.get(7, {}), what="a reading")
            time.sleep(0.5)
            self.assertFalse(list(site.folder.rglob("*_wdata.txt")))


if __name__ == "__main__":
    unittest.main()
