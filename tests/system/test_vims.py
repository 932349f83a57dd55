"""gorizont-tool vims and the server itself against a simulated L-VIMS behind a socket."""
import csv
import json
import pathlib
import struct
import subprocess
import tempfile
import unittest

from site_under_test import PROGRAMS, Site, free_port

GOOD, REFUSED, USAGE, NO_ANSWER = 0, 1, 2, 3
ENOUGH = 150  # seconds; the machine may be busy


def ini(port):
    return f"""[Common]
NumOfPorts=1
[Port1]
Num=1
On=1
Device=tcp://127.0.0.1:{port}
NumOfSensors=1
Name1=Pump (L-VIMS)
N1=1
On1=1
"""


def tool(port, *arguments):
    """Exit code and the objects printed."""
    done = subprocess.run(
        [str(PROGRAMS / "gorizont-tool"), "vims", *map(str, arguments), "--device", f"tcp://127.0.0.1:{port}",
         "--timeout", "5000", "--lang", "en", "--json"],
        capture_output=True, text=True, timeout=ENOUGH, stdin=subprocess.DEVNULL)
    return done.returncode, [json.loads(line) for line in done.stdout.splitlines()]


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return rows[0], [[float(cell) for cell in row] for row in rows[1:]]


class Vims(unittest.TestCase):
    def setUp(self):
        self.port = free_port()
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.site = self.enterContext(Site(ini(self.port)))

    def test_info_and_state(self):
        code, found = tool(self.port, "info")
        self.assertEqual((code, found[0]["type"], found[0]["name"], found[0]["mode"]), (GOOD, "L-VIMS", "VIMS_ICP", 2))
        code, found = tool(self.port, "state")
        self.assertEqual(code, GOOD)
        self.assertEqual([c["channel"] for c in found[0]["channels"]], [0, 1, 2, 3])
        self.assertEqual([c["state"] for c in found[0]["channels"]], [0, 0, 0, 0])
        self.assertEqual([m["type"] for m in found[0]["channels"][3]["measurements"]], [1, 2, 3])
        self.assertEqual([r["index"] for r in found[0]["relays"]], list(range(8)))

    def test_waveform(self):
        path = self.folder / "wave.csv"
        code, found = tool(self.port, "waveform", "--channel", 1, "--out", path)
        self.assertEqual((code, found[0]["samples"], found[0]["rate"]), (GOOD, 12800, 25600))
        header, rows = table(path)
        self.assertEqual(header, ["time", "code", "value"])
        self.assertEqual(len(rows), 12800)
        self.assertAlmostEqual(rows[-1][0], 12799 / 25600)
        # y = Kx + B: 10 V over 2**23 codes, 100 mV/g, 0.25 mm/s2 of offset
        for _, number, value in rows[::997]:
            self.assertAlmostEqual(value, number * 10 / 2**23 * 10 * 9806.65 + 0.25, places=2)
        sound = self.folder / "wave.wav"
        self.assertEqual(tool(self.port, "waveform", "--out", sound)[0], GOOD)
        data = sound.read_bytes()
        self.assertEqual((data[:4], struct.unpack("<I", data[24:28])[0], len(data)), (b"RIFF", 25600, 44 + 4 * 12800))

    def test_spectra(self):
        for kind, step in (("5000", 12800 / 4096), ("200", 512 / 4096)):
            path = self.folder / f"{kind}.csv"
            code, found = tool(self.port, "spectrum", "--channel", 2, "--type", kind, "--out", path)
            self.assertEqual((code, found[0]["bins"], found[0]["spectrum"]), (GOOD, 2048, int(kind)))
            header, rows = table(path)
            self.assertEqual(header, ["frequency", "amplitude"])
            self.assertAlmostEqual(rows[1][0], step)
            highest = max(rows, key=lambda row: row[1])
            self.assertAlmostEqual(highest[0], found[0]["peakFrequency"], places=3)

    def test_settings(self):
        path = self.folder / "settings.json"
        self.assertEqual(tool(self.port, "settings", "--save", path)[0], GOOD)
        kept = json.loads(path.read_text(encoding="utf-8"))
        self.assertEqual((kept["type"], len(kept["registers"]), kept["registers"][114]), ("L-VIMS", 7456, 500))
        kept["registers"][114] = 100
        path.write_text(json.dumps(kept), encoding="utf-8")
        self.assertEqual(tool(self.port, "settings", "--load", path)[0], REFUSED)  # nobody agreed
        code, found = tool(self.port, "settings", "--load", path, "--yes")
        self.assertEqual((code, found[0]["done"], found[0]["settingsError"]), (GOOD, True, 0))
        self.assertEqual(tool(self.port, "waveform")[1][0]["samples"], 2560)
        kept["registers"][114] = 4001
        path.write_text(json.dumps(kept), encoding="utf-8")
        code, found = tool(self.port, "settings", "--load", path, "--yes")
        self.assertEqual((code, found[0]["done"], found[0]["fault"]), (REFUSED, False, "refused"))
        self.assertNotEqual(found[0]["settingsError"], 0)

    def test_single_settings(self):
        code, found = tool(self.port, "settings", "--show")
        self.assertEqual((code, len(found[0]["values"]), found[0]["differences"]), (GOOD, 175, []))
        self.assertEqual(found[0]["values"]["IP_ADDR"], "192.168.1.10")
        self.assertEqual(found[0]["values"]["CH2.MEAS1.TYPE"], "2")
        change = ("settings", "--set", "WF_ACQ_TIME=100", "--set", "ch1.sensor_k=12,5")
        self.assertEqual(tool(self.port, *change)[0], REFUSED)  # nobody agreed
        code, found = tool(self.port, *change, "--yes")
        self.assertEqual((code, found[0]["applied"], found[0]["writeError"]), (GOOD, False, 0))
        prepared = [{"name": "WF_ACQ_TIME", "current": "500", "changed": "100"},
                    {"name": "CH1.SENSOR_K", "current": "100", "changed": "12.5"}]
        self.assertEqual(tool(self.port, "settings", "--show")[1][0]["differences"], prepared)
        self.assertEqual(tool(self.port, "waveform")[1][0]["samples"], 12800)  # only prepared
        code, found = tool(self.port, "settings", "--apply", "--yes")
        self.assertEqual((code, [c["after"] for c in found[0]["changes"]]), (GOOD, ["100", "12.5"]))
        self.assertEqual(tool(self.port, "waveform")[1][0]["samples"], 2560)
        self.assertEqual(tool(self.port, "reload", "--yes")[0], GOOD)
        self.assertEqual(tool(self.port, "waveform")[1][0]["samples"], 12800)
        code, found = tool(self.port, "settings", "--set", "CUSTOM_NAME=Вентилятор", "--flash", "--yes")
        self.assertEqual((code, found[0]["flash"]), (GOOD, True))
        self.assertEqual(tool(self.port, "reboot")[0], REFUSED)  # nobody agreed
        self.assertEqual(tool(self.port, "reboot", "--yes")[0], GOOD)
        values = tool(self.port, "settings", "--show")[1][0]["values"]
        self.assertEqual(values["CUSTOM_NAME"], "Вентилятор")

    def test_usage(self):
        for wrong in ((), ("dance",), ("waveform", "--channel", 4), ("spectrum", "--type", 300), ("settings",),
                      ("settings", "--set", "WF_ACQ_TIME"), ("settings", "--set", "WF_ACQ_TIME=4001"),
                      ("settings", "--set", "NO_SUCH=1"), ("settings", "--show", "--apply"),
                      ("settings", "--load", "x", "--set", "WF_ACQ_TIME=1")):
            self.assertEqual(tool(self.port, *wrong)[0], USAGE, wrong)
        self.assertEqual(tool(free_port(), "info")[0], NO_ANSWER)
        self.assertEqual(tool(self.port, "info", "--unit", 9)[0], NO_ANSWER)

    def test_server(self):
        self.site.start()
        self.site.wait_for(lambda readings: readings.get(1, {}).get("channels"), what="channels")
        last = [r for r in self.site.readings() if r.get("channels")][-1]
        self.assertEqual((last["type"], last["number"], last["status"] >> 12), ("L-VIMS", 1, 0))
        self.assertEqual(len(last["channels"]), 4)
        self.assertEqual(len(last["relays"]), 8)
        measured = last["channels"][0]["measurements"][0]
        self.assertEqual((measured["index"], measured["type"], measured["fault"]), (0, 1, False))
        self.assertGreater(measured["value"], 100)


if __name__ == "__main__":
    unittest.main()
