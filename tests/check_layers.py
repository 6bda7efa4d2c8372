#!/usr/bin/env python3
"""Checks the boundaries between rooms: which room may include which, in which order the folders of a room include each other,
which rooms may include certain libraries, how long a file may be, how many a folder may hold. ARCHITECTURE.md describes the rooms; this file holds the rules.

check_layers.py ROOT        checks the source tree at ROOT; prints each violation and exits 1 where there is one
check_layers.py --self-test plants violations of every rule in a small tree and fails if it misses one
"""
import collections
import pathlib
import re
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "tools"))
from command_line import Parser  # noqa: E402

# The rooms that each room under src/ may include.
ALLOWED = {
    "base": set(),
    "parallel": {"base"},
    "settings": {"base"},
    "scene": {"base", "settings"},
    "gl": {"base", "settings", "scene", "parallel"},
    "accel": {"base", "settings", "scene", "parallel"},
    "render": {"base", "settings", "scene", "parallel", "accel"},
    "frame": {"base", "settings", "scene", "parallel", "accel", "render"},
    "control": {"base", "settings"},
    "cluster": {"base", "settings", "scene", "parallel", "accel", "render", "frame", "control"},
    "saved": {"base", "settings", "scene", "parallel", "accel", "render", "frame", "control", "cluster"},
    "intercept": {"base", "settings", "scene", "parallel", "gl", "accel", "render", "frame", "control", "cluster", "saved"},
    "osmesa": {"intercept"},  # its header of OSMesa's interface alone
}
# The folders of a room in a fixed order: each includes only itself and those before it, so that there is no circle among them.
# A nested folder is a folder of its own ("outer/inner"); "" is the room itself. Folders named testing, whose headers tests alone
# include, have no place in the order, nor have *_test.cpp.
FOLDERS = {
    "base": ["processes", ""],
    "settings": ["", "layers", "live"],
    "frame": ["tracing", "refinement", "idle", "images", "pixels", "questions"],
    "accel": ["memory", "rays", "device", "impostors", "queries", "blocks", "meshes", "pages", "cache", "volumes", ""],
    "render": ["tiles", "camera", "local", "edges", "bsdf", "sampling", "resolve", "lights", "media", "frame_data", "shading", "hit_points", "remote",
               "integrators", "moving", "paths", "ground", "effects", "packets", "visibility", "layers", "kernels", "volumes", "volume_light", "", "exposure"],
    "gl": ["basics", "real", "welding", "capture", "glsl", "glsl/parser", "glsl/functions", "families", "families/built_in", "families/files", "programs", "trials",
           "clock", "buffers", "sharing", "arrays", "textures", "program_state", "state", "shadow", "impostors", "batch", "objects",
           "views", "history", "counts", "framebuffers", "pending", "layers", "window", "flush", "classify", "draws", "volumes",
           "culled/trials", "culled/shader_slice", "culled/clusters", "culled/small", "culled/feedback", "culled/instances", "culled", "context",
           "commands"],
    "control": ["", "messages", "auth", "connection", "client", "link/program", "link", "hub", "hub/server"],
    "cluster": ["stream", "messages", "local", "ranks", "ranks/mpi", "program", "arrays", "shares", "pages", "peers", "gather",
                "worker/facts", "worker/moving", "worker"],
    "saved": ["exr", "sections", "scene", "shot", "export/arrays", "export/gather", "export/formats", "export", "layers", "view", "program"],
    "intercept": ["doors", "stubs", "probe", "session", "window_systems", "present/state", "present/read_back", "present/write_back",
                  "present/raster", "present", "tracing", "hud", "windows", "contexts", "reports", "control", "capture", "frames", "hooks", ""],
}
# Name of the monopoly, pattern of its headers, folders that may include them. Holds for tests beside the code, too.
MONOPOLIES = [
    ("Embree", r"embree\d*/", ["src/accel"]),
    ("X11, GLX and EGL", r"(X11|xcb|EGL|glvnd)/|GL/glx", ["src/intercept", "src/osmesa", "apps"]),
    ("dlfcn", r"dlfcn\.h$", ["src/intercept", "src/osmesa", "apps", "src/frame/refinement/oidn_library.cpp", "src/parallel/visible_joins.cpp"]),
    # guarded_write.h opens none, but standard error may be one.
    ("sockets", r"(sys/(socket|un)\.h|netinet/|arpa/|netdb\.h|asio)", ["src/control", "src/cluster", "apps", "src/base/guarded_write.h"]),
    ("MPI", r"mpi\.h$", ["src/cluster"]),
]
MPI_FILES = 1  # number of files in cluster/ that may include mpi.h
MAX_LINES = 300
MAX_FILES = 40  # of code in a folder
CODE = {".c", ".cpp", ".h", ".hpp", ".S"}
MEASURED = CODE | {".py"}
TREES = ["apps", "bench", "examples", "python", "scenes", "scripts", "src", "tests", "tools"]
INCLUDE = re.compile(r'^\s*#\s*(?:include|include_next)\s*([<"])([^>"]+)[>"]', re.MULTILINE)
MODULE = re.compile(r"gluray_module\(\s*\w+([^)]*)\)")


