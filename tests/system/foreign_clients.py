"""Modbus clients of other makers against the program: what they read is decoded here and compared with what it prints.

A relay between the two keeps all that passes for a protocol analyser.
"""
import datetime
import json
import math
import os
import pathlib
import socket
import struct
import subprocess
import threading

from site_under_test import ARC_SECONDS_PER_DEGREE, Site, analysed, annex, free_port

CLIENTS = pathlib.Path(__file__).parent.parent / "foreign"
TILT_NUMBERS = [1, 2, 3, 4, 11, 12, 13, 14]
ACCELERATION_NUMBERS = [1, 2, 11, 12]
# unit:function:first register:registers; the layouts are those of spec/gorizont.md, section 6
WANTED = ["3:4:0:34", "6:4:0:22", *(f"1:{function}:{3000 + 100 * slot}:48" for function in (3, 4) for slot in range(8)),
          "3:4:30000:2", "3:3:0:2", "7:4:0:2"]
EXCEPTIONS = [{"exception": 2}, {"exception": 1}, {"exception": 11}]
FLOATS = {"tiltX": 16, "tiltY": 18, "temperature": 24, "accelMax": 32, "accelDirection": 34, "accelRmsX": 42,
          "accelRmsY": 44}


class Relay:
    """Passes connections on to the server and keeps the bytes in their order."""

    def __init__(self, port):
        self.server_port = port
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.traffic = []
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        while True:
            try:
                client, _ = self.listener.accept()
            except OSError:
                return
            threading.Thread(target=self._serve, args=(client,), daemon=True).start()

    def _serve(self, client):
        with client, socket.create_connection(("127.0.0.1", self.server_port)) as server:
            requests = threading.Thread(target=self._pass, args=("request", client, server), daemon=True)
            requests.start()
            self._pass("answer", server, client)
            requests.join()

    def _pass(self, kind, source, target):
        while data := source.recv(65536):
            self.traffic.append((kind, data))
            target.sendall(data)
        target.shutdown(socket.SHUT_WR)

    def close(self):
        self.listener.close()


def as_bytes(registers):
    return struct.pack(f">{len(registers)}H", *registers)


def near(served, printed, step):
    """Equal to a step of the served integer."""
    return abs(served - printed) <= 0.5001 * step


def tilt_agrees(block, printed):
    """Unit 3: numbers low byte first (manual 000, 10.3)."""
    sensors = struct.iter_unpack("<hhhH", as_bytes(block)[4:])
    return all(
        near(x, 1000 * printed[n]["tiltX"] / ARC_SECONDS_PER_DEGREE, 1)
        and near(y, 1000 * printed[n]["tiltY"] / ARC_SECONDS_PER_DEGREE, 1)
        and near(t, 100 * printed[n].get("temperature", 0), 1) and status == printed[n]["status"]
        for n, (x, y, t, status) in zip(TILT_NUMBERS, sensors, strict=True))


def acceleration_agrees(block, printed):
    """Unit 6 (manual 000, 10.4)."""
    sensors = struct.iter_unpack("<hhHHH", as_bytes(block)[4:])
    return all(
        near(maximum, 100 * printed[n]["accelMax"], 1)
        and near((direction - 10 * printed[n]["accelDirection"] + 1800) % 3600, 1800, 1)
        and near(x, 100 * printed[n]["accelRmsX"], 1) and near(y, 100 * printed[n]["accelRmsY"], 1)
        and status == printed[n]["status"]
        for n, (maximum, direction, x, y, status) in zip(ACCELERATION_NUMBERS, sensors, strict=True))


def extended_agrees(block, number, printed):
    """One sensor of unit 1: numbers high byte first."""
    data = as_bytes(block)
    served = {name: struct.unpack_from(">f", data, 2 * at)[0] for name, at in FLOATS.items()}
    n, _, address, _, _, status = struct.unpack_from(">IHHHHH", data, 0)
    moment = datetime.datetime.fromisoformat(printed["time"].replace("Z", "+00:00")).timestamp()
    return (n == number and address == printed["address"] and status == printed["status"]
            and struct.unpack_from(">Q", data, 24)[0] == round(1000 * moment)
            and all(math.isnan(value) if name not in printed
                    else math.isclose(value, printed[name], rel_tol=1e-6, abs_tol=1e-6)
                    for name, value in served.items()))


def disagreements(answers, printed):
    tilt, acceleration, *rest = answers
    slots, errors = rest[:-len(EXCEPTIONS)], rest[-len(EXCEPTIONS):]
    found = [] if tilt_agrees(tilt, printed) else [f"unit 3: {tilt}"]
    found += [] if acceleration_agrees(acceleration, printed) else [f"unit 6: {acceleration}"]
    for slot, block in enumerate(slots):
        number = TILT_NUMBERS[slot % 8]
        if not extended_agrees(block, number, printed[number]):
            found.append(f"unit 1, function {3 + slot // 8}, sensor {number}: {block}")
    return found + ([] if errors == EXCEPTIONS else [f"exceptions: {errors}"])


class ForeignClients:
    """Mixed into a TestCase: one site for all clients of a file."""

    @classmethod
    def setUpClass(cls):
        port = free_port()
        # Seldom polled: a program of many requests has to find a moment between two readings.
        cls.site = Site(annex(IPPort1=port, TmRun=3000))
        cls.addClassCleanup(cls.site.__exit__)
        cls.site.start()
        cls.relay = Relay(port)
        cls.addClassCleanup(cls.relay.close)
        cls.site.wait_for(
            lambda last: set(last) == set(TILT_NUMBERS) and all("accelMax" in last[n] for n in ACCELERATION_NUMBERS),
            seconds=180)

    def check(self, *command, **environment):
        """The client agrees with the readings that were current all the while."""
        for _ in range(20):
            self.relay.traffic.clear()
            before = self.site.last_readings()
            client = subprocess.run(
                [*command, str(self.relay.port), *WANTED], capture_output=True, text=True, timeout=60,
                env=os.environ | environment)
            self.assertEqual(client.returncode, 0, client.stderr)
            answers = json.loads(client.stdout)
            self.assertEqual(len(answers), len(WANTED))
            problems = disagreements(answers, before)
            if not problems or before == self.site.last_readings():
                break
        self.assertEqual(problems, [], before)
        self.assertEqual(len(self.relay.traffic), 2 * len(WANTED))
        decoded = analysed(self.relay.traffic)
        self.assertEqual(decoded.count("Modbus/TCP"), len(self.relay.traffic), decoded[-3000:])
        self.assertNotIn("Malformed", decoded)
