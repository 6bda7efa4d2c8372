"""How import gluray finds, starts and leaves hubs, and what it takes from them: hub_python_test.py GLURAY PYTHON_FOLDER."""
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

from memory_hub import FakeProgram, line_of, seek_hub
from python_case import FOLDER, GLURAY, ROWS, PythonCase, gluray


class HubPython(PythonCase):
    def test_forked_children_connect_anew(self):
        """Even while another thread of the parent waits for an answer, which holds the lock."""
        os.environ["GLURAY"] = GLURAY
        code = """
import gluray, os, sys, threading, time, warnings
warnings.simplefilter("ignore", DeprecationWarning)  # Python 3.12 and later warn of fork() beside threads
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
