"""beyond one process: images shared by ranks, light across ranks, and a simulation of up to 1024 ranks

The Wavelet's isosurfaces, 1024x1024, an orbit of one degree a frame. Needs no display. Parts:

  image       ranks of gluray-worker as processes under Open MPI, one thread each, that share each image of one program, also of frames of
              an animation with occlusion (one ray for four pixels, smoothed); in turn with a job of one rank, frame by frame. The ranks share this machine's cores: frame times show no scaling, CPU times show what ranks
              of their own cores would do. NAME_image.json
  pages       the same with less memory for each rank than the geometry takes (--pages MILLIONS:RANKS:MEMORY): the image's checksum is that of a
              process of its own that has all of it. NAME_pages.json
  peers       ambient occlusion with four rays a pixel across the ranks of a sort-last program: slabs, all in one process. NAME.json
  simulation  measures tiles, the head's work and messages, then SIMULATES the job's protocol on 1 to 1024 ranks. NAME_simulated.json
  figure      docs/scaling.svg from the results
  network     (--network) part 'image' between hosts of this machine with networks of their own, over a switch that delays and limits; takes
              root. The hosts share this machine's cores: what the network costs, no scaling. NAME_network.json
"""
import json
import pathlib
import shlex
import tempfile

from scale import figure, network_jobs, simulation, worker_jobs
from scale.links import links
from suites.light import figures_of
from support import machine, programs
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PARTS = ("image", "pages", "peers", "simulation", "figure")
NETWORKS = ((20, 10000), (200, 10000), (2000, 10000), (20, 1000), (20, 100))  # microseconds each way, Mbit/s
NETWORK_RANKS, NETWORK_LOOKS = (2, 3), ("local", "moving")
LOOKS = {"local": 0, "occlusion": 16}  # rays of ambient occlusion a pixel
IMAGE_LOOKS = {**LOOKS, "moving": 16}
LINK_RUNS = 8  # of which the least times count: other processes of the machine disturb the others
SIMULATED_RANKS = [2**power for power in range(11)]


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench scale")
    parser.add_argument("--sizes", default="1,4", help="millions of triangles (1,4); the simulation takes the first")
    parser.add_argument("--ranks", default="1,2,4,8", help="numbers of ranks that are measured (1,2,4,8)")
    parser.add_argument("--parts", default=",".join(PARTS), help=f"which parts ({','.join(PARTS)})")
    parser.add_argument("--figure", action="store_true", help="--parts figure")
    parser.add_argument("--network", action="store_true", help="--parts network, which is not among those that are the default")
    parser.add_argument("--frames", type=int, default=7, help="that count (7); of the part 'image' four times as many in the local look")
    parser.add_argument("--pages", default="16:2:700M,64:4:1200M", help="of the part 'pages', with commas between: millions of triangles, "
                        "ranks, memory of each (16:2:700M,64:4:1200M)")
    parser.add_argument("--looks", default=",".join(LOOKS), help=f"of the part 'pages' ({','.join(LOOKS)})")
    parser.add_argument("--threads", type=int, default=2, help="of each rank of the part 'peers'")
    parser.add_argument("--name", default="scale", help="name of the result files")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    options = parser.parse_args(argv)
    options.parts = ["figure"] if options.figure else ["network"] if options.network else options.parts.split(",")
    if unknown := set(options.parts) - {*PARTS, "network"}:
        parser.error(f"no part {', '.join(sorted(unknown))}")
    return options


def said_by(command, environment=None):
    """What the program printed."""
    code, out, err = programs.run([str(word) for word in command], environment or {}, 1800)
    if code != 0:
        raise programs.Failed(f"exit code {code}: {' '.join(map(str, command))}\n{err}")
    return out


def program(options, name):
    path = options.build / "bench" / "scale" / name
    programs.require(path)
    return path


