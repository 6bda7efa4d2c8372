"""Checks of the built libraries: link_check.py CHECK LIBRARY [NAMES].

exports LIBRARY NAMES...   exactly these symbols are exported
preload-exports LIBRARY    every entry point of OpenGL, GLX, EGL and OSMesa that the registries know, and dlopen; no other
no-constructors LIBRARY    loading the library runs no code of ours
libc-only LIBRARY          needs libc and nothing else
nodelete LIBRARY           stays in memory once loaded
without-integrators ARCHIVE  the kernels of the local look name no integrator
silent LIBRARY             preloaded into /bin/true: no output; prints its cost in time
"""
from __future__ import annotations

import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tools"))
from command_line import Parser  # noqa: E402


def output(*command: str, **more) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True, **more).stdout


def exported(library: str) -> set[str]:
    return {line.split()[-1] for line in output("nm", "-D", "--defined-only", library).splitlines()}


def compare(got: set[str], wanted: set[str]) -> str:
    """Empty when equal. Sanitized builds export names of their runtime, which all start with underscores."""
    surplus = {name for name in got - wanted if not name.startswith("__")}
    return "; ".join(f"{what}: {' '.join(sorted(names)[:10])}" for what, names in
                     (("missing", wanted - got), ("surplus", surplus)) if names)


def exports(library: str, *names: str) -> str:
    return compare(exported(library), set(names))


def preload_exports(library: str) -> str:
    import c_headers
    import doors
    import glxml
    every = [*glxml.desktop_gl(), *glxml.load("glx", ("glx",)), *c_headers.egl(), *c_headers.osmesa()]
    wanted = {c.name for c in every if not any(p.type in doors.UNKNOWN_TO_ANY_HEADER for p in c.params)}
    core = {"glVertex3f", "glXSwapBuffers", "eglSwapBuffers", "OSMesaMakeCurrent", "glXGetProcAddressARB", "glDrawElements"}
    return compare(exported(library), wanted | core | {"dlopen"})


def without_integrators(archive: str) -> str:
    """Virtual calls need no symbol: whatever names an integrator's class or its maker reaches into light transport."""
    listed = output("nm", "-A", "-C", "--undefined-only", archive)
    kernels = [line for line in listed.splitlines() if "kernels.cpp.o:" in line]
    if not kernels:
        return "has no kernels"
    names = ("Integrator", "AmbientOcclusion", "SurfaceLight", "Shadow", "Relit", "Occluders", "Transmittance", "occluded(")
    return "; ".join(line.split(":", 2)[2].strip() for line in kernels if any(name in line for name in names))


def no_constructors(library: str) -> str:
    """One entry is allowed: frame_dummy, which the compiler's start files put into every library. .init is theirs too."""
    sections = output("readelf", "-SW", library)
    found = re.search(r"\.init_array\s+INIT_ARRAY\s+\S+\s+\S+\s+([0-9a-f]+)", sections)
    entries = int(found.group(1), 16) // 8 if found else 0
    if re.search(r"\.preinit_array|\.ctors\s", sections):
        return "has .preinit_array or .ctors"
    return f"{entries} load-time constructors" if entries > 1 else ""


def libc_only(library: str) -> str:
    needed = set(re.findall(r"NEEDED.*\[(.*)\]", output("readelf", "-d", library)))
    surplus = {n for n in needed if not re.match(r"(libc|ld-linux.*)\.so", n)}
    listed = {line.split()[0] for line in output("ldd", library).splitlines()}
    surplus |= {n for n in listed if not re.match(r"(linux-vdso|libc|/.*/ld-linux.*)\.so", n)}
    return f"needs {' '.join(sorted(surplus))}" if surplus else ""


def nodelete(library: str) -> str:
    return "" if "NODELETE" in output("readelf", "-d", library) else "is not linked with -z nodelete"


def silent(library: str) -> str:
    def run(environment: dict[str, str]) -> tuple[float, str]:
        start = time.perf_counter()
        done = subprocess.run(["/bin/true"], env=environment, capture_output=True, text=True, check=True)
        return time.perf_counter() - start, done.stdout + done.stderr

    plain = {k: v for k, v in os.environ.items() if k != "LD_PRELOAD"}
    loaded = plain | {"LD_PRELOAD": library}
    times: dict[bool, list[float]] = {False: [], True: []}
    for _ in range(60):  # interleaved, so that a busy machine slows both alike
        for ours in times:
            seconds, text = run(loaded if ours else plain)
            times[ours].append(seconds)
            if ours and text:
                return f"printed {text!r}"
    cost = statistics.median(times[True]) - statistics.median(times[False])
    print(f"costs {cost * 1000:.2f} ms a process (goal: below 1 ms)")
    return ""


CHECKS = {"exports": exports, "preload-exports": preload_exports, "no-constructors": no_constructors,
          "libc-only": libc_only, "nodelete": nodelete, "silent": silent,
          "without-integrators": without_integrators}

if __name__ == "__main__":
    parser = Parser(__doc__)
    parser.add_argument("check", metavar="CHECK", choices=CHECKS)
    parser.add_argument("library", metavar="LIBRARY")
    parser.add_argument("names", metavar="NAMES", nargs="*")
    given = parser.parse_args()
    if problem := CHECKS[given.check](given.library, *given.names):
        sys.exit(f"{given.library}: {problem}")
