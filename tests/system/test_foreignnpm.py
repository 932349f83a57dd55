"""Modbus clients for Node.js read every unit. They are fetched before the tests, see packaging/run-tests."""
import os
import pathlib
import sys
import unittest

from foreign_clients import CLIENTS, ForeignClients

MODULES = pathlib.Path(os.environ["GORIZONT_FOREIGN"]) / "node_modules"
SKIPPED = 77


class ForeignNpm(ForeignClients, unittest.TestCase):
    def test_modbus_serial(self):
        self.check("node", CLIENTS / "read_modbus-serial.js", NODE_PATH=str(MODULES))

    def test_jsmodbus(self):
        self.check("node", CLIENTS / "read_jsmodbus.js", NODE_PATH=str(MODULES))


if __name__ == "__main__":
    if not (MODULES / "modbus-serial").is_dir() or not (MODULES / "jsmodbus").is_dir():
        print("Skipped: modbus-serial and jsmodbus could not be fetched from the npm registry.")
        sys.exit(SKIPPED)
    unittest.main()
