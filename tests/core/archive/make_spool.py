#!/usr/bin/env python3
"""Prints the spool that tst_spool reads: three batches of the spool 0102030405060708h, from sequence 41 on."""
import struct
import zlib

NAME = 0x0102030405060708


def record(sequence, batch):
    head = struct.pack("<Iqq", len(batch), NAME, sequence)
    return b"GSPL" + head + struct.pack("<I", zlib.crc32(head + batch)) + batch


for number, content in ((41, b"first"), (42, b""), (43, b"the GSPL of it")):
    print(record(number, content).hex())
