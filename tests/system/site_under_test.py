"""What the system tests share: a site of simulated sensors on ptys, the program that watches it, and a Modbus client.

The client is written from the Modbus specification and manual 000, section 10, without a look at the server.
"""
import contextlib
import json
import os
import pathlib
import queue
import re
import signal
import socket
import struct
import subprocess
import tempfile
import threading
import time

PROGRAMS = pathlib.Path(os.environ["GORIZONT_BIN"])
DATA = pathlib.Path(os.environ["GORIZONT_TEST_DATA"])
ARC_SECONDS_PER_DEGREE = 3600


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def annex(**changes):
    """The ini of the manual's annex, as it is but for `key=value` of some keys (the first of that name).

    The port of ADC24 is a free one, so that tests can run side by side.
    """
    changes.setdefault("IPPort2", free_port())
    text = (DATA / "config" / "annex-utf8.ini").read_bytes().decode("utf-8-sig")
    for key, value in changes.items():
        text, count = re.subn(rf"(?m)^{key}=.*?(\r?)$", rf"{key}={value}\1", text, count=1)
        assert count == 1, key
    return text


class Program:
    """A running process whose lines on stdout are collected as they come."""

    def __init__(self, name, *arguments, folder=None):
        command = [str(PROGRAMS / name), *map(str, arguments)]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=folder)
        self.lines = []
        self.errors = []
        self._news = queue.Queue()
        self._readers = [
            threading.Thread(target=self._collect, args=(self.process.stdout, self.lines), daemon=True),
            threading.Thread(target=self._collect, args=(self.process.stderr, self.errors), daemon=True)]
        for reader in self._readers:
            reader.start()

    def _collect(self, stream, lines):
        for line in stream:
            lines.append(line.decode("utf-8").rstrip("\n"))
            self._news.put(None)

    def wait_until(self, condition, seconds=60, what="condition"):
        deadline = time.monotonic() + seconds
        while not condition():
            left = deadline - time.monotonic()
            ended = self.process.poll()
            said = "\n".join(self.errors[-20:])
            assert left > 0, f"{what} not reached in {seconds} s\n{said}"
            assert ended is None or condition(), f"ended with {ended} before {what}\n{said}"
            with contextlib.suppress(queue.Empty):
                self._news.get(timeout=min(left, 0.2))

    def stop(self, number=signal.SIGTERM, seconds=30):
        """Sends the signal; returns the exit code."""
        if self.process.poll() is None:
            self.process.send_signal(number)
        code = self.process.wait(seconds)
        for reader, stream in zip(self._readers, (self.process.stdout, self.process.stderr)):
            reader.join(5)
            stream.close()
        return code

    def cpu_seconds(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Site(contextlib.AbstractContextManager):
    """A folder with an ini, its simulated sensors, and the program on request. Everything ends with the `with` block."""

    def __init__(self, ini_text, faults=()):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self.ini = self.folder / "GorizontServer.ini"
        self.ini.write_bytes(ini_text.encode("utf-8") if isinstance(ini_text, str) else ini_text)
        self.ports = self.folder / "ports"
        self.history = self.folder / "History"
        self.simulator = None
        self.server = None
        if faults is not None:
            options = [o for fault in faults for o in ("--fault", fault)]
            self.simulator = Program("gorizont-simulator", "--config", self.ini, "--ports", self.ports, *options)
            self.simulator.wait_until(lambda: "ready" in self.simulator.lines, what="simulator")

    def start(self, *options):
        self.server = Program(
            "gorizont-server", "--config", self.ini, "--ports", self.ports, "--headless", "--print-readings", *options)
        return self.server

    def readings(self):
        return [json.loads(line) for line in self.server.lines if line.startswith("{")]

    def last_readings(self):
        """Site number → its last reading."""
        return {reading["number"]: reading for reading in self.readings()}

    def wait_for(self, condition, seconds=60, what="readings"):
        self.server.wait_until(lambda: condition(self.last_readings()), seconds, what)

    def file_text(self, kind):
        return "".join(p.read_bytes().decode("utf-8") for p in sorted(self.history.glob(f"*_{kind}.txt")))

    def __exit__(self, *_):
        for program in (self.server, self.simulator):
            if program and program.process.poll() is None:
                program.stop(signal.SIGKILL)
        self._folder.cleanup()


class ModbusError(Exception):
    pass


class ModbusClient:
    """Functions 03 and 04 over TCP; keeps the bytes of all it sent and received for a protocol analyser."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=10)
        self.transaction = 0
        self.traffic = []

    def read(self, unit, start, count, function=4):
        self.transaction += 1
        request = struct.pack(">HHHBBHH", self.transaction, 0, 6, unit, function, start, count)
        self.traffic.append(("request", request))
        self.socket.sendall(request)
        header = self._exactly(7)
        transaction, protocol, length, answered_unit = struct.unpack(">HHHB", header)
        body = self._exactly(length - 1)
        self.traffic.append(("answer", header + body))
        assert (transaction, protocol, answered_unit) == (self.transaction, 0, unit)
        if body[0] & 0x80:
            raise ModbusError(body[1])
        assert body[0] == function and body[1] == 2 * count and len(body) == 2 + 2 * count
        return body[2:]

    def _exactly(self, count):
        data = b""
        while len(data) < count:
            more = self.socket.recv(count - len(data))
            assert more, "the server closed the connection"
            data += more
        return data

    def close(self):
        self.socket.close()


class Adc24Client:
    """Written from spec/gorizont.md, section 7, without a look at the server."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=10)

    def available(self):
        address, command, samples = struct.unpack("<BBI", self._ask(1, 0, 0, 6))
        assert (address, command) == (1, 1)
        return samples

    def block(self, number, size):
        """The samples of a block; None when there is no such block."""
        answer = self._ask(3, number, size, 8)
        assert answer[:2] == b"\x01\x03"
        if answer[2] != 2:
            assert answer[4:] == bytes(4)
            return None
        element, status, count, scale, rate = struct.unpack("<BBIdd", answer[2:] + self._exactly(16))
        assert (element, count, scale, rate) == (2, size, 1 / 8, 10.0), (element, status, count, scale, rate)
        return list(struct.unpack(f"<{count}h", self._exactly(2 * count)))

    def samples(self, size):
        """All whole blocks there are."""
        found = []
        for number in range(self.available() // size):
            found += self.block(number, size)
        return found

    def _ask(self, command, block, size, length):
        self.socket.sendall(struct.pack("<BBBBBII", 1, command, 0, 0, 0, block, size))
        return self._exactly(length)

    def _exactly(self, count):
        data = b""
        while len(data) < count:
            more = self.socket.recv(count - len(data))
            assert more, "the server closed the connection"
            data += more
        return data

    def close(self):
        self.socket.close()


def read_tilt(client, sensors):
    """Channel word and a list of (x°, y°, t°C, status) from unit 3: all numbers low byte first (manual 000, 10.3)."""
    data = client.read(3, 0, (4 + 8 * sensors) // 2)
    values = struct.iter_unpack("<hhhH", data[4:])
    return struct.unpack("<I", data[:4])[0], [(x / 1000, y / 1000, t / 100, s) for x, y, t, s in values]


def read_acceleration(client, sensors):
    """Channel word and a list of (maximum, direction, rms x, rms y, status) from unit 6 (manual 000, 10.4)."""
    data = client.read(6, 0, (4 + 10 * sensors) // 2)
    values = struct.iter_unpack("<hhHHH", data[4:])
    return struct.unpack("<I", data[:4])[0], [(m / 100, d / 10, x / 100, y / 100, s) for m, d, x, y, s in values]


def analysed(traffic):
    """What a protocol analyser says of ("request" | "answer", bytes) in their order, as text."""
    with tempfile.TemporaryDirectory() as folder:
        capture = pathlib.Path(folder) / "capture"
        capture.with_suffix(".txt").write_text("".join(
            ("O " if kind == "request" else "I ") + "000000 " + data.hex(" ") + "\n" for kind, data in traffic))
        subprocess.run(["text2pcap", "-q", "-D", "-T", "40000,502", capture.with_suffix(".txt"),
                        capture.with_suffix(".pcap")], check=True, capture_output=True, timeout=60)
        return subprocess.run(
            ["tshark", "-r", capture.with_suffix(".pcap"), "-V"], capture_output=True, text=True, timeout=120,
            check=True).stdout
