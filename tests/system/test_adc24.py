"""ADC24 TCP against the binary files that are written meanwhile: both show the raw samples of one axis."""
import struct
import time
import unittest

from site_under_test import Adc24Client, Site, annex, free_port


def pairs(site, number, axis):
    """The samples of each binary file of an axis, in the order of their times."""
    files = sorted((site.history / "Bin").glob(f"*_{number}{axis}.wrd"))
    return [[value for value, in struct.iter_unpack("<h", path.read_bytes())] for path in files]


def wait(site, condition, seconds=120, what="condition"):
    """As Program.wait_until(), for what shows in files and sockets and not in lines."""
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, f"{what} not reached in {seconds} s"
        assert site.server.process.poll() is None, site.server.errors[-20:]
        time.sleep(0.2)


class Adc24(unittest.TestCase):
    def test_serves_the_first_accelerometer_while_it_is_saved(self):
        port = free_port()
        with Site(annex(IPPort1=free_port(), IPPort2=port)) as site:
            site.start()
            wait(site, lambda: any(len(file) >= 128 for file in pairs(site, 1, "X")), what="samples in the file")
            client = Adc24Client(port)
            wait(site, lambda: client.available() >= 128, what="samples in the ring")
            served = client.samples(50)
            self.assertGreaterEqual(len(served), 100)
            one_by_one = [client.block(number, 1)[0] for number in range(20)]
            self.assertEqual(one_by_one, served[:20])
            wait(site, lambda: len(pairs(site, 1, "X")[-1]) >= len(served), what="the file catches up")
            self.assertEqual(pairs(site, 1, "X")[-1][:len(served)], served)
            self.assertGreater(len(set(served)), 5)  # a building that moves
            self.assertNotEqual(pairs(site, 1, "Y")[-1][:len(served)], served)
            self.assertIsNone(client.block(0xFFFFFFFF, 0xFFFFFFFF))
            self.assertIsNone(client.block(client.available() + 1000, 1))
            client.close()
            self.assertEqual(site.server.stop(), 0)
            log = site.file_text("log")
            self.assertEqual(log.count("ADC24 TCP"), 3, log)  # serving, a client, and the end

    def test_begins_anew_with_the_files_when_the_chosen_sensor_restarts(self):
        port = free_port()
        ini = annex(IPPort1=free_port(), IPPort2=port) + "\r\n[ADC24]\r\nSensor=12\r\nAxis=Y\r\n"
        with Site(ini, faults=["reboot=12@25"]) as site:
            site.start()
            site.wait_for(lambda last: 12 in last)
            client = Adc24Client(port)
            before = 0

            def has_restarted():
                nonlocal before
                now = client.available()
                before, has_fallen = now, now < before
                return has_fallen

            wait(site, has_restarted, what="fewer samples than before")
            wait(site, lambda: client.available() >= 64, what="samples after the restart")
            served = client.samples(32)
            wait(site, lambda: len(pairs(site, 12, "Y")[-1]) >= len(served), what="the file catches up")
            files = pairs(site, 12, "Y")
            self.assertGreaterEqual(len(files), 2)
            self.assertEqual(files[-1][:len(served)], served)
            client.close()
            self.assertEqual(site.server.stop(), 0)


if __name__ == "__main__":
    unittest.main()
