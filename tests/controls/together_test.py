"""Programs, hubs, commands and Python together: together_test.py GLURAY CLIENT PYTHON_FOLDER, with an X server at hand."""
import json
import os
import queue
import signal
import subprocess
import sys
import threading
import time
import unittest

from fake_programs import FakePrograms, Peer, wait_for
from parts import Parts

CROWD = 200  # programs of one hub


class Together(Parts):
    def watch(self):
        """Events that `gluray watch` prints from now on."""
        events = queue.Queue()
        process = self.spawn(self.gluray, "watch", "--json", stderr=subprocess.DEVNULL)
        threading.Thread(target=lambda: [events.put(json.loads(line)) for line in process.stdout], daemon=True).start()
        return events

    def seen(self, events, name, setting, value):
        while True:
            event = events.get(timeout=30)
            if event["name"] == name and event.get("values", {}).get(setting, {}).get("value") == value:
                return

    def python(self, line):
        """What an expression of the module says."""
        done = subprocess.run([sys.executable, "-c", f"import gluray; print({line})"], capture_output=True, text=True, timeout=60,
                              env=self.environment | {"PYTHONPATH": PYTHON})
        self.assertEqual((done.returncode, done.stderr), (0, ""), line)
        return done.stdout.strip()

    def test_every_client_sees_what_the_others_do(self):
        self.two(), self.hub()
        self.assertEqual({name: p["ranks"] for name, p in self.listed(2).items()}, {"painter": 1, "sleeper": 1})
        events = self.watch()
        self.assertEqual(set(self.results("set", "-p", "painter", "spp=2")), {"painter"})
        self.seen(events, "painter", "spp", 2)
        both = self.results("set", "ao=on", "ao.samples=3")
        self.assertEqual({name: one["values"] for name, one in both.items()}, dict.fromkeys(["painter", "sleeper"], {"ao": True, "ao.samples": 3}))
        self.assertIsInstance(both["painter"]["frame"], int)
        self.seen(events, "sleeper", "ao.samples", 3)
        said = self.command("get", "--live", "ao.samples").stdout
        self.assertEqual([line.split(" = ")[1] for line in said.splitlines()], ["3", "3"], said)
        self.assertEqual(self.python("len(gluray.undo())"), "2")
        self.assertEqual(self.values("ao"), {"painter": False, "sleeper": False})
        self.seen(events, "painter", "ao", False)
        self.assertEqual(set(self.results("redo", "-p", "sleeper")), {"sleeper"})
        self.assertEqual(self.python("[p['ao'] for p in sorted(gluray.programs(), key=lambda p: p.name)]"), "[False, True]")
        self.assertEqual(self.python("gluray.programs('painter')[0]['spp']"), "2")

    def test_steps_outlive_hubs_that_are_killed(self):
        self.two()
        hub = self.hub()
        self.listed(2)
        self.results("set", "spp=2"), self.results("set", "spp=4")
        self.kill(hub)
        self.hub()
        self.listed(2)
        self.assertEqual(self.values("spp"), {"painter": 4, "sleeper": 4})
        for expected in (2, 1):
            self.results("undo")
            self.assertEqual(self.values("spp"), {"painter": expected, "sleeper": expected})
        self.assertIn("nothing to undo", self.refusal("undo", "-p", "painter"))
        self.assertEqual(self.results("redo")["sleeper"]["values"], {"spp": 2})

    def momentary(self, *words):
        """What a command without a hub says of the painter. On a machine that is busy it may not find it at once."""
        def found():
            done = self.command(*words, "-p", "painter", "--json")
            return None if "running program" in done.stderr or "no program runs" in done.stderr else done
        done = wait_for(found)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads(done.stdout)[0]["values"]

    def killed_hub(self, programs):
        """A hub that knew so many programs and was killed long enough ago for all of them to have looked for it often."""
        hub = self.hub()
        self.listed(programs)
        self.kill(hub)
        self.assertTrue((self.runtime / "hub.sock").exists())
        time.sleep(4)

    def test_commands_find_programs_whose_hub_was_killed(self):
        self.two()
        for spp in (2, 3, 4):
            self.killed_hub(2)
            self.assertEqual({name: one["values"] for name, one in self.results("set", f"spp={spp}").items()}, dict.fromkeys(["painter", "sleeper"], {"spp": spp}))

    def test_commands_wait_for_programs_with_slow_frames(self):
        self.program("slow", "always", "2500")
        self.killed_hub(1)
        self.assertEqual(self.results("set", "spp=2")["slow"]["values"], {"spp": 2})
        self.killed_hub(1)
        self.assertEqual(self.python("gluray.programs('slow')[0]['spp']"), "2")

    def test_commands_wait_for_slow_programs_whose_windows_are_not_known(self):
        self.program("slow", "always", "2500", "egl"), self.program("painter", "always", "10")
        self.killed_hub(2)
        windows = {(one := json.loads(file.read_text()))["name"]: one["window"] for file in (self.runtime / "programs").iterdir()}
        self.assertEqual((windows["slow"], windows["painter"] > 0), (0, True))
        self.assertEqual(self.results("set", "-p", "slow", "spp=2")["slow"]["values"], {"spp": 2})

    def test_programs_that_do_not_come_are_not_waited_for_long(self):
        asleep = self.program("painter", "always", "10")
        self.killed_hub(1)
        asleep.send_signal(signal.SIGSTOP)
        self.assertIn("a program runs under GLuRay that has not connected", self.refusal("set", "spp=2"))
        asleep.send_signal(signal.SIGCONT)
        self.assertEqual(self.results("set", "spp=2")["painter"]["values"], {"spp": 2})
        self.kill(asleep)
        self.assertIn("no program runs under GLuRay", self.refusal("set", "spp=2"))
        self.assertEqual(os.listdir(self.runtime / "programs"), [])

    def test_commands_that_are_hubs_for_a_moment(self):
        self.two()
        for words, value in ((["set", "spp=2"], 2), (["set", "spp=3"], 3), (["undo"], 2), (["undo"], 1), (["redo"], 2)):
            self.assertEqual(self.momentary(*words), {"spp": value}, words)
        self.assertFalse((self.runtime / "hub.sock").exists())

    def test_a_hub_that_is_killed_in_the_middle_of_a_drag(self):
        painter, hub = self.program("painter", "always", "10"), self.hub()
        number = self.listed(1)["painter"]["program"]
        peer = Peer(self.runtime)
        for value in range(1, 101):
            id = peer.start("set", program=number, values={"ao.samples": value}, gesture="drag")
            if value == 50:
                self.assertIn("frame", peer.answer(id)["results"][0])
        self.kill(hub)
        peer.close()
        before = self.frames(painter)
        self.assertTrue(wait_for(lambda: self.frames(painter) > before + 10), "frames go on without a hub")
        self.hub()
        number = self.listed(1)["painter"]["program"]
        peer = Peer(self.runtime)
        self.addCleanup(peer.close)
        for value in range(101, 201):
            id = peer.start("set", program=number, values={"ao.samples": value}, gesture="drag")
        self.assertEqual(peer.answer(id)["results"][0]["values"], {"ao.samples": 200})
        self.assertEqual(self.values("ao.samples"), {"painter": 200})
        # Gestures of two clients are two steps.
        self.assertIn(peer.ask("undo", program=number)["results"][0]["values"]["ao.samples"], range(50, 101))
        self.assertEqual(peer.ask("undo", program=number)["results"][0]["values"], {"ao.samples": 16})

    def test_a_program_that_is_killed(self):
        painter, _ = self.two()
        self.hub()
        self.listed(2)
        self.kill(painter)
        self.listed(1)
        self.assertEqual(set(self.results("set", "spp=2")), {"sleeper"})

    def test_a_program_that_is_stopped(self):
        painter, _ = self.two()
        self.hub()
        self.listed(2)
        self.results("set", "spp=2")
        painter.send_signal(signal.SIGSTOP)
        done = self.command("set", "--json", "ao=on")
        self.assertEqual(done.returncode, 1)
        both = {one["name"]: one for one in json.loads(done.stdout)}
        self.assertIn("answer", both["painter"]["why"])
        self.assertEqual(both["sleeper"]["values"], {"ao": True})
        painter.send_signal(signal.SIGCONT)
        before = self.frames(painter)
        self.assertTrue(wait_for(lambda: self.frames(painter) > before))
        self.assertEqual(self.values("spp"), {"painter": 2, "sleeper": 2})
        self.assertEqual(self.results("set", "-p", "painter", "ao.samples=5")["painter"]["values"], {"ao.samples": 5})

    def test_a_crowd(self):
        self.program("painter", "always", "10"), self.hub()
        crowd = FakePrograms(self.runtime, CROWD)
        self.addCleanup(crowd.close)
        self.listed(CROWD + 1)
        results = self.results("set", "spp=2")
        self.assertEqual(len(results), CROWD + 1)
        self.assertTrue(all(one["values"] == {"spp": 2} for one in results.values()))
        self.assertEqual(crowd.sets, CROWD)
        peer = Peer(self.runtime)
        self.addCleanup(peer.close)
        self.assertEqual(len(peer.ask("set", program="all", values={"spp": 3})["results"]), CROWD + 1)
        self.assertEqual(len(self.command("list").stdout.splitlines()), CROWD + 2)


if __name__ == "__main__":
    Parts.gluray, Parts.client, PYTHON = map(os.path.abspath, sys.argv[1:4])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
