"""The OPC DA gateway under Wine, against a feed whose every value is set here. Ends with 77 where it cannot be tried."""
import difflib
import json
import os
import pathlib
import sys
import unittest

import wine_prefix
from fake_feed import GOOD, FakeFeed

OPC = pathlib.Path(os.environ["GORIZONT_OPC"])
WORK = pathlib.Path(os.environ["GORIZONT_OPC_WORK"])
GATEWAY = OPC / "gorizont-opc-da.exe"
CLIENT = OPC / "opc-test-client.exe"
BENCH = "bench" in sys.argv


class GatewayTest(unittest.TestCase):
    """One prefix and one feed for all; the tests run in the order of their names."""

    @classmethod
    def setUpClass(cls):
        cls.prefix = wine_prefix.Prefix(WORK)
        cls.feed = FakeFeed()
        cls.conversations = 0
        cls.before = cls.prefix.registry()
        cls.registered = cls.prefix.run(GATEWAY, "/RegServer", f"/Port={cls.feed.port}", f"/Hash={cls.feed.hash}")

    @classmethod
    def tearDownClass(cls):
        cls.prefix.close()

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

    def converse(self, *words):
        type(self).conversations += 1
        output = WORK / f"client{self.conversations}.txt"
        return wine_prefix.Conversation(self.prefix, CLIENT, words, output, self.deed, " ".join(words))

    def assert_well(self, lines):
        failed = [line for line in lines if line.startswith("FAIL")]
        self.assertEqual(failed, [])
        self.assertEqual(lines[-1:], ["end 0"])
        self.assertGreater(sum(line.startswith("ok ") for line in lines), 0)

    def try_out(self, *words, seconds=120):
        self.assert_well(self.converse(*words).finish(seconds))

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
        self.try_out("survivor")

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


class Bench(GatewayTest):
    """`test_gateway.py bench`: figures, not verdicts."""

    def test_bench(self):
        self.try_out("bench", seconds=3600)


def main():
    absent = wine_prefix.missing() or next(
        (f"{program.name} is not built: the cross compiler is missing" for program in (GATEWAY, CLIENT) if not program.exists()),
        None)
    if absent:
        print(f"skipped: {absent}")
        return 77
    WORK.mkdir(parents=True, exist_ok=True)
    names = ["Bench.test_bench"] if BENCH else ["GatewayTest"]
    arguments = [sys.argv[0], *(argument for argument in sys.argv[1:] if argument != "bench")]
    program = unittest.main(argv=arguments, defaultTest=names, verbosity=2, exit=False)
    return 0 if program.result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
