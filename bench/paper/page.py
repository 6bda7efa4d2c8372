"""The Markdown page about a result: the paper's numbers beside ours."""
from paper import plan
from paper.engines import TITLES
from paper.results import sweep_rows, table_rows

BUSY = 1.0  # load from which times mean little
STANDS_FOR = {
    "PV-Wavelet": "ParaView 5.11; the paper: ParaView 3.11",
    "VI-Wavelet": "VTK 9.1 alone; the paper: VisIt 2.4, which draws with VTK",
    "PV-VPIC": "ParaView; plasma-like isosurface and stream tubes",
    "VI-VPIC": "VTK alone; the same data",
    "EnSight-VPIC": "our client in immediate mode; EnSight draws so, or with display lists",
    "PV-RMI": "ParaView; interface of mixing fluids, close up",
    "PV-RMO": "ParaView; the same from outside",
    "VAPOR-Star": "our client, vertex arrays in a display list, as VAPOR draws; field lines of a star",
}


def number(value):
    """Three significant digits."""
    if value is None:
        return "-"
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"


def fps(figures):
    """Median, and in brackets the range of the quartiles of the frames."""
    return "-" if not figures else f"{number(figures['fps'])} ({number(figures['fps_low'])} to {number(figures['fps_high'])})"


def table(head, lines):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] + ["| " + " | ".join(map(str, line)) + " |" for line in lines]


def engines_in(rows):
    return [engine for engine in TITLES if any(engine in row for row in rows)]


def table_one(rows):
    ours = table_rows(rows)
    engines = engines_in(ours.values())
    lines = []
    for name, row in ours.items():
        paper = plan.PAPER_TABLE[name]
        lines.append([name, paper["millions"], number(paper["gluray"]), number(paper["mesa"]), number(paper["gpu"]),
                      number(paper["gluray"] / paper["mesa"]), f"{row['triangles'] / 1e6:.1f}", *[fps(row.get(e)) for e in engines],
                      number(row.get("gluray_over_mesa1")), number(row.get("gluray_over_mesa"))])
    head = ["", "paper Mtri", "paper GLuRay", "paper Mesa", "paper GPU", "paper ratio", "Mtri", *[TITLES[e] for e in engines],
            "ratio to 1 thread", "ratio to all"]
    return table(head, lines)


def sweep(rows, scene):
    found = sweep_rows(rows, scene)
    engines = engines_in(found)
    return table(["Mtri", "sent by", *[TITLES[e] for e in engines], "ratio to 1 thread", "ratio to all", "first image GLuRay s", "Mesa, 1 thread s"],
                 [[f"{row['triangles'] / 1e6:.2f}", row["path"], *[fps(row.get(e)) for e in engines], number(row.get("gluray_over_mesa1")),
                   number(row.get("gluray_over_mesa")), number(row.get("gluray", {}).get("first_image_s")),
                   number(row.get("mesa1", {}).get("first_image_s"))] for row in found])


def builds(rows):
    mesa = {row["millions"]: row for row in rows if row["scene"] == "PV-Wavelet"}
    by_size = {}
    for row in rows:
        if row["scene"] == "build":
            by_size.setdefault(row["millions"], {})[row["path"]] = row

    def frame(millions, engine):
        figures = mesa.get(millions, {}).get(engine)
        return number(1 / figures["fps"]) if figures else "-"
    lines = [[f"{next(iter(found.values()))['triangles'] / 1e6:.2f}", *[number(found.get(q, {}).get("build_s")) for q in ("fast", "full")],
              *[number(found.get(q, {}).get("bvh_bytes_per_triangle")) for q in ("fast", "full")], frame(size, "mesa1"), frame(size, "mesa")]
             for size, found in sorted(by_size.items())]
    return table(["Mtri", "fast build s", "full build s", "fast B/triangle", "full B/triangle", "ParaView frame, Mesa 1 thread, s", "all threads, s"],
                 lines)


