"""The repair of what widl writes: a piece in the form of widl 7, one in the form of a later one, and a form that is neither."""
import importlib.util
import pathlib
import unittest

SCRIPT = pathlib.Path(__file__).parents[2] / "app/opc-da/idl/repair_proxy.py"
TYPES = """
/* 28 (LPWSTR *) */
        0x11, 0x14,\t\t/* FC_RP [allocated_on_stack] [pointer_deref] */
        NdrFcShort(0x2),\t/* Offset= 2 (32) */
/* 32 (LPWSTR) */
        0x13, 0x8,\t/* FC_OP [simple_pointer] */
"""


def piece(offset):
    return f'#include "rpcproxy.h"\n        NdrFcShort({offset:#x}),\t/* type offset = {offset} */\n' + TYPES


class RepairTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        spec = importlib.util.spec_from_file_location("repair_proxy", SCRIPT)
        cls.script = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(cls.script)

    def test_inner_pointer_becomes_the_outer(self):
        text = self.script.repaired(piece(32))
        self.assertIn("NdrFcShort(0x1c),\t/* type offset = 28 */", text)
        self.assertNotIn("type offset = 32", text)

    def test_right_one_stays(self):
        self.assertIn("NdrFcShort(0x1c),\t/* type offset = 28 */", self.script.repaired(piece(28)))

    def test_prototypes_follow_the_includes(self):
        first, second = self.script.repaired(piece(28)).splitlines()[:2]
        self.assertEqual(first, '#include "rpcproxy.h"')
        self.assertEqual(second, "")
        self.assertIn("IUnknown_AddRef_Proxy(IUnknown *This);", self.script.repaired(piece(28)))

    def test_unknown_form_is_refused(self):
        with self.assertRaises(SystemExit):
            self.script.repaired(piece(44))
        with self.assertRaises(SystemExit):
            self.script.repaired('#include "rpcproxy.h"\n')


if __name__ == "__main__":
    unittest.main()
