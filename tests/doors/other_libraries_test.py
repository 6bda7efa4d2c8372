"""Programs that hold other libraries by the names of those that the engine needs: nobody gets the other's functions.

    other_libraries_test.py GLURAY LIBRARY_DIRECTORY CLIENTS_DIRECTORY [unittest arguments]
"""
from __future__ import annotations

import json
import pathlib
import re
import subprocess
import sys
import unittest

from manners import CLIENTS, GLURAY, LIBRARIES, Folder, run

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import private_libraries  # noqa: E402

DOORS = ("vendor", "preload")
EFFECTS = ("--engine", "always", "--set", "ao=on", "--set", "shadows=on")


def originals() -> list[str]:
    """DT_SONAMEs of the libraries whose copies the engine has, but those that the real OpenGL needs, too."""
    names = (p.name.removesuffix(private_libraries.NAME_SUFFIX) for p in (LIBRARIES / "private").iterdir())
    return sorted(name for name in names if not name.startswith("libz.so"))


def exports(name: str) -> set[str]:
    library = private_libraries.Elf(private_libraries.find(name, []))
    return {e for e in library.exports if re.fullmatch(r"[A-Za-z_]\w*", e)}


class OtherLibraries(Folder):
    def make(self, name: str, functions: set[str]) -> pathlib.Path:
        """A library of this DT_SONAME all of whose functions end the program."""
        folder = self.folder / "other"
        folder.mkdir(exist_ok=True)
        source = self.folder / "other.c"
        source.write_text("#include <stdlib.h>\n" + "".join(f"void {f}(void) {{ abort(); }}\n" for f in sorted(functions)))
        subprocess.run(["cc", "-shared", "-fPIC", "-O0", "-w", "-fno-builtin", f"-Wl,-soname,{name}", "-o", folder / name, source], check=True)
        return folder / name

    def everything(self) -> list[pathlib.Path]:
        """Other versions of all libraries that the engine needs."""
        runtime = {e for one in ("libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1")
                   for e in private_libraries.Elf(private_libraries.find(one, [])).exports}
        return [self.make(name, exports(name) - runtime) for name in originals()]

    def traced(self, *words, **environment):
        report = self.folder / "report.json"
        done = run(GLURAY, "--report", report, *words, **environment)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertGreater(json.loads(report.read_text())["triangles"]["traced"], 0)
        return done.stdout

    def test_copies_are_complete(self):
        """Nothing that the engine loads has a name of the system's, but the runtimes of C and C++."""
        for path in [LIBRARIES / "libgluray-engine.so", *(LIBRARIES / "private").iterdir()]:
            library = private_libraries.Elf(path)
            for name in library.needed:
                self.assertTrue(private_libraries.is_runtime(name) or (LIBRARIES / "private" / name).exists(), f"{path} needs {name}")
        self.assertTrue(any(name.startswith("libtbb.so") for name in originals()))
        self.assertTrue(any(name.startswith("libembree") for name in originals()))

    def test_program_with_other_versions_in_its_global_scope(self):
        others = ":".join(map(str, self.everything()))
        for door in DOORS:
            for client in ("door_linked_gl", "door_egl"):
                for more in ((), EFFECTS):
                    with self.subTest(door=door, client=client, more=more):
                        # Not before the launcher itself, which needs some of them.
                        self.traced("--door", door, *more, "--", "sh", "-c", f'LD_PRELOAD="$LD_PRELOAD:{others}" exec "$0"', CLIENTS / client)

    def test_program_that_opens_other_versions_later(self):
        names = originals()
        for name in names:
            self.make(name, {"marker"})
        for door in DOORS:
            with self.subTest(door=door):
                out = self.traced("--door", door, "--", "sh", "-c", f'LD_LIBRARY_PATH="$LD_LIBRARY_PATH:{self.folder}/other" exec "$0" "$@"',
                                  CLIENTS / "door_late_libraries", *names)
                self.assertEqual([line for line in out.splitlines() if line.startswith("opened")],
                                 [f"opened {self.folder}/other/{name}" for name in names])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
