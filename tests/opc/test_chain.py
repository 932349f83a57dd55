"""The whole chain: simulated sensors, the program, the OPC DA gateway under Wine, a COM client. Ends with 77 where it cannot be
tried."""
import datetime
import os
import pathlib
import signal
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "system"))
os.environ.setdefault("GORIZONT_TEST_DATA", str(pathlib.Path(__file__).parents[1] / "data"))

import opc_case
from opc_case import GATEWAY
from site_under_test import Site, annex, free_port


def milliseconds(iso):
    return round(datetime.datetime.fromisoformat(iso.replace("Z", "+00:00")).timestamp() * 1000)


class ChainTest(opc_case.OpcCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.port = free_port()
        text = annex(IPPort1=free_port(), TmRun=200, TORCom=500, SCRCErrors=10)
        text = text.replace("[Common]", "[Common]\r\nCanOPCDA=1", 1) + f"\r\n[OPC]\r\nPort={cls.port}\r\n"
        cls.site = Site(text)
        cls.addClassCleanup(cls.site.__exit__)
        cls.start_program()

    @classmethod
    def start_program(cls):
        cls.site.start()
        cls.site.wait_for(lambda last: 1 in last)

    def deed(self, conversation, what):
        word, *rest = what.split(" ")
        if word == "told":
            value, moment = float(rest[0]), int(rest[1])
            # The line of a reading and its value on the feed have no fixed order.
            self.site.server.wait_until(lambda: self.printed(value, moment), 20, f"a printed reading {what}")
        elif rest == ["start"]:
            self.start_program()
        else:
            self.site.server.stop({"kill": signal.SIGKILL, "end": signal.SIGTERM}[rest[0]])

    def printed(self, value, moment):
        return any(reading["number"] == 1 and milliseconds(reading["time"]) == moment and reading["tiltX"] == value
                   for reading in self.site.readings())

    def test_chain(self):
        # What the first run left for the gateway is what registration gets on Windows.
        folder = next(self.site.folder.rglob("registered")).parent
        tag_hash, port = (folder / "registered").read_text().split()
        self.assertEqual(int(port), self.port)
        tags = self.prefix.windows_path(folder / "tags.jsonl")
        self.assertEqual(self.prefix.run(GATEWAY, "/RegServer", f"/Port={port}", f"/Hash={tag_hash}", f"/Tags={tags}"), 0)
        self.try_out("registry", "chain", seconds=300)
        self.try_out("alone")


if __name__ == "__main__":
    sys.exit(opc_case.main("ChainTest"))
