"""the paper's evaluation, repeated: its Table 1 and Figures 7, 8 and 9

Generated data like the paper's, in ParaView, VTK and our client; GLuRay, Mesa with one and with all threads,
and the GPU's OpenGL if the display has one, in turn. Writes bench/results/paper/small.json with the figures as SVG, and
docs/paper-evaluation.md; --full writes to paper/full and docs/paper-evaluation-full.md. Measurements are kept: an
interrupted run resumes; another build starts again.
The small version, a fortieth of the paper's sizes, takes up to ten minutes on two cores; --full takes hours and uses all
available memory.
"""
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import time

from paper import engines, page, plan, results, store
from support import machine, programs
from support.display import NoDisplay, display
from support.options import Parser
from support.telling import end_by_exception

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PYTHONS = (sys.executable, "/usr/bin/python3")  # where matplotlib may be


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench paper")
    parser.add_argument("--full", action="store_true", help="the paper's sizes, within available memory")
    parser.add_argument("--scale", type=float, help="sizes of Table 1 relative to the paper's (small: 1/40, full: 1)")
    parser.add_argument("--sizes", help="millions of triangles of Figures 7 and 8, for instance 1,4")
    parser.add_argument("--engines", default="gluray,mesa1,mesa,gpu", help=f"some of {','.join(engines.NAMES)} (all but auto)")
    parser.add_argument("--rows", help="measure only rows whose name contains one of these, for instance PV-RMI,Star; the page also has kept results of the others")
    parser.add_argument("--rounds", type=int, help="rounds, each measuring every engine once (small: 2, and 1 from 4 million on; full: 3)")
    parser.add_argument("--seconds", type=float, help="time of one measurement, which has at least two frames (small: 1.5; full: 5)")
    parser.add_argument("--frames", type=int, default=120, help="largest number of frames of one measurement")
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)), help="threads of GLuRay and of Mesa (all)")
    parser.add_argument("--timeout", type=int, default=3600, help="seconds after which a measurement is aborted")
    parser.add_argument("--fresh", action="store_true", help="discard earlier measurements")
    parser.add_argument("--resume", action="store_true", help="resume the last run (the default)")
    parser.add_argument("--clean", action="store_true", help="delete data and measurements, and exit")
    parser.add_argument("--plan", action="store_true", help="print the planned measurements, and exit")
    parser.add_argument("--draw", action="store_true", help="draw the figures and write the page from the kept result again, and exit")
    parser.add_argument("--name", default="small", help="name of the result file (small; full: full)")
    parser.add_argument("--out", type=pathlib.Path, help="folder of result and figures (bench/results/paper; full: its folder full)")
    parser.add_argument("--page", type=pathlib.Path, help="the Markdown page (docs/paper-evaluation.md; full: docs/paper-evaluation-full.md)")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    options = parser.parse_args(argv)
    options.engines = options.engines.split(",")
    if not set(options.engines) <= set(engines.NAMES):
        parser.error(f"engines are {', '.join(engines.NAMES)}")
    try:
        options.sweep = [float(size) for size in options.sizes.split(",")] if options.sizes else plan.FULL_SWEEP if options.full else plan.SMALL_SWEEP
    except ValueError:
        parser.error(f"--sizes takes millions, not '{options.sizes}'")
    options.scale = options.scale or (1 if options.full else plan.SMALL_SCALE)
    options.rounds = options.rounds or (3 if options.full else 2)
    options.seconds = options.seconds or (5 if options.full else 1.5)
    if options.full and options.name == "small":
        options.name = "full"
    results_folder = ROOT / "bench" / "results" / "paper"
    options.out = options.out or (results_folder / "full" if options.full else results_folder)
    options.page = options.page or ROOT / "docs" / ("paper-evaluation-full.md" if options.full else "paper-evaluation.md")
    options.work = options.build / "bench" / "paper" / "work"
    return options


class Progress:
    """One line a measurement on stderr, with the estimated remaining time."""

    def __init__(self, guesses):
        self.guesses, self.done, self.start, self.number = guesses, 0.0, time.monotonic(), 0

    def before(self, what, guess):
        self.number += 1
        spent, left = time.monotonic() - self.start, sum(self.guesses) - self.done
        if self.done > 0:
            left *= spent / self.done
        self.done += guess
        print(f"[{self.number}/{len(self.guesses)}, about {left / 60:.0f} min left] {what} ... ", end="", file=sys.stderr, flush=True)

    @staticmethod
    def after(text):
        print(text, file=sys.stderr, flush=True)


