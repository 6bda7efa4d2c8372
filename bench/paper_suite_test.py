"""The paper's evaluation without its measurements: plan, store, messages (no program is measured)."""
import contextlib
import io
import pathlib
import signal
import subprocess
import sys
import time
import types
import unittest

sys.dont_write_bytecode = True
BENCH = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(BENCH))
from paper import plan, results, store  # noqa: E402
from suites import compare  # noqa: E402
from suites import paper as suite  # noqa: E402
from support import programs  # noqa: E402
from support.paper_samples import TRACED, FakeEngines, InFolder, measurement, result_of, small_rows  # noqa: E402

PLENTY = 1e15


class Plan(unittest.TestCase):
    def test_names_of_the_small_version_are_stable(self):
        rows, notes = plan.rows(plan.SMALL_SCALE, plan.SMALL_SWEEP, PLENTY)
        self.assertEqual(notes, [])
        self.assertEqual([row.name for row in rows], [
            "Wavelet client list 1M", "PV-Wavelet ParaView buffers 1M", "Wavelet client list 4M", "PV-Wavelet ParaView buffers 4M",
            "Wavelet client list 16M", "PV-Wavelet ParaView buffers 16M", "VI-Wavelet VTK buffers 16M", "PV-VPIC ParaView buffers 2.6M",
            "VI-VPIC VTK buffers 2.6M", "EnSight-VPIC client immediate 2.6M", "PV-RMI ParaView buffers 7.9M", "PV-RMO ParaView buffers 7.9M",
            "VAPOR-Star client elements 2.1M"])

    def test_the_full_version_has_the_papers_sizes(self):
        rows, _ = plan.rows(1, plan.FULL_SWEEP, PLENTY)
        for row in rows:
            if row.scene in plan.PAPER_TABLE and row.data != "wavelet":
                self.assertEqual(row.millions, plan.PAPER_TABLE[row.scene]["millions"])
        self.assertIn(plan.Row("Wavelet", "client", "list", "wavelet", 256), rows)  # with plenty of memory
        self.assertEqual(len(rows), len(set(rows)))

    def test_what_does_not_fit_is_smaller_or_left_out_and_told(self):
        rows, notes = plan.rows(1, plan.FULL_SWEEP, 20.5e9)
        self.assertTrue(all(row.engine_needs("gluray") <= 20.5e9 for row in rows))
        by_scene = {row.scene: row for row in rows}
        self.assertEqual(by_scene["PV-RMI"].millions, 79)  # 316 halved twice
        self.assertEqual(by_scene["PV-RMI"].millions, by_scene["PV-RMO"].millions)
        self.assertEqual([(row.path, row.millions) for row in rows if row.scene == "Wavelet"][-2:], [("list", 128), ("vbo", 256)])
        self.assertTrue(any("PV-Wavelet ParaView buffers 256M is left out with GLuRay and Mesa" in note for note in notes), notes)
        self.assertTrue(any("Wavelet client vbo 256M is left out with Mesa:" in note for note in notes), notes)
        self.assertTrue(any("PV-RMI ParaView buffers 316M is measured with 79M" in note for note in notes), notes)
        self.assertEqual(plan.rows(1, (1,), 1e6)[0], [])

    def test_large_rows_of_the_small_version_are_measured_once(self):
        small, large = plan.Row("a", "client", "list", "wavelet", 2), plan.Row("a", "client", "list", "wavelet", 4)
        self.assertEqual([plan.rounds_of(small, 2, False), plan.rounds_of(large, 2, False), plan.rounds_of(large, 3, True)], [2, 1, 3])


class Kept(InFolder):
    def test_what_was_kept_is_known_again_by_the_same_build_alone(self):
        file = self.folder / "deep" / "kept.jsonl"
        first = store.Store(file, "build 1")
        first.keep("a", {"x": 1})
        first.keep("b", {"x": 2})
        again = store.Store(file, "build 1")
        self.assertEqual((again["a"], again["b"], "c" in again, again.others), ({"x": 1}, {"x": 2}, False, 0))
        other = store.Store(file, "build 2")
        self.assertEqual(("a" in other, other.others), (False, 2))
        self.assertNotIn("a", store.Store(file, "build 1", fresh=True))
        self.assertNotIn("a", store.Store(file, "build 1"))

    def test_a_line_cut_short_is_no_measurement_and_spoils_no_other(self):
        file = self.folder / "kept.jsonl"
        store.Store(file, "s").keep("a", {"x": 1})
        with file.open("a") as out:
            out.write('{"stamp": "s", "key": "b", "meas')
        store.Store(file, "s").keep("c", {"x": 3})
        again = store.Store(file, "s")
        self.assertEqual(sorted(again.known), ["a", "c"])

    def test_stamps_tell_builds_and_machines_apart(self):
        file = self.folder / "engine"
        file.write_bytes(b"one")
        stamps = [store.stamp_of([file], cpu="a"), store.stamp_of([file], cpu="b")]
        file.write_bytes(b"two")
        stamps.append(store.stamp_of([file], cpu="a"))
        self.assertEqual(len(set(stamps)), 3)
        self.assertEqual(stamps[2], store.stamp_of([file], cpu="a"))


