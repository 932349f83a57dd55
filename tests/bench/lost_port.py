#!/usr/bin/env python3
"""What a port that vanishes costs: CPU of the process, the periods of the other ports, the time until data are back.

Usage: GORIZONT_BIN=build/dev/bin GORIZONT_TEST_DATA=tests/data python3 tests/bench/lost_port.py
Prints figures, judges nothing. The pauses are those of the manual's annex (PClose = PReOpen = 5 s).
"""
import datetime
import pathlib
import statistics
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "system"))
from site_under_test import Site, annex, free_port  # noqa: E402

GONE_AT = 30
GONE_FOR = 20
OTHER_PORTS = (1, 2, 11, 12, 13, 14)


def seconds(reading):
    return datetime.datetime.fromisoformat(reading["time"].replace("Z", "+00:00")).timestamp()


def periods(readings, begin, end):
    """Mean period of the sensors of the other ports between two times."""
    means = []
    for number in OTHER_PORTS:
        times = [seconds(r) for r in readings if r["number"] == number and begin <= seconds(r) < end]
        means.append((times[-1] - times[0]) / (len(times) - 1))
    return statistics.mean(means)


def main():
    with Site(annex(IPPort1=free_port()), faults=[f"gone=9:{GONE_FOR}@{GONE_AT}"]) as site:
        started = time.time()
        server = site.start()
        server.wait_until(lambda: site.last_readings().get(3, {}).get("status") == 0x2700, 90, "loss")
        lost = time.time()
        cpu = server.cpu_seconds()
        time.sleep(GONE_FOR - 4)
        share = (server.cpu_seconds() - cpu) / (time.time() - lost)
        site.wait_for(lambda last: last[3]["status"] == 0x0300, 60, "return")
        back = time.time()
        server.stop()
        readings = site.readings()
        before = periods(readings, started + 10, lost - 1)
        during = periods(readings, lost, back - 1)
        print(f"CPU of the process while the port is gone: {100 * share:.2f} % of a core")
        print(f"period of the other ports: {before:.4f} s before, {during:.4f} s during, ratio {during / before:.4f}")
        print(f"data again {back - lost - GONE_FOR:.1f} s after the port came back (PClose and PReOpen are 5 s)")
        lines = [line for line in site.file_text("log").splitlines() if "COM9" in line]
        print("journal:", *lines, sep="\n  ")


if __name__ == "__main__":
    main()
