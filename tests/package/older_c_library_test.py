"""Libraries and programs for older C libraries: tools/older_c_library.py and src/portable.

    older_c_library_test.py [unittest arguments]
"""
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))
from elf_library import Elf, Unsupported  # noqa: E402
from older_c_library import OlderCLibrary, number  # noqa: E402
from private_libraries import find  # noqa: E402

PORTABLE = ROOT / "src/portable"
NEW_CALLS = """
    #define _GNU_SOURCE
    #include <dlfcn.h>
    #include <math.h>
    #include <pthread.h>
    #include <stdio.h>
    #include <string.h>
    #include <sys/stat.h>
    #include <time.h>
    #include <unistd.h>
    static void* work(void* result) { *(int*)result = gettid(); return NULL; }
    int check(const char* file) {
      int thread = 0;
      pthread_t one;
      pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
      pthread_cond_t condition = PTHREAD_COND_INITIALIZER;
      struct timespec start, end, until;
      struct stat known, linked;
      if (pthread_create(&one, NULL, work, &thread) || pthread_join(one, NULL) || thread == gettid() || !thread) return 1;
      if (!dlsym(RTLD_DEFAULT, "printf") || pow(3.0, strlen(file) ? 2.0 : 1.0) != 9.0 || hypot(3.0, 4.0) != 5.0) return 2;
      if (stat(file, &known) || known.st_size != 7 || !S_ISREG(known.st_mode)) return 3;
      if (lstat(file, &linked) || linked.st_ino != known.st_ino) return 4;
      if (stat("/nowhere/at/all", &known) != -1) return 5;
      clock_gettime(CLOCK_MONOTONIC, &start);
      until = start;
      until.tv_nsec += 120000000;
      if (until.tv_nsec >= 1000000000) until.tv_nsec -= 1000000000, ++until.tv_sec;
      pthread_mutex_lock(&mutex);
      while (pthread_cond_clockwait(&condition, &mutex, CLOCK_MONOTONIC, &until) == 0) {}
      clock_gettime(CLOCK_MONOTONIC, &end);
      return (end.tv_sec - start.tv_sec) * 1e3 + (end.tv_nsec - start.tv_nsec) / 1e6 < 100 ? 6 : 0;
    }
"""


class OlderCLibraryTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.substitutes = self.folder / "libsubstitutes.so"
        self.compile("-shared", "-fPIC", "-fvisibility=hidden", "-DGLURAY_EXPORTED", "-Wl,-soname,libsubstitutes.so", PORTABLE / "substitutes.c",
                     to=self.substitutes)

    def compile(self, *words, to: pathlib.Path, compiler="cc") -> pathlib.Path:
        subprocess.run([compiler, "-O1", "-o", str(to), *map(str, words)], check=True)
        return to

    def source(self, name: str, text: str) -> pathlib.Path:
        path = self.folder / name
        path.write_text(textwrap.dedent(text))
        return path

    def c_library(self, newest: str) -> OlderCLibrary:
        return OlderCLibrary(number(f"GLIBC_{newest}"), [Elf(find(name, [])) for name in ("libc.so.6", "libm.so.6")], Elf(self.substitutes))

    def suited(self, path: pathlib.Path, newest: str = "2.28") -> Elf:
        older, elf = self.c_library(newest), Elf(path)
        elf.rename({}, older.suit(elf))
        elf.look_in("$ORIGIN")
        elf.save(path)
        self.assertEqual(older.newer(Elf(path)), [])
        return Elf(path)

    def test_functions_that_moved_or_are_new(self):
        library = self.compile("-shared", "-fPIC", "-fno-builtin", self.source("new.c", NEW_CALLS), "-lm", to=self.folder / "libnew.so")
        self.assertTrue(self.c_library("2.28").newer(Elf(library)))
        elf = self.suited(library)
        for needed in ("libpthread.so.0", "libdl.so.2", "libsubstitutes.so"):
            self.assertIn(needed, elf.needed)
        main = self.source("main.c", "int check(const char*); int main(int n, char** words) { return check(words[1]); }")
        program = self.compile(main, library, f"-Wl,-rpath,{self.folder}", to=self.folder / "program")
        self.source("file", "7 bytes")
        self.assertEqual(subprocess.run([program, self.folder / "file"]).returncode, 0)
        self.assertEqual(subprocess.run(["readelf", "-V", library], capture_output=True, text=True).stderr, "")

    def test_function_that_is_missing_is_named(self):
        library = self.compile("-shared", "-fPIC", self.source("new.c", NEW_CALLS), "-lm", to=self.folder / "libnew.so")
        with self.assertRaisesRegex(Unsupported, r"pthread_create \(GLIBC_2.*\)"):
            older = self.c_library("2.1")
            older.suit(Elf(library))

    def test_program_constructs_its_objects_once(self):
        source = self.source("main.cpp", """
            #include <cstdio>
            #include <cstdlib>
            struct Object { Object() { std::puts("made"); } ~Object() { std::puts("gone"); } } object;
            int main(int n, char** words) { std::printf("%d %s %s\\n", n, words[1], std::getenv("WORD")); return 3; }
        """)
        start = self.compile("-c", "-fPIC", PORTABLE / "start.c", to=self.folder / "start.o")
        program = self.compile(source, start, "-Wl,-e,glurayStart", to=self.folder / "program", compiler="c++")
        for _ in range(2):
            done = subprocess.run([program, "one"], capture_output=True, text=True, env={"WORD": "two"})
            self.assertEqual((done.returncode, done.stdout.split("\n")), (3, ["made", "2 one two", "gone", ""]))
            self.suited(program)
        self.assertNotIn("GLIBC_2.34", subprocess.run(["objdump", "-T", program], capture_output=True, text=True).stdout)


if __name__ == "__main__":
    unittest.main(verbosity=2)
