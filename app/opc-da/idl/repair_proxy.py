#!/usr/bin/env python3
"""Mends what widl 7 and 8 write for `[out, string] LPWSTR *`, in place: repair_proxy.py FILE_p.c.

The parameter has to name the reference pointer (FC_RP) that leads to the string's own pointer; these versions name the inner
pointer, four bytes further, and the client gets NULL without an error. A newer widl has nothing to mend.
"""
import pathlib
import re
import sys

REFERENCE = re.compile(
    r"/\* (?P<at>\d+) \(LPWSTR \*\) \*/\s+"
    r"0x11, 0x14,\s+/\* FC_RP \[allocated_on_stack\] \[pointer_deref\] \*/\s+"
    r"NdrFcShort\(0x2\),\s+/\* Offset= 2 \((?P<inner>\d+)\) \*/")
PARAMETER = re.compile(r"NdrFcShort\(0x[0-9a-f]+\),\t/\* type offset = (\d+) \*/")
PROXY_PROTOTYPES = """
/* The C view of unknwn.h lacks these three. */
HRESULT __stdcall IUnknown_QueryInterface_Proxy(IUnknown *This, REFIID riid, void **ppvObject);
ULONG __stdcall IUnknown_AddRef_Proxy(IUnknown *This);
ULONG __stdcall IUnknown_Release_Proxy(IUnknown *This);
"""


def repaired(text):
    outer_of = {int(m["inner"]): int(m["at"]) for m in REFERENCE.finditer(text)}

    def point_at_outer(match):
        offset = int(match[1])
        if offset not in outer_of:
            return match[0]
        return f"NdrFcShort({outer_of[offset]:#x}),\t/* type offset = {outer_of[offset]} */"

    text = PARAMETER.sub(point_at_outer, text)
    used = {int(offset) for offset in PARAMETER.findall(text)}
    unused = sorted(at for at in outer_of.values() if at not in used)
    if unused or not outer_of:
        raise SystemExit(f"the output of widl has another form than expected: string pointers at {unused} lead nowhere")
    last_include = text.rindex("#include")
    end_of_line = text.index("\n", last_include) + 1
    return text[:end_of_line] + PROXY_PROTOTYPES + text[end_of_line:]


def main():
    path = pathlib.Path(sys.argv[1])
    path.write_text(repaired(path.read_text()))


if __name__ == "__main__":
    main()
