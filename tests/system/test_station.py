"""gorizont-station on a pty and on TCP, read by a client that packs and unpacks with struct, and polled by gorizont-server."""
import contextlib
import os
import pathlib
import pty
import re
import signal
import socket
import struct
import sys
import tempfile
import time
import tty
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from site_under_test import PROGRAMS, Program, free_port  # noqa: E402

EXAMPLE = pathlib.Path(__file__).parents[2] / "resources" / "station"
VALUES = {1: 1, 2: 2, 3: 3, 4: 4, 5: 5, 6: 6, 7: 3, 8: 1}


def header(address, command, length, digital):
    data = struct.pack("<BBBBI", 0xBB, address, command, length, digital)
    return data + bytes([-sum(data) & 0xFF])


def file_frame(address, name, text):
    block = name + text
    return header(address, 0xFF, len(name), len(text)) + block + bytes([-sum(block) & 0xFF])


def parse(answer, command):
    """Address, digital inputs, parameters as lists of values (None: no value), extras, times."""
    assert len(answer) >= 9 and sum(answer[:9]) & 0xFF == 0 and answer[0] == 0xBB and answer[2] == 0, answer.hex(" ")
    address, count, digital = answer[1], answer[3], struct.unpack("<I", answer[4:8])[0]
    block = answer[9:]
    if count == 0:
        assert not block, answer.hex(" ")
        return address, digital, [], [], []
    assert sum(block) & 0xFF == 0, answer.hex(" ")
    each = VALUES[command]
    size = count * each * 4 + (52 if command == 8 else 0) + 1
    assert len(block) == size, (len(block), size)
    words = [block[i:i + 4] for i in range(0, size - 1, 4)]
    floats = [None if word == b"\xff\xff\xff\xff" else struct.unpack("<f", word)[0] for word in words[:count * each]]
    extras, times = [], []
    if command == 8:
        rest = words[count * each:]
        extras = [None if word == b"\xff\xff\xff\xff" else struct.unpack("<f", word)[0] for word in rest[:3]]
        times = [struct.unpack("<i", word)[0] for word in rest[3:]]
    return address, digital, [floats[i:i + each] for i in range(0, len(floats), each)], extras, times


class TcpClient(contextlib.AbstractContextManager):
    def __init__(self, port):
        self._socket = socket.create_connection(("127.0.0.1", port), timeout=5)

    def ask(self, request, seconds=1.0):
        """All that comes until `seconds` pass, or 0.3 s after the first bytes."""
        self._socket.sendall(request)
        return self._collect(lambda: self._socket.recv(65536), seconds)

    def _collect(self, read, seconds):
        received = b""
        deadline = time.monotonic() + seconds
        self._socket.settimeout(0.05)
        while time.monotonic() < deadline:
            with contextlib.suppress(TimeoutError):
                part = read()
                if not part:
                    break
                if not received:
                    deadline = time.monotonic() + 0.3
                received += part
        return received

    def __exit__(self, *_):
        self._socket.close()


class Tty:
    """A pty that the station opens as COMn; this is the dispatcher's end."""

    def __init__(self, folder, number):
        self.master, self.slave = pty.openpty()
        tty.setraw(self.master)
        tty.setraw(self.slave)
        os.set_blocking(self.master, False)
        self.link = folder / f"COM{number}"
        self.link.symlink_to(os.ttyname(self.slave))

    def ask(self, request, seconds=2.0):
        os.write(self.master, request)
        received = b""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            try:
                received += os.read(self.master, 65536)
                deadline = min(deadline, time.monotonic() + 0.3)
            except BlockingIOError:
                time.sleep(0.02)
        return received

    def vanish(self):
        self.link.unlink()
        os.close(self.master)
        os.close(self.slave)


class StationFolder(contextlib.AbstractContextManager):
    """The example of the sources, with the changes that a test needs."""

    def __init__(self, ini="", **files):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self.config = self.folder / "station"
        self.config.mkdir()
        self.ports = self.folder / "ports"
        self.ports.mkdir()
        for source in EXAMPLE.iterdir():
            if source.is_file():
                (self.config / source.name).write_bytes(source.read_bytes())
        (self.config / "ACK.INI").write_text("1 1 x\n1 0 a\n" + ini, encoding="utf-8")
        # Means after one good value, so that a test need not wait.
        settings = (self.config / "ACK.PSE").read_text(encoding="utf-8").splitlines()
        settings[28] = "0 percent"
        (self.config / "ACK.PSE").write_text("\n".join(settings) + "\n", encoding="utf-8")
        for name, text in files.items():
            (self.config / name.replace("_", ".")).write_text(text, encoding="utf-8")
        self.program = None
        self.port = free_port()

    def start(self, *options):
        self.program = Program(
            "gorizont-station", "--config", self.config, "--ports", self.ports, "--listen", self.port, "--lang", "en",
            "--print", *options)
        self.program.wait_until(lambda: len(self.program.lines) >= 3, what="three seconds of values")
        return self.program

    def __exit__(self, *_):
        if self.program:
            self.program.stop()
        self._folder.cleanup()


