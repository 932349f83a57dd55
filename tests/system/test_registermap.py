"""`--print-register-map`: a contract for scripts, and true of the server that runs with the same ini."""
import re
import struct
import subprocess
import tempfile
import unittest
import pathlib

from site_under_test import DATA, PROGRAMS, ModbusClient, Site, annex, free_port

ROW = re.compile(r"^\| (\d+) \| 3(\d+) \|(?: 4(\d+) \|)? (\d) \| `(\w+)` \| (\w+) \| ([A-H]+) \| (\S+) \|(.*)\|$")
FORMATS = {"int16": ">h", "uint16": ">H", "uint32": ">I", "uint64": ">Q", "float32": ">f"}
ANNEX_NUMBERS = [1, 2, 3, 4, 11, 12, 13, 14]


def print_map(*arguments, **environment):
    return subprocess.run(
        [str(PROGRAMS / "gorizont-server"), "--print-register-map", *map(str, arguments)], capture_output=True,
        timeout=60, stdin=subprocess.DEVNULL, env={"HOME": "/nonexistent", "PATH": "/usr/bin:/bin", **environment})


class Row:
    def __init__(self, unit, match):
        self.unit = unit
        self.register, self.input = int(match[1]), int(match[2])
        self.holding = int(match[3]) if match[3] else None
        self.count, self.field, self.type, self.order = int(match[4]), match[5], match[6], match[7]
        self.scale = float(match[8])

    def value(self, client, function=4):
        data = client.read(self.unit, self.register, self.count, function)
        in_order = bytes(data[self.order.index(letter)] for letter in "ABCDEFGH"[:2 * self.count])
        return struct.unpack(FORMATS[self.type], in_order)[0] * self.scale


def rows_of(text):
    rows, unit = [], 0
    for line in text.splitlines():
        if line.startswith("## "):
            title = re.match(r"## \w+ (\d+)\. ", line)
            unit = int(title[1]) if title else 0
        elif unit and (match := ROW.match(line)):
            rows.append(Row(unit, match))
    return rows


class RegisterMap(unittest.TestCase):
    def test_needs_no_display_no_lock_and_no_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            ini = pathlib.Path(folder) / "GorizontServer.ini"
            ini.write_text(annex(IPPort1=1502), encoding="utf-8")
            pathlib.Path(folder).chmod(0o500)
            done = print_map("--config", ini, "--data", pathlib.Path(folder) / "data")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(sorted(p.name for p in pathlib.Path(folder).iterdir()), ["GorizontServer.ini"])
            pathlib.Path(folder).chmod(0o700)
        self.assertIn("1502", done.stdout.decode("utf-8"))

    def test_speaks_the_chosen_language(self):
        for language, words in (("ru", ["Карта регистров Modbus", "Ускорения"]), ("en", ["Modbus register map", "Accelerations"])):
            text = print_map("--demo", "--lang", language).stdout.decode("utf-8")
            for word in words:
                self.assertTrue(word in text, word)
            # The same registers in every language.
            self.assertEqual(len(rows_of(text)), 1 + 4 * 10 + 1 + 5 * 4 + 25 + 10 * (3 + 43))

    def test_failures_are_one_sentence(self):
        done = print_map("--config", "/nonexistent/GorizontServer.ini")
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"/nonexistent/GorizontServer.ini", done.stderr)
        self.assertEqual(done.stdout, b"")
        self.assertEqual(print_map("--nonsense").returncode, 2)

    def test_a_damaged_ini_has_a_map_too(self):
        done = print_map("--config", DATA / "config" / "mistakes.ini", "--lang", "en")
        self.assertEqual(done.returncode, 0)
        self.assertTrue(rows_of(done.stdout.decode("utf-8")))

    def test_the_map_is_true_of_the_running_server(self):
        port = free_port()
        with Site(annex(IPPort1=port)) as site:
            document = print_map("--config", site.ini, "--lang", "en").stdout.decode("utf-8")
            rows = rows_of(document)
            self.assertEqual(len(rows), 1 + 4 * 8 + 1 + 5 * 4 + 25 + 8 * (3 + 43))
            for row in rows:
                self.assertEqual(row.input, row.register + 1)
                self.assertEqual(row.holding, row.register + 1 if row.unit == 1 else None)
            site.start()
            site.wait_for(lambda last: all("tiltX" in last.get(n, {}) for n in ANNEX_NUMBERS), what="all sensors")
            client = ModbusClient(port)
            values = {(row.unit, row.register): row.value(client) for row in rows}
            fields = {(row.unit, row.register): row.field for row in rows}
            numbers = [value for key, value in values.items() if fields[key] == "number" and key[1] >= 3000]
            self.assertEqual(numbers, ANNEX_NUMBERS)
            for number, slot in zip(ANNEX_NUMBERS, range(8)):
                # The angles do not move by a hundredth of a degree between two requests.
                tilt = {name: next(r for r in rows if r.unit == 1 and r.field == name and r.register >= 3000 + 100 * slot)
                        for name in ("tilt_x", "tilt_x_arcsec")}
                degrees = tilt["tilt_x"].value(client, 3)
                self.assertAlmostEqual(degrees, tilt["tilt_x_arcsec"].value(client) / 3600, delta=0.01)
                self.assertAlmostEqual(degrees, values[3, 2 + 4 * slot], delta=0.01)
                self.assertAlmostEqual(degrees, site.last_readings()[number]["tiltX"] / 3600, delta=0.01)
            client.close()
            self.assertEqual(site.server.stop(), 0)


if __name__ == "__main__":
    unittest.main()