def tell(row, names):
    title = " ".join(str(row[name]) for name in names)
    for name, value in row.items():
        if name not in names and isinstance(value, (int, float)):
            print(f"{title:32} {name:28} {value:10.3f}", flush=True)


def image_rows(options, millions, look, ranks):
    """Rows of a job of one rank and of one of `ranks`, which took turns."""
    worker = options.build / "apps" / "gluray" / "gluray-worker"
    programs.require(worker, worker_jobs.LAUNCHER)
    with tempfile.TemporaryDirectory(prefix="gluray-bench-") as folder:
        with worker_jobs.job(worker, "one", 1, folder) as one, worker_jobs.job(worker, "many", ranks, folder) as many:
            jobs = [f"{name}:{','.join(map(str, processes))}" for name, processes in (("one", one), ("many", many))]
            moving = ["--moving", "--without-local"] if look == "moving" else []
            figures = figures_of(said_by([program(options, "gluray-bench-image"), "--triangles", millions, "--samples", IMAGE_LOOKS[look],
                                          "--frames", options.frames * (1 if look == "occlusion" else 4), *moving, *jobs],
                                         {"GLURAY_RUNTIME": folder}))
    row = {name.split(".", 1)[1]: value for name, value in figures.items() if name.startswith("many.")}
    # What one core would take, over what so many cores would be busy for.
    row["one_rank_tracing_cpu_ms"] = figures["one.tracing_cpu_ms"]
    row["tracing_cpu_over_one_rank"] = row["tracing_cpu_ms"] / figures["one.tracing_cpu_ms"]
    row["tracing_cpu_ms_a_rank"] = row["tracing_cpu_ms"] / ranks
    row["same_picture"] = int(figures["one.checksum"] == row["checksum"])
    row["efficiency_by_busiest_rank"] = figures["one.tracing_cpu_ms"] / (ranks * row["busiest_rank_cpu_ms"])
    return {"path": "image-parallel", "millions": millions, "look": look, "ranks": ranks, **row}


def measure_image(options):
    for millions in map(float, options.sizes.split(",")):
        for look in IMAGE_LOOKS:
            for ranks in map(int, options.ranks.split(",")):
                yield image_rows(options, millions, look, ranks)


def network_row(options, millions, look, ranks, delay_us, megabits):
    """A job of one rank, and one with a rank on each host, which took turns."""
    worker = options.build / "apps" / "gluray" / "gluray-worker"
    link = options.build / "tests" / "network" / "network_link"
    programs.require(worker, link, network_jobs.LAUNCHER)
    moving = ["--moving"] if look == "moving" else []
    with network_jobs.Hosts(link, worker, ranks, delay_us, 1e6 * megabits) as hosts:
        round_trip, before = hosts.round_trip_us(), hosts.net.bytes()
        figures = figures_of(said_by([program(options, "gluray-bench-image"), "--triangles", millions, "--samples", IMAGE_LOOKS[look], "--frames",
                                      options.frames, "--without-local", *moving, *hosts.jobs()], {"GLURAY_RUNTIME": hosts.runtime()}))
        crossed = hosts.net.crossed(before)
    return {"path": "network", "millions": millions, "look": look, "ranks": ranks, "delay_us": delay_us, "megabits": megabits,
            "round_trip_us": round_trip, "frames_per_second": 1000 / figures["many.frame_ms"], "frame_ms": figures["many.frame_ms"],
            "one_rank_frame_ms": figures["one.frame_ms"], "first_ms": figures["many.first_ms"], "max_over_mean": figures["many.max_over_mean"],
            "megabytes_crossed": crossed / 1e6, "same_picture": int(figures["one.checksum"] == figures["many.checksum"])}


def measure_network(options):
    for look in NETWORK_LOOKS:
        for ranks in NETWORK_RANKS:
            for delay_us, megabits in NETWORKS:
                yield network_row(options, float(options.sizes.split(",")[0]), look, ranks, delay_us, megabits)


