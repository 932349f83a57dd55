"""What the server keeps and serves of a simulated L-VIMS: `_vdata`, unit 1, captured files."""
import csv
import json
import math
import re
import struct
import subprocess
import time
import unittest

from foreign_clients import CLIENTS
from site_under_test import Site, free_port

PYTHON = "/usr/bin/python3"  # that of Debian sees its pymodbus
ENOUGH = 120  # seconds; the machine may be busy
CAPTURED = re.compile(r"^(\d\d_){6}5_ch([01])(_200)?\.(csv|wav)$")


def ini(module, modbus, *more):
    return "\n".join([
        "[Common]", f"IPPort1={modbus}", "CanModbus=1", "NumOfPorts=1", "[Timers]", "TmSave=500", "[Port1]", "Num=1",
        "On=1", f"Device=tcp://127.0.0.1:{module}", "NumOfSensors=1", "Name1=Pump (L-VIMS)", "N1=5", "On1=1", *more, ""])


def registers(port, *wanted):
    """Each `start:count` of unit 1 as bytes, read by pymodbus."""
    done = subprocess.run(
        [PYTHON, str(CLIENTS / "read_pymodbus.py"), str(port), *(f"1:4:{what}" for what in wanted)],
        capture_output=True, text=True, timeout=ENOUGH, check=True)
    return [struct.pack(f">{len(block)}H", *block) for block in json.loads(done.stdout)]


def same(served, printed):
    return math.isnan(served) if printed is None else math.isclose(served, printed, rel_tol=1e-6)


def channel_agrees(block, channel):
    """A channel's 100 registers against the JSON of one reading."""
    state, flags, count = struct.unpack_from(">HHH", block)
    measured = channel["measurements"]
    served = {m["index"]: struct.unpack_from(">HHfff", block, 2 * (20 + 10 * m["index"])) for m in measured}
    return (state, flags & 3, count) == (channel["state"], 3, len(measured)) and all(
        served[m["index"]][0] == m["type"] and same(served[m["index"]][2], m["value"])
        and same(served[m["index"]][3], m["percent"]) for m in measured)


def row_agrees(fields, reading):
    """The 70 fields of a module in `_vdata` against the JSON of one reading."""
    for channel in reading["channels"]:
        own = fields[1 + 17 * channel["channel"]:][:17]
        if own[0] != str(channel["state"]):
            return False
        measured = {m["index"]: m for m in channel["measurements"]}
        for index in range(8):
            kind, value = own[1 + 2 * index:3 + 2 * index]
            known = measured.get(index)
            if known is None and (kind or value):
                return False
            if known and (kind != str(known["type"]) or not math.isclose(float(value), known["value"], rel_tol=2e-6)):
                return False
    relays = fields[69].split(" ")
    return [int(word, 2) for word in relays] == [
        sum(relay[what] << relay["index"] for relay in reading["relays"])
        for what in ("enabled", "error", "physical", "logical")]


