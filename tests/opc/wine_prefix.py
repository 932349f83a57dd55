"""A Windows of its own for a test: a fresh prefix of Wine without a display, and programs that run in it.

A server that COM starts inherits the output of its client, so outputs are files: the end of a pipe would never come.
"""
import os
import pathlib
import shutil
import subprocess
import time

BOOT_SECONDS = 180


def missing():
    """What is not installed, in words; None when all is there."""
    absent = [program for program in ("wine", "wineserver") if not shutil.which(program)]
    return f"{' and '.join(absent)} is not installed" if absent else None


class Prefix:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.environment = {
            **{name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")},
            "WINEPREFIX": str(self.folder / "prefix"), "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml=;winemenubuilder.exe=d",
            "WINEARCH": "win64", "LC_ALL": "C.UTF-8"}
        self.log = (self.folder / "wine.log").open("ab")
        self._call(["wine", "wineboot", "--init"], BOOT_SECONDS)
        # What the first start has begun must have ended: a COM server that is started meanwhile is never found.
        self._call(["wineserver", "-w"], BOOT_SECONDS)

    def close(self):
        subprocess.run(["wineserver", "-k"], env=self.environment, timeout=60, check=False)
        self.log.close()

    def _call(self, command, seconds):
        return subprocess.run(command, env=self.environment, stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log,
                              timeout=seconds, check=False).returncode

    def run(self, program, *arguments, seconds=60):
        """Runs to the end and gives the exit code."""
        return self._call(["wine", str(program), *arguments], seconds)

    def start(self, program, *arguments, output):
        with open(output, "wb") as target:
            return subprocess.Popen(["wine", str(program), *arguments], env=self.environment, stdin=subprocess.DEVNULL,
                                    stdout=target, stderr=self.log)

    def registry(self):
        """The text of all classes, of the machine and of the user."""
        texts = []
        for root in ("HKEY_LOCAL_MACHINE\\Software\\Classes", "HKEY_CURRENT_USER\\Software\\Classes"):
            file = self.folder / f"registry{len(texts)}.reg"
            file.unlink(missing_ok=True)
            # A root that holds nothing is not written at all.
            self.run("regedit", "/E", f"Z:{file}", root)
            texts.append(file.read_text(encoding="utf-16") if file.exists() else "")
        return "\n".join(texts)

    def windows_path(self, path):
        return "Z:" + str(pathlib.Path(path).resolve()).replace("/", "\\")


class Conversation:
    """A client that runs in a prefix: its lines as they come, and what it asks for (`do …`) done meanwhile."""

    def __init__(self, prefix, program, words, output, deeds, name):
        self.output = pathlib.Path(output)
        self.process = prefix.start(program, *words, output=output)
        self.deeds = deeds
        self.name = name
        self.lines = []
        self.position = 0

    def _read(self):
        data = self.output.read_bytes()[self.position:]
        whole = data[:data.rfind(b"\n") + 1]
        self.position += len(whole)
        return whole.decode("utf-8", "replace").splitlines()

    def finish(self, seconds):
        """The lines of a client that has said `end N` and left; raises when it does not in time."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            is_over = self.process.poll() is not None
            for line in self._read():
                self.lines.append(line)
                word, _, rest = line.partition(" ")
                if word == "do":
                    self.deeds(self, rest)
                elif word == "note":
                    print(line)
            if is_over:
                return self.lines
            time.sleep(0.02)
        self.process.kill()
        raise AssertionError(f"{self.name} has not ended in {seconds} s; its last lines: {self.lines[-5:]}")