class Run:
    """Makes the missing measurements; keeps each one immediately."""

    def __init__(self, options, kept, engine_set, names, memory_bytes=float("inf")):
        self.options, self.kept, self.engines, self.names, self.memory = options, kept, engine_set, names, memory_bytes
        self.notes = []

    def jobs(self, rows):
        """(key, title, estimated seconds, function that measures it) in the order of measuring."""
        for row in rows:
            for number in range(plan.rounds_of(row, self.options.rounds, self.options.full)):
                for engine in [name for name in self.names if row.engine_needs(name) <= self.memory]:
                    yield (f"{row.name} {engine} {number}", row, plan.guess_seconds(row, engine, self.options.threads),
                           lambda row=row, engine=engine: self.engines.measure(row, engine))
        for row in rows:
            if row.scene == "Wavelet" and "gluray" in self.names and row.build_needs <= self.memory:
                for quality in ("fast", "full"):
                    yield (f"{row.name} build {quality}", row, 2 + 0.6 * row.millions,
                           lambda row=row, quality=quality: self.engines.measure_build(row, quality))

    def mesh(self, row):
        """Makes the row's data unless they exist; prints the size of the file."""
        file = self.engines.mesh_file(row)
        if file.exists():
            return
        file.parent.mkdir(parents=True, exist_ok=True)
        print(f"making {row.data}, {row.millions:g} million triangles ... ", end="", file=sys.stderr, flush=True)
        maker = self.options.build / "bench" / "paper" / "gluray-bench-paper-data"
        code, _, err = programs.run([maker, row.data, "--millions", row.millions, "--out", file], {}, self.options.timeout)
        if code != 0:
            file.with_suffix(".mesh.part").unlink(missing_ok=True)
            raise programs.Failed(f"{row.data}: {err.strip() or f'exit code {code}'}")
        print(f"{file.stat().st_size / 1e6:.0f} MB", file=sys.stderr, flush=True)

    def measure(self, rows):
        todo = [job for job in self.jobs(rows) if job[0] not in self.kept]
        progress = Progress([guess for _, _, guess, _ in todo])
        for key, row, guess, measured in todo:
            try:
                self.mesh(row)
                progress.before(key, guess)
                self.kept.keep(key, measured())
                progress.after(self.said(key))
            except programs.Failed as error:
                progress.after("failed")
                why = str(error).splitlines()[0].replace(str(ROOT) + "/", "")
                print(error, file=sys.stderr, flush=True)
                self.notes.append(f"{key} failed: {why}")

    def said(self, key):
        measured = self.kept[key]
        return f"{measured['build_s']:.2f} s" if "bvh_bytes" in measured else f"{1 / measured['frame_s']:.3g} fps, {measured['frames']} frames"

    def rows(self, rows):
        """Rows of the result file from the measurements so far."""
        for row in rows:
            keys = {e: [f"{row.name} {e} {n}" for n in range(plan.rounds_of(row, self.options.rounds, self.options.full))] for e in self.names}
            measured = {e: [self.kept[key] for key in names if key in self.kept] for e, names in keys.items()}
            measured = {e: rounds for e, rounds in measured.items() if rounds}
            if measured:
                yield results.row_of(row, measured)
        for row in rows:
            builds = {q: self.kept[f"{row.name} build {q}"] for q in ("fast", "full") if f"{row.name} build {q}" in self.kept}
            yield from results.build_rows(row, builds)


def draw(options, result_file):
    """Names of the drawn figures; prints a line if none can be drawn."""
    for python in PYTHONS:
        if shutil.which(python) and subprocess.run([python, "-c", "import matplotlib"], capture_output=True, check=False).returncode == 0:
            done = subprocess.run([python, ROOT / "bench" / "paper" / "figures.py", result_file, options.out], text=True, capture_output=True, check=False)
            if done.returncode == 0:
                return done.stdout.split()
            print(f"bench: the figures could not be drawn: {done.stderr.strip()}", file=sys.stderr)
            return []
    print("bench: no figures: python3-matplotlib is missing (scripts/setup --all)", file=sys.stderr)
    return []


def publish(options, result):
    """Writes result file, figures and page."""
    options.out.mkdir(parents=True, exist_ok=True)
    file = options.out / f"{options.name}.json"
    file.write_text(json.dumps(result, indent=1) + "\n")
    names = draw(options, file) + (["figure9"] if (options.out / "figure9.svg").exists() else [])
    images = {name: os.path.relpath(options.out / f"{name}.svg", options.page.parent) for name in names}
    options.page.write_text(page.page(result, images))
    for path in (file, options.page, *(options.out / f"{name}.svg" for name in names)):
        print(f"written: {os.path.relpath(path, ROOT)}")


