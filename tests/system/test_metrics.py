"""Counters as Prometheus reads them."""
import re
import socket
import unittest
import urllib.error
import urllib.request

from site_under_test import ModbusClient, Site, annex, free_port, read_tilt

SAMPLE = re.compile(r'([a-z_]+)(?:\{((?:[a-z]+="(?:[^"\\\n]|\\["\\n])*",?)*)\})? (NaN|[+-]?(?:Inf|[0-9.]+(?:e[+-]?\d+)?))')
LABEL = re.compile(r'([a-z]+)="((?:[^"\\]|\\.)*)"')


def parse(text):
    """(name, labels) → value; checks that a family stands together, behind its HELP and TYPE."""
    values = {}
    types = {}
    lines = text.splitlines()
    assert text.endswith("\n")
    for number, line in enumerate(lines):
        if line.startswith("# HELP "):
            name = line.split(" ")[2]
            assert name not in types, f"{name} twice"
            assert lines[number + 1].startswith(f"# TYPE {name} "), line
        elif line.startswith("# TYPE "):
            _, _, name, kind = line.split(" ")
            assert kind in ("counter", "gauge")
            assert (kind == "counter") == name.endswith("_total"), line
            types[name] = kind
            current = name
        else:
            match = SAMPLE.fullmatch(line)
            assert match, line
            assert match[1] == current, line
            key = match[1], frozenset(LABEL.findall(match[2] or ""))
            assert key not in values, line
            values[key] = float(match[3])
    return values


class Metrics(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.port = free_port()
        cls.modbus_port = free_port()
        text = annex(IPPort1=cls.modbus_port, TmRun=200, TORCom=500, SCRCErrors=10)
        text += f"\r\n[Metrics]\r\nPort={cls.port}\r\n[MQTT]\r\nHost=127.0.0.1\r\nPort={free_port()}\r\n"
        cls.site = Site(text, faults=["silent=3"])
        cls.addClassCleanup(cls.site.__exit__)
        cls.site.start()
        cls.site.wait_for(lambda last: last.get(3, {}).get("status") == 0x3700 and last.get(1, {}).get("status") == 0x0100)

    def get(self, path="/metrics", method="GET"):
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}{path}", method=method)
        with urllib.request.urlopen(request, timeout=30) as answer:
            return answer.headers, answer.read().decode("utf-8")

    def value(self, values, name, **labels):
        found = [v for (n, l), v in values.items() if n == name and set(labels.items()) <= l]
        self.assertEqual(len(found), 1, (name, labels))
        return found[0]

    def test_agrees_with_what_is_printed(self):
        headers, text = self.get()
        self.assertEqual(headers["Content-Type"], "text/plain; version=0.0.4; charset=utf-8")
        values = parse(text)
        self.assertEqual(self.value(values, "gorizont_sensor_status_code", sensor="3"), 3)
        self.assertEqual(self.value(values, "gorizont_sensor_status_code", sensor="1", port="COM10", type="AN-D3"), 0)
        self.assertEqual(self.value(values, "gorizont_port_state", port="COM10", state="open"), 1)
        self.assertGreater(self.value(values, "gorizont_sensor_read_errors_total", sensor="3"), 5)
        self.assertGreater(self.value(values, "gorizont_port_received_bytes_total", port="COM9"), 100)
        self.assertLess(self.value(values, "gorizont_sensor_last_answer_age_seconds", sensor="1"), 30)
        self.assertNotIn("gorizont_sensor_last_answer_age_seconds", [n for (n, l) in values if ("sensor", "3") in l])
        printed = [r for r in self.site.readings() if r["number"] == 4]
        tilt = self.value(values, "gorizont_sensor_tilt_arcseconds", sensor="4", axis="x")
        self.assertLess(min(abs(tilt - r["tiltX"]) for r in printed[-50:] if "tiltX" in r), 5)
        self.assertEqual(self.value(values, "gorizont_mqtt_connected"), 0)
        self.assertLess(self.value(values, "gorizont_archive_waiting_readings"), 1000)
        self.assertEqual(self.value(values, "gorizont_server_clients", server="Modbus TCP"), 0)
        client = ModbusClient(self.modbus_port)
        read_tilt(client, 8)
        self.site.server.wait_until(
            lambda: self.value(parse(self.get()[1]), "gorizont_server_clients", server="Modbus TCP") == 1,
            what="client")
        client.close()
        self.site.server.wait_until(
            lambda: self.value(parse(self.get()[1]), "gorizont_mqtt_waiting_readings") > 10, what="queue")

    def test_counters_never_fall(self):
        before = parse(self.get()[1])
        answers = self.value(before, "gorizont_sensor_answers_total", sensor="4")
        self.site.server.wait_until(
            lambda: self.value(parse(self.get()[1]), "gorizont_sensor_answers_total", sensor="4") > answers + 3,
            what="answers")
        after = parse(self.get()[1])
        for key, value in before.items():
            if key[0].endswith("_total"):
                self.assertGreaterEqual(after[key], value, key)

    def test_other_pages_and_methods(self):
        for path, method, code in (("/", "GET", 404), ("/metrics", "DELETE", 405), ("/metrics", "PUT", 405)):
            with self.assertRaises(urllib.error.HTTPError) as error:
                self.get(path, method)
            self.assertEqual(error.exception.code, code)
            error.exception.close()

    def test_only_the_address_of_bind_is_served(self):
        socket.create_connection(("127.0.0.1", self.port), timeout=5).close()
        with self.assertRaises(OSError):
            socket.create_connection(("127.0.0.2", self.port), timeout=5).close()


if __name__ == "__main__":
    unittest.main()
