"""The OPC DA gateway under Wine, against a feed whose every value is set here. Ends with 77 where it cannot be tried.

`test_gateway.py Bench` prints figures.
"""
import difflib
import json
import re
import sys

import opc_case
from fake_feed import GOOD, FakeFeed
from opc_case import GATEWAY

OTHERS = "{11111111-2222-3333-4444-555555555555}"
PROXY = "{3F6A91D8-04B2-4E5C-A7C9-60D1E8B25F43}"


class FedCase(opc_case.OpcCase):
    """With one feed for all tests."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.feed = FakeFeed()
        cls.before = cls.prefix.registry()
        cls.registered = cls.prefix.run(GATEWAY, "/RegServer", f"/Port={cls.feed.port}", f"/Hash={cls.feed.hash}")

    def deed(self, conversation, what):
        word, _, rest = what.partition(" ")
        if word == "set":
            # Names hold no spaces.
            name, value, *quality = rest.split(" ")
            self.feed.set(name, json.loads(value), int(quality[0]) if quality else GOOD)
        elif word == "load":
            period, rounds = rest.split(" ")
            self.feed.run_load(float(period), int(rounds))
        elif word == "feed":
            {"stop": self.feed.stop, "start": self.feed.start, "end": self.feed.end}[rest]()
        elif word == "kill":
            conversation.process.kill()
        else:
            self.fail(f"the client asks for «{what}»")


class GatewayTest(FedCase):
    def assert_registry_as_before(self):
        changed = difflib.unified_diff(self.before.splitlines(), self.prefix.registry().splitlines(), n=0, lineterm="")
        self.assertEqual(list(changed), [])

    def test_1_interfaces(self):
        self.assertEqual(self.registered, 0)
        self.try_out("registry", "server", "browsing", "items", "reading", "state")

    def test_2_callbacks(self):
        self.try_out("callbacks", "thousand")

    def test_3_several_clients(self):
        three = [self.converse("items", "reading") for _ in range(3)]
        for conversation in three:
            self.assert_well(conversation.finish(120))

    def test_4_killed_client(self):
        lines = self.converse("hold").finish(60)
        self.assertIn("ok hold.told", lines)
        self.assertNotIn("end 0", lines)
        # What the killed client still held keeps neither the gateway from serving nor from ending.
        self.try_out("survivor", "ending")

    def test_5_outage(self):
        self.try_out("outage")

    def test_6_gateway_dies(self):
        self.try_out("death")

    def test_7_gateway_ends_by_itself(self):
        self.try_out("ending")

    def test_8_shutdown(self):
        self.try_out("shutdown")

    def test_9_registry_as_before(self):
        self.assertNotEqual(self.prefix.registry(), self.before)
        again = self.prefix.run(GATEWAY, "/RegServer", "/Port=43212")
        self.assertEqual(again, 0)
        # What the second registration did not name is still that of the first.
        self.assertIn(self.feed.hash, self.prefix.registry())
        self.assertEqual(self.prefix.run(GATEWAY, "/UnregServer"), 0)
        self.assert_registry_as_before()
        self.assertEqual(self.prefix.run(GATEWAY, "/RegServer", "/PerUser"), 0)
        self.assertIn("OPC.DA.GorizontServer", self.prefix.registry())
        self.assertEqual(self.prefix.run(GATEWAY, "/UnregServer", "/PerUser"), 0)
        self.assert_registry_as_before()
        self.assertNotEqual(self.prefix.run(GATEWAY, "/Nonsense"), 0)

    def test_9_registry_keeps_the_proxy_of_others(self):
        key = "HKLM\\Software\\Classes\\Interface\\{39C13A4D-011E-11D0-9675-0020AFD8ADB3}"  # IOPCServer
        for view in ("/reg:64", "/reg:32"):
            self.prefix.run("reg", "add", key + "\\ProxyStubClsid32", "/ve", "/d", OTHERS, "/f", view)
        before = self.prefix.registry()
        for scope in ((), ("/PerUser",)):
            self.assertEqual(self.prefix.run(GATEWAY, "/RegServer", *scope), 0)
            self.assertEqual(self.proxies("39C13A4D"), {OTHERS})
            self.assertEqual(self.proxies("39C13A4F"), {PROXY})
            self.assertEqual(self.prefix.run(GATEWAY, "/UnregServer", *scope), 0)
            self.assertEqual(self.prefix.registry(), before)

    def proxies(self, interface):
        pattern = rf'\\Interface\\{{{interface}[^\]]*\\ProxyStubClsid32\]\n@="([^"]*)"'
        return set(re.findall(pattern, self.prefix.registry(), re.IGNORECASE))


class Bench(FedCase):
    def test_bench(self):
        self.try_out("bench", seconds=3600)


if __name__ == "__main__":
    sys.exit(opc_case.main("GatewayTest"))
