"""The main job on the manual's own configuration: poll, print, save, serve; compared value by value."""
import ctypes
import datetime
import math
import re
import shutil
import struct
import subprocess
import time
import unittest
import pathlib

from site_under_test import (
    ARC_SECONDS_PER_DEGREE, ModbusClient, Site, analysed, annex, free_port, read_acceleration, read_tilt)

TILT_NUMBERS = [1, 2, 3, 4, 11, 12, 13, 14]
ACCELERATION_NUMBERS = [1, 2, 11, 12]
DATA_LINE = re.compile(
    r"\d\d:\d\d:\d\d \d\d\.\d\d\.\d\d\t[0-3]{4,16}"
    r"(\t *-?\d+\.\d\t *-?\d+\.\d\t( *-?\d+\.\d\d)?\t *\d+\.\d\t[ \d]\d [01]{4} [01]{4} [01]{4}){8}\r\n")


class LibModbus:
    """The C library of that name, through its plain interface."""

    def __init__(self, port):
        self.library = ctypes.CDLL("libmodbus.so.5")
        self.library.modbus_new_tcp.restype = ctypes.c_void_p
        self.context = ctypes.c_void_p(self.library.modbus_new_tcp(b"127.0.0.1", port))
        assert self.library.modbus_connect(self.context) == 0

    def read(self, unit, start, count):
        registers = (ctypes.c_uint16 * count)()
        self.library.modbus_set_slave(self.context, unit)
        assert self.library.modbus_read_input_registers(self.context, start, count, registers) == count
        return b"".join(value.to_bytes(2, "big") for value in registers)

    def close(self):
        self.library.modbus_close(self.context)
        self.library.modbus_free(self.context)


def close(served, printed, step):
    """Equal to a step of the served integer; a little more because the two were not taken at the same moment."""
    return abs(served - printed) <= 0.5001 * step


