"""The output of `scripts/bench compare`, and the results of `scripts/bench micro` (no program is run)."""
import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest
import unittest.mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
from suites import compare, first, micro, objects, versions, volumes, wheels  # noqa: E402
from support import programs  # noqa: E402

OLD = {"machine": {"cpu": "A", "load_before": 1}, "versions": {"source": "1"},
       "rows": [{"millions": 1, "path": "list", "fps": 10.0, "ms": {"trace": 4.0}, "kind": "x"}, {"millions": 2, "path": "list", "fps": 5.0}]}
NEW = {"machine": {"cpu": "B", "load_before": 2}, "versions": {"source": "1"},
       "rows": [{"millions": 1, "path": "list", "fps": 20.0, "ms": {"trace": 1.0}, "new": 3}, {"millions": 4, "path": "list", "fps": 1.0}]}


class Compare(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_with(self, *results):
        """(exit status, standard output, standard error)."""
        files = []
        for i, result in enumerate(results):
            files.append(self.folder / f"{i}.json")
            files[-1].write_text(result if isinstance(result, str) else json.dumps(result))
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = compare.main([str(file) for file in files])
        return status, out.getvalue().splitlines(), err.getvalue()

    def test_rows_of_one_name_are_compared(self):
        status, out, _ = self.run_with(OLD, NEW)
        self.assertEqual(status, 0)
        self.assertEqual([line.split() for line in out],
                         [["cpu:", "A", "->", "B"], ["row", "figure", "old", "new", "new/old"], ["list", "1M", "fps", "10", "20", "2.000"],
                          ["list", "1M", "ms.trace", "4", "1", "0.250"], ["only", "in", "the", "old", "one:", "list", "2M"],
                          ["only", "in", "the", "new", "one:", "list", "4M"]])

    def test_what_was_nothing_has_no_ratio(self):
        _, out, _ = self.run_with({"rows": [{"millions": 1, "drawn": 0}]}, {"rows": [{"millions": 1, "drawn": 3}]})
        self.assertEqual(out[-1].split(), ["1M", "drawn", "0", "3", "-"])

    def test_what_is_no_result_is_told_in_one_line(self):
        for text in ("no json", "[]", '{"rows": 3}', "{}"):
            status, out, err = self.run_with(OLD, text)
            self.assertEqual((status, out, err.count("\n")), (1, [], 1), text)
            self.assertIn("1.json is not a result of scripts/bench", err)

    def test_results_in_the_repository_can_all_be_compared(self):
        for file in sorted(compare.RESULTS.rglob("*.json")):
            with self.subTest(file.name):
                result = compare.read(str(file.relative_to(compare.RESULTS).with_suffix("")))
                lines = compare.compare(result, result)
                self.assertGreater(len(lines), 1)
                self.assertTrue(all(line.split()[-1] in ("1.000", "-", "new/old") for line in lines))


class Micro(unittest.TestCase):
    @staticmethod
    def said(name, *rates, **more):
        return [{"name": name, "run_name": name, "run_type": "iteration", "items_per_second": rate, **more} for rate in rates] + [
            {"name": f"{name}_mean", "run_name": name, "run_type": "aggregate", "items_per_second": 1}]

    def test_rates_become_the_units_people_ask_for(self):
        runs = (self.said("door/vertex_call/iterations:10/manual_time", 5e8, 1e9, 2.5e8) + self.said("build/fast/manual_time", 2e7) +
                self.said("trace/frame/real_time", 50.0) + self.said("write_back/depth/real_time", 500.0))
        rows = {row["scene"]: row for row in micro.rows_of({"benchmarks": runs}, "GLuRay")}
        self.assertEqual(rows["door/vertex_call"], {"scene": "door/vertex_call", "path": "GLuRay", "ns_per_call": 2.0, "ns_per_call_low": 1.0,
                                                    "ns_per_call_high": 4.0})
        self.assertEqual((rows["build/fast"]["mtri_per_s"], rows["write_back/depth"]["ms"]), (20.0, 2.0))
        self.assertAlmostEqual(rows["trace/frame"]["mray_per_s"], 52.4288)

    def test_a_benchmark_that_failed_is_no_figure(self):
        with self.assertRaises(programs.Failed):
            list(micro.rows_of({"benchmarks": self.said("write_back/depth", 1.0, error_occurred=True, error_message="refused")}, "GLuRay"))


class Versions(unittest.TestCase):
    def test_a_row_holds_medians_and_their_ratio(self):
        row = versions.row_of("x", [{"ms": 10.0}, {"ms": 30.0}, {"ms": 20.0}], [{"ms": 10.0}, {"ms": 9.0}, {"ms": 50.0}])
        self.assertEqual((row["old"]["ms"], row["new"]["ms"], row["new_over_old"]["ms"]), (20.0, 10.0, 0.5))

    def test_builds_take_turns(self):
        class Program:
            name = "x"
            ran = []

            def measure(self, gluray, _options):
                self.ran.append(gluray.parts[0])
                return {"ms": 1.0}
        program = Program()
        with contextlib.redirect_stderr(io.StringIO()):
            versions.measure(program, versions.arguments(["old", "new", "--rounds", "3"]))
        self.assertEqual(program.ran, ["old", "new", "new", "old", "old", "new"])


class First(unittest.TestCase):
    @staticmethod
    def said(*seconds):
        return [{"first_image_s": s, "triangles": 12} for s in seconds]

    def test_ratios_are_those_of_rounds(self):
        row = first.row_of(4, "shader", {"plain": self.said(1.0, 2.0, 4.0), "gluray": self.said(1.5, 2.0, 4.4)})
        self.assertEqual((row["plain_first_image_s"], row["gluray_first_image_s"], row["rounds"]), (2.0, 2.0, 3))
        self.assertAlmostEqual(row["gluray_times_plain"], 1.1)
        self.assertAlmostEqual(row["gluray_times_plain_low"], 1.0)
        self.assertAlmostEqual(row["gluray_times_plain_high"], 1.5)

    def test_an_earlier_build_is_compared_with_both(self):
        row = first.row_of(1, "list", {"plain": self.said(2.0, 4.0), "gluray": self.said(1.0, 1.0), "before": self.said(2.0, 2.0)})
        self.assertEqual((row["scene"], row["gluray_times_before"], row["before_times_plain"]), ("wavelet", 0.5, 0.75))

    def test_both_take_turns_in_being_the_first(self):
        ran = []

        def plain(*_):
            ran.append("plain")
            return self.said(1.0)[0]

        def traced(*_):
            ran.append("gluray")
            return self.said(1.0)[0] | {"report": report}
        report = {}
        with unittest.mock.patch.multiple(programs, measure=plain, measure_with_gluray=traced, require=lambda *_: None):
            first.measured(first.arguments(["--rounds", "3"]), 1.0, {})
            self.assertEqual(ran, ["plain", "gluray", "gluray", "plain", "plain", "gluray"])
            report = None  # GLuRay was not loaded
            with self.assertRaises(programs.Failed):
                first.measured(first.arguments(["--rounds", "3"]), 1.0, {})


class TrialsOfObjects(unittest.TestCase):
    def test_frames_before_the_measured_ones_are_compared_by_number(self):
        plain = [0.125] * 300
        auto = [0.5] + [0.125] * 9 + [0.25] * 10 + [0.125] * 300  # the second that is left out ends before the slow ones
        overall, worst = objects.early_of(plain, auto, settle=13)
        self.assertEqual(overall, (12 - 1.25) / 12)
        self.assertEqual(worst, 5 / 6.25)
        self.assertEqual(objects.early_of(plain, auto, settle=1), (1.0, 1.0))

    def test_ways_are_compared_at_the_same_places_of_the_orbit(self):
        plain, other = [1.0] * 10 + [3.0] * 10, [0.5] * 4 + [2.0] * 8
        self.assertEqual(objects.last_of_both(plain, other, 6), (1.0, 2.0))
        self.assertEqual(objects.last_of_both(plain, other, 2), (3.0, 2.0))
        self.assertEqual(objects.last_of_both(plain, other[:1], 6), (1.0, 0.5))

    def test_short_runs_have_one_window(self):
        overall, worst = objects.early_of([0.1] * 30, [0.125] * 30, settle=3)
        self.assertAlmostEqual(overall, 0.8)
        self.assertAlmostEqual(worst, 0.8)


class Wheels(unittest.TestCase):
    def test_the_ratio_is_the_median_of_those_of_the_rounds(self):
        plain = [{"frame_s": s, "triangles": 500000} for s in (0.2, 0.4, 0.1)]
        traced = [{"frame_s": s, "report": None} for s in (0.1, 0.1, 0.1)]
        traced[-1]["report"] = {"triangles": {"traced": 3, "rasterised": 1}, "draws": {"rasterised": {"lines": 1}}}
        row = wheels.row_of("open3d", plain, traced)
        self.assertEqual((row["ratio"], row["ratios"], row["gl_ms"], row["gluray_ms"]), (2, [2, 4, 1], 200, 100))
        self.assertEqual((row["traced"], row["rasterised"]), (0.75, {"lines": 1}))

    def test_a_program_without_a_report_has_traced_nothing(self):
        row = wheels.row_of("vispy", [{"frame_s": 1, "triangles": 1}], [{"frame_s": 2, "report": None}])
        self.assertEqual((row["traced"], row["ratio"]), (0, 0.5))


class Volumes(unittest.TestCase):
    def test_the_ratio_is_the_median_of_those_of_the_rounds(self):
        traced = [{"frame_s": 0.1, "report": None, "rss_bytes": 3},
                  {"frame_s": 0.1, "report": {"draws": {"traced": 7, "rasterised": {}}}, "rss_bytes": 4}]
        row = volumes.row_of("dense", [{"frame_s": 0.4, "rss_bytes": 1}, {"frame_s": 0.6, "rss_bytes": 2}], traced)
        self.assertEqual((row["ratio"], row["gl_ms"], row["traced"]), (5, 500, 7))
        self.assertEqual((row["gl_rss_bytes"], row["gluray_rss_bytes"]), (2, 4))

    def test_unknown_types_are_refused(self):
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit):
            volumes.arguments(["--types", "halves"])
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit):
            volumes.arguments(["--fields", "thin"])


if __name__ == "__main__":
    unittest.main()