def within(path, folder):
    return path == folder or path.startswith(folder + "/")


def room_violations(path, includes):
    """Includes of a file in src/ROOM/ from rooms that it may not include."""
    room = path.split("/")[1]
    for quote, header in includes:
        if quote == '"' and header.startswith(".."):
            yield f'{path}: "{header}": name headers from the root of src/, not by ..'
        target = header.split("/")[0]
        if target in ALLOWED and "/" in header and target != room and target not in ALLOWED.get(room, set()):
            yield f'{path}: room {room} may not include "{header}": it may include {sorted(ALLOWED.get(room, []))}'


def is_for_tests(path):
    return path.endswith("_test.cpp") or "/testing/" in path


def folder_in(path):
    """The folder of src/ROOM/FOLDER/FILE, or of the ROOM/FOLDER/FILE of an include, within its room."""
    return path.removeprefix("src/").partition("/")[2].rpartition("/")[0]


def order_violations(path, includes, folders):
    """Includes of a file in src/ROOM/ against the order of the room's folders."""
    room = path.split("/")[1]
    if room not in folders or is_for_tests(path):
        return
    name = path.rpartition("/")[2]
    if name.startswith(("fake_", "test_")):
        yield f"{path}: headers for tests belong into a folder testing"
    order, folder = folders[room], folder_in(path)
    if folder not in order:
        yield f"{path}: folder {folder or room} has no place in the order of room {room}"
        return
    for quote, header in includes:
        if quote != '"' or not header.startswith(room + "/"):
            continue
        target = folder_in(header)
        if is_for_tests(header):
            yield f'{path}: "{header}" is for tests alone'
        elif target in order and order.index(target) > order.index(folder):
            yield f'{path}: folder {folder or room} may not include "{header}": {target or room} comes after it'


def unused_folders(root, folders):
    """Folders that have a place in the order of their room but hold no code."""
    for room, order in folders.items():
        for folder in order:
            files = (root / "src" / room / folder).glob("*")
            if (root / "src" / room).is_dir() and not any(file.suffix in CODE for file in files):
                yield f"src/{room}/{folder}: the order of room {room} names a folder without code"


def crowd_violations(root):
    """Folders with too many files, and headers under src/ whose names others have."""
    crowds, headers = collections.Counter(), collections.defaultdict(list)
    for tree in TREES:
        for file in sorted((root / tree).rglob("*")):
            path = file.relative_to(root).as_posix()
            if file.suffix in MEASURED and "__pycache__" not in path:
                crowds[path.rpartition("/")[0]] += 1
            if tree == "src" and file.suffix in (".h", ".hpp"):
                headers[file.name].append(path)
    for folder, files in sorted(crowds.items()):
        if files > MAX_FILES:
            yield f"{folder}: {files} files; a folder is split at {MAX_FILES}"
    for name, paths in sorted(headers.items()):
        if len(paths) > 1:
            yield f"{' and '.join(paths)} have one name"


def monopoly_violations(path, includes):
    for name, pattern, holders in MONOPOLIES:
        if any(within(path, holder) for holder in holders):
            continue
        for _, header in includes:
            if re.match(pattern, header):
                yield f"{path}: includes {header}: {name} belongs to {' and '.join(holders)} alone"


def module_violations(path, text):
    """DEPS of gluray_module() that the room may not have."""
    room = path.split("/")[1]
    for arguments in MODULE.findall(text):
        words = arguments.split()
        start = words.index("DEPS") + 1 if "DEPS" in words else len(words)
        for word in words[start:]:
            if word.isupper():
                break
            if word in ALLOWED and word != room and word not in ALLOWED.get(room, set()):
                yield f"{path}: room {room} may not depend on {word}"


def violations(root, folders):
    """All violations of the tree at `root`, as lines to print. `folders`: as FOLDERS."""
    yield from crowd_violations(root)
    mpi_files = []
    yield from unused_folders(root, folders)
    for tree in TREES:
        for file in sorted((root / tree).rglob("*")):
            path = file.relative_to(root).as_posix()
            if not file.is_file() or "__pycache__" in path:
                continue
            if file.name == "CMakeLists.txt" and within(path, "src"):
                yield from module_violations(path, file.read_text())
            if file.suffix not in MEASURED:
                continue
            text = file.read_text(errors="replace")
            lines = text.count("\n")
            if lines > MAX_LINES:
                yield f"{path}: {lines} lines; a file is split at {MAX_LINES}"
            if file.suffix not in CODE or not (within(path, "src") or within(path, "apps")):
                continue
            includes = INCLUDE.findall(text)
            yield from monopoly_violations(path, includes)
            if within(path, "src") and path.count("/") >= 2:
                yield from room_violations(path, includes)
                yield from order_violations(path, includes, folders)
            if within(path, "src/cluster") and any(header == "mpi.h" for _, header in includes):
                mpi_files.append(path)
    if len(mpi_files) > MPI_FILES:
        yield f"mpi.h is included by {', '.join(mpi_files)}; one file may"