class VimsRecords(unittest.TestCase):
    def site(self, *more):
        self.modbus = free_port()
        site = self.enterContext(Site(ini(free_port(), self.modbus, *more)))
        site.start()
        site.wait_for(lambda last: last.get(5, {}).get("channels"), ENOUGH, "channels")
        return site

    def wait(self, condition, what):
        deadline = time.monotonic() + ENOUGH
        while not condition():
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(0.2)

    def whole(self, site):
        return [reading for reading in site.readings() if len(reading.get("channels", [])) == 4]

    def test_monthly_file(self):
        site = self.site()
        self.wait(lambda: site.file_text("vdata").count("\r\n") >= 6, "records")
        self.assertEqual(site.server.stop(), 0)
        text = site.file_text("vdata")
        self.assertTrue(text.endswith("\r\n"))
        rows = [line.split("\t") for line in text.split("\r\n")[:-1]]
        times = [line.split("\t")[0] for line in site.file_text("data").split("\r\n")[:-1]]
        self.assertEqual([row[0] for row in rows], times)  # beside those of _data
        self.assertEqual({len(row) for row in rows}, {72})
        last = rows[-1]
        self.assertEqual((last[1], last[2]), ("3330", " 0 0111 0000 0000"))
        self.assertTrue(any(row_agrees(last[2:], reading) for reading in self.whole(site)), last)

    def test_unit_1(self):
        site = self.site()
        self.wait(lambda: registers(self.modbus, "65000:1")[0] == b"\0\0", "registers")
        block, relays, *channels = registers(
            self.modbus, "3000:100", "65400:5", *(f"{65000 + 100 * i}:100" for i in range(4)))
        self.assertEqual(struct.unpack_from(">IHHH", block), (5, 1, 1, 4))  # N, port, address, type
        self.assertEqual(struct.unpack_from(">6H", block, 2 * 94), (65000, 4, 100, 65400, 0, 0))
        for i, channel in enumerate(channels):
            self.assertTrue(any(channel_agrees(channel, r["channels"][i]) for r in self.whole(site)), (i, channel.hex()))
        printed = self.whole(site)[-1]["relays"]
        self.assertEqual(struct.unpack(">5H", relays), (0xFF, *(
            sum(relay[what] << relay["index"] for relay in printed)
            for what in ("logical", "physical", "error", "enabled"))))
        self.assertEqual(site.server.stop(), 0)

    def test_captures(self):
        site = self.site("CaptureEvery1=2", "CaptureChannels1=0,1", "CaptureKinds1=waveform,200", "CaptureFormat1=csv,wav")
        folder = site.history / "Vims"
        kinds = {(channel, kind, suffix) for channel in "01" for kind, suffix in
                 ((None, "csv"), (None, "wav"), ("_200", "csv"))}

        def found():
            names = [CAPTURED.match(path.name) for path in folder.glob("*")]
            return {(name[2], name[3], name[4]) for name in names if name}

        self.wait(lambda: found() == kinds, "captures")
        before = len(site.readings())
        self.wait(lambda: len(site.readings()) > before + 2, "polling")  # goes on beside the captures
        self.assertEqual(site.server.stop(), 0)
        self.assertEqual([path.name for path in folder.iterdir() if not CAPTURED.match(path.name)], [])
        with open(min(folder.glob("*_5_ch1.csv")), newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.assertEqual((rows[0], len(rows)), (["time", "code", "value"], 12801))
        # 10 V over 2**23 codes, 100 mV/g, 0.25 mm/s2 of offset; 25600 samples a second
        for number, (moment, code, value) in enumerate(rows[1:]):
            self.assertAlmostEqual(float(moment), number / 25600, places=6)
            self.assertAlmostEqual(float(value), int(code) * 10 / 2**23 * 10 * 9806.65 + 0.25, places=2)
        sound = min(folder.glob("*_5_ch0.wav")).read_bytes()
        self.assertEqual((sound[:4], len(sound)), (b"RIFF", 44 + 4 * 12800))
        with open(min(folder.glob("*_5_ch0_200.csv")), newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.assertEqual((rows[0], len(rows)), (["frequency", "amplitude"], 2049))
        self.assertEqual([row for row in site.file_text("log").splitlines() if row.startswith("3")], [])

    def test_nothing_is_saved_without_can_save(self):
        site = self.site("CaptureEvery1=1")
        self.assertEqual(site.server.stop(), 0)
        text = site.ini.read_text(encoding="utf-8").replace("CanModbus=1", "CanModbus=1\nCanSave=0")
        site.ini.write_text(text, encoding="utf-8")
        for path in [*site.history.glob("*.txt"), *site.history.glob("Vims/*")]:
            path.unlink()
        site.start()
        self.wait(lambda: len(self.whole(site)) > 4, "readings")
        self.assertEqual(site.server.stop(), 0)
        self.assertEqual([*site.history.glob("*.txt"), *site.history.glob("Vims/*")], [])


if __name__ == "__main__":
    unittest.main()