class Resume(InFolder):
    ROWS = [plan.Row("Wavelet", "client", "list", "wavelet", 1), plan.Row("PV-RMI", "ParaView", "buffers", "mixing", 2)]

    def setUp(self):
        super().setUp()
        (self.folder / "there.mesh").write_bytes(b"")
        self.options = types.SimpleNamespace(rounds=2, full=False, threads=2, build=self.folder, timeout=9)

    def run_with(self, fake):
        run = suite.Run(self.options, store.Store(self.folder / "kept.jsonl", "s"), fake, ["gluray", "mesa1"])
        with contextlib.redirect_stderr(io.StringIO()):
            run.measure(self.ROWS)
        return run

    def test_engines_take_turns_round_by_round(self):
        fake = FakeEngines(self.folder)
        self.run_with(fake)
        one, two = (row.name for row in self.ROWS)
        self.assertEqual(fake.calls, [f"{one} gluray", f"{one} mesa1", f"{one} gluray", f"{one} mesa1", f"{two} gluray", f"{two} mesa1",
                                      f"{two} gluray", f"{two} mesa1", f"{one} fast", f"{one} full"])

    def test_an_interrupted_run_goes_on_where_it_was(self):
        first = FakeEngines(self.folder, 4, KeyboardInterrupt())
        with self.assertRaises(KeyboardInterrupt):
            self.run_with(first)
        second = FakeEngines(self.folder)
        run = self.run_with(second)
        self.assertEqual(len(second.calls), 7)
        self.assertEqual(second.calls[0], first.calls[3])
        self.assertEqual([row["scene"] for row in run.rows(self.ROWS)], ["Wavelet", "PV-RMI", "build", "build"])
        third = FakeEngines(self.folder)
        self.run_with(third)
        self.assertEqual(third.calls, [])

    def test_engines_without_memory_are_left_out(self):
        fake = FakeEngines(self.folder)
        rows = [plan.Row("Wavelet", "client", "vbo", "wavelet", 256)]
        run = suite.Run(self.options, store.Store(self.folder / "kept.jsonl", "s"), fake, ["gluray", "mesa1"], 20.5e9)
        with contextlib.redirect_stderr(io.StringIO()):
            run.measure(rows)
        self.assertEqual({call.rsplit(" ", 1)[1] for call in fake.calls}, {"gluray"}, "a fast structure would not fit")
        self.assertEqual(set(next(run.rows(rows))) & {"gluray", "mesa1"}, {"gluray"})

    def test_what_fails_is_told_and_the_rest_goes_on(self):
        run = self.run_with(FakeEngines(self.folder, 1, programs.Failed("exit code 9: it\nwith more")))
        rows = list(run.rows(self.ROWS))
        self.assertEqual(rows[0]["gluray"]["rounds"], 1)
        self.assertEqual(rows[1]["gluray"]["rounds"], 2)
        self.assertEqual(run.notes, ["Wavelet client list 1M gluray 0 failed: exit code 9: it"])


class Rows(unittest.TestCase):
    def test_medians_and_spread_over_rounds(self):
        row = results.row_of(plan.Row("PV-RMI", "ParaView", "buffers", "mixing", 2.0),
                             {"gluray": [measurement(0.1, report=TRACED), measurement(0.3, report=TRACED), measurement(0.2, report=TRACED)],
                              "mesa1": [measurement(2.0)]})
        self.assertAlmostEqual(row["gluray"]["fps"], 5)
        self.assertAlmostEqual(row["gluray"]["fps_low"], 1 / 0.36)
        self.assertAlmostEqual(row["gluray"]["fps_high"], 1 / 0.09)
        self.assertAlmostEqual(row["gluray_over_mesa1"], 10)
        self.assertEqual((row["gluray"]["frames"], row["rasterised"], row["millions"]), (30, {"lines": 2}, 2))
        self.assertNotIn("gluray_over_mesa", row)

    def test_of_several_sizes_table_one_has_the_papers(self):
        rows = small_rows()
        self.assertEqual(results.table_rows(rows)["PV-Wavelet"]["millions"], 16)
        self.assertEqual(results.table_rows([row for row in rows if row["millions"] < 16])["PV-Wavelet"]["millions"], 4)
        self.assertEqual(list(results.table_rows(rows)), ["PV-Wavelet"])

    def test_compare_reads_them_and_no_two_have_one_name(self):
        result = result_of(small_rows())
        names = [compare.name_of(row) for row in result["rows"]]
        self.assertEqual(len(names), len(set(names)))
        lines = [line.split() for line in compare.compare(result, result)]
        self.assertIn(["ParaView", "PV-Wavelet", "buffers", "16M", "gluray.fps", "12.5", "12.5", "1.000"], lines)
        self.assertIn(["client", "build", "full", "4M", "build_s", "0.6", "0.6", "1.000"], lines)


class Interrupted(InFolder):
    def test_nothing_is_left_running(self):
        """Child processes of the measured program end with us, too."""
        pid_file = self.folder / "pid"
        line = f"import signal; signal.signal(signal.SIGINT, signal.default_int_handler); from support import programs; programs.run(['sh', '-c', 'sleep 60 & echo $! >{pid_file}; wait'], {{}}, 50)"
        ours = subprocess.Popen([sys.executable, "-c", line], cwd=BENCH, stderr=subprocess.DEVNULL)
        self.addCleanup(ours.kill)
        deadline = time.monotonic() + 20
        while not (pid_file.exists() and pid_file.read_text().strip()) and time.monotonic() < deadline:
            time.sleep(0.02)
        ours.send_signal(signal.SIGINT)
        ours.wait(20)
        stat = pathlib.Path(f"/proc/{pid_file.read_text().strip()}/stat")
        while stat.exists() and stat.read_text().split()[2] != "Z" and time.monotonic() < deadline:
            time.sleep(0.02)
        self.assertTrue(not stat.exists() or stat.read_text().split()[2] == "Z")

    def test_what_takes_too_long_fails(self):
        with self.assertRaises(programs.Failed):
            programs.run(["sleep", "30"], {}, 0.2)


if __name__ == "__main__":
    unittest.main()
