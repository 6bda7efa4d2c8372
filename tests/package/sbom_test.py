"""The bill of materials: tools/sbom.py. sbom_test.py [unittest arguments]"""
import hashlib
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))
from private_libraries import find  # noqa: E402


class Sbom(unittest.TestCase):
    def test_names_each_copy_once(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            private = folder / "tree/lib/gluray/private"
            private.mkdir(parents=True)
            copied = ("libz.so.1", "libstdc++.so.6")
            for library in copied:
                shutil.copy(find(library, []), private / f"{library}-gluray")
            (private / "libgluray-substitutes.so").write_bytes(b"ours")
            command = [sys.executable, "-B", ROOT / "tools/sbom.py", "--tree", folder / "tree", "--version", "1.2", "--created", "86400"]
            for file in ("one.json", "two.json"):
                subprocess.run([*command, "--out", folder / file], check=True)
            self.assertEqual((folder / "one.json").read_bytes(), (folder / "two.json").read_bytes())
            bill = json.loads((folder / "one.json").read_text())
            self.assertEqual((bill["spdxVersion"], bill["creationInfo"]["created"]), ("SPDX-2.3", "1970-01-02T00:00:00Z"))
            by_name = {package["name"]: package for package in bill["packages"]}
            self.assertEqual(by_name["gluray"]["versionInfo"], "1.2")
            self.assertFalse(any("substitutes" in package for package in by_name))
            for library in copied:
                digest = hashlib.sha256((private / f"{library}-gluray").read_bytes()).hexdigest()
                self.assertEqual(by_name[library]["checksums"], [{"algorithm": "SHA256", "checksumValue": digest}])
                self.assertNotEqual(by_name[library]["licenseConcluded"], "NOASSERTION")
            identities = [package["SPDXID"] for package in bill["packages"]]
            self.assertEqual(len(identities), len(set(identities)))
            related = {relation["relatedSpdxElement"] for relation in bill["relationships"]}
            self.assertEqual(related, set(identities))


if __name__ == "__main__":
    unittest.main(verbosity=2)
