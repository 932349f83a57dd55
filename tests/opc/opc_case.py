"""What the tests of the OPC DA gateway share: the programs, the prefix, and a client's conversation."""
import os
import pathlib
import sys
import unittest

import wine_prefix

OPC = pathlib.Path(os.environ["GORIZONT_OPC"])
WORK = pathlib.Path(os.environ["GORIZONT_OPC_WORK"])
GATEWAY = OPC / "gorizont-opc-da.exe"
CLIENT = OPC / "opc-test-client.exe"


class OpcCase(unittest.TestCase):
    """One prefix for all; the tests run in the order of their names. `deed(conversation, what)` does what a client asks for."""

    @classmethod
    def setUpClass(cls):
        cls.prefix = wine_prefix.Prefix(WORK)
        cls.addClassCleanup(cls.prefix.close)
        cls.conversations = 0

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


def main(tests):
    """Runs the tests; 77 where the gateway cannot be tried."""
    absent = wine_prefix.missing() or next(
        (f"{program.name} is not built: the cross compiler is missing" for program in (GATEWAY, CLIENT) if not program.exists()),
        None)
    if absent:
        print(f"skipped: {absent}")
        return 77
    WORK.mkdir(parents=True, exist_ok=True)
    program = unittest.main(module="__main__", defaultTest=tests, verbosity=2, exit=False)
    return 0 if program.result.wasSuccessful() else 1
