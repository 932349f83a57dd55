"""Reads registers with pymodbus: read_pymodbus.py PORT UNIT:FUNCTION:START:COUNT…; see test_foreign.py."""
import json
import sys

from pymodbus.client import ModbusTcpClient

client = ModbusTcpClient("127.0.0.1", port=int(sys.argv[1]), timeout=10)
assert client.connect()
answers = []
for what in sys.argv[2:]:
    unit, function, start, count = map(int, what.split(":"))
    read = {3: client.read_holding_registers, 4: client.read_input_registers}[function]
    answer = read(start, count, slave=unit)
    answers.append({"exception": answer.exception_code} if answer.isError() else answer.registers)
client.close()
print(json.dumps(answers))
