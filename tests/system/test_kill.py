"""`kill -9` while the program writes: every line is whole, and nothing that was due is missing."""
import random
import re
import signal
import time
import unittest

from site_under_test import Site, annex, free_port

RECORD = re.compile(r"\d\d:\d\d:\d\d \d\d\.\d\d\.\d\d\t[0-3]{4,}(\t[^\t\r\n]*){40}")
SAVE_INTERVAL = 0.1


class Kill(unittest.TestCase):
    def test_twenty_times(self):
        chance = random.Random(20)
        with Site(annex(IPPort1=free_port(), TmRun=50, TmSave=int(1000 * SAVE_INTERVAL))) as site:
            for run in range(20):
                before = site.file_text("data").count("\n")
                server = site.start()
                server.wait_until(lambda: site.file_text("data").count("\n") > before + 2, what="records")
                time.sleep(chance.uniform(0, 0.5))
                newest = time.time()
                server.stop(signal.SIGKILL)
                text = site.file_text("data")
                lines = text.split("\r\n")
                # The very last line may be cut off by the kill itself; the next start removes what is not whole.
                for line in lines[:-1]:
                    self.assertRegex(line, RECORD, f"run {run}")
                stamp = time.mktime(time.strptime(lines[-2][:17], "%H:%M:%S %d.%m.%y"))
                self.assertLess(newest - stamp, 1 + SAVE_INTERVAL + 2, f"run {run}")
            server = site.start()
            server.wait_until(lambda: site.file_text("data").count("\r\n") > len(lines), what="records")
            self.assertEqual(server.stop(), 0)
            for line in site.file_text("data").split("\r\n")[:-1]:
                self.assertRegex(line, RECORD)
            for x in (site.history / "Bin").glob("*X.wrd"):
                y = x.with_name(x.name.replace("X.wrd", "Y.wrd"))
                self.assertEqual(x.stat().st_size, y.stat().st_size, x.name)


if __name__ == "__main__":
    unittest.main()
