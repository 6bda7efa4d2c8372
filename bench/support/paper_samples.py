"""What tests of the paper's evaluation share: rows and results as a run has them, a folder, engines that measure instantly."""
import pathlib
import tempfile
import unittest

from paper import plan, results

def measurement(frame_s, triangles=1000, report=None, **more):
    return {"frame_s": frame_s, "frame_low_s": 0.9 * frame_s, "frame_high_s": 1.2 * frame_s, "frames": 10, "triangles": triangles,
            "first_image_s": 2 * frame_s, "rss_bytes": 5, "report": report, **more}


TRACED = {"draws": {"traced": 7, "rasterised": {"lines": 2}}}


def result_of(rows):
    return {"rows": rows, "date": "today", "command": "scripts/bench paper", "threads": 2, "rounds": 1, "gpu": "none", "notes": ["a note"],
            "machine": {"cpu": "A CPU", "cores": 2, "memory": "8 kB", "system": "Linux", "load_before": 0.0},
            "versions": {"source": "abc", "source_modified": False, "embree": "e", "mesa": "m"}}


def small_rows():
    """Rows as a small run has them: speed by size, the paper's size of the Wavelet among them."""
    rows = []
    for millions, ours, one, both in ((1, 0.02, 0.2, 0.1), (4, 0.04, 1, 0.5), (16, 0.08, 4, 2)):
        measured = {"gluray": [measurement(ours, millions * 10**6, TRACED)], "mesa1": [measurement(one, millions * 10**6)],
                    "mesa": [measurement(both, millions * 10**6)]}
        rows += [results.row_of(plan.Row("Wavelet", "client", "list", "wavelet", millions), measured),
                 results.row_of(plan.Row("PV-Wavelet", "ParaView", "buffers", "wavelet", millions), measured)]
        rows += results.build_rows(plan.Row("Wavelet", "client", "list", "wavelet", millions), {
            quality: {"build_s": seconds * millions, "first_image_s": 1, "triangles": millions * 10**6, "bvh_bytes": 70e6 * millions}
            for quality, seconds in (("fast", 0.05), ("full", 0.15))})
    return rows


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class FakeEngines:
    """Measures instantly; can simulate a failure or an interruption at a call."""

    def __init__(self, folder, at=None, error=None):
        self.calls, self.folder, self.at, self.error = [], folder, at, error

    def mesh_file(self, _row):
        return self.folder / "there.mesh"

    def measure(self, row, engine):
        self.calls.append(f"{row.name} {engine}")
        if len(self.calls) == self.at:
            raise self.error
        return measurement(0.1 if engine == "gluray" else 0.4, report=TRACED)

    def measure_build(self, row, quality):
        self.calls.append(f"{row.name} {quality}")
        return {"build_s": 1, "first_image_s": 2, "triangles": 1000, "bvh_bytes": 60000}