def paged_row(options, millions, look, ranks, memory):
    worker = options.build / "apps" / "gluray" / "gluray-worker"
    programs.require(worker, worker_jobs.LAUNCHER)
    bench = [program(options, "gluray-bench-image"), "--triangles", millions, "--samples", LOOKS[look], "--frames", options.frames]
    with tempfile.TemporaryDirectory(prefix="gluray-bench-") as folder, \
            worker_jobs.job(worker, "paged", ranks, folder, "--memory", memory) as processes, worker_jobs.PeakMemory(processes) as peak:
        job = f"paged:{','.join(map(str, processes))}"
        # The ranks' memory is that of one machine here, which may not hold another copy of the geometry.
        figures = figures_of(said_by([*bench, "--without-local", "--drop", job], {"GLURAY_RUNTIME": folder}))
    row = {name.split(".", 1)[1]: value for name, value in figures.items()}
    # Only now: this machine may not hold both. Images do not depend on the structure.
    local = figures_of(said_by([*bench, "--small"]))["local.checksum"]
    return {"path": "paged", "millions": millions, "look": look, "ranks": ranks, "memory_of_a_rank": memory,
            "peak_rank_mb": max(peak.most.values()) / 1e6, "same_picture": int(local == row["checksum"]), **row}


def measure_pages(options):
    for case in options.pages.split(","):
        millions, ranks, memory = case.split(":")
        for look in options.looks.split(","):
            yield paged_row(options, float(millions), look, int(ranks), memory)


def measure_peers(options):
    for millions in map(float, options.sizes.split(",")):
        for ranks in map(int, options.ranks.split(",")):
            for path, more in {"sort-last": [], "sort-last, hidden pixels lit": ["--light-all"]}.items():
                if more and ranks == 1:
                    continue
                figures = figures_of(said_by([program(options, "gluray-bench-scale"), "--triangles", millions, "--ranks", ranks,
                                              "--frames", options.frames, "--threads", options.threads, *more]))
                one = figures["one_process_occlusion_cpu_ms"]
                figures["cpu_over_one_process"] = figures["occlusion_cpu_ms"] / one
                figures["moving_cpu_over_one_process"] = figures["moving_occlusion_cpu_ms"] / figures["one_process_moving_occlusion_cpu_ms"]
                figures["gathered_cpu_over_one_process"] = figures["gathered_occlusion_cpu_ms"] / one
                yield {"path": path, "millions": millions, "ranks": ranks, **figures}


def measured_inputs(options):
    """What the simulation starts from: figures of links, and of the images by look."""
    mpi = options.build / "lib" / "gluray" / "libgluray-mpi-openmpi.so"
    runs = [figures_of(said_by([*worker_jobs.launcher(2), program(options, "gluray-bench-link"), mpi])) for _ in range(LINK_RUNS)]
    link = {name: min(run[name] for run in runs) for name in runs[0]}
    millions = options.sizes.split(",")[0]
    images = {look: json.loads(said_by([program(options, "gluray-bench-tiles"), "--triangles", millions, "--samples", samples]))
                for look, samples in LOOKS.items()}
    inputs = {"link": link, "pictures": images, "look_us": 0.0}
    # A look's own time: CPU time of the main thread of the head of two ranks, without what the looks found.
    inputs["head_cpu_ms"] = head_cpu_of_two_ranks(options, float(millions))
    two = simulation.simulate(costs_of(inputs, "local", 2), links(link)["shm"], 2, 1)
    inputs["look_us"] = max(1000 * inputs["head_cpu_ms"] - two.head, 0.0) / two.looks
    return inputs


def head_cpu_of_two_ranks(options, millions):
    path = result_file(options, "image")
    rows = json.loads(path.read_text())["rows"] if path.exists() else []
    for row in rows:
        if (row["millions"], row["look"], row["ranks"]) == (millions, "local", 2):
            return row["head_protocol_cpu_ms"]
    raise programs.Failed(f"{path.name} has no job of two ranks with {millions:g} million triangles: run the part 'image' first")


