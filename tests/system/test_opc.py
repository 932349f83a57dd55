"""The feed for the gateways of OPC DA: tags, values, qualities and times of a whole site, as a plain client reads them."""
import datetime
import hashlib
import json
import os
import pathlib
import socket
import subprocess
import time
import unittest
import unittest.mock

from site_under_test import PROGRAMS, ModbusClient, Site, annex, free_port, read_tilt

GOOD, LAST_KNOWN, COMM_FAILURE, OUT_OF_SERVICE, WAITING, NOT_CONNECTED = 192, 20, 24, 28, 32, 8
STATE = ["Restart", "ReadyAngl", "ReadyTmp", "ReadErr", "CRCErr", "RangdErr", "TReadErr", "TRangErr"]
AND3 = ["Angl_X", "Angl_Y", "AMax_X", "AMax_Y", "ARms_X", "ARms_Y", "Temper", "8_Reserv"]
IND3 = ["Angl_X", "Angl_Y", "3_Reserv", "4_Reserv", "5_Reserv", "6_Reserv", "7_Reserv", "8_Reserv"]


class Gateway:
    """A client of the feed, written from the agreed protocol without a look at the server."""

    def __init__(self, port, registered=""):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=30)
        self.file = self.socket.makefile("rb")
        greeting = {"client": "gorizont-opc-da", "version": "0", "pid": 1, "registered": registered}
        self.socket.sendall(json.dumps(greeting).encode() + b"\n")
        self.tags = []
        self.values = {}
        self.hello = self.next()
        assert self.hello["hello"] == "GorizontServer" and self.hello["protocol"] == 1, self.hello
        while "ready" not in (line := self.next()):
            assert set(line) == {"tags"} and 1 <= len(line["tags"]) <= 200, line
            self.tags += line["tags"]
        self.names = [tag["name"] for tag in self.tags]
        while len(self.values) < len(self.tags):
            self.take(self.next())

    def next(self):
        line = self.file.readline()
        assert line.endswith(b"\n"), "the feed ended"
        return json.loads(line)

    def take(self, line):
        for index, value, quality, ms in line.get("v", ()):
            self.values[self.names[index]] = (value, quality, ms)
        return line

    def wait(self, condition, seconds=60):
        deadline = time.monotonic() + seconds
        while not condition(self.values):
            assert time.monotonic() < deadline, "not reached"
            self.take(self.next())

    def close(self):
        self.file.close()
        self.socket.close()



def milliseconds(iso):
    return round(datetime.datetime.fromisoformat(iso.replace("Z", "+00:00")).timestamp() * 1000)


