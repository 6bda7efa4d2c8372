"""Piglit's tests, each run without GLuRay and while it traces, or culls, everything it can: every test that passes without it
must pass with it. Run with a display: run.py --gluray LAUNCHER --out FOLDER [--suite SUITE] [--every N] [--list] [NAME ...]; a NAME is a
part of tests' names. Suites: opengl_1 (tests of OpenGL 1.x), later (all others of desktop OpenGL), shaders (those of shader_runner).

Every result is a test's or a subtest's. Tests that fail only with GLuRay are printed and kept in FOLDER with the output of both runs; the exit status is
1 then, and 77 where piglit is not installed. Such a test is run once more by itself, because machines under load are slow."""
import ast
import concurrent.futures
import dataclasses
import glob
import gzip
import json
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402

FIRST = re.compile(r"spec@!opengl 1\.[0-5]@")
OTHERS = re.compile(r"(egl|wgl)@|@egl|@(arb|ext|khr|mesa)_image|dma_buf")  # not of this door
SUITES = {"opengl_1": ("quick_gl", FIRST.match),
          "later": ("quick_gl", lambda name: not FIRST.match(name) and not OTHERS.search(name)),
          "shaders": ("quick_shader", lambda name: True)}
AT_ONCE = 2
TIMEOUT = 120  # seconds; a test that neither run finishes in time counts as no result
KEPT = 4000    # characters kept from the end of the output

# Reasons not to compare a test's results.
LEFT_OUT = {
}


@dataclasses.dataclass
class Test:
    name: str
    command: list


def installation():
    """The folder of Debian's package piglit; None if it is not installed."""
    found = glob.glob("/usr/lib/*/piglit/bin")
    return pathlib.Path(found[0]).parent if found else None


def words_of(node, root):
    """The command of a test in piglit's list, and whether it may run beside others; None if it is none of desktop OpenGL."""
    options = {o.get("name"): o.get("value") for o in node.iter("option")}
    if node.get("type") not in ("gl", "shader") or "gles" in options.get("api", ""):
        return None
    words = ast.literal_eval(options["command"])
    if node.get("type") == "shader" and not (root / words[1]).exists():
        return None
    return words, options.get("run_concurrent") == "True"


def tests(root, suite):
    """The tests of a suite, sorted by name."""
    listed, belongs = SUITES[suite]
    with gzip.open(root / f"tests/{listed}.xml.gz") as packed:
        tree = xml.etree.ElementTree.parse(packed)
    found = []
    for node in tree.getroot().iter("Test"):
        command = words_of(node, root) if belongs(node.get("name")) and node.get("name") not in LEFT_OUT else None
        if not command:
            continue
        words, concurrent = command
        program = root / "bin" / pathlib.Path(words[0]).name
        if program.exists():
            found.append(Test(node.get("name"), [str(program), *words[1:], "-auto", *(["-fbo"] if concurrent else [])]))
    return sorted(found, key=lambda t: t.name)


def results(output, status, name):
    """The results in a test's output by name, among them how it ended."""
    found = {}
    for line in output.splitlines():
        if not line.startswith("PIGLIT: {"):
            continue
        try:
            told = json.loads(line[len("PIGLIT: "):])
        except ValueError:
            continue
        for subtest, result in told.get("subtest", {}).items():
            found[f"{name}@{subtest}"] = result
        if "result" in told:
            found[name] = told["result"]
    found.setdefault(name, "timeout" if status is None else "crash" if status < 0 else "nothing")
    return found


def run(test, prefix, root):
    """The results of one run, and its output. Ends its process group, too."""
    environment = dict(os.environ, PIGLIT_SOURCE_DIR=str(root), PIGLIT_BUILD_DIR=str(root), PIGLIT_NO_FAST_SKIP="1")
    process = subprocess.Popen([*prefix, *test.command], cwd=root, env=environment, text=True, errors="replace",
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
    try:
        output, _ = process.communicate(timeout=TIMEOUT)
        status = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        output, _ = process.communicate()
        status = None
    return results(output, status, test.name), output


def compare(test, prefix, root):
    """The number of results, how many pass without GLuRay, those that then fail with it, and both outputs."""
    plain, expected = run(test, [], root)
    ours, output = run(test, prefix, root)
    good = [name for name, result in plain.items() if result in ("pass", "warn")]
    lost = [f"{name}: {plain[name]}, then {ours.get(name, 'nothing')}" for name in good
            if ours.get(name) not in ("pass", "warn")]
    return len(plain), len(good), sorted(lost), f"{expected[-KEPT:]}\n--- with GLuRay ---\n{output[-KEPT:]}"


def main():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--suite", choices=SUITES, default="opengl_1")
    parser.add_argument("--every", type=int, default=1, help="only every Nth test")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    root = installation()
    if not root:
        print("piglit is not installed (scripts/setup --all)")
        return 77
    chosen = [t for t in tests(root, options.suite)[::options.every] if not options.names or any(n in t.name for n in options.names)]
    if options.list:
        print("\n".join(" ".join([t.name, "=", *t.command]) for t in chosen))
        return 0
    options.out.mkdir(parents=True, exist_ok=True)
    prefix = [str(pathlib.Path(options.gluray).resolve()), "--engine", "always"]
    if options.suite != "opengl_1":
        prefix += ["--set", "cull.draws=always", "--set", "cull.from=1"]
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        done = list(pool.map(lambda t: compare(t, prefix, root), chosen))
    total, good, failed = sum(count for count, _, _, _ in done), sum(passed for _, passed, _, _ in done), []
    for test, (_, _, lost, _) in zip(chosen, done):
        if not lost:
            continue
        _, _, again, output = compare(test, prefix, root)
        if again:
            failed += again
            (options.out / (re.sub(r"\W+", "_", test.name) + ".txt")).write_text(output)
    print("\n".join(failed))
    print(f"{len(chosen)} tests, {total} results, {good} pass plain, {len(failed)} lost")
    if 2 * good < total or not chosen:
        print("piglit does not work here: too little passes without GLuRay to compare with")
        return 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
