"""The Modbus client of Debian's Python reads every unit."""
import unittest

from foreign_clients import CLIENTS, ForeignClients

# Not the interpreter of this test: packages of Debian are seen by the one of Debian.
PYTHON = "/usr/bin/python3"


class Foreign(ForeignClients, unittest.TestCase):
    def test_pymodbus(self):
        self.check(PYTHON, CLIENTS / "read_pymodbus.py")


if __name__ == "__main__":
    unittest.main()
