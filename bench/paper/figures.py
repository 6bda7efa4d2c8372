"""Draws Table 1 and Figures 7 and 8 of a result as SVG. Needs matplotlib."""
import json
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from support.options import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("result", type=pathlib.Path, metavar="RESULT.json")
    parser.add_argument("folder", type=pathlib.Path, help="of the SVG files")
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
import matplotlib  # noqa: E402

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FuncFormatter, NullFormatter  # noqa: E402
from paper import plan  # noqa: E402
from paper.engines import TITLES  # noqa: E402
from paper.results import sweep_rows, table_rows  # noqa: E402

COLORS = {"gluray": "#c8860a", "auto": "#e3c06a", "mesa1": "#35597a", "mesa": "#6f9fc8", "gpu": "#5a8f3c", "paper": "#999999"}
MARKERS = {"gluray": "o", "auto": "v", "mesa1": "s", "mesa": "D", "gpu": "^"}
plt.rcParams.update({"font.family": "DejaVu Sans", "font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
                     "axes.grid": True, "grid.color": "#e4e4e4", "axes.axisbelow": True, "legend.frameon": False,
                     # Equal figures give equal files.
                     "svg.hashsalt": "gluray", "svg.fonttype": "path"})
PLAIN = FuncFormatter(lambda value, _: f"{value:g}")


def log_axes(ax, sizes, ylabel):
    ax.set_xscale("log", base=2)
    ax.set_yscale("log")
    ax.set_xticks(sizes)
    ax.xaxis.set_major_formatter(PLAIN)
    ax.xaxis.set_minor_formatter(NullFormatter())
    ax.yaxis.set_major_formatter(PLAIN)
    ax.set_xlabel("million triangles")
    ax.set_ylabel(ylabel)


def figure7(rows):
    panels = [("PV-Wavelet", "ParaView"), ("Wavelet", "display list")]
    panels = [panel for panel in panels if sweep_rows(rows, panel[0])]
    if not panels:
        return None
    figure, axes = plt.subplots(1, len(panels), figsize=(4.6 * len(panels), 4), sharey=True, squeeze=False)
    for ax, (scene, title) in zip(axes[0], panels):
        found = sweep_rows(rows, scene)
        for engine in TITLES:
            points = [(row["triangles"] / 1e6, row[engine]) for row in found if engine in row]
            if points:
                x, f = [p[0] for p in points], [p[1] for p in points]
                ax.plot(x, [p["fps"] for p in f], color=COLORS[engine], marker=MARKERS[engine], markersize=4, label=TITLES[engine])
                ax.fill_between(x, [p["fps_low"] for p in f], [p["fps_high"] for p in f], color=COLORS[engine], alpha=0.2, linewidth=0)
        log_axes(ax, [row["millions"] for row in found], "frames a second" if ax is axes[0][0] else "")
        ax.set_title(f"Wavelet, {title}", fontsize=10)
    axes[0][-1].legend(loc="lower left")
    return figure


def figure8(rows):
    builds = {q: sorted((r["triangles"] / 1e6, r["build_s"]) for r in rows if r["scene"] == "build" and r["path"] == q) for q in ("fast", "full")}
    if not any(builds.values()):
        return None
    figure, ax = plt.subplots(figsize=(5.6, 4))
    for quality, marker in (("fast", "o"), ("full", "^")):
        ax.plot(*zip(*builds[quality]), color=COLORS["gluray"] if quality == "full" else COLORS["auto"], marker=marker, markersize=4,
                label=f"GLuRay, {quality} build")
    for engine in ("mesa1", "mesa"):
        points = [(row["triangles"] / 1e6, 1 / row[engine]["fps"]) for row in sweep_rows(rows, "PV-Wavelet") if engine in row]
        if points:
            ax.plot(*zip(*points), color=COLORS[engine], marker=MARKERS[engine], markersize=4, linestyle="--",
                    label=f"one frame, {TITLES[engine]}")
    log_axes(ax, sorted({row["millions"] for row in rows if row["scene"] == "build"}), "seconds")
    ax.legend(loc="upper left")
    ax.set_title("Building the acceleration structure, and one frame of Mesa (ParaView)", fontsize=10)
    return figure


def table1(rows):
    ours = table_rows(rows)
    engines = [engine for engine in TITLES if any(engine in row for row in ours.values())]
    if not ours:
        return None
    figure, ax = plt.subplots(figsize=(9.2, 4))
    width = 0.8 / (len(engines) + 1)
    for i, engine in enumerate(engines + ["paper"]):
        places = [at + width * (i - len(engines) / 2) for at, row in enumerate(ours.values()) if engine == "paper" or engine in row]
        if engine == "paper":
            values, spread = [plan.PAPER_TABLE[name]["gluray"] for name in ours], None
        else:
            f = [row[engine] for row in ours.values() if engine in row]
            values = [p["fps"] for p in f]
            spread = [[p["fps"] - p["fps_low"] for p in f], [p["fps_high"] - p["fps"] for p in f]]
        ax.bar(places, values, width, color=COLORS[engine], yerr=spread, error_kw={"linewidth": 0.8},
               label="the paper's GLuRay (its sizes, 8 cores of 2009)" if engine == "paper" else TITLES[engine])
    ax.set_yscale("log")
    ax.yaxis.set_major_formatter(PLAIN)
    ax.grid(axis="x", visible=False)
    ax.set_ylabel("frames a second")
    ax.set_xticks(range(len(ours)), [f"{name}\n{row['triangles'] / 1e6:.1f}M" for name, row in ours.items()], fontsize=8)
    ax.legend(ncol=len(engines) + 1, loc="lower center", bbox_to_anchor=(0.5, 1.0), fontsize=8)
    return figure


def main(result_file, folder):
    rows = json.loads(result_file.read_text())["rows"]
    for name, draw in (("table1", table1), ("figure7", figure7), ("figure8", figure8)):
        figure = draw(rows)
        if figure:
            figure.tight_layout()
            figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
            print(name)


main(OPTIONS.result, OPTIONS.folder)
