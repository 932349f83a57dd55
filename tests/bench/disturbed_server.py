#!/usr/bin/env python3
"""What Modbus clients that misbehave cost the rest of the program: polling, saving, and the answers to another client.

Usage: GORIZONT_BIN=build/release/bin GORIZONT_TEST_DATA=tests/data python3 tests/bench/disturbed_server.py [SECONDS]
Prints figures and ratios, judges nothing. The program runs on the simulated sensors of its demonstration. Phases of SECONDS
alternate: quiet, disturbed in one way, quiet, disturbed in the next way. Those who disturb, and the other client who asks
a hundred times a second, are processes of their own.
"""
import os
import pathlib
import random
import re
import selectors
import socket
import statistics
import struct
import subprocess
import sys
import threading
import time

from lost_port import seconds
from site_under_test import ModbusClient, Site, free_port

DEMO = pathlib.Path(__file__).parent.parent.parent / "resources" / "demo.ini"
POLLING = 0.5
SAVING = 1.0
PROBE_PERIOD = 0.01
CONNECTIONS = 8
REQUEST = struct.pack(">HHHBBHH", 1, 0, 6, 1, 4, 3000, 125)  # unit 1 costs the server most: it holds clocks


def ini(port):
    text = DEMO.read_bytes().decode("utf-8-sig")
    changes = {"IPPort1": port, "IPPort2": free_port(), "TmRun": int(1000 * POLLING), "TmSave": int(1000 * SAVING)}
    for key, value in changes.items():
        text, count = re.subn(rf"(?m)^{key}=.*$", f"{key}={value}", text, count=1)
        assert count == 1, key
    return text


class Hooligan:
    """Several connections that are made again as soon as the server ends them."""

    def __init__(self, port):
        self.port = port
        self.selector = selectors.DefaultSelector()
        for _ in range(CONNECTIONS):
            self.connect()

    def connect(self):
        try:
            client = socket.create_connection(("127.0.0.1", self.port), timeout=10)
        except OSError:
            time.sleep(0.01)
            return self.connect()
        client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))  # uses up no ports
        client.setblocking(False)
        self.selector.register(client, selectors.EVENT_READ | selectors.EVENT_WRITE)

    def run(self):
        while True:
            for key, events in self.selector.select():
                try:
                    self.turn(key.fileobj, events)
                except BlockingIOError:
                    pass
                except OSError:
                    self.selector.unregister(key.fileobj)
                    key.fileobj.close()
                    self.connect()


class Flooding(Hooligan):
    """Sends requests as fast as the system takes them, and takes the answers."""

    requests = 256 * REQUEST
    rest = {}

    def turn(self, client, events):
        if events & selectors.EVENT_READ and not client.recv(1 << 20):
            raise ConnectionResetError
        if events & selectors.EVENT_WRITE:
            sent = self.rest.get(client, 0) + client.send(self.requests[self.rest.get(client, 0):])
            self.rest[client] = sent % len(self.requests)


class NeverReading(Hooligan):
    """As the flood, but takes no answer."""

    requests = 256 * REQUEST
    rest = {}

    def turn(self, client, events):
        if not events & selectors.EVENT_WRITE:
            client.recv(1, socket.MSG_PEEK)  # the connection may be over
            time.sleep(0.001)
            return
        sent = self.rest.get(client, 0) + client.send(self.requests[self.rest.get(client, 0):])
        self.rest[client] = sent % len(self.requests)


class Garbage(Hooligan):
    """Half of it is noise, half has the right length and is nonsense."""

    def turn(self, client, events):
        if events & selectors.EVENT_READ and not client.recv(1 << 20):
            raise ConnectionResetError
        if events & selectors.EVENT_WRITE:
            body = random.randbytes(random.randrange(1, 250))
            head = struct.pack(">HHHB", 1, 0, 1 + len(body), random.choice((1, 3, 6, 77)))
            client.send(random.choice((head + body, body)))


DISTURBANCES = {"flood": Flooding, "never reads": NeverReading, "garbage": Garbage}


