"""The simulation of `scripts/bench scale`, and the chart of its results (no program is run)."""
import contextlib
import dataclasses
import io
import pathlib
import sys
import unittest
import xml.etree.ElementTree

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
from scale import chart, figure, worker_jobs  # noqa: E402
from scale.links import Link, links  # noqa: E402
from scale.shares import Shares  # noqa: E402
from scale.simulation import Costs, Job, simulate  # noqa: E402
from suites import scale  # noqa: E402

BYTES = {"order": 1000, "more": 20, "more_per_tile": 4, "tile": 8192, "end": 10, "finished": 100, "alive": 6}
FREE = Costs(before=[10.0] * 64, tiles=[10.0] * 64, begin=0.0, end=0.0, pack=0.0, take=0.0, give=0.0, sleep=1e-3, look=0.0, wake=0.0, bytes=BYTES)
NOTHING = Link("none", 0, 0, 0, 0, 0, "")


class SharesAsTheHeadMakesThem(unittest.TestCase):
    def test_a_rank_gets_a_third_of_its_rest_but_enough_for_its_threads(self):
        shares = Shares([1.0] * 120, 2, 4)
        self.assertEqual(shares.more(0), list(range(20)))
        self.assertEqual(shares.more(0), [])
        for _ in range(13):
            shares.finish(0)
        self.assertEqual(shares.more(0), list(range(20, 33)))

    def test_shares_cost_the_same_and_are_runs_of_neighbours(self):
        shares = Shares([4.0, 1.0, 1.0, 1.0, 1.0, 4.0], 3, 1)
        self.assertEqual(shares.rests, [[0], [1, 2, 3, 4], [5]])

    def test_whoever_is_done_takes_the_second_half_of_the_largest_rest(self):
        shares = Shares([1.0] * 40, 2, 1)
        taken = list(shares.more(0))
        while shares.rests[0]:
            for _ in range(shares.pending[0]):
                shares.finish(0)
            taken += shares.more(0)
        self.assertEqual(taken, list(range(20)))
        for _ in range(shares.pending[0]):
            shares.finish(0)
        self.assertEqual(shares.more(0), [30, 31, 32])
        self.assertEqual((shares.rests[0][0], shares.rests[1]), (33, list(range(20, 30))))


class Simulation(unittest.TestCase):
    def test_without_costs_of_messages_ranks_share_the_work(self):
        for ranks in (1, 2, 4, 8):
            done = simulate(FREE, NOTHING, ranks, 2)
            self.assertAlmostEqual(done.frame, 640 / (2 * ranks), delta=0.5)
            self.assertAlmostEqual(sum(done.busy), 640)
            self.assertAlmostEqual(done.balance, 1)

    def test_each_tile_is_traced_once(self):
        costs = dataclasses.replace(FREE, tiles=[float(1 + i * 7 % 50) for i in range(64)])
        traced = []

        class Watched(Job):
            def _at_tile_done(self, time, number, tile):
                traced.append(tile)
                super()._at_tile_done(time, number, tile)
        Watched(costs, Link("x", 1.5, 0.3, 0.3, 0.5, 0.25, ""), 5, 3).run()
        self.assertEqual(sorted(traced), list(range(64)))

    def test_equal_input_gives_equal_results(self):
        link = Link("x", 1.5, 0.3, 0.3, 0.5, 0.25, "")
        self.assertEqual(simulate(FREE, link, 7, 2), simulate(FREE, link, 7, 2))

    def test_pixels_pass_the_heads_link_one_after_the_other(self):
        slow = Link("slow", 0, 0, 0, 0, 10, "")  # 82 microseconds a tile
        done = simulate(FREE, slow, 64, 1)
        self.assertGreater(done.head_link, 60 * 81.92)
        self.assertGreater(done.frame, done.head_link)

    def test_the_heads_work_is_a_limit(self):
        done = simulate(dataclasses.replace(FREE, take=5.0, give=2.0), NOTHING, 64, 1)
        self.assertAlmostEqual(done.head, 64 * 5 + 63 * 2, delta=1e-6)
        self.assertGreater(done.frame, done.head)

    def test_each_look_of_the_head_takes_time(self):
        done = simulate(dataclasses.replace(FREE, look=3.0), NOTHING, 1, 1)
        self.assertAlmostEqual(done.head, 3.0 * done.looks, delta=1e-6)
        self.assertGreater(done.looks, 64)

    def test_messages_wait_for_the_end_of_a_sleep(self):
        awake = simulate(FREE, NOTHING, 2, 1).frame
        asleep = simulate(dataclasses.replace(FREE, sleep=100.0), NOTHING, 2, 1).frame
        self.assertTrue(awake < asleep < awake + 300)

    def test_published_links_come_with_their_sources(self):
        all_links = links({"half_round_trip_us": 1.5, "send_us": 0.25, "receive_us": 0.5, "gap_us": 0.6, "gap_per_byte_ns": 0.2})
        self.assertEqual(all_links["shm"].latency_us, 0.75)
        self.assertTrue(all(link.source and link.send_us == 0.25 for link in all_links.values()))


class Chart(unittest.TestCase):
    def test_ticks(self):
        self.assertEqual(chart.ticks(1, 8, 2), [1, 2, 4, 8])
        self.assertEqual(chart.ticks(0.5, 20, 10), [0.5, 1, 2, 5, 10, 20])

    def test_it_is_svg(self):
        simulated = [{"millions": 1.0, "look": look, "link": link, "threads": threads, "ranks": ranks,
                      "frame_ms": 100 / ranks} for look in figure.TITLES for link in figure.LINKS for threads in (1, 8) for ranks in (1, 2, 4)]
        measured = [{"millions": 1.0, "look": "local", "ranks": 2, "tracing_cpu_ms_a_rank": 20.0}]
        text = figure.figure(measured, simulated)
        self.assertEqual(text, figure.figure(measured, simulated))
        self.assertTrue(xml.etree.ElementTree.fromstring(text).tag.endswith("svg"))


class Suite(unittest.TestCase):
    def test_parts(self):
        self.assertEqual(scale.arguments([]).parts, list(scale.PARTS))
        self.assertEqual(scale.arguments(["--figure"]).parts, ["figure"])
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit):
            scale.arguments(["--parts", "image,nothing"])

    def test_ranks_share_cores_and_do_not_spin(self):
        line = worker_jobs.launcher(8)
        self.assertEqual(line[1:3], ["-n", "8"])
        self.assertIn("mpi_yield_when_idle", line)


if __name__ == "__main__":
    unittest.main()