def not_traced(rows):
    """A line for each row in which GLuRay traced nothing."""
    for row in rows:
        if "gluray" in row and not row["gluray"].get("draws_traced"):
            yield f"- {row['scene']}, {row['program']}, {row['millions']:g}M: nothing was traced, so there is nothing to compare."


def reasons(rows):
    """What GLuRay left to the real OpenGL, over all rows."""
    found = {}
    for row in rows:
        for reason in row.get("rasterised", {}):
            found.setdefault(reason, set()).add(row["program"])
    return [f"- {reason} ({', '.join(sorted(who))})" for reason, who in sorted(found.items())]


def page(result, images):
    """The page's text; `images`: {name: path from the page} of the drawn figures."""
    rows, machine, versions = result["rows"], result["machine"], result["versions"]

    def figure(name, caption):
        return [f"![{caption}]({images[name]})", ""] if name in images else []
    lines = [
        "# The paper's evaluation, repeated", "",
        "`scripts/bench paper` measures at a fortieth of the paper's sizes and writes docs/paper-evaluation.md; with `--full` it goes to the paper's",
        "sizes within available memory and writes docs/paper-evaluation-full.md. [ADR 0019](adr/0019-the-papers-evaluation.md) says what replaces the paper's data and programs.", "",
        f"Measured {result['date']} by `{result['command']}`:", f"{machine['cpu']}, {machine['cores']} cores, {machine['memory']} of memory,",
        f"{machine['system']}, load {machine['load_before']:.1f} before and {machine.get('load_after', 0):.1f} after; GLuRay "
        f"{versions['source']}{' with changes' if versions['source_modified'] else ''}, {versions['embree']}, {versions['mesa']},",
        f"ParaView {versions.get('paraview', '-')}; {result['threads']} threads; 1024x1024 pixels, local lighting. GPU: {result['gpu']}.", "",
        "Numbers are medians; brackets hold the range from the lowest first to the highest third quartile of the frames of all rounds. Each round",
        "measures every engine once, in turn. The camera goes once around in the measured frames, after a warm-up. Mesa is llvmpipe",
        "(the paper's Mesa had one thread and an older rasteriser); \"1 thread\" is LP_NUM_THREADS=0. The paper's node had 8 cores of 2009.", "",
        "## Table 1", "", "Frames a second. \"Mtri\" shows where sizes differ from the paper's: ratios grow with the size.", "", *table_one(rows), ""]
    lines += [f"- {name}: {text}." for name, text in STANDS_FOR.items()] + [""]
    lines += figure("table1", "Frames a second of each row of Table 1") + ["## Figure 7: frames a second over triangles", ""]
    lines += figure("figure7", "Frames a second over triangles, both logarithmic")
    lines += ["ParaView, Wavelet:", "", *sweep(rows, "PV-Wavelet"), "", "Our client, one display list of the same (vbo: buffer objects, where a list would be too large):", "", *sweep(rows, "Wavelet"), ""]
    lines += ["## Figure 8: building against one frame of Mesa", "",
              "The paper: less than a second at 1 million triangles, more than a minute at 256 million, always less than one frame of Mesa.", ""]
    lines += figure("figure8", "Seconds to build an acceleration structure and to draw one frame with Mesa, over triangles") + [*builds(rows), ""]
    lines += ["## Figure 9: who works when", ""] + figure("figure9", "What each thread does: the whole run and a close-up of some frames")
    lines += [f"ParaView from its start, {result.get('timeline_millions', plan.TIMELINE_MILLIONS):g} million triangles of the Wavelet (the paper: 8): "
              "`gluray --timeline`, `gluray timeline`.", ""]
    lines += ["## Limits of these measurements", ""]
    if machine["load_before"] > BUSY:
        lines.append(f"- The machine was busy when the run began (load {machine['load_before']:.1f}): do not take its times as a measure of speed.")
    lines += [f"- {note}." for note in result["notes"]] + list(not_traced(rows))
    left = reasons(rows)
    if left:
        lines += ["- Drawn by the real OpenGL in the measured frames, beside the traced surfaces:", *[f"  {line}" for line in left]]
    return "\n".join(lines).rstrip() + "\n"