class Answers(unittest.TestCase):
    def test_all_commands_on_tcp_and_on_a_tty(self):
        with StationFolder("1 0 q1 9600 8 1 0\n") as station:
            line = Tty(station.ports, 1)
            station.start()
            with TcpClient(station.port) as client:
                for ask in (client.ask, line.ask):
                    for command in range(1, 9):
                        address, _, parameters, extras, times = parse(ask(header(1, command, 0, 0)), command)
                        self.assertEqual(address, 1)
                        self.assertEqual(len(parameters), 6)
                        supply, temperature, pressure, humidity, direction, speed = (p[0] for p in parameters)
                        self.assertAlmostEqual(supply, 12.6, delta=0.3)
                        self.assertTrue(-60 < temperature < 60 and 600 < pressure < 800 and 0 < humidity < 100)
                        self.assertTrue(200 < direction < 240, direction)
                        self.assertTrue(3.9 < speed < 8.1, speed)
                        if command == 8:
                            self.assertEqual((len(extras), len(times)), (3, 10))
                # Not to others, not to nonsense.
                self.assertEqual(client.ask(header(2, 1, 0, 0), 0.5), b"")
                self.assertEqual(client.ask(header(1, 9, 0, 0), 0.5), b"")
                damaged = bytearray(header(1, 1, 0, 0))
                damaged[5] ^= 1
                self.assertEqual(client.ask(bytes(damaged), 0.5), b"")
                parse(client.ask(b"\xbb\x00\xbb" + header(1, 1, 0, 0)), 1)
            line.vanish()

    def test_lost_tty_comes_back_and_nothing_spins(self):
        with StationFolder("1 0 q1 9600 8 1 0\n") as station:
            line = Tty(station.ports, 1)
            program = station.start()
            parse(line.ask(header(1, 1, 0, 0)), 1)
            line.vanish()
            program.wait_until(lambda: any("is closed for dispatchers" in e for e in program.errors), 10, "the loss")
            before = program.cpu_seconds()
            time.sleep(3)
            self.assertLess(program.cpu_seconds() - before, 1.0)
            line = Tty(station.ports, 1)
            opened = sum("open for dispatchers" in e for e in program.errors)
            program.wait_until(
                lambda: sum("open for dispatchers" in e for e in program.errors) > opened, 20, "the return")
            parse(line.ask(header(1, 1, 0, 0)), 1)
            line.vanish()

    def test_file_and_time(self):
        with StationFolder() as station:
            program = station.start()
            with TcpClient(station.port) as client:
                confirmation = client.ask(header(1, 0xFF, 0, 1_000_000_000))
                self.assertEqual(confirmation[:4], b"\xbb\x01\x00\x00")
                seen = len(program.lines)
                program.wait_until(lambda: any('"2001-09-09T01:' in line for line in program.lines[seen:]), 10, "its time")
                self.assertEqual(client.ask(file_frame(1, b"../ACK.PAR", b"x"), 0.5), b"")
                self.assertEqual(client.ask(file_frame(1, b"ACK.SRC", b"x"), 0.5), b"")
                self.assertEqual(client.ask(file_frame(2, b"ACK.PAR", header(1, 1, 0, 0)), 0.5), b"")
                parameters = 'Supply V s U 1 A 5 %4.1f 10 15 - 0 1\n'.encode()
                answer = client.ask(file_frame(1, b"ACK.PAR", parameters))
                self.assertEqual((len(answer), answer[:4]), (9, b"\xbb\x01\x00\x00"))
                deadline = time.monotonic() + 20
                while time.monotonic() < deadline:
                    if len(parse(client.ask(header(1, 1, 0, 0)), 1)[2]) == 1:
                        break
                else:
                    self.fail("the new ACK.PAR is not in force")
            self.assertEqual((station.config / "ACK.PAR").read_bytes(), parameters)
            self.assertTrue((station.config / "ACK.PAR.bak").exists())


