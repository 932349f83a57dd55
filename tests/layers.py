#!/usr/bin/env python3
"""Reads the includes of the source tree against the table of rooms: which room may see which.

The order of the rooms is the way of a reading, from the wire to the file and the socket; nothing looks back.
"""
import pathlib
import re
import sys

DEVICES = "core/devices"

# room: what it may include beside itself
ROOMS = {
    "core/values": [],
    "core/files": [],
    "core/config": ["core/values"],
    "core/protocol": ["core/values"],
    "core/line": ["core/values", "core/protocol"],
    DEVICES: ["core/values", "core/protocol", "core/line"],
    "core/engine": ["core/values", "core/line", "core/devices/driver.h", "core/devices/drivercatalog.h"],
    "core/registry": ["core/values"],
    "core/analysis": ["core/values"],
    "core/alarms": ["core/values", "core/config", "core/registry"],
    "core/history": ["core/values", "core/files", "core/config", "core/registry"],
    "core/archive": ["core/values", "core/files", "core/config", "core/registry"],
    "core/net": ["core/values"],
    "core/modbus": ["core/values", "core/config", "core/registry", "core/protocol", "core/net"],
    "core/adc24": ["core/values", "core/config", "core/registry", "core/protocol", "core/net"],
    "core/mqtt": ["core/values", "core/files", "core/config", "core/registry"],
    "core/metrics": ["core/values", "core/config", "core/registry"],
    "core/opc": ["core/values", "core/config", "core/registry", "core/net"],
    "core/export": ["core/values"],
    "core/simulation": [
        "core/values", "core/protocol/mbap.h", "core/line", "core/devices/simulateddevice.h", "core/devices/drivercatalog.h",
    ],
    "translations": [],
    "ui/plots": [
        "ui", "core/values", "core/config", "core/registry", "core/analysis", "core/history/historysource.h",
        "core/export/csvtable.h",
    ],
    "ui/service": [
        "ui", "core/values", "core/config", "core/registry", "core/engine/lineworker.h", "core/devices/addressscan.h",
        "core/devices/ind3/ind3dialect.h", "core/devices/ind3/ind3service.h", "core/devices/ind3/ind3values.h",
        "core/devices/and3/and3answers.h", "core/devices/and3/and3service.h", "core/devices/usmisn/usmisnfetch.h",
        "core/devices/usmisn/usmisnrecords.h", "core/devices/usmisn/usmisnservice.h", "core/devices/usmisn/usmisnvalues.h",
        "core/files/wholefile.h",
    ],
    "ui/history": ["ui", "core/values", "core/registry", "core/export"],
    "ui": [
        "core/values", "core/config", "core/registry", "core/alarms", "core/engine/lineworker.h", "core/net/clientinfo.h",
        "resources",
    ],
    "app": ["core", "ui", "translations", "resources"],
    "tests": ["app", "core", "ui", "tests", "translations"],
}
GUI = re.compile(r'#include <Q(Widget|Application|Icon|Pixmap|Color|Font|MessageBox|Gui|Painter|TreeView|Main)')
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def room_of(path):
    return max((room for room in ROOMS if path.startswith(room + "/")), key=len, default=None)


def may_include(path, included):
    room = room_of(path)
    if not included.startswith(tuple(r + "/" for r in ROOMS)):
        return included.endswith(".moc")
    if included.startswith(tuple(allowed for allowed in ROOMS[room])):
        return True
    if not included.startswith(room + "/"):
        return False
    if room != DEVICES:
        return True
    # A device sees its own folder and what lies at the root of the devices; only the catalog sees every device.
    folder = pathlib.PurePath(included).parent.as_posix()
    own = pathlib.PurePath(path).parent.as_posix()
    return folder in (DEVICES, own) or path.startswith(DEVICES + "/drivercatalog")


def complaints(root):
    for path in sorted(p for r in ROOMS for p in (root / r).rglob("*") if p.suffix in (".h", ".cpp")):
        name = path.relative_to(root).as_posix()
        if room_of(name) is None:
            continue
        text = path.read_text(encoding="utf-8")
        for included in INCLUDE.findall(text):
            if not may_include(name, included):
                yield f"{name} includes {included}"
        if name.startswith("core/") and GUI.search(text):
            yield f"{name} includes a part of the GUI"


def main():
    found = sorted(set(complaints(pathlib.Path(sys.argv[1]))))
    for line in found:
        print(line)
    print(f"{len(found)} includes cross a wall")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