def probe(port, duration):
    """Prints the latencies of a client that asks quietly, ms."""
    client = ModbusClient(port)
    end = time.perf_counter() + duration
    following = time.perf_counter()
    while following < end:
        time.sleep(max(0, following - time.perf_counter()))
        following += PROBE_PERIOD
        begin = time.perf_counter()
        client.read(3, 0, 26)
        print(1000 * (time.perf_counter() - begin))


class Saves(threading.Thread):
    """When a record came to the file of measurements."""

    def __init__(self, site):
        super().__init__(daemon=True)
        self.site = site
        self.times = []

    def run(self):
        size = 0
        while True:
            now = sum(path.stat().st_size for path in self.site.history.glob("*_data.txt"))
            if now > size:
                self.times.append(time.time())
            size = now
            time.sleep(0.005)


def differences(times, begin, end):
    chosen = [t for t in times if begin <= t < end]
    return [b - a for a, b in zip(chosen, chosen[1:])]


def polling_periods(readings, begin, end):
    found = []
    for number in {reading["number"] for reading in readings}:
        found += differences([seconds(r) for r in readings if r["number"] == number], begin, end)
    return found


def phase(site, saves, port, disturbance, duration):
    """Mean and largest polling period, mean and largest saving period, latencies of the other client."""
    self = [sys.executable, __file__]
    hooligan = subprocess.Popen([*self, "--disturb", disturbance, str(port)]) if disturbance else None
    time.sleep(1)
    cpu = site.server.cpu_seconds()
    begin = time.time()
    asked = subprocess.run([*self, "--probe", str(port), str(duration)], stdout=subprocess.PIPE, text=True, check=True)
    end = time.time()
    cpu = (site.server.cpu_seconds() - cpu) / (end - begin)
    if hooligan:
        assert hooligan.poll() is None, f"{disturbance} ended"
        hooligan.kill()
        hooligan.wait()
    latencies = sorted(map(float, asked.stdout.split()))
    return {"polling": polling_periods(site.readings(), begin, end), "saving": differences(saves.times, begin, end),
            "latencies": latencies, "cpu": cpu}


def measure(duration):
    port = free_port()
    phases = []
    with Site(ini(port), faults=None) as site:
        site.start()
        site.wait_for(lambda last: len(last) == 10, what="all sensors")
        saves = Saves(site)
        saves.start()
        for name in DISTURBANCES:
            phases += [("quiet", phase(site, saves, port, None, duration)),
                       (name, phase(site, saves, port, name, duration))]
        assert site.server.stop() == 0
    return phases


def merged(phases, name):
    chosen = [figures for n, figures in phases if n == name]
    return {key: sum((f[key] for f in chosen), []) for key in ("polling", "saving", "latencies")} | {
        "cpu": statistics.mean(f["cpu"] for f in chosen)}


def main():
    phases = measure(float(sys.argv[1]) if len(sys.argv) > 1 else 20)
    quiet = merged(phases, "quiet")
    print(f"load of this machine in the last minute: {os.getloadavg()[0]:.1f} of {os.cpu_count()} cores")
    print(f"{'':12} {'polling s':>10} {'ratio':>7} {'longest':>8} {'saving s':>9} {'ratio':>7} {'longest':>8}"
          f" {'p50 ms':>7} {'p99 ms':>7} {'max ms':>7} {'cores':>6}")
    for name in ("quiet", *DISTURBANCES):
        figures = merged(phases, name)
        cells = []
        for kind in ("polling", "saving"):
            mean = statistics.mean(figures[kind])
            cells += [mean, mean / statistics.mean(quiet[kind]), max(figures[kind])]
        latencies = sorted(figures["latencies"])
        cells += [latencies[len(latencies) * share // 100] for share in (50, 99)] + [latencies[-1], figures["cpu"]]
        print("{:12} {:10.4f} {:7.4f} {:8.3f} {:9.4f} {:7.4f} {:8.3f} {:7.2f} {:7.2f} {:7.1f} {:6.2f}".format(
            name, *cells))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--disturb"]:
        DISTURBANCES[sys.argv[2]](int(sys.argv[3])).run()
    elif sys.argv[1:2] == ["--probe"]:
        probe(int(sys.argv[2]), float(sys.argv[3]))
    else:
        main()
