"""The figure of docs/performance.md: frame times by number of ranks, simulated, measured and published."""
from scale.chart import Panel, Series, svg
from scale.links import PUBLISHED

# Brownlee et al., GLuRay, Figure 10 (average render time; the text has these two) and its citation of Ize et al. 2011: (nodes, ms).
PAPER = [(1, 210.0), (64, 37.0)]
IZE = [(60, 10.0)]
Y_RANGE = (0.5, 5000)  # ms
TITLES = {"local": "local look", "occlusion": "ambient occlusion, 16 rays a pixel"}
LINKS = {"hdr": ("#4477aa", ""), "qdr": ("#ee6677", "7 3"), "shm": ("#228833", "2 3")}
NAMES = {"shm": "this machine's shared memory", **{key: link["name"] for key, link in PUBLISHED.items()}}


def _points(rows, **wanted):
    found = [row for row in rows if all(row.get(key) == value for key, value in wanted.items())]
    return sorted((row["ranks"], row["frame_ms"]) for row in found)


def _panel(look, millions, image_rows, simulated_rows):
    series = []
    for link, (color, dash) in LINKS.items():
        points = _points(simulated_rows, look=look, link=link, threads=8)
        series.append(Series(f"simulated, 8 threads a rank, {NAMES[link]}", color, points, dash=dash))
    first = series[0].points[0][1]
    most = min(first / Y_RANGE[0], 1024)
    series.append(Series("ideal, from one rank of 8 threads", "#777777", [(1, first), (most, first / most)], dash="1 3"))
    one_thread = _points(simulated_rows, look=look, link="shm", threads=1)
    series.append(Series("simulated, 1 thread a rank, this machine's shared memory", "#aa3377", one_thread, dash="7 3 2 3"))
    busy = sorted((row["ranks"], row["tracing_cpu_ms_a_rank"]) for row in image_rows if row["look"] == look and row["millions"] == millions)
    series.append(Series("measured, 1 thread a rank: tracing CPU time a rank", "#aa3377", busy, marker="circle", line=False))
    series.append(Series("paper, Figure 10 (RMO, 316 million triangles, 8 cores of 2009 a node)", "#333333", PAPER, marker="square", line=False))
    series.append(Series("Ize et al. 2011, ray-parallel, two megapixels, at best (cited in the paper)", "#bb9911", IZE, marker="diamond", line=False))
    return Panel(f"Wavelet, {millions:g}M triangles, {TITLES[look]}", "ranks", "ms a frame", (1, 1024), Y_RANGE, series)


def figure(image_rows, simulated_rows):
    """Text of the SVG."""
    millions = simulated_rows[0]["millions"]
    return svg([_panel(look, millions, image_rows, simulated_rows) for look in TITLES])
