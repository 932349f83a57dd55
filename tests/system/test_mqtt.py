"""Readings to a real MQTT broker (mosquitto), watched by a real client (mosquitto_sub)."""
import contextlib
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import time
import unittest

from site_under_test import Site, annex, free_port

NUMBERS = {1, 2, 3, 4, 11, 12, 13, 14}
BROKER = shutil.which("mosquitto") or "/usr/sbin/mosquitto"  # not in everybody's PATH


class Broker(contextlib.AbstractContextManager):
    """mosquitto on a free port, with its memory in a folder, so that watchers miss nothing when it is away."""

    def __init__(self, *lines, user=None):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self.port = free_port()
        text = [f"listener {self.port} 127.0.0.1", "persistence true", f"persistence_location {self.folder}/",
                "max_queued_messages 0", *lines]
        if os.getuid() == 0:
            text.append("user root")  # otherwise the folder is not its own
        if user:
            passwords = self.folder / "passwords"
            subprocess.run(["mosquitto_passwd", "-b", "-c", passwords, *user], check=True, capture_output=True)
            text += ["allow_anonymous false", f"password_file {passwords}"]
        else:
            text.append("allow_anonymous true")
        (self.folder / "broker.conf").write_text("\n".join(text) + "\n")
        self.start()

    def start(self):
        self.process = subprocess.Popen(
            [BROKER, "-c", self.folder / "broker.conf"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + 30
        while time.monotonic() < deadline:
            with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", self.port), timeout=1):
                return
            time.sleep(0.1)
        raise AssertionError("the broker does not start")

    def stop(self):
        self.process.terminate()
        self.process.wait(30)

    def __exit__(self, *_):
        self.stop()
        self._folder.cleanup()


class Watcher(contextlib.AbstractContextManager):
    """mosquitto_sub with a session that the broker keeps for it."""

    def __init__(self, port, topic, *options):
        command = ["mosquitto_sub", "-h", "127.0.0.1", "-p", str(port), "-i", "watcher", "-c", "-q", "1", "-t", topic,
                   "-F", "%r %t %p", *options]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.messages = []  # (is retained, topic, payload)
        self.thread = threading.Thread(target=self._collect, daemon=True)
        self.thread.start()

    def _collect(self):
        for line in self.process.stdout:
            retained, topic, payload = line.decode("utf-8").rstrip("\n").split(" ", 2)
            self.messages.append((retained == "1", topic, payload))

    def payloads(self, topic):
        return [payload for _, name, payload in list(self.messages) if name == topic]

    def readings(self):
        return [json.loads(payload) for _, topic, payload in list(self.messages) if topic.endswith("/reading")]

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait(30)
        self.thread.join(10)
        self.process.stdout.close()


def ini(broker_port, *lines, prefix="горизонт/стенд", **changes):
    keys = {"IPPort1": free_port(), "TmRun": 200, "TORCom": 500, "SCRCErrors": 10, **changes}
    return annex(**keys) + "\r\n".join(
        ["", "[MQTT]", "Host=127.0.0.1", f"Port={broker_port}", f"Prefix={prefix}", *lines, ""])


def wait_until(condition, seconds=90, what="condition"):
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, f"{what} not reached in {seconds} s"
        time.sleep(0.1)


def keys(readings):
    return {(reading["number"], reading["time"]) for reading in readings}


def without_number(reading):
    return {key: value for key, value in reading.items() if key != "seq"}


class Mqtt(unittest.TestCase):
    def test_readings_states_and_will(self):
        with Broker() as broker, Site(ini(broker.port)) as site, \
                Watcher(broker.port, "горизонт/стенд/#") as watcher:
            server = site.start()
            wait_until(lambda: {r["number"] for r in watcher.readings() if "tiltX" in r} == NUMBERS, what="readings")
            wait_until(lambda: len(watcher.payloads("горизонт/стенд/sensor/3/reading")) > 5, what="more readings")
            self.assertEqual(watcher.payloads("горизонт/стенд/status"), ["online"])
            printed = {(r["number"], r["time"]): r for r in site.readings()}
            for reading in watcher.readings()[:50]:
                self.assertEqual(without_number(reading), printed[(reading["number"], reading["time"])])
            # Who comes later finds the states.
            with Watcher(broker.port, "горизонт/стенд/+/+/state", "-i", "later") as later:
                wait_until(lambda: len(later.messages) >= len(NUMBERS) + 4, what="retained states")
                self.assertTrue(all(retained for retained, _, _ in later.messages))
                port = json.loads(later.payloads("горизонт/стенд/port/1/state")[-1])
                self.assertEqual((port["port"], port["state"]), ("COM10", "open"))
                sensor = json.loads(later.payloads("горизонт/стенд/sensor/3/state")[-1])
                self.assertEqual((sensor["code"], sensor["type"]), (0, "IN-D3"))
            server.stop(signal.SIGKILL)
            wait_until(lambda: watcher.payloads("горизонт/стенд/status") == ["online", "offline"], what="last will")
            server = site.start()
            wait_until(lambda: watcher.payloads("горизонт/стенд/status")[-1] == "online", what="return")
            self.assertEqual(server.stop(), 0)
            wait_until(lambda: watcher.payloads("горизонт/стенд/status")[-1] == "offline", what="good-bye")

    def test_nothing_is_missing_after_the_broker_was_away_and_the_program_was_killed(self):
        with Broker() as broker, Site(ini(broker.port)) as site, Watcher(broker.port, "горизонт/стенд/#") as watcher:
            server = site.start()
            wait_until(lambda: len(watcher.readings()) > 50, what="first readings")
            broker.stop()
            before = len(site.readings())
            server.wait_until(lambda: len(site.readings()) > before + 200, what="readings without a broker")
            time.sleep(2)  # what was printed last is on its way to the disk
            expected = keys(site.readings()[:-40])
            server.stop(signal.SIGKILL)
            server = site.start()
            server.wait_until(lambda: len(site.readings()) > 100, what="readings of the second run")
            broker.start()
            server.wait_until(lambda: len(site.readings()) > 300, what="readings with a broker")
            expected |= keys(site.readings()[:250])
            wait_until(lambda: expected <= keys(watcher.readings()), what="all that was missing")
            self.assertEqual(server.stop(), 0)
            # Each once, the order of the first arrivals is the order of the measurements.
            last = 0
            times = {}
            for reading in watcher.readings():
                if reading["seq"] > last:
                    last = reading["seq"]
                    self.assertGreater(reading["time"], times.get(reading["number"], ""))
                    times[reading["number"]] = reading["time"]
            first = min(r["seq"] for r in watcher.readings())
            self.assertEqual({r["seq"] for r in watcher.readings()}, set(range(first, last + 1)))

    def test_wrong_password_is_one_sentence(self):
        with Broker(user=("site", "right")) as broker, \
                Site(ini(broker.port, "User=site", "PasswordFile=secret.txt")) as site:
            (site.folder / "secret.txt").write_text("wrong\n")
            server = site.start("--lang", "en")
            server.wait_until(lambda: any("PasswordFile" in line for line in server.errors), what="sentence")
            time.sleep(5)  # several attempts
            (site.folder / "secret.txt").write_text("right\n")
            server.wait_until(
                lambda: any("MQTT: connected to the broker" in line for line in server.errors), what="connection")
            told = [line for line in server.errors if "MQTT" in line]
            self.assertEqual(len(told), 2, told)
            self.assertEqual(server.stop(), 0)

    def test_tls(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for who, subject in (("right", "localhost"), ("wrong", "elsewhere")):
                subprocess.run(
                    ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj",
                     f"/CN={subject}", "-addext", f"subjectAltName=DNS:{subject},IP:127.0.0.1", "-keyout",
                     folder / f"{who}.key", "-out", folder / f"{who}.pem"], check=True, capture_output=True)
            with Broker(f"certfile {folder}/right.pem", f"keyfile {folder}/right.key") as broker, \
                    Site(ini(broker.port, "TLS=1", "CAFile=ca.pem")) as site:
                shutil.copy(folder / "wrong.pem", site.folder / "ca.pem")
                server = site.start("--lang", "en")
                server.wait_until(lambda: any("is not trusted" in line for line in server.errors), what="distrust")
                shutil.copy(folder / "right.pem", site.folder / "ca.pem")
                server.wait_until(
                    lambda: any("MQTT: connected to the broker" in line for line in server.errors), what="connection")
                told = [line for line in server.errors if "MQTT" in line]
                self.assertEqual(len(told), 2, told)
                with Watcher(broker.port, "горизонт/стенд/#", "--cafile", folder / "right.pem") as watcher:
                    wait_until(lambda: len(watcher.readings()) > 20, what="readings")
                self.assertEqual(server.stop(), 0)


if __name__ == "__main__":
    unittest.main()