def result_file(options, part):
    return ROOT / "bench" / "results" / f"{options.name}_{part}.json"


def costs_of(inputs, look, ranks):
    image, link = inputs["pictures"][look], inputs["link"]
    head = next(row for row in image["head"] if row["ranks"] == ranks)
    return simulation.Costs(before=image["before_us"], tiles=image["tiles_us"], begin=image["begin_us"], end=image["end_us"],
                            pack=image["pack_us"], take=head["take_us"], give=head["give_us"], sleep=link["sleep_us"], look=inputs["look_us"],
                            wake=link["wake_us"], bytes=image["bytes"])


def simulated_row(inputs, millions, look, link, threads, ranks):
    done = simulation.simulate(costs_of(inputs, look, ranks), links(inputs["link"])[link], ranks, threads)
    return {"path": f"simulated {link}, {threads} threads", "millions": millions, "look": look, "link": link, "threads": threads,
            "ranks": ranks, "frame_ms": round(done.frame / 1000, 4), "max_over_mean": round(done.balance, 4),
            "busiest_rank_ms": round(max(done.busy) / threads / 1000, 4), "head_works_ms": round(done.head / 1000, 4),
            "head_link_ms": round(done.head_link / 1000, 4)}


def simulated_rows(inputs, millions):
    curves = [(link, threads) for threads in (8, 1) for link in links(inputs["link"])]
    for look in LOOKS:
        for link, threads in curves:
            for ranks in SIMULATED_RANKS:
                yield simulated_row(inputs, millions, look, link, threads, ranks)


def compact(inputs):
    """Lists of tiles as one text for each row of the image."""
    def text(numbers):
        side = round(len(numbers)**0.5)
        return [" ".join(f"{n:g}" for n in numbers[at:at + side]) for at in range(0, len(numbers), side)]
    images = {look: {name: text(value) if name in ("before_us", "tiles_us") else value for name, value in image.items()}
                for look, image in inputs["pictures"].items()}
    return {**inputs, "pictures": images}


def head_of(part, argv):
    return {"suite": "scale", "part": part, "command": ("scripts/bench scale " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}


def run_rows(options, argv, part, name, rows, names):
    result = head_of(part, argv)
    for row in rows:
        tell(row, names)
        result["rows"].append(row)
    machine.write(ROOT, name, result)


def run_simulation(options, argv):
    result = head_of("simulation: every row is SIMULATED from the measured inputs", argv)
    inputs = measured_inputs(options)
    result["links"] = {key: vars(link) for key, link in links(inputs["link"]).items()}
    result["rows"] = list(simulated_rows(inputs, float(options.sizes.split(",")[0])))
    result["inputs"] = compact(inputs)
    machine.write(ROOT, f"{options.name}_simulated", result)


def draw(options):
    results = [json.loads(result_file(options, part).read_text())["rows"] for part in ("image", "simulated")]
    (ROOT / "docs" / "scaling.svg").write_text(figure.figure(*results))
    print("written: docs/scaling.svg")


def run(options, argv):
    if "image" in options.parts:
        run_rows(options, argv, "image", f"{options.name}_image", measure_image(options), ("millions", "look", "ranks", "path"))
    if "network" in options.parts:
        run_rows(options, argv, "network", f"{options.name}_network", measure_network(options), ("look", "ranks", "delay_us", "megabits"))
    if "pages" in options.parts:
        run_rows(options, argv, "pages", f"{options.name}_pages", measure_pages(options), ("millions", "look", "ranks", "path"))
    if "peers" in options.parts:
        run_rows(options, argv, "peers", options.name, measure_peers(options), ("millions", "ranks", "path"))
    if "simulation" in options.parts:
        run_simulation(options, argv)
    if "figure" in options.parts:
        draw(options)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