# The order of folders in the valid tree.
ORDERED = {"render": ["tiles", "tiles/rows", "kernels", ""]}
# A valid tree, and changes to it that must be reported: file, new content (None: the file is gone), words that the report must
# contain.
SOUND = {
    "src/base/log.h": "#pragma once\n#include <string>\n",
    "src/gl/context/context.cpp": '#include "gl/context/context.h"\n#include "scene/mesh.h"\n#include <GL/gl.h>\n',
    "src/accel/device/embree.h": "#include <embree3/rtcore.h>\n",
    "src/render/tiles.cpp": '#include "accel/tlas.h"\n#include "render/tiles.h"\n',
    "src/render/tiles/tile.h": "#pragma once\n",
    "src/render/tiles/tile_test.cpp": '#include "render/testing/test_tiles.h"\n#include "render/tiles.h"\n',
    "src/render/tiles/rows/row.h": '#include "render/tiles/tile.h"\n',
    "src/render/kernels/kernels.h": '#include "render/tiles/rows/row.h"\n',
    "src/render/testing/test_tiles.h": '#include "render/tiles.h"\n',
    "src/render/CMakeLists.txt": "gluray_module(render DEPS base scene accel LIBS TBB::tbb)\n",
    "src/intercept/hooks/glx.cpp": '#include <GL/glx.h>\n#include <dlfcn.h>\n#include "frame/tracing/renderer.h"\n',
    "src/cluster/mpi.cpp": "#include <mpi.h>\n",
    "apps/gluray/main.cpp": "#include <dlfcn.h>\n",
    "tests/long_test.cpp": "\n" * MAX_LINES,
    **{f"bench/crowd/{number}.py": "\n" for number in range(MAX_FILES)},
}
PLANTED = [
    ("src/gl/planted.cpp", '#include "render/tiles.h"\n', "room gl may not include"),
    ("src/render/planted.h", '#  include "gl/context/context.h"\n', "room render may not include"),
    ("src/base/planted.h", '#include "scene/mesh.h"\n', "room base may not include"),
    ("src/gl/planted_test.cpp", '#include "intercept/door.h"\n', "room gl may not include"),
    ("src/gl/deeper/planted.h", '#include "../context.h"\n', "not by .."),
    ("src/render/planted.cpp", "#include <embree4/rtcore.h>\n", "Embree belongs"),
    ("src/gl/planted.h", "#include <X11/Xlib.h>\n", "X11, GLX and EGL belongs"),
    ("src/render/kernels/planted.h", '#include "render/tiles.h"\n', "render comes after it"),
    ("src/render/tiles/planted.h", '#include "render/tiles/rows/row.h"\n', "tiles/rows comes after it"),
    ("src/render/tiles/tile.h", '#include "render/kernels/kernels.h"\n', "kernels comes after it"),  # a circle of three folders
    ("src/render/tiles/planted.inl.h", '#include "render/kernels/kernels.h"\n', "kernels comes after it"),
    ("src/render/planted/planted.h", "#pragma once\n", "has no place in the order"),
    ("src/render/kernels/rows/planted.cpp", "#pragma once\n", "has no place in the order"),
    ("src/render/kernels/planted.cpp", '#include "render/testing/test_tiles.h"\n', "is for tests alone"),
    ("src/render/kernels/fake_tiles.h", "#pragma once\n", "belong into a folder testing"),
    ("src/render/kernels/kernels.h", None, "names a folder without code"),
    ("src/frame/planted.h", "#include <GL/glxext.h>\n", "X11, GLX and EGL belongs"),
    ("src/base/planted.cpp", "#include <dlfcn.h>\n", "dlfcn belongs"),
    ("src/intercept/planted.cpp", "#include <sys/socket.h>\n", "sockets belongs"),
    ("src/frame/planted.cpp", "#include <mpi.h>\n", "MPI belongs"),
    ("src/cluster/planted.cpp", "#include <mpi.h>\n", "mpi.h is included by"),
    ("src/render/CMakeLists.txt", "gluray_module(render DEPS base gl\n  LIBS TBB::tbb)\n", "may not depend on gl"),
    ("tests/long_test.cpp", "\n" * (MAX_LINES + 1), "a file is split"),
    ("src/frame/log.h", "#pragma once\n", "have one name"),
    ("bench/crowd/more.py", "\n", "a folder is split"),
]


def write(root, files):
    for name, text in files.items():
        file = root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text or "")


def self_test():
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        write(root, SOUND)
        failures += [f"a sound tree was blamed: {line}" for line in violations(root, ORDERED)]
    for name, text, words in PLANTED:
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            write(root, {**SOUND, name: text})
            if text is None:
                (root / name).unlink()
            found = list(violations(root, ORDERED))
            if len(found) != 1 or words not in found[0]:
                failures.append(f"planted in {name}: expected one line with '{words}', got {found}")
    return failures


def main():
    parser = Parser(__doc__)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("root", nargs="?", type=pathlib.Path, metavar="ROOT")
    what.add_argument("--self-test", action="store_true")
    given = parser.parse_args()
    if given.self_test:
        found = self_test()
        print(f"{len(PLANTED)} violations planted")
    else:
        found = list(violations(given.root, FOLDERS))
    print("\n".join(found) if found else "no violations")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
