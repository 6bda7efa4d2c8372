"""import gluray, with a hub that only pretends: python_test.py GLURAY PYTHON_FOLDER."""
import contextlib
import io
import itertools
import os
import pathlib
import resource
import select
import signal
import socket
import subprocess
import sys
import threading
import time
import unittest

from memory_hub import FakeProgram, PICTURE, line_of, picture_of, seek_hub
from python_case import FOLDER, GLURAY, ROWS, PythonCase, gluray


class Python(PythonCase):
    def test_names_of_python_stay(self):
        names = {}
        exec("from gluray import *", names)
        self.assertEqual({"set", "help"} & set(names), set())
        self.assertIs(names["settings"], gluray.settings)

    def test_forked_children_connect_anew(self):
        """Even while another thread of the parent waits for an answer, which holds the lock."""
        os.environ["GLURAY"] = GLURAY
        code = """
import gluray, os, sys, threading, time
gluray.programs()
held = threading.Event()
def hold():
    with gluray.hub._lock:
        held.set()
        time.sleep(3)
threading.Thread(target=hold).start()
events = gluray.watch(what=["programs"])
held.wait()
hub, before = gluray.hub._child.pid, gluray.hub._connection
sockets = {os.readlink(f"/proc/self/fd/{c._socket.fileno()}") for c in gluray.connection.Connection.all}
pipe = os.readlink(f"/proc/self/fd/{gluray.hub._child.stdin.fileno()}")
child = os.fork()
if child == 0:
    open_now = set()
    for name in os.listdir("/proc/self/fd"):
        try:
            open_now.add(os.readlink(f"/proc/self/fd/{name}"))
        except OSError:
            pass
    gluray.programs()
    print(bool(open_now & (sockets | {pipe})), gluray.hub._child, gluray.hub._connection is before, len(gluray.programs()), flush=True)
    sys.exit(0)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), gluray.hub._connection is before, gluray.programs() == [], gluray.hub._child.poll())
"""
        with self.python(code) as python:
            said, failed = python.communicate(timeout=60)
        self.assertEqual((said, failed), ("False None False 0\n0 True True None\n", ""))

    def test_another_process_becomes_the_hub_first(self):
        self.own_hub("another hub runs already", first=True)
        with self.python("import gluray; print(gluray.programs(), gluray.hub._child.poll())") as python:
            said, failed = python.communicate(timeout=30)
        self.assertEqual((said, failed), ("[<gluray.Program late (9)>] 1\n", ""))

    def test_looking_up_a_name_has_a_limit(self):
        key = self.folder / "key"
        key.write_bytes(b"k" * 32)
        key.chmod(0o600)
        ended, real = threading.Event(), socket.getaddrinfo
        self.addCleanup(setattr, socket, "getaddrinfo", real)
        self.addCleanup(ended.set)
        socket.getaddrinfo = lambda *_, **__: [] if ended.wait() else []
        with self.assertRaisesRegex(gluray.HubError, "hub = far:4500: looking up the name takes too long"):
            gluray.connection.Connection("far:4500", str(key), seconds=0.2)

    def test_programs(self):
        self.two()
        paraview, vmd = gluray.programs()
        self.assertEqual((paraview.name, paraview.pid, paraview.ranks, paraview.since, repr(vmd)), ("paraview", 4242, 1, 1764000000.5, "<gluray.Program vmd (77)>"))
        self.assertEqual(gluray.programs("vmd"), [vmd])

    def test_set_and_get(self):
        _, first, second = self.two()
        paraview, vmd = gluray.programs()
        self.assertEqual(gluray.set(ao=True, **{"ao.samples": 8}), {paraview: 1042, vmd: None})
        self.assertEqual((first.live, second.live), ({"ao": True, "ao.samples": 8},) * 2)
        paraview["ao.samples"] = 32
        self.assertEqual((paraview["ao.samples"], paraview.get("ao"), vmd["ao.samples"]), (32, True, 8))
        self.assertEqual(paraview.why("ao.samples"), {"value": 32, "layer": "live", "place": ""})
        self.assertEqual(paraview.set({"ao": None}, ao_samples=4), 1042)
        self.assertEqual(first.live, {"ao.samples": 4})
        self.assertEqual(paraview.settings()["ao.samples"], 4)
        self.assertEqual(vmd.preset("draft"), None)
        self.assertEqual(second.live["preset"], "draft")
        gluray.preset("paper")
        self.assertEqual(first.live["preset"], "paper")

    def test_undo_and_gestures(self):
        _, first, _ = self.two()
        p = gluray.programs()[0]
        with p.gesture():
            for samples in (1, 2, 3):
                p["ao.samples"] = samples
        p["spp"] = 4
        gluray.programs("vmd")[0].set(spp=2)
        gluray.undo()
        self.assertEqual(first.live, {"ao.samples": 3})
        p.undo()
        self.assertEqual((first.live, p.redo(), first.live), ({}, 1042, {"ao.samples": 3}))
        gluray.redo()
        p.undo(), p.undo()
        self.assertEqual(self.refusal(p.undo), "paraview (4242): there is nothing to undo")

    def test_settings_for_a_while(self):
        _, first, second = self.two()
        gluray.programs()[0]["spp"] = 2
        with self.assertRaises(ZeroDivisionError), gluray.settings(ao=True, spp=4):
            self.assertEqual((first.live, second.live), ({"ao": True, "spp": 4},) * 2)
            gluray.programs()[0]["ao.samples"] = 3
            1 / 0
        self.assertEqual((first.live, second.live), ({"spp": 2, "ao.samples": 3}, {}))

    def test_shot(self):
        hub, first, _ = self.two()
        p = gluray.programs()[0]
        file = self.folder / "a.png"
        self.assertEqual((p.shot(file), p.shot(str(file))), ((5, 3), (5, 3)))
        self.assertEqual(picture_of(file), (5, 3, PICTURE))
        first.no_picture = "no"
        self.assertEqual(self.refusal(lambda: p.shot(file)), "paraview (4242): no")
        self.assertEqual([one.name for one in self.folder.iterdir() if one.name != "run"], ["a.png"])

    def test_shots_replace_pictures_alone(self):
        self.two()
        p = gluray.programs()[0]
        notes = self.folder / "notes.png"
        notes.write_text("notes")
        (self.folder / "folder.png").mkdir()
        (self.folder / "link.png").symlink_to("notes.png")
        for name in ("notes.png", "folder.png", "link.png"):
            self.assertIn("is no PNG file", self.refusal(lambda: p.shot(self.folder / name)))
        self.assertIn(".png", self.refusal(lambda: p.shot(self.folder / "a.jpg")))
        self.assertIn("No such file", self.refusal(lambda: p.shot(self.folder / "nowhere" / "a.png")))
        self.assertEqual(notes.read_text(), "notes")

    def test_wrong_shots(self):
        hub, *_ = self.two()
        p, size = gluray.programs()[0], {"shot": 1, "width": 5, "height": 3}
        for value in (3, {}, size | {"width": 0}, size | {"width": 1 << 40}, size | {"height": "3"}, size, size | {"pixels": "AAAA"}, size | {"pixels": "?"}):
            hub.instead["call"] = {"results": [{"program": 1, "value": value}]}
            self.assertEqual(self.refusal(lambda: p.shot(self.folder / "a.png")), "paraview (4242): it sends no picture")
        self.assertFalse((self.folder / "a.png").exists())

    def test_names(self):
        hub, first, _ = self.two()
        hub.rows += [{"name": "a.b-c", "value": 1, "layer": "built-in", "place": "", "default": 1}, {"name": "a.b.c", "value": 1, "layer": "built-in", "place": "", "default": 1}]
        p = gluray.programs()[0]
        p.set(camera_f_number=4, log_level="debug")
        self.assertEqual(first.live, {"camera.f-number": 4, "log-level": "debug"})
        self.assertEqual(self.refusal(lambda: p.set(ao_sample=1)), "paraview (4242): no setting is called 'ao_sample'")
        self.assertIn("no name", self.refusal(lambda: p.set({3: 1})))
        hub.add("third", 3)
        third = gluray.programs("third")[0]
        self.assertEqual(self.refusal(lambda: third.get("a_b_c")), "a_b_c may mean a.b-c or a.b.c; use the setting's own name")

    def test_values(self):
        _, first, _ = self.two()
        p = gluray.programs()[0]

        class Array:
            def tolist(self):
                return [1.0, 0.5]

        p["lights.up"] = Array()
        self.assertEqual(first.live["lights.up"], [1.0, 0.5])
        for value in (object(), float("nan"), {1, 2}):
            self.assertIn("a value is no boolean, number, text or list", self.refusal(lambda: p.set(spp=value)))
        self.assertEqual(p["spp"], 1)
        self.assertIn("longer than 1 MiB", self.refusal(lambda: p.set(report="x" * (1 << 20))))

    def test_programs_refuse(self):
        _, first, second = self.two()
        first.refuses["spp"] = "spp: not\nnow"
        self.assertEqual(self.refusal(lambda: gluray.set(spp=4)), "paraview (4242): spp: not now")
        self.assertEqual(second.live, {"spp": 4})

    def test_all_programs_get_one_request(self):
        hub, first, second = self.two()
        gluray.set(ao_samples=8), gluray.preset("draft"), gluray.undo(), gluray.redo()
        with gluray.settings(spp=3):
            pass
        sent = [(r["type"], r["program"]) for r in hub.requests if r["type"] not in ("list", "describe")]
        self.assertEqual(sent, [(kind, [1, 2]) for kind in ("set", "set", "undo", "redo", "get", "set", "set")])
        self.assertEqual((first.live, second.live), ({"ao.samples": 8, "preset": "draft"},) * 2)

    def test_silent_programs_delay_all_by_one_limit(self):
        programs = self.real_hub(*(FakeProgram(1, f"p{i}", i, ROWS) for i in range(1, 7)))
        gluray.set(spp=2)
        for program in programs[1:]:
            program.silent = ("set", "undo", "redo")
        silent, seen = [f"p{i} ({i})" for i in range(2, 7)], []
        for act in (lambda: gluray.set(spp=4), gluray.undo, lambda: gluray.settings(spp=5).__enter__()):
            begin = time.monotonic()
            said = self.refusal(act)
            self.assertLess(time.monotonic() - begin, 9)  # one after the other: 15
            self.assertEqual([name for name in silent if name in said], silent)
            self.assertNotIn("p1", said)
            seen.append(programs[0].live)
        self.assertEqual(seen, [{"spp": 4}, {"spp": 2}, {"spp": 2}])

    def test_two_clients(self):
        """A change of one is seen and taken back by the other; gestures of two clients are two steps, also where they meet."""
        first, second = self.real_hub(FakeProgram(1, "paraview", 4242, ROWS), FakeProgram(1, "vmd", 77, ROWS))
        paraview, vmd = sorted(gluray.programs(), key=lambda p: p.name)
        other = "import gluray, sys\np, = gluray.programs('paraview')\nwith p.gesture():\n"
        other += "    for line in sys.stdin:\n        print(p.set({'ao.radius': float(line)}), flush=True)\nprint(p.undo(), sorted(gluray.undo().values()))"
        with self.python(other) as python, paraview.gesture():
            for radius in (1, 2):
                paraview["ao.radius"] = radius
            python.stdin.write("3\n"), python.stdin.flush()
            self.assertEqual(python.stdout.readline(), "1042\n")
            paraview["ao.radius"] = 4
            self.assertEqual([step[1]["ao.radius"] for step in first.steps], [2, 3.0, 4])
            paraview.undo()
            self.assertEqual(paraview["ao.radius"], 3)
            vmd["spp"] = 2
            said, failed = python.communicate(timeout=20)
        self.assertEqual((said.split("\n")[0], failed), ("1042 [1042, 1042]", ""))
        self.assertEqual((first.live, second.live), ({}, {}))

    def test_settings_for_a_while_of_programs_that_differ(self):
        first, second, third = self.real_hub(*(FakeProgram(1, name, pid, ROWS) for pid, name in ((1, "a"), (2, "b"), (3, "c"))))
        a, b, _ = sorted(gluray.programs(), key=lambda p: p.name)
        a["ao.samples"], b["ao.samples"] = 2, 3
        with gluray.settings(ao_samples=9, spp=4):
            self.assertEqual([p.live for p in (first, second, third)], [{"ao.samples": 9, "spp": 4}] * 3)
        self.assertEqual([p.live for p in (first, second, third)], [{"ao.samples": 2}, {"ao.samples": 3}, {}])
        second.refuses["spp"] = "spp: not now"
        with self.assertRaisesRegex(gluray.GlurayError, r"^b \(2\): spp: not now$"), gluray.settings(spp=4):
            self.fail("the block is not entered")
        self.assertEqual([p.live for p in (first, second, third)], [{"ao.samples": 2}, {"ao.samples": 3}, {}])

    def test_the_hub_of_another_script_may_end(self):
        os.environ["GLURAY"] = GLURAY
        self.addCleanup(seek_hub(FakeProgram(1, "paraview", 4242, ROWS), self.folder / "run"))
        code = "import gluray, sys\nfor line in sys.stdin: p, = gluray.programs('paraview'); print(p.set(eval(line)), gluray.hub._child is not None, flush=True)"
        with self.python(code) as one, self.python(code) as two:
            for python, said in ((one, "1042 True\n"), (two, "1042 False\n")):
                python.stdin.write("{'spp': 2}\n"), python.stdin.flush()
                self.assertEqual(python.stdout.readline(), said)
            hub, = pathlib.Path(f"/proc/{one.pid}/task/{one.pid}/children").read_text().split()
            watched = os.pidfd_open(int(hub))
            self.addCleanup(os.close, watched)
            one.kill(), one.wait()
            self.assertTrue(select.select([watched], [], [], 20)[0])
            two.stdin.write("{'spp': 3}\n"), two.stdin.flush()
            self.assertEqual(two.stdout.readline(), "1042 True\n")
            two.communicate(timeout=20)

    def test_programs_that_end_meanwhile(self):
        hub, first, second = self.two()
        found = gluray.programs()
        hub.remove(second)
        real, gluray._some = gluray._some, lambda: found
        self.addCleanup(setattr, gluray, "_some", real)
        self.assertEqual(self.refusal(lambda: gluray.set(spp=4)), "vmd (77): it has ended")
        self.assertEqual(first.live, {"spp": 4})

    def test_state(self):
        hub, *_ = self.two()
        p = gluray.programs()[0]
        for fps, moment in ((0.0, 0.2), (24.0, 0.5)):
            event = {"type": "event", "what": "state", "program": 1, "state": {"fps": fps}}
            threading.Timer(moment, hub.tell, [event]).start()
        self.assertEqual(p.state(), {"fps": 24.0})
        self.assertEqual(self.refusal(lambda: p.state(seconds=0.2)), "paraview (4242): it does not tell its state")

    def test_watch(self):
        hub, first, second = self.two()
        events = gluray.watch(seconds=20)
        threading.Timer(0.3, lambda: (gluray.set(spp=4), hub.add("third", 3), hub.remove(second))).start()
        seen = list(itertools.islice((e for e in events if e.get("values") != {}), 4))
        self.assertEqual([(e["what"], e["program"].name, e["values"]["spp"]["value"]) for e in seen[:2]], [("settings", "paraview", 4), ("settings", "vmd", 4)])
        self.assertEqual([[p.name for p in e["programs"]] for e in seen[2:]], [["paraview", "vmd", "third"], ["paraview", "third"]])
        events.close()
        self.assertEqual(list(gluray.watch(what=["programs"], seconds=0.2)), [])
        events = gluray.watch()
        hub.add("fourth", 4)
        threading.Timer(0.3, hub.end).start()
        with self.assertRaisesRegex(gluray.HubError, "the connection to the hub ended"):
            list(events)

    def test_help(self):
        os.environ["GLURAY"] = GLURAY
        hub, *_ = self.two()
        for _ in range(2):  # from a program, then from the executable
            text = io.StringIO()
            with contextlib.redirect_stdout(text):
                gluray.help("ao.samples")
            self.assertIn("ao.samples (default: 16)", text.getvalue())
            self.assertIn("from 1 to 4096", text.getvalue())
            self.refusal(lambda: gluray.help("ao.sample"))
            hub.end()
            hub = self.hub()

    def test_no_program(self):
        self.hub()
        for act in (lambda: gluray.set(spp=4), gluray.undo, lambda: gluray.settings(spp=4).__enter__()):
            self.assertEqual(self.refusal(act), "no program runs under GLuRay; start one with: gluray PROGRAM")
        self.assertEqual(gluray.programs(), [])

    def test_no_hub(self):
        self.assertEqual(self.refusal(gluray.programs, gluray.HubError), "/nowhere/gluray: No such file or directory; set GLURAY to the path of the program gluray")
        del os.environ["GLURAY"]
        path, os.environ["PATH"] = os.environ["PATH"], "/nowhere"
        try:
            self.assertEqual(self.refusal(gluray.programs), "no hub runs here; start gluray panel or gluray hub, or set GLURAY to the path of the program gluray")
        finally:
            os.environ["PATH"] = path

    def test_a_hub_of_its_own_ends_with_the_process(self):
        self.own_hub()
        done = subprocess.run([sys.executable, "-c", "import gluray; print(gluray.programs()); gluray.set(ao=True)"], capture_output=True, text=True, timeout=30,
                              env={**os.environ, "PYTHONPATH": FOLDER})
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "[<gluray.Program late (9)>]\n", ""))
        self.assertFalse((self.folder / "run/hub.sock").exists())

    def test_a_hub_of_its_own_ends_however_the_process_ends(self):
        os.environ["GLURAY"] = GLURAY
        code = ("import gluray, os, sys; gluray.programs(); print(os.getpgid(gluray.hub._child.pid) != os.getpgid(0), gluray.hub._child.pid, flush=True);"
                "sys.stdin.readline(); os._exit(3)")
        for end in (signal.SIGTERM, signal.SIGKILL, signal.SIGINT, None):
            with self.subTest(end=end), self.python(code) as python:
                own, hub = python.stdout.readline().split()
                self.assertEqual(own, "True")
                watched = os.pidfd_open(int(hub))
                self.addCleanup(os.close, watched)
                if end:
                    python.send_signal(end)
                else:
                    python.stdin.write("\n"), python.stdin.flush()
                self.assertTrue(select.select([watched], [], [], 20)[0], "the hub goes on")
                self.assertFalse((self.folder / "run/hub.sock").exists())
                python.communicate(timeout=20)

    def test_a_hub_with_a_parent(self):
        for stdin in (subprocess.DEVNULL, subprocess.PIPE):
            done = subprocess.Popen([GLURAY, "hub", "--with-parent"], stdin=stdin, stderr=subprocess.PIPE, text=True)
            self.addCleanup(done.kill)
            self.assertIn("listens", done.stderr.readline())
            if stdin == subprocess.PIPE:
                done.stdin.write("word\n" * 1000), done.stdin.flush()
                with self.assertRaises(subprocess.TimeoutExpired):
                    done.wait(0.3)
            self.assertEqual((done.communicate(timeout=20), done.returncode), ((None, ""), 0))
        done = subprocess.run(["sh", "-c", '"$0" hub --with-parent <&-', GLURAY], capture_output=True, text=True, timeout=20)
        self.assertEqual(done.returncode, 0)

    def test_without_a_hub_gluray_hub_is_started(self):
        os.environ["GLURAY"] = GLURAY
        self.addCleanup(seek_hub(FakeProgram(1, "paraview", 4242, ROWS), self.folder / "run"))
        code = "import gluray; p, = gluray.programs(); p['spp'] = 4; print(p['spp'], p.set({'ao': True}), p.undo(), p.settings()['ao'])"
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=30, env={**os.environ, "PYTHONPATH": FOLDER})
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "4 1042 1042 False\n", ""))
        self.assertFalse((self.folder / "run/hub.sock").exists())

    def test_tcp_to_gluray_hub(self):
        key = str(self.folder / "key")
        subprocess.run([GLURAY, "hub", "--new-key", key], check=True, capture_output=True, timeout=20)
        hub = subprocess.Popen([GLURAY, "hub", "--listen", "127.0.0.1:0", "--key", key], stderr=subprocess.PIPE, text=True)
        self.addCleanup(hub.communicate)
        self.addCleanup(hub.terminate)
        self.addCleanup(setattr, gluray.hub, "_address", ("", ""))
        address = hub.stderr.readline().split()[-1]
        self.addCleanup(seek_hub(FakeProgram(1, "paraview", 4242, ROWS), self.folder / "run"))
        gluray.connect(address, key)
        time.sleep(0.5)
        gluray.set(spp=4)
        self.assertEqual(gluray.programs()[0]["spp"], 4)
        done = subprocess.run([GLURAY, "get", "--live", "--hub", address, "--key", key, "--why", "spp"], capture_output=True, text=True, timeout=20,
                              env={**os.environ, "GLURAY_RUNTIME": str(self.folder)})
        self.assertEqual((done.stdout, done.stderr), ("spp = 4  (live)\n  built-in  1\n  live      4\n", ""))
        (self.folder / "other").write_bytes(b"o" * 32)
        (self.folder / "other").chmod(0o600)
        self.assertIn("same key file", self.refusal(lambda: gluray.connect(address, str(self.folder / "other"))))

    def test_a_hub_of_its_own_that_does_not_start(self):
        self.own_hub("another hub hangs")
        self.assertEqual(self.refusal(gluray.programs), "gluray: another hub hangs")

    def test_a_hub_that_ends_is_found_again(self):
        hub, first, _ = self.two()
        p = gluray.programs()[1]
        hub.end()
        time.sleep(0.1)
        hub = self.hub()
        hub.add("other", 5), hub.add("more", 6)
        vmd = hub.add("vmd", 77)
        p["spp"] = 4  # has another number now
        self.assertEqual([one.live for one in hub.programs.values()], [{}, {}, {"spp": 4}])
        hub.remove(vmd)
        gluray.hub._drop()
        self.assertEqual(self.refusal(lambda: p.get("spp")), "vmd (77): it has ended")

    def test_hubs_that_fail(self):
        for instead, line in (("end", "the connection to the hub ended"), ("garbage", "is no message"), ({"why": "the hub is\nbusy"}, "the hub is busy"),
                              ({"results": [3, {"program": "x"}]}, "does not answer"), ({}, "does not answer"), ({"results": [{"program": 1, "why": 3}]}, ": 3")):
            hub = self.hub()
            hub.add("paraview", 4242)
            hub.instead["set"] = instead
            p = gluray.programs()[0]
            self.assertIn(line, self.refusal(lambda: p.set(spp=4)))
            hub.end()
            gluray.hub._drop()

    def test_hubs_that_never_answer(self):
        hub = self.hub()
        hub.instead["list"] = "silence"
        begin = time.monotonic()
        self.assertIn("the hub does not answer", self.refusal(gluray.programs))
        self.assertLess(time.monotonic() - begin, 8)

    def test_other_listeners_are_refused(self):
        for hello, line in ((line_of({"type": "hello", "version": 0, "role": "hub"}), "no hub of GLuRay"), (b"SSH-2.0-OpenSSH_9.2\n", "is no message"),
                            (b"[" * 100000 + b"\n", "is no message"), (line_of({"type": "error", "why": "the hub is full"}), "the hub is full")):
            hub = self.hub(hello=hello)
            self.assertIn(line, self.refusal(gluray.programs))
            hub.end()

    def test_unsafe_directories_are_refused(self):
        (self.folder / "run").mkdir(mode=0o755)
        self.assertIn("mode 700", self.refusal(gluray.programs))

    def test_descriptors_above_1023(self):
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        if hard != resource.RLIM_INFINITY and hard < 1300:
            self.skipTest("fewer descriptors are allowed")
        resource.setrlimit(resource.RLIMIT_NOFILE, (max(soft, 1300), hard))
        self.addCleanup(resource.setrlimit, resource.RLIMIT_NOFILE, (soft, hard))
        hub, first, _ = self.two()
        nothing = [os.open(os.devnull, os.O_RDONLY) for _ in range(1100)]
        for descriptor in nothing:
            self.addCleanup(os.close, descriptor)
        p = gluray.programs()[0]
        self.assertGreater(gluray.hub._connection._socket.fileno(), 1023)
        p["spp"] = 4
        self.assertEqual((first.live, p["spp"]), ({"spp": 4}, 4))
        self.assertEqual(list(gluray.watch(what=["state"], seconds=0.1)), [])

    def test_tcp(self):
        key = self.folder / "key"
        key.write_bytes(b"k" * 32)
        key.chmod(0o600)
        hub = self.hub(key=b"k" * 32)
        hub.add("paraview", 4242)
        self.addCleanup(setattr, gluray.hub, "_address", ("", ""))
        gluray.connect(hub.address, str(key))
        gluray.set(spp=4)
        self.assertEqual(gluray.programs()[0]["spp"], 4)
        self.assertIn("HOST:PORT", self.refusal(lambda: gluray.connect("nowhere", str(key))))
        key.write_bytes(b"l" * 32)
        self.assertIn("same key file", self.refusal(lambda: gluray.connect(hub.address, str(key))))
        key.write_bytes(b"k" * 31)
        self.assertIn("at least 32 bytes", self.refusal(lambda: gluray.connect(hub.address, str(key))))
        key.chmod(0o644)
        self.assertIn("chmod 600", self.refusal(lambda: gluray.connect(hub.address, str(key))))
        self.assertIn("no key file", self.refusal(lambda: gluray.connect(hub.address)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
