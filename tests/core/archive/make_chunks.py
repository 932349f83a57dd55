#!/usr/bin/env python3
"""Writes the chunks in tests/data/archive after the drawings in core/archive, with nothing of the program.

Predictors and parameters are chosen by hand here, so that every form of a column occurs.
"""
import pathlib
import struct
import zlib

MASK = (1 << 64) - 1


def number(value):
    out = bytearray()
    while value >= 0x80:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)
    return bytes(out)


def zigzag(value):
    return 2 * value if value >= 0 else -2 * value - 1


def signed(value):
    return number(zigzag(value))


def piece(data):
    return number(len(data)) + data


class Bits:
    def __init__(self):
        self.text = ""

    def put(self, value, count):
        self.text += "".join(str(value >> i & 1) for i in range(count))

    def ones(self, count):
        self.text += "1" * count

    def bytes(self):
        padded = self.text + "0" * (-len(self.text) % 8)
        return bytes(int(padded[i:i + 8][::-1], 2) for i in range(0, len(padded), 8))


def rice(bits, value, k):
    high = value >> k
    if high < 24:
        bits.ones(high)
        bits.put(0, 1)
        bits.put(value & ((1 << k) - 1), k)
    else:
        bits.ones(24)
        bits.put(value, 64)


def integers(values, predictor, first, ks, slope=None, flagged=()):
    """ks: the k of each block of 64; 63: all zero. flagged: indices of blocks written with flags."""
    bits = Bits()
    for i, value in enumerate(values):
        if i % 64 == 0:
            k = ks[i // 64]
            bits.put(k, 6)
            bits.put(1 if i // 64 in flagged else 0, 1)
        if predictor == 0:
            guess = first
        elif predictor == 1:
            guess = values[i - 1] if i else first
        elif predictor == 2:
            guess = first if i == 0 else values[0] if i == 1 else 2 * values[i - 1] - values[i - 2]
        else:
            guess = first + (slope * i >> 16)
        residual = zigzag(value - guess) & MASK
        if k == 63:
            assert residual == 0
        elif i // 64 in flagged:
            bits.put(1 if residual else 0, 1)
            if residual:
                rice(bits, residual - 1, k)
        else:
            rice(bits, residual, k)
    head = number(predictor) + signed(first) + (signed(slope) if predictor == 3 else b"")
    return head + piece(bits.bytes())


def sealed(data):
    return data + struct.pack("<I", zlib.crc32(data))


def ordered(value):
    bits = struct.unpack("<q", struct.pack("<d", value))[0]
    return bits if bits >= 0 else bits ^ 0x7FFFFFFFFFFFFFFF


START = 1_700_000_000_000_000


def readings():
    """130 readings, one a second but the last, which comes 5 ms late."""
    times = [START + 1_000_000 * i for i in range(130)]
    times[129] += 5_000
    x = [(i * i) % 97 - 40 for i in range(130)]  # 1/256 of an arc-second
    y = [-264 * 10 + i for i in range(130)]  # tenths, and 12.3 subtracted
    warm = [0.1 + 0.2 * (i // 64) for i in range(130)]  # on no grid: 0.30000000000000004 is among them
    out = bytes([1, 1]) + number(130)
    out += integers(times, 3, START, [63, 63, 13], slope=1_000_000 << 16)
    out += number(3)
    out += bytes([1]) + piece(b"\0" + b"\1" + number(256) + integers(x, 0, 7, [5, 0, 6]))
    out += bytes([2]) + piece(b"\0" + b"\2" + number(10) + struct.pack("<d", 12.3) + integers(y, 2, y[0], [0, 63, 63]))
    # Of the temperatures every third is not valid.
    valid = [0 if i % 3 == 2 else 1 for i in range(130)]
    kept = [ordered(warm[i]) for i in range(130) if valid[i]]
    column = b"\1" + integers(valid, 0, 1, [0, 0, 0], flagged=(1,)) + b"\0" + integers(kept, 1, kept[0], [9, 20], flagged=(0, 1))
    out += bytes([3]) + piece(column)
    return sealed(out)


def samples():
    """Three blocks of 32 samples, 10 a second."""
    starts = [START, START + 3_200_000, START + 6_400_100]
    x = [(i * 37) % 201 - 100 for i in range(96)]
    y = [-32768 if i == 5 else 32767 if i == 6 else 0 for i in range(96)]
    out = bytes([1, 2]) + number(3) + b"\1" + struct.pack("<dd", 10.0, -0.0059)
    out += integers(starts, 1, START, [21])
    out += integers([32] * 3, 0, 32, [63])
    out += integers(x, 1, -100, [6, 6])
    out += integers(y, 0, 0, [9, 63], flagged=(0,))
    return sealed(out)


def rollup():
    """Four minutes, the third without a valid value, one missing before the last."""
    first = START // 60_000_000
    out = bytes([1, 3]) + number(4)
    out += integers([first, first + 1, first + 2, first + 4], 1, first, [0])
    out += integers([60, 60, 58, 7], 0, 60, [3])
    out += integers([60, 59, 0, 7], 0, 60, [4])
    out += b"\1" + number(10)
    out += integers([-25, -30, 4], 0, -25, [3])
    out += integers([10, 15, 0], 0, 0, [4])
    out += integers([80, 121, 0], 0, 0, [6])
    return sealed(out)


def tail():
    """A reading of sensor 300, a block of two samples of sensor 7."""
    reading = signed(START) + b"\1\1" + struct.pack("<d", -264.5) + b"\2\0" + b"\3\1" + struct.pack("<d", 21.0625)
    block = signed(START + 1) + b"\1" + struct.pack("<dd", 10.0, 0.5) + number(2)
    block += signed(-3) + signed(4) + signed(32767) + signed(-32768)
    return sealed(b"\1" + b"\1" + number(300) + piece(reading) + b"\2" + number(7) + piece(block))


def main():
    folder = pathlib.Path(__file__).parents[2] / "data" / "archive"
    for make in (readings, samples, rollup, tail):
        (folder / f"{make.__name__}.bin").write_bytes(make())


if __name__ == "__main__":
    main()
