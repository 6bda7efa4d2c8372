"""Commands that print what happens in running programs, with a hub that only pretends: watch_cli_test.py GLURAY."""
import json
import signal
import sys
import time
import unittest

from cli_case import CliCase


class Watch(CliCase):
    def until_observed(self, hub):
        end = time.monotonic() + 20
        while not any(r["type"] == "observe" for r in hub.requests) and time.monotonic() < end:
            time.sleep(0.01)
        time.sleep(0.1)  # its list

    def test_watch(self):
        hub, first, second = self.two()
        watch = self.watch()
        self.until_observed(hub)
        self.output("set", "-p", "1", "ao=on")
        self.assertEqual(watch.stdout.readline(), "paraview (4242): ao = true  (live)\n")
        hub.add("glxgears", 5)
        self.assertEqual(watch.stdout.readline(), "glxgears (5): started\n")
        hub.remove(second)
        self.assertEqual(watch.stdout.readline(), "vmd (77): ended\n")
        watch.send_signal(signal.SIGINT)
        self.assertEqual((watch.wait(20), watch.stderr.read()), (0, ""))

    def test_watch_as_json(self):
        hub, first, _ = self.two()
        watch = self.watch("--json", "--state", "-p", "1", "spp")
        self.until_observed(hub)
        self.output("set", "spp=4", "ao=on")
        self.assertEqual(json.loads(watch.stdout.readline()), {"what": "settings", "program": 1, "name": "paraview", "pid": 4242,
                                                               "values": {"spp": {"value": 4, "layer": "live", "place": ""}}})
        hub.tell({"type": "event", "what": "state", "program": 1, "state": {"frame": 3}})
        self.assertEqual(json.loads(watch.stdout.readline())["state"], {"frame": 3})
        watch.send_signal(signal.SIGTERM)
        self.assertEqual(watch.wait(20), 0)

    def test_watch_state(self):
        hub, first, _ = self.two()
        watch = self.watch("--state")
        self.until_observed(hub)
        self.assertEqual([(r["what"], r["every"]) for r in hub.requests if r["type"] == "observe"], [(["settings", "programs", "state"], 1)])
        hub.tell({"type": "event", "what": "state", "program": 1, "state": {
            "frame": 1042, "fps": 23.96, "triangles": 1000000, "traced": 0.985, "memory": 512345678, "noise": 0.0123, "passes": 14, "building": True,
            "progress": {"share": 0.437, "noise": 0.0123, "secondsLeft": 12.4}}})
        self.assertEqual(watch.stdout.readline(), "paraview (4242): frame 1042, 24.0 fps, 1 000 000 triangles, 98.5 % traced, 512 MB, noise 0.0123, "
                                                  "14 passes, 44 % refined, 12 s left, building a better structure\n")
        hub.tell({"type": "event", "what": "state", "program": 1, "state": {"frame": "x", "fps": 0, "traced": None, "triangles": -3, "memory": 1e300}})
        self.assertEqual(watch.stdout.readline(), "paraview (4242): 0.0 fps, 0 triangles\n")
        hub.end()
        self.assertEqual(watch.wait(20), 1)
        self.assertIn("the connection to the hub ended", watch.stderr.read())

    @staticmethod
    def rank(number, images, light, sent):
        return {"rank": number, "state": "connected", "host": f"node{number}", "images": images, "memory": 800e6, "bytes": {"sent": sent, "received": sent},
                "ms": {"image": 300, "eye": 12, "light": light, "waiting": {"scenes": 1, "depths": 2, "answers": 3}}}

    def test_top(self):
        hub, *_ = self.two()
        top = self.watch("--once", command="top")
        self.until_observed(hub)
        self.assertEqual([r["what"] for r in hub.requests if r["type"] == "observe"], [["state", "programs"]])
        for images in (10, 14):
            hub.tell({"type": "event", "what": "state", "program": 1,
                      "state": {"ranks": [self.rank(0, images, 200, 0), self.rank(1, images, 250, 1e6), {"rank": 2, "state": "lost"}]}})
            hub.tell({"type": "event", "what": "state", "program": 2, "state": {"fps": 23.96, "memory": 512345678}})
            time.sleep(0.2)
        head, *rows = [line.split() for line in top.stdout.read().splitlines()]
        self.assertEqual(head[:4], ["program", "rank", "host", "fps"])
        self.assertEqual([row[:4] for row in rows[:3]], [["paraview", "(4242)", "0", "node0"], ["paraview", "(4242)", "1", "node1"],
                                                         ["paraview", "(4242)", "2", "lost"]])
        self.assertEqual(rows[1][5:], ["12.0", "250.0", "6.0", "0.00", "0.00", "800"])
        self.assertTrue(5 < float(rows[0][4]) < 40, rows)
        self.assertEqual(rows[3][-7:], ["24.0", "-", "-", "-", "-", "-", "512"])
        self.assertEqual((top.wait(20), top.stderr.read()), (0, ""))

    def test_top_until_it_is_interrupted(self):
        hub, *_ = self.two()
        top = self.watch("--json", "-p", "2", command="top")
        self.until_observed(hub)
        hub.tell({"type": "event", "what": "state", "program": 2, "state": {"fps": 5, "memory": 1000}})
        for _ in range(2):
            row, = json.loads(top.stdout.readline())
            self.assertEqual((row["name"], row["rank"], row["fps"], row["eyeMs"], row["memory"]), ("vmd", None, 5, None, 1000))
        top.send_signal(signal.SIGINT)
        self.assertEqual((top.wait(20), top.stderr.read()), (0, ""))

    def test_watch_ends_in_time(self):
        self.hub()
        begin = time.monotonic()
        self.assertEqual(self.output("watch", "--seconds", "0.3"), "")
        self.assertLess(0.25, time.monotonic() - begin)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
