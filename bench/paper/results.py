"""From measurements to the rows of a result file."""
import statistics

from paper import plan


def rasterised(report):
    """{reason: draws} left to the real OpenGL."""
    return (report or {}).get("draws", {}).get("rasterised", {})


def whole(millions):
    """A whole number as such: it is part of the row's name."""
    return int(millions) if millions == int(millions) else millions


def engine_figures(rounds):
    """Figures of one engine from its rounds: the median of their medians, and how far the frames' quartiles reach."""
    out = {"fps": 1 / statistics.median(r["frame_s"] for r in rounds), "fps_low": 1 / max(r["frame_high_s"] for r in rounds),
           "fps_high": 1 / min(r["frame_low_s"] for r in rounds), "frames": sum(r["frames"] for r in rounds),
           "rounds": len(rounds), "first_image_s": statistics.median(r["first_image_s"] for r in rounds),
           "rss_bytes": max(r["rss_bytes"] for r in rounds)}
    draws = (rounds[-1].get("report") or {}).get("draws")
    if draws:
        out["draws_traced"] = draws.get("traced", 0)
    return out


def row_of(row, measured):
    """A row of the result file; measured: {engine: [measurement a round]}, without those that failed."""
    any_round = next(iter(measured.values()))[0]
    out = {"scene": row.scene, "program": row.program, "path": row.path, "millions": whole(row.millions), "triangles": any_round["triangles"]}
    for engine, rounds in measured.items():
        out[engine] = engine_figures(rounds)
    for slower in ("mesa1", "mesa", "gpu"):
        if slower in out and "gluray" in out:
            out[f"gluray_over_{slower}"] = out["gluray"]["fps"] / out[slower]["fps"]
    if "gluray" in measured:
        out["rasterised"] = rasterised(measured["gluray"][-1].get("report"))
    paper = plan.PAPER_TABLE.get(row.scene)
    if paper and paper["millions"] == row.millions:
        out["paper_size"] = True
    return out


def build_rows(row, measured):
    """Rows about acceleration structures; measured: {quality: measurement}."""
    for quality, m in measured.items():
        yield {"scene": "build", "program": row.program, "path": quality, "millions": whole(row.millions), "triangles": m["triangles"],
               "build_s": m["build_s"], "first_image_s": m["first_image_s"], "bvh_bytes_per_triangle": m["bvh_bytes"] / m["triangles"],
               "mtri_per_s": m["triangles"] / 1e6 / m["build_s"] if m["build_s"] else 0.0}


def table_rows(rows):
    """{name in the paper's Table 1: its row}: of several sizes that of the paper, or the largest."""
    out = {}
    for row in rows:
        name = row["scene"]
        if name in plan.PAPER_TABLE and (name not in out or row.get("paper_size") or
                                         (not out[name].get("paper_size") and row["millions"] > out[name]["millions"])):
            out[name] = row
    return {name: out[name] for name in plan.PAPER_TABLE if name in out}


def sweep_rows(rows, scene):
    """Rows of the Wavelet by size: scene "Wavelet" (client) or "PV-Wavelet" (ParaView)."""
    return sorted((row for row in rows if row["scene"] == scene), key=lambda row: row["triangles"])