class Opc(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.port = free_port()
        cls.modbus_port = free_port()
        text = annex(IPPort1=cls.modbus_port, TmRun=200, TORCom=500, SCRCErrors=10)
        text = text.replace("[Common]", "[Common]\r\nCanOPCDA=1", 1) + f"\r\n[OPC]\r\nPort={cls.port}\r\n"
        cls.site = Site(text, faults=["silent=3"])
        cls.addClassCleanup(cls.site.__exit__)
        cls.site.start("--lang", "en")
        cls.site.wait_for(
            lambda last: last.get(3, {}).get("status") == 0x3700 and last.get(1, {}).get("status") == 0x0100)

    def gateway(self):
        gateway = Gateway(self.port)
        self.addCleanup(gateway.close)
        return gateway

    def prefix(self, gateway, number):
        return gateway.names[[f".Sensor_{number:03d}[" in n for n in gateway.names].index(True)].rsplit(".", 2)[0] + "."

    def test_tags_are_those_of_the_figure(self):
        gateway = self.gateway()
        self.assertEqual(gateway.hello["count"], len(gateway.tags))
        self.assertEqual(gateway.hello["caption"], "Gorizont Server")
        text = "".join(f"{tag['name']}\t{tag['type']}\n" for tag in gateway.tags)
        self.assertEqual(hashlib.sha256(text.encode()).hexdigest(), gateway.hello["hash"])
        self.assertEqual(len(set(gateway.names)), len(gateway.names))
        for number, reading in self.site.last_readings().items():
            start = (f"[{reading['port']}].Sensor_{number:03d}[{reading['type'].replace('-', '')}]"
                     f"[Addr:{reading['address']:03d}].")
            data = AND3 if reading["type"] == "AN-D3" else IND3
            expected = [(start + "STATE." + leaf, "bool") for leaf in STATE]
            expected += [(start + "DATA." + leaf, "double") for leaf in data]
            mine = [(t["name"], t["type"]) for t in gateway.tags if t["name"].startswith(start)]
            self.assertEqual(mine, expected)
        aliases = [alias for tag in gateway.tags for alias in tag.get("aliases", ())]
        self.assertIn(self.prefix(gateway, 1) + "STATUS.ReadyTmpr", aliases)

    def test_values_are_those_of_modbus_and_of_the_readings(self):
        gateway = self.gateway()
        name = self.prefix(gateway, 4) + "DATA.Angl_X"
        gateway.wait(lambda values: values[name][1] == GOOD)
        client = ModbusClient(self.modbus_port)
        self.addCleanup(client.close)
        # answers that the feed has told are among those that were printed, with the same time
        for _ in range(3):
            before = gateway.values[name]
            gateway.wait(lambda values: values[name] != before)
        told = gateway.values[name]
        self.site.server.wait_until(
            lambda: any(r["number"] == 4 and milliseconds(r["time"]) == told[2] for r in self.site.readings()),
            what="the reading of that time")
        reading = next(r for r in self.site.readings() if r["number"] == 4 and milliseconds(r["time"]) == told[2])
        self.assertAlmostEqual(told[0], reading["tiltX"], places=9)
        _, sensors = read_tilt(client, 8)
        self.assertLess(min(abs(told[0] / 3600 - x) for x, _, _, _ in sensors), 0.002)
        and3 = self.prefix(gateway, 1)
        raw = self.site.last_readings()[1]["rawStatus"]
        for leaf, bit in zip(STATE, (0, 1, 2, 4, 5, 6, 8, 9)):
            self.assertEqual(gateway.values[and3 + "STATE." + leaf][:2], (bool(raw >> bit & 1), GOOD), leaf)
        self.assertLess(abs(gateway.values[and3 + "DATA.Temper"][0] - self.site.last_readings()[1]["temperature"]), 1)
        self.assertLess(abs(gateway.values[and3 + "STATE.Restart"][2] / 1000 - time.time()), 60)

    def test_qualities(self):
        gateway = self.gateway()
        silent = self.prefix(gateway, 3)
        self.assertEqual(gateway.values[silent + "DATA.Angl_X"][:2], (None, COMM_FAILURE))
        last = self.site.last_readings()
        for number, reading in last.items():
            if reading["status"] & 0x0800:
                self.assertEqual(gateway.values[self.prefix(gateway, number) + "STATE.Restart"][1], OUT_OF_SERVICE)

    def test_two_gateways_and_garbage(self):
        first, second = self.gateway(), self.gateway()
        first.socket.sendall(b"\x00\xff GET / \n{}\n[]\n")
        before = first.values[self.prefix(first, 1) + "DATA.Angl_X"]
        for gateway in (first, second):
            gateway.wait(lambda values: values[self.prefix(gateway, 1) + "DATA.Angl_X"][2] > before[2])
        with socket.create_connection(("127.0.0.1", self.port), timeout=30) as stranger:
            stranger.sendall(b"x" * 10000)
            with self.assertRaises((AssertionError, ConnectionError)):
                while True:
                    assert stranger.recv(65536)
        first.wait(lambda values: values[self.prefix(first, 1) + "DATA.Angl_X"][2] > before[2] + 500)

    def test_first_run_writes_the_list(self):
        listed = (self.site.folder / "OPC" / "tags.txt").read_text(encoding="utf-8")
        gateway = self.gateway()
        self.assertEqual([line.split("\t")[:2] for line in listed.splitlines()],
                         [[tag["name"], tag["type"]] for tag in gateway.tags])
        lines = [json.loads(line) for line in
                 (self.site.folder / "OPC" / "tags.jsonl").read_text(encoding="utf-8").splitlines()]
        self.assertEqual([tag for line in lines for tag in line["tags"]], gateway.tags)
        errors = self.site.server.errors
        told = [line for line in errors if "OPC DA" in line]
        self.assertEqual(sum("OPC DA needs Windows" in line for line in told), 1, told)
        self.assertIn(f"on port {self.port} of this computer", " ".join(told))
        self.assertEqual(sum("the list of tags is new" in line for line in told), 1, told)
        self.assertTrue(any("CanCopy" in line for line in errors) == ("CanCopy=1" in self.site.ini.read_text("utf-8")))

    def test_the_list_is_printed(self):
        for options in ([], ["--lang", "en"]):
            printed = subprocess.run(
                [PROGRAMS / "gorizont-server", "--config", self.site.ini, "--print-opc-tags", *options],
                capture_output=True, text=True, encoding="utf-8", timeout=60, check=True).stdout
            rows = [line.split("\t") for line in printed.splitlines()]
            self.assertTrue(all(len(row) == 3 for row in rows))
            self.assertEqual([row[0] for row in rows], self.gateway().names)
            self.assertEqual("arc-seconds" in printed, bool(options))

    def test_one_copy_only(self):
        """Another folder and another port of Modbus do not make a second copy possible."""
        with Site(self.site.ini.read_text("utf-8").replace("CanCopy=0", "CanCopy=1"), faults=None) as other:
            second = other.start("--lang", "en")
            self.assertEqual(second.process.wait(60), 3)
            second.stop()
            self.assertIn("only one copy of the program may work", " ".join(second.errors))


class OpcEnd(unittest.TestCase):
    def site(self, more=""):
        port = free_port()
        text = annex(IPPort1=free_port(), TmRun=200, TORCom=500).replace("[Common]", "[Common]\r\nCanOPCDA=1", 1)
        site = Site(text + f"\r\n[OPC]\r\nPort={port}\r\n" + more)
        self.addCleanup(site.__exit__)
        return site, port

    def test_end_and_later_runs(self):
        site, port = self.site()
        site.start("--lang", "en")
        site.wait_for(lambda last: "tiltX" in last.get(1, {}))
        gateway = Gateway(port)
        site.server.process.terminate()
        while "end" not in (line := gateway.next()):
            pass
        self.assertEqual(line, {"end": True})
        self.assertEqual(gateway.file.read(), b"")
        gateway.close()
        self.assertEqual(site.server.stop(), 0)
        site.start("--lang", "en")
        site.wait_for(lambda last: "tiltX" in last.get(1, {}))
        again = Gateway(port)
        again.close()
        self.assertFalse(any("the list of tags is new" in line for line in site.server.errors), site.server.errors)
        self.assertEqual(site.server.stop(), 0)

    def test_a_gateway_that_never_reads_costs_nothing(self):
        site, port = self.site()
        # What a sanitizer keeps of memory that was given back is not the program's.
        with unittest.mock.patch.dict(os.environ, {"ASAN_OPTIONS": "quarantine_size_mb=1"}):
            site.start()
        site.wait_for(lambda last: "tiltX" in last.get(1, {}))
        with socket.create_connection(("127.0.0.1", port), timeout=30) as lazy:
            other = Gateway(port)
            name = next(n for n in other.names if n.endswith(".DATA.Angl_X"))

            def resident():
                fields = pathlib.Path(f"/proc/{site.server.process.pid}/statm").read_text().split()
                return int(fields[1]) * 4096

            start = other.values[name][2]
            other.wait(lambda values: values[name][2] > start + 2000)
            before = resident()
            other.wait(lambda values: values[name][2] > start + 10000)
            self.assertLess(resident() - before, 8 * 1024 * 1024)
            other.close()
            lazy.recv(100)

    def test_port_that_is_taken(self):
        site, port = self.site()
        with socket.create_server(("127.0.0.1", port)):
            site.start("--lang", "en")
            site.wait_for(lambda last: "tiltX" in last.get(1, {}))
            told = [line for line in site.server.errors if line.startswith("OPC DA: cannot serve on port")]
            self.assertEqual(len(told), 1, site.server.errors)
            self.assertIn("choose another [OPC] Port", told[0])
        site.server.wait_until(
            lambda: any("OPC DA needs Windows" in line for line in site.server.errors), what="the port")
        Gateway(port).close()


if __name__ == "__main__":
    unittest.main()