class Annex(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.port = free_port()
        cls.site = Site(annex(IPPort1=cls.port, TmSave=1000))
        cls.addClassCleanup(cls.site.__exit__)
        cls.site.start()
        # Statistics of accelerations need ten packets of 3.2 s.
        cls.site.wait_for(
            lambda last: set(last) == set(TILT_NUMBERS) and all("accelMax" in last[n] for n in ACCELERATION_NUMBERS),
            seconds=120)

    def matching(self, read, agrees):
        """Served values and the printed readings that were current; tried again when a reading came in between."""
        for _ in range(20):
            before = self.site.last_readings()
            served = read()
            problems = agrees(served, before)
            if not problems or before == self.site.last_readings():
                return problems
        return problems

    def test_unit_3_agrees_with_the_printed_readings(self):
        def agrees(served, printed):
            channels, sensors = served
            problems = [] if channels == 0 else [f"channel word {channels:08x}"]
            for number, (x, y, t, status) in zip(TILT_NUMBERS, sensors):
                reading = printed[number]
                if not (close(x, reading["tiltX"] / ARC_SECONDS_PER_DEGREE, 0.001)
                        and close(y, reading["tiltY"] / ARC_SECONDS_PER_DEGREE, 0.001)
                        and status == reading["status"]
                        and ("temperature" not in reading or close(t, reading["temperature"], 0.01))):
                    problems.append(f"{number}: {(x, y, t, status)} against {reading}")
            return problems

        for client in (ModbusClient(self.port), LibModbus(self.port)):
            self.assertEqual(self.matching(lambda: read_tilt(client, 8), agrees), [])
            client.close()

    def test_unit_6_agrees_with_the_printed_readings(self):
        def agrees(served, printed):
            problems = []
            for number, (maximum, direction, x, y, status) in zip(ACCELERATION_NUMBERS, served[1]):
                reading = printed[number]
                if not (close(maximum, reading["accelMax"], 0.01) and close((direction - reading["accelDirection"] + 180) % 360, 180, 0.1)
                        and close(x, reading["accelRmsX"], 0.01) and close(y, reading["accelRmsY"], 0.01)
                        and status == reading["status"]):
                    problems.append(f"{number}: {(maximum, direction, x, y, status)} against {reading}")
            return problems

        for client in (ModbusClient(self.port), LibModbus(self.port)):
            self.assertEqual(self.matching(lambda: read_acceleration(client, 4), agrees), [])
            client.close()

    def test_unit_1_agrees_with_the_printed_readings(self):
        numbers = sorted(TILT_NUMBERS)
        fields = {"tiltX": 16, "tiltY": 18, "temperature": 24, "accelMax": 32, "accelDirection": 34, "accelRmsX": 42,
                  "accelRmsY": 44}

        def read_blocks(client):
            return lambda: [client.read(1, 3000 + 100 * slot, 64) for slot in range(len(numbers))]

        def agrees(blocks, printed):
            problems = []
            for number, block in zip(numbers, blocks):
                reading = printed[number]
                served = {name: struct.unpack_from(">f", block, 2 * at)[0] for name, at in fields.items()}
                n, port, address, _, flags, status = struct.unpack_from(">IHHHHH", block, 0)
                milliseconds = struct.unpack_from(">Q", block, 24)[0]
                moment = datetime.datetime.fromisoformat(reading["time"].replace("Z", "+00:00"))
                same = all(math.isnan(served[name]) if name not in reading
                           else math.isclose(served[name], reading[name], rel_tol=1e-6, abs_tol=1e-6) for name in fields)
                if not (same and n == number and status == reading["status"] and address == reading["address"]
                        and flags & 0b1111 == 0b1111 and milliseconds == round(1000 * moment.timestamp())):
                    problems.append(f"{number}: {served} {n} {port} {flags:x} {milliseconds} against {reading}")
            return problems

        for client in (ModbusClient(self.port), LibModbus(self.port)):
            self.assertEqual(self.matching(read_blocks(client), agrees), [])
            client.close()

    def test_clocks_of_unit_1_go(self):
        client = ModbusClient(self.port)
        before = time.time()
        served = struct.unpack(">Q", client.read(1, 8, 4, function=3))[0] / 1000
        self.assertTrue(before - 0.002 <= served <= time.time() + 0.002, (before, served))
        client.close()

    def test_mbpoll_reads_floats(self):
        client = ModbusClient(self.port)
        for _ in range(20):
            before = client.read(1, 3016, 4)
            output = subprocess.run(
                ["mbpoll", "-m", "tcp", "-p", str(self.port), "-a", "1", "-0", "-r", "3016", "-c", "2", "-t", "4:float",
                 "-B", "-1", "-q", "127.0.0.1"], capture_output=True, text=True, timeout=30, check=True).stdout
            if before == client.read(1, 3016, 4):
                break
        values = [float(value) for value in re.findall(r"\[\d+\]:\s*(\S+)", output)]
        self.assertEqual(len(values), 2, output)
        for value, expected in zip(values, struct.unpack(">ff", before)):
            self.assertTrue(math.isclose(value, expected, rel_tol=1e-4), (value, expected))
        client.close()

    def test_mbpoll_reads_the_same_registers(self):
        client = ModbusClient(self.port)
        for unit, count in ((3, 2), (6, 2), (1, 8)):
            output = subprocess.run(
                ["mbpoll", "-m", "tcp", "-p", str(self.port), "-a", str(unit), "-0", "-r", "0", "-c", str(count),
                 "-t", "3:hex", "-1", "-q", "127.0.0.1"], capture_output=True, text=True, timeout=30, check=True).stdout
            registers = [int(value, 16) for value in re.findall(r"\[\d+\]:\s*0x([0-9A-Fa-f]{4})", output)]
            ours = client.read(unit, 0, count)
            self.assertEqual(registers, [int.from_bytes(ours[i:i + 2], "big") for i in range(0, 2 * count, 2)])
        client.close()

    def test_an_analyser_finds_nothing_malformed(self):
        client = ModbusClient(self.port)
        read_tilt(client, 8)
        read_acceleration(client, 4)
        client.read(1, 0, 125)
        client.read(1, 3000, 125, function=3)
        with self.assertRaises(Exception):
            client.read(3, 30000, 2)
        client.close()
        decoded = analysed(client.traffic)
        self.assertEqual(decoded.count("Modbus/TCP"), len(client.traffic), decoded[-3000:])
        self.assertNotIn("Malformed", decoded)
        self.assertIn("Illegal data address", decoded)

    def test_files_have_the_form_of_the_manual(self):
        for line in self.site.file_text("data").splitlines(keepends=True):
            if line.count("\t\t\t") == 0:  # every sensor has answered
                self.assertRegex(line, DATA_LINE)
        last = self.site.file_text("data").splitlines(keepends=True)[-1]
        self.assertRegex(last, DATA_LINE)
        self.assertTrue(last.split("\t")[1] == "0000")
        acceleration = self.site.file_text("adata").splitlines()[-1].split("\t")
        self.assertEqual(len(acceleration), 2 + 5 * len(ACCELERATION_NUMBERS))

    def test_samples_are_saved_in_pairs(self):
        for x in (self.site.history / "Bin").glob("*X.wrd"):
            y = x.with_name(x.name.replace("X.wrd", "Y.wrd"))
            self.assertEqual(x.stat().st_size, y.stat().st_size)
            self.assertGreater(x.stat().st_size, 0)
        names = {re.sub(r".*_(\d+)X\.wrd", r"\1", x.name) for x in (self.site.history / "Bin").glob("*X.wrd")}
        self.assertEqual(names, {str(n) for n in ACCELERATION_NUMBERS})


if __name__ == "__main__":
    assert shutil.which("mbpoll") and shutil.which("tshark") and shutil.which("text2pcap")
    unittest.main()
