"""The main program's side of the OPC feed (protocol 1), with values that a test sets: no line of it comes from the program."""
import contextlib
import hashlib
import json
import socket
import threading
import time

AND3 = "[COM5].Sensor_001[AND3][Addr:002]"
IND3 = "[COM16].Sensor_002[IND3][Addr:003]"
NET = "[tcp://10.0.0.7:502].Sensor_003[AND3][Addr:001]"
STATE = ["Restart", "ReadyAngl", "ReadyTmp", "ReadErr", "CRCErr", "RangdErr", "TReadErr", "TRangErr"]
AND3_DATA = ["Angl_X", "Angl_Y", "AMax_X", "AMax_Y", "ARms_X", "ARms_Y", "Temper", "8_Reserv"]
IND3_DATA = ["Angl_X", "Angl_Y", *(f"{n}_Reserv" for n in range(3, 9))]
# What table 11.1 of the manual calls otherwise than figure 11.4.
TABLE = {"ReadyTmp": "ReadyTmpr", "RangdErr": "RangErr", "AMax_X": "Amax_X", "AMax_Y": "Amax_Y", "ARms_Y": "Arms_Y",
         "Temper": "Rezerv"}
BULK = 1000
MOMENT = 1522846251330  # 2018-04-04 12:50:51.330 UTC
FIGURE = [True, True, True, False, False, False, False, False,
          -3599.5, 12.25, 0.267620891332626, 5.31519273039294e-15, 0.100418690954787, 70000.0, 26.448, 3119.0]
GOOD, LAST_KNOWN, OUT_OF_SERVICE, WAITING, NOT_CONNECTED = 192, 20, 28, 32, 8


def tag(sensor, branch, leaf):
    entry = {"name": f"{sensor}.{branch}.{leaf}", "type": "bool" if branch == "STATE" else "double",
             "description": f"{leaf} датчика"}
    other = TABLE.get(leaf, leaf)
    if branch == "STATE":
        entry["aliases"] = [f"{sensor}.STATUS.{other}"]
    elif other != leaf:
        entry["aliases"] = [f"{sensor}.DATA.{other}"]
    return entry


def tag_list():
    tags = []
    for sensor, data in ((AND3, AND3_DATA), (IND3, IND3_DATA), (NET, AND3_DATA)):
        tags += [tag(sensor, "STATE", leaf) for leaf in STATE] + [tag(sensor, "DATA", leaf) for leaf in data]
    tags += [tag(f"[SIM].Sensor_{n:04}[AND3][Addr:001]", "DATA", "Angl_X") for n in range(1, BULK + 1)]
    return tags


def hash_of(tags):
    return hashlib.sha256("".join(f"{t['name']}\t{t['type']}\n" for t in tags).encode()).hexdigest()


class FakeFeed:
    """Listens until stop(); every gateway gets the list, the snapshot, and then each change."""

    def __init__(self, port=0):
        self.tags = tag_list()
        self.hash = hash_of(self.tags)
        self.index = {t["name"]: i for i, t in enumerate(self.tags)}
        self.values = [[i, value, GOOD, MOMENT] for i, value in enumerate(FIGURE)]
        self.values += [[16 + i, None, NOT_CONNECTED, MOMENT] for i in range(16)]
        self.values += [[32 + i, value, GOOD, MOMENT] for i, value in enumerate(FIGURE)]
        self.values += [[48 + i, 0.0, GOOD, MOMENT] for i in range(BULK)]
        for leaf, quality in (("Angl_Y", LAST_KNOWN), ("Temper", OUT_OF_SERVICE), ("8_Reserv", WAITING)):
            self.values[self.index[f"{NET}.DATA.{leaf}"]][2] = quality
        self.greetings = []
        self.lock = threading.Lock()
        self.clients = []
        self.load = threading.Event()
        self.port = port
        self.listener = None
        self.start()

    def start(self):
        self.listener = socket.create_server(("127.0.0.1", self.port))
        self.port = self.listener.getsockname()[1]
        threading.Thread(target=self._accept, args=(self.listener,), daemon=True).start()

    def stop(self):
        """As a program that was killed: nothing is said."""
        self.listener.shutdown(socket.SHUT_RDWR)  # wakes who waits in accept; the port would stay taken
        self.listener.close()
        with self.lock:
            for client in self.clients:
                with contextlib.suppress(OSError):  # a gateway that has ended
                    client.shutdown(socket.SHUT_RDWR)
                client.close()
            self.clients.clear()

    def end(self):
        self._send([{"end": True}])

    def set(self, name, value, quality=GOOD):
        entry = [self.index[name], value, quality, int(time.time() * 1000)]
        self.values[entry[0]] = entry
        self._send([{"v": [entry]}])

    def run_load(self, period, rounds):
        """Counts all bulk tags up together, `rounds` times, one step in `period` seconds. Returns the last count."""
        for count in range(1, rounds + 1):
            now = int(time.time() * 1000)
            changed = [[48 + i, float(count), GOOD, now] for i in range(BULK)]
            self.values[48:48 + BULK] = changed
            self._send([{"v": changed[at:at + 500]} for at in range(0, BULK, 500)])
            time.sleep(period)
        return rounds

    def _opening(self):
        lines = [{"hello": "GorizontServer", "protocol": 1, "version": "9.8.7", "caption": "Проба", "hash": self.hash,
                  "count": len(self.tags)}]
        lines += [{"tags": self.tags[at:at + 200]} for at in range(0, len(self.tags), 200)]
        lines += [{"ready": True}]
        return lines + [{"v": self.values[at:at + 500]} for at in range(0, len(self.values), 500)]

    def _accept(self, listener):
        while True:
            try:
                client, _ = listener.accept()
            except OSError:
                return
            greeting = client.makefile("r", encoding="utf-8").readline()
            with self.lock:
                self.greetings.append(json.loads(greeting))
                client.sendall(as_bytes(self._opening()))
                self.clients.append(client)
            threading.Thread(target=self._ping, args=(client,), daemon=True).start()

    def _ping(self, client):
        while True:
            time.sleep(2)
            with self.lock:
                try:
                    client.sendall(as_bytes([{"ping": True}]))
                except OSError:
                    return

    def _send(self, lines):
        data = as_bytes(lines)
        with self.lock:
            for client in list(self.clients):
                try:
                    client.sendall(data)
                except OSError:
                    self.clients.remove(client)
                    client.close()


def as_bytes(lines):
    return "".join(json.dumps(line, ensure_ascii=False, separators=(",", ":")) + "\n" for line in lines).encode()


if __name__ == "__main__":
    FakeFeed(43212)
    threading.Event().wait()
