"""Wheels that are compressed again: tools/smaller_wheel.py. smaller_wheel_test.py [unittest arguments]"""
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))
from smaller_wheel import compress_again  # noqa: E402

MEMBERS = {"gluray/__init__.py": (b"x = 1\n" * 5000, 0o100644), "gluray-1.data/data/bin/gluray": (bytes(range(256)) * 300, 0o100755),
           "gluray/umlaut-\u00fc.txt": ("\u00fc" * 700).encode(), "empty": b"", "noise": zlib.compress(bytes(range(256)) * 4)}


def deflated(content: bytes) -> bytes:
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    return packer.compress(content) + packer.flush()


class SmallerWheel(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.old, self.new = self.folder / "old.whl", self.folder / "new.whl"
        with zipfile.ZipFile(self.old, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
            for name, content in MEMBERS.items():
                content, mode = content if isinstance(content, tuple) else (content, 0o100644)
                info = zipfile.ZipInfo(name, (2024, 2, 29, 23, 58, 58))
                info.external_attr = mode << 16
                info.compress_type = zipfile.ZIP_DEFLATED
                archive.writestr(info, content)

    def test_holds_the_same(self):
        compress_again(self.old, self.new, deflated)
        with zipfile.ZipFile(self.old) as old, zipfile.ZipFile(self.new) as new:
            self.assertIsNone(new.testzip())
            self.assertEqual(old.namelist(), new.namelist())
            for one, other in zip(old.infolist(), new.infolist()):
                self.assertEqual(old.read(one), new.read(other))
                for part in ("date_time", "external_attr", "create_system", "CRC", "file_size"):
                    self.assertEqual(getattr(one, part), getattr(other, part), part)
        self.assertLess(self.new.stat().st_size, self.old.stat().st_size)

    def test_stores_what_does_not_become_smaller(self):
        compress_again(self.old, self.new, lambda content: content + b"!")
        with zipfile.ZipFile(self.new) as new:
            self.assertEqual({info.compress_type for info in new.infolist()}, {zipfile.ZIP_STORED})
            self.assertIsNone(new.testzip())

    def test_other_programs_read_it(self):
        compress_again(self.old, self.new, deflated)
        subprocess.run(["cmake", "-E", "tar", "xf", self.new], cwd=self.folder, check=True)
        for name, content in MEMBERS.items():
            self.assertEqual((self.folder / name).read_bytes(), content[0] if isinstance(content, tuple) else content)
        self.assertTrue((self.folder / "gluray-1.data/data/bin/gluray").stat().st_mode & 0o100)

    def test_second_time_changes_nothing(self):
        compress_again(self.old, self.new, deflated)
        again = self.folder / "again.whl"
        compress_again(self.new, again, deflated)
        self.assertEqual(again.read_bytes(), self.new.read_bytes())


if __name__ == "__main__":
    unittest.main(verbosity=2)
