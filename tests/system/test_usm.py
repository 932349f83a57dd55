"""gorizont-tool usm against simulated УСМ-ИСН: what it prints, what it changes, its exit codes."""
import json
import pathlib
import subprocess
import tempfile
import time
import unittest

from site_under_test import PROGRAMS, Site

INI = """[Common]
NumOfPorts=1
[Port1]
Num=1
On=1
BaudRate=9600
NumOfSensors=2
Name1=Inclinometer (USM-ISN)
N1=1
On1=1
adr1=7
SND31=01234567
Name2=Inclinometer (USM-ISN)
N2=2
On2=1
adr2=9
SND32=07654321
"""
GOOD, REFUSED, USAGE, NO_ANSWER = 0, 1, 2, 3
ENOUGH = 150  # seconds: a recorder may sleep for 26 of them, and the machine may be busy


def tool(site, *arguments, baud=9600):
    """Exit code and the objects printed."""
    done = subprocess.run(
        [str(PROGRAMS / "gorizont-tool"), "usm", *map(str, arguments), "--device", str(site.ports / "COM1"), "--baud",
         str(baud), "--timeout", "500", "--lang", "en", "--json"],
        capture_output=True, text=True, timeout=ENOUGH, stdin=subprocess.DEVNULL)
    return done.returncode, [json.loads(line) for line in done.stdout.splitlines()]


class Usm(unittest.TestCase):
    def test_who_is_there(self):
        with Site(INI) as site:
            code, found = tool(site, "scan", "--from", 6, "--to", 10)
            self.assertEqual((code, [(f["address"], f["serial"]) for f in found]), (GOOD, [(7, 1234567), (9, 7654321)]))
            self.assertEqual(tool(site, "serial", "--address", 9),
                             (GOOD, [{"type": "usm", "address": 9, "serial": 7654321}]))
            self.assertEqual(tool(site, "find", 7654321), (GOOD, [{"type": "usm", "address": 9, "serial": 7654321}]))
            code, found = tool(site, "info", "--address", 7)
            self.assertEqual(code, GOOD)
            self.assertEqual((found[0]["deviceType"], found[0]["calibratedOn"], found[0]["calibrations"]),
                             (28, "2017-04-14", 2))
            self.assertEqual([c["id"] for c in found[0]["channels"]], [123456701, 123456702])
            self.assertEqual(tool(site, "serial", "--address", 8)[0], NO_ANSWER)

    def test_measures_and_keeps_records(self):
        with Site(INI) as site:
            code, values = tool(site, "value", "--address", 7)
            self.assertEqual((code, [v["channel"] for v in values]), (GOOD, [1, 2]))
            self.assertEqual(tool(site, "records", "--address", 7), (GOOD, []))
            before = int(time.time())
            for _ in range(2):
                code, values = tool(site, "value", "--address", 7, "--channel", 2, "--store")
                self.assertEqual((code, len(values)), (GOOD, 1))
            self.assertTrue(before <= values[0]["timestamp"] <= time.time())
            code, records = tool(site, "records", "--address", 7, "--mask", "NEW")
            self.assertEqual((code, [r["measurement"] for r in records]), (GOOD, [1, 2]))
            self.assertEqual(records[1], values[0])
            self.assertEqual(tool(site, "records", "--address", 7, "--mask", "new"), (GOOD, []))
            code, records = tool(site, "records", "--address", 7, "--count", 1, "--channel", 2)
            self.assertEqual((code, [r["measurement"] for r in records]), (GOOD, [2]))

    def test_table_of_records(self):
        """Written as they come, continued without duplicates, and never over something else."""
        with Site(INI) as site, tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "deep" / "records.csv"
            header = "time,timestamp,serial,channel,measurement,value,variation,temperature"
            self.assertEqual(tool(site, "serial", "--address", 7)[0], GOOD)  # it is awake: storing is not tried twice
            self.assertEqual(tool(site, "value", "--address", 7, "--store")[0], GOOD)
            self.assertEqual(tool(site, "records", "--address", 7, "--mask", "NEW", "--csv", table)[0], GOOD)
            lines = table.read_bytes().decode().split("\r\n")
            self.assertEqual((lines[0], lines[3], len(lines)), (header, "", 4))
            self.assertEqual([line.split(",")[2:5] for line in lines[1:3]], [["01234567", "1", "1"], ["01234567", "2", "2"]])
            table.write_bytes(table.read_bytes()[:-5])  # what a kill leaves behind
            self.assertEqual(tool(site, "records", "--address", 7, "--csv", table)[0], GOOD)
            self.assertEqual(table.read_bytes().decode().split("\r\n"), lines)
            self.assertEqual(tool(site, "records", "--address", 7, "--csv", table)[0], GOOD)
            self.assertEqual(table.read_bytes().decode().split("\r\n"), lines)
            table.write_text("something else\n", encoding="utf-8")
            self.assertEqual(tool(site, "records", "--address", 7, "--csv", table)[0], REFUSED)
            self.assertEqual(table.read_text(encoding="utf-8"), "something else\n")

    def test_address_and_port(self):
        with Site(INI) as site:
            self.assertEqual(tool(site, "set-address", 12, "--address", 7)[0], REFUSED)  # nobody agreed
            self.assertEqual(tool(site, "set-address", 9, "--address", 7, "--yes")[0], REFUSED)  # taken
            code, done = tool(site, "set-address", 12, "--address", 7, "--yes")
            self.assertEqual((code, done[0]["newAddress"], done[0]["done"]), (GOOD, 12, True))
            code, done = tool(site, "port-settings", 19200, "N", 1, "--address", 12, "--yes")
            self.assertEqual((code, done[0]["done"], done[0]["isProbed"]), (GOOD, True, True))
            self.assertEqual(tool(site, "serial", "--address", 12)[0], NO_ANSWER)
            code, found = tool(site, "serial", "--address", 12, baud=19200)
            self.assertEqual((code, found[0]["serial"]), (GOOD, 1234567))

    def test_recorder(self):
        with Site(INI) as site:
            self.assertEqual(tool(site, "start-cycle", "--address", 9, "--period", 900, "--yes")[0], GOOD)
            self.assertEqual(tool(site, "serial", "--address", 9)[0], NO_ANSWER)
            self.assertEqual(tool(site, "serial", "--address", 7)[0], GOOD)
            self.assertEqual(tool(site, "stop-cycle", "--address", 9)[0], GOOD)
            self.assertEqual(tool(site, "serial", "--address", 9)[0], GOOD)
            code, records = tool(site, "records", "--address", 9)
            self.assertEqual((code, [r["channel"] for r in records]), (GOOD, [1, 2]))

    def test_usage(self):
        with Site(INI) as site:
            for wrong in (["start-cycle", "--address", 7, "--period", 899], ["set-address", 256, "--address", 7],
                          ["port-settings", 19200, "M", 1, "--address", 7], ["value"], ["value", "--address", 7, "--channel", 3],
                          ["records", "--address", 7, "--mask", "OLD"], ["nothing", "--address", 7]):
                self.assertEqual(tool(site, *wrong)[0], USAGE, wrong)


if __name__ == "__main__":
    unittest.main()