def prepare(options, display_name):
    """(engines, their names, rows, notes about omitted rows, the GPU's name or why there is none, bytes of memory)."""
    engine_set = engines.Engines(options, display_name, options.work / "data")
    programs.require(*engine_set.needed())
    names, gpu = list(options.engines), "not asked for"
    if "gpu" in names:
        renderer, why = engines.gpu_renderer(display_name)
        gpu = renderer or f"none, {why}"
        if not renderer:
            print(f"no GPU: {why}", file=sys.stderr)
            names.remove("gpu")
    memory = 0.9 * int(machine.field("/proc/meminfo", "MemAvailable").split()[0]) * 1024
    rows, notes = plan.rows(options.scale, options.sweep, memory)
    for program, needs in (("ParaView", "pvbatch"), ("VTK", "/usr/bin/python3")):
        if not shutil.which(needs):
            notes.append(f"{program} is left out: {needs} is missing")
            rows = [row for row in rows if row.program != program]
    return engine_set, names, rows, notes, gpu, memory


def timeline_millions(options):
    return min(plan.TIMELINE_MILLIONS, max(options.sweep))


def timeline(options, engine_set, run):
    """The paper's Figure 9, unless it exists for this build."""
    row = plan.Row("PV-Wavelet", "ParaView", "buffers", "wavelet", timeline_millions(options))
    chart = options.out / "figure9.svg"
    if "figure9" in run.kept and chart.exists():
        return
    try:
        run.mesh(row)
        options.out.mkdir(parents=True, exist_ok=True)
        run.kept.keep("figure9", {"table": engine_set.draw_timeline(row, options.work, chart)})
    except programs.Failed as error:
        print(error, file=sys.stderr)
        run.notes.append("Figure 9 could not be drawn")


def told(argv):
    """The options without the build folder, whose place does not matter: the result names the build."""
    rest, out = iter(argv), []
    for option in rest:
        if option == "--build":
            next(rest, None)
        elif not option.startswith("--build="):
            out.append(option)
    return out


def measure(options, argv, display_name):
    engine_set, names, rows, notes, gpu, memory = prepare(options, display_name)
    for note in notes:
        print(note, file=sys.stderr)
    what = {"threads": options.threads, "seconds": options.seconds, "frames": options.frames, "cpu": machine.field("/proc/cpuinfo", "model name")}
    kept = store.Store(options.work / f"{options.name}.jsonl", store.stamp_of(engine_set.needed(), **what), options.fresh)
    if kept.others:
        print(f"{kept.others} measurements of another build or machine are ignored", file=sys.stderr)
    run = Run(options, kept, engine_set, names, memory)
    wanted = [row for row in rows if not options.rows or any(part in row.name for part in options.rows.split(","))]
    if options.plan:
        jobs = [job for job in run.jobs(wanted) if job[0] not in kept]
        print("\n".join(f"{guess:6.0f} s  {key}" for key, _, guess, _ in jobs))
        print(f"about {sum(job[2] for job in jobs) / 60:.0f} minutes")
        return
    result = {"suite": "paper", "command": ("scripts/bench paper " + shlex.join(told(argv))).strip(), **machine.describe(ROOT)}
    if options.rows:
        notes.append("rows that --rows does not name were measured before, by the same command without it")
    result["versions"]["paraview"] = machine.package_version("python3-paraview")
    run.measure(wanted)
    missing = sorted({row.name for key, row, _, _ in run.jobs(rows) if key not in kept})
    if missing:
        notes.append(f"not measured yet, the same command goes on: {', '.join(missing)}")
    if "gluray" in names and not options.rows:
        timeline(options, engine_set, run)
    size = sum(file.stat().st_size for file in (options.work / "data").glob("*.mesh"))
    print(f"data: {size / 1e9:.2f} GB in {os.path.relpath(options.work / 'data', ROOT)}; scripts/bench paper --clean deletes them", file=sys.stderr)
    result["machine"]["load_after"] = os.getloadavg()[0]
    result.update({"threads": options.threads, "rounds": options.rounds, "gpu": gpu, "timeline_millions": timeline_millions(options),
                   "notes": notes + run.notes, "rows": list(run.rows(rows))})
    if not result["rows"]:
        raise programs.Failed("nothing could be measured")
    publish(options, result)


def main(argv):
    options = arguments(argv)
    if options.clean:
        shutil.rmtree(options.work, ignore_errors=True)
        print(f"deleted: {os.path.relpath(options.work, ROOT)}")
        return 0
    end_by_exception()
    try:
        if options.draw:
            publish(options, json.loads((options.out / f"{options.name}.json").read_text()))
            return 0
        with display(own=options.xvfb) as name:
            measure(options, argv, name)
    except KeyboardInterrupt:
        print("\nbench: interrupted; measurements are kept, the same command resumes", file=sys.stderr)
        return 130
    except (NoDisplay, programs.Failed, OSError) as error:
        print(f"bench: {error}", file=sys.stderr)
        return 1
    return 0
