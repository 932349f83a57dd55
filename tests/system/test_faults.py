"""What goes wrong on a line: a port that vanishes, a sensor that falls silent, noise."""
import unittest

from site_under_test import ModbusClient, Site, annex, free_port, read_tilt


class Faults(unittest.TestCase):
    def test_a_port_that_vanishes_comes_back(self):
        port = free_port()
        with Site(annex(IPPort1=port, PReOpen=1000, PClose=1000, TmSave=1000), faults=["gone=9:4@5"]) as site:
            server = site.start()
            site.wait_for(lambda last: last.get(3, {}).get("status") == 0x0300, what="first answer")
            site.wait_for(lambda last: last[3]["status"] == 0x2700, what="loss")
            client = ModbusClient(port)
            channels, sensors = read_tilt(client, 8)
            self.assertIn(channels, (0b01_00, 0b10_00))  # the second port of the list
            self.assertEqual(sensors[2][3], 0x2700)
            self.assertNotEqual(sensors[2][:2], (0, 0))  # the last value stays
            self.assertEqual(sensors[0][3] & 0xF000, 0)  # the other ports go on
            client.close()
            site.wait_for(lambda last: last[3]["status"] == 0x0300, what="return")
            self.assertEqual(server.stop(), 0)
            log = site.file_text("log").splitlines()
            lost = [line for line in log if "COM9" in line]
            self.assertEqual([line[0] for line in lost], ["1", "3", "1"], lost)  # open, gone, open: one line each

    def test_a_silent_sensor_is_told_once_and_its_neighbour_goes_on(self):
        with Site(annex(IPPort1=free_port(), TORCom=100, NumRErrSrs=5), faults=["silent=3"]) as site:
            server = site.start()
            site.wait_for(lambda last: last.get(3, {}).get("status") == 0x3700, what="code 3")
            site.wait_for(lambda last: last.get(4, {}).get("status") == 0x0300, what="neighbour")
            before = len([r for r in site.readings() if r["number"] == 4])
            server.wait_until(
                lambda: len([r for r in site.readings() if r["number"] == 4]) > before + 3, what="neighbour goes on")
            self.assertEqual(server.stop(), 0)
            errors = [line for line in site.file_text("log").splitlines() if line.startswith("3") and "COM9" in line]
            self.assertEqual(len(errors), 1, errors)

    def test_the_journal_has_one_line_for_each_way_of_a_message(self):
        ini = annex(IPPort1=free_port(), TORCom=100, NumRErrSrs=5, TmRun=200)
        with Site(ini, faults=["silent=3@5-15", "gone=10:3@6"]) as site:
            server = site.start()
            site.wait_for(lambda last: last.get(3, {}).get("status") == 0x0300, what="first answer")
            site.wait_for(lambda last: last[3]["status"] == 0x3700, what="code 3")
            site.wait_for(lambda last: last[3]["status"] == 0x0300, what="return")
            site.wait_for(lambda last: last[1]["status"] & 0xF000 == 0 and "tiltX" in last[1], what="port")
            self.assertEqual(server.stop(), 0)
            log = site.file_text("log").splitlines()
            # What a dispatcher reads: the sensor falls silent and works again; the port goes and comes, its two
            # sensors say nothing of their own.
            sensor = [line[0] for line in log if "COM9" in line and "№ 3" in line]
            self.assertEqual(sensor, ["3", "1"], log)
            port = [line[0] for line in log if "COM10" in line and "№" not in line]
            self.assertEqual(port, ["1", "3", "1"], log)
            self.assertEqual([line for line in log if "COM10" in line and "№" in line and line[0] == "3"], [], log)

    def test_noise_does_not_stop_the_readings(self):
        faults = ["crc=10", "garbage=20", "pieces=50"]
        with Site(annex(IPPort1=free_port(), SCRCErrors=10, TmRun=200), faults=faults) as site:
            server = site.start()
            server.wait_until(
                lambda: all(
                    len([r for r in site.readings() if r["number"] == number and "tiltX" in r]) > 10
                    for number in (1, 2, 3, 4, 11, 12, 13, 14)),
                seconds=90, what="readings of all sensors")
            self.assertEqual(server.stop(), 0)
            values = [r["tiltX"] for r in site.readings() if r["number"] == 3 and "tiltX" in r]
            self.assertLess(max(values) - min(values), 60, values)  # noise never became a value

    def test_a_restarted_sensor_is_acknowledged(self):
        with Site(annex(IPPort1=free_port(), TmRun=200), faults=["reboot=1@6"]) as site:
            server = site.start()
            site.wait_for(lambda last: last.get(1, {}).get("rawStatus", 0) & 1 == 1, what="first acknowledgement")
            server.wait_until(
                lambda: len([r for r in site.readings() if r["number"] == 1 and r["status"] & 0x20]) >= 2,
                what="restart seen")
            site.wait_for(lambda last: last[1]["status"] & 0x20 == 0, what="acknowledged")
            self.assertEqual(server.stop(), 0)


if __name__ == "__main__":
    unittest.main()