class TheProgram(unittest.TestCase):
    def test_records_log_and_end(self):
        with StationFolder() as station:
            data = station.folder / "data"
            program = station.start("--data", str(data))
            program.wait_until(lambda: len(program.lines) >= 5)
            self.assertEqual(program.stop(), 0)
            records = list(data.glob("????_??_obj001.txt"))
            self.assertEqual(len(records), 1)
            lines = records[0].read_text(encoding="utf-8").splitlines()
            self.assertTrue(lines[0].startswith(";time\tU01\tU01 min\tU01 max\tT01"), lines[0])
            self.assertGreaterEqual(len(lines), 4)
            for line in lines[1:]:
                self.assertRegex(line, r"^\d{4}-\d\d-\d\d \d\d:\d\d:\d\d(\t-?[\d.]+|\t-){18}\t[0-9a-f]{8}$")
            log = list(data.glob("????_??_log.txt"))
            self.assertEqual(len(log), 1)
            self.assertIn("Station 1 ended", log[0].read_text(encoding="utf-8"))

    def test_killed_and_started_again(self):
        with StationFolder() as station:
            station.start()
            station.program.stop(signal.SIGKILL)
            station.start()
            station.program.stop()
            text = next(station.config.glob("????_??_obj001.txt")).read_text(encoding="utf-8")
            self.assertTrue(text.endswith("\n"))
            self.assertEqual(text.count(";time"), 1)

    def test_second_copy_is_refused(self):
        with StationFolder() as station:
            station.start()
            second = Program("gorizont-station", "--config", station.config, "--lang", "en")
            self.assertEqual(second.process.wait(20), 3)
            second.stop()
            self.assertTrue(any("already works" in line for line in second.errors), second.errors)

    def test_usage(self):
        for arguments, code in (((), 2), (("--config", "/there/is/nothing"), 1), (("--config", ".", "--listen", "door"), 2),
                                (("--help",), 0), (("--version",), 0)):
            program = Program("gorizont-station", *arguments)
            program.process.wait(20)
            self.assertEqual(program.stop(), code, arguments)

    def test_hangup_reads_the_files_again(self):
        with StationFolder() as station:
            program = station.start()
            (station.config / "ACK.PAR").write_text("Supply V s U 1 A 5 %4.1f 10 15 - 0 1\nbroken\n", encoding="utf-8")
            program.process.send_signal(signal.SIGHUP)
            program.wait_until(lambda: any("ACK.PAR, line 2" in line for line in program.errors), 10, "the complaint")
            seen = len(program.lines)
            program.wait_until(lambda: any('"code":"T"' not in line for line in program.lines[seen:]), 10, "new parameters")

    def test_gathers_another_station(self):
        with StationFolder() as other:
            (other.config / "ACK.PSE").write_text(
                (other.config / "ACK.PSE").read_text(encoding="utf-8").replace("1 ", "5 ", 1), encoding="utf-8")
            (other.config / "ACK.INI").write_text("5 1 x\n5 0 a\n", encoding="utf-8")
            other.start()
            parameters = (EXAMPLE / "ACK.PAR").read_text(encoding="utf-8") + 'Far C s T 2 A 60 %6.2f - - - 0 1\n'
            ini = f'5 1 q:tcp://127.0.0.1:{other.port} 9600 8 1 0 4:-,T02\n'
            with StationFolder(ini, ACK_PAR=parameters) as station:
                station.start()
                with TcpClient(station.port) as client:
                    deadline = time.monotonic() + 20
                    while time.monotonic() < deadline:
                        values = parse(client.ask(header(1, 2, 0, 0)), 2)[2]
                        if len(values) == 7 and values[6][0] is not None:
                            break
                    else:
                        self.fail("the other station's temperature does not come")
                    self.assertAlmostEqual(values[6][0], values[1][0], delta=2)  # both simulate the same day
                    own = parse(client.ask(header(5, 4, 0, 0)), 4)
                    self.assertEqual((own[0], len(own[2])), (5, 6))
                text = ""
                deadline = time.monotonic() + 10
                while time.monotonic() < deadline and not text:
                    text = "".join(p.read_text(encoding="utf-8") for p in station.config.glob("????_??_obj005.txt"))
                    time.sleep(0.2)
                self.assertIn("T02", text)


class MainProgram(unittest.TestCase):
    """gorizont-server polls the station with its ordinary driver: over TCP, and as a station of its own process."""

    def poll(self, device, folder, has_records=lambda: True):
        ini = folder / "GorizontServer.ini"
        ini.write_text(
            f"[Common]\nNumOfPorts=1\nCanModbus=0\nCanADC24=0\n[Port1]\nOn=1\nDevice={device}\nNumOfSensors=1\n"
            "Name1=МК-14\nN1=1\nOn1=1\nadr1=1\n", encoding="utf-8")
        server = Program("gorizont-server", "--config", ini, "--headless", "--print-readings", "--lang", "en")
        try:
            server.wait_until(
                lambda: any(re.search(r'"code":"M"[^}]*"mean":[3-8]\.', line) for line in server.lines), 60, "the wind")
            server.wait_until(has_records, 20, "records of a period")
        finally:
            code = server.stop()
        self.assertEqual(code, 0, server.errors[-5:])

    def test_over_tcp(self):
        with StationFolder() as station:
            station.start()
            self.poll(f"tcp://127.0.0.1:{station.port}", station.folder)

    def test_in_the_same_process(self):
        with StationFolder() as station:
            self.poll("station:station", station.folder, lambda: list(station.config.glob("????_??_obj001.txt")))


if __name__ == "__main__":
    assert (PROGRAMS / "gorizont-station").exists()
    unittest.main(verbosity=2)
