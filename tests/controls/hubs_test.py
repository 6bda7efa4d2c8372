"""A program and hubs that end, say nothing or are not trusted, and its children: hubs_test.py GLURAY CLIENT PYTHON_FOLDER, with an X server at hand."""
import contextlib
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest

from fake_hub import Hub
from linked import CLIENT, Linked


class Ends(Linked):
    def test_no_thread_and_no_file_without_a_hub(self):
        self.start()
        threads, descriptors = self.threads(), self.descriptors()
        self.assertNotIn("gluray-control", threads)
        for _ in range(3):
            hub = Hub(self.runtime)
            self.connect(hub)
            self.assertIn("gluray-control", self.threads())
            hub.ask("observe", what=["state"], every=0.05)
            hub.event("state")
            hub.close()
            self.frames_until(lambda: "gluray-control" not in self.threads())
            self.assertNotIn("gluray-control", self.threads())
            self.assertLessEqual(self.descriptors(), descriptors)
        self.assertEqual(self.lines(), [])

    def test_the_next_hub_finds_the_program_and_its_settings(self):
        hub = self.linked()
        plain = self.frame()
        self.set(hub, values={"ao": True})
        occluded = self.frame()
        self.assertNotEqual(occluded, plain)
        hub.close()
        self.assertEqual([self.frame() for _ in range(5)], [occluded] * 5)
        hub = self.hub()
        self.connect(hub)
        self.assertEqual(hub.ask("get", names=["ao"])["values"]["ao"]["layer"], "live")

    def test_what_hubs_leave_is_no_hub(self):
        hub = self.linked()
        hub.hang_up()
        hub.listener.close()  # the socket's file stays
        plain = self.frame()
        until = time.monotonic() + 3
        while time.monotonic() < until:
            self.assertEqual(self.frame(), plain)
        os.remove(hub.path)
        self.connect(self.hub())

    def test_garbage(self):
        hub = self.linked()
        plain = self.frame()
        self.set(hub, values={"ao": True})
        occluded = self.frame()
        deep = b"[" * 200 + b"]" * 200
        for bytes in (b"what?\n", b"\n", b"[]\n", b"{}\n", b'{"type":3}\n', b'{"type":"get","id":1,"names":' + deep + b"}\n", b"\xff\xfe{\n",
                      b'{"type":"x","id":1,"\xc3\x28":1}\n', b"x" * (3 << 20), b'{"type":"set","values":"' + b"y" * (2 << 20) + b'"}\n', b"\0" * 5000 + b"\n"):
            try:
                hub.peer.sendall(bytes)
                while (message := hub.message()) is not None:
                    self.assertEqual(message["type"], "error")
            except (BrokenPipeError, ConnectionResetError):
                pass
            self.assertEqual(self.frame(), occluded, bytes[:20])
            hub.hang_up()
            self.connect(hub)
        for first in ({"type": "get", "id": 1}, {"type": "hello", "version": 0}, {"type": "hello"}):
            hub.hang_up()
            self.assertTrue(self.frames_until(lambda: hub.wait_for_program(0.02)))
            hub.tell(first)
            while (message := hub.message()) is not None:
                self.assertIn(message["type"], ("hello", "error"))
        self.assertEqual(self.frame(), occluded)
        self.assertEqual(self.lines(), [])

    def test_wrong_members_are_answered(self):
        hub = self.linked()
        plain = self.frame()
        nonsense = (None, True, -1, 1.5, 1e300, "x" * 5000, [], [[]], {}, {"a": 1})
        for type in ("get", "set", "undo", "apply", "draw", "drop", "observe", "call"):
            for member in ("names", "values", "hold", "gesture", "of", "frame", "what", "every", "name", "arguments"):
                for value in nonsense:
                    hub.start(type, **{member: value})
        last, answered = hub.start("get", names=["ao"]), set()
        while last not in answered:
            message = hub.message()
            self.assertIn(message["type"], ("answer", "event"))
            answered.add(message.get("id"))
        self.assertEqual(self.frame(), plain)


class Silence(Linked):
    def speed(self, seconds=1):
        """Frames a second, and the longest one."""
        count, longest, until = 0, 0.0, time.monotonic() + seconds
        while time.monotonic() < until:
            before = time.monotonic()
            self.frame()
            count, longest = count + 1, max(longest, time.monotonic() - before)
        return count / seconds, longest

    def test_hubs_that_say_nothing(self):
        self.start()
        hub = self.hub()
        self.assertTrue(self.frames_until(lambda: hub.wait_for_program(0.02)))
        rate, longest = self.speed()
        self.assertGreater(rate, 2)
        self.assertLess(longest, 4)  # a hub has five seconds for hello
        self.assertTrue(self.frames_until(lambda: "gluray-control" not in self.threads()), "it waits for hello for five seconds")

    def test_hubs_that_do_not_accept(self):
        self.start()
        self.hub()
        rate, longest = self.speed()
        self.assertGreater(rate, 2)
        self.assertLess(longest, 4)  # a hub has five seconds for hello

    def test_hubs_that_do_not_read(self):
        hub = self.linked()
        hub.ask("observe", what=["state", "settings"], every=0.05)
        for _ in range(20000):
            hub.start("get", names=["ao"])
            if not self.threads().count("gluray-control"):
                break
        self.assertGreater(self.speed()[0], 2)

    def test_stopped_hubs(self):
        script = ("import sys; sys.path.insert(0, sys.argv[2]); from fake_hub import Hub; hub = Hub(sys.argv[1]); hub.wait_for_program(60); hub.greet();"
                  "hub.ask('observe', what=['state'], every=0.05); print('ready', flush=True)\nwhile True: hub.event('state')")
        self.start()
        hub = subprocess.Popen([sys.executable, "-c", script, self.runtime, os.path.dirname(__file__)], stdout=subprocess.PIPE, text=True)
        self.addCleanup(hub.stdout.close)
        self.addCleanup(hub.wait)
        self.addCleanup(hub.kill)
        ready = threading.Thread(target=hub.stdout.readline)
        ready.start()
        self.assertTrue(self.frames_until(lambda: not ready.is_alive()))
        hub.send_signal(signal.SIGSTOP)
        rate, longest = self.speed(2)
        self.assertGreater(rate, 2)
        self.assertLess(longest, 4)  # a hub has five seconds for hello
        hub.kill()
        self.assertTrue(self.frames_until(lambda: "gluray-control" not in self.threads()))


class Trust(Linked):
    def refused(self, folder, *options):
        """Whether a program does not use the hub of this folder."""
        hub = Hub(folder)
        self.addCleanup(hub.close)
        self.start(*options)
        for _ in range(30):
            self.frame()
            time.sleep(0.01)
        self.assertNotIn("gluray-control", self.threads())
        return not hub.wait_for_program(0)

    def test_directories_that_others_may_write(self):
        self.runtime.mkdir()
        self.runtime.chmod(0o755)
        self.assertTrue(self.refused(self.runtime))
        self.assertEqual(len(self.lines()), 1, self.lines())
        self.assertIn("mode 755", self.lines()[0])
        self.assertFalse((self.runtime / "programs").exists())

    def test_links(self):
        (self.folder / "other").mkdir(mode=0o700)
        self.runtime.symlink_to(self.folder / "other")
        self.assertTrue(self.refused(self.runtime))
        self.assertIn("symbolic link", self.lines()[0])
        self.assertFalse((self.folder / "other/programs").exists())

    @unittest.skipIf(os.getuid(), "only root gives directories away")
    def test_other_users(self):
        self.runtime.mkdir(mode=0o700)
        os.chown(self.runtime, 65534, 65534)
        self.assertTrue(self.refused(self.runtime))
        self.assertIn("another user", self.lines()[0])

    def test_unsafe_directories_without_a_hub_are_no_matter(self):
        self.runtime.mkdir()
        self.runtime.chmod(0o755)
        self.start()
        self.frame()
        self.assertEqual(self.lines(), [])

    def test_off(self):
        self.assertTrue(self.refused(self.runtime, "--set", "control=off"))
        self.assertFalse((self.runtime / "programs").exists())


class Forks(Linked):
    def sockets(self, process):
        """Its open sockets; None: it has ended."""
        try:
            opened = [os.readlink(f"/proc/{process}/fd/{descriptor}") for descriptor in os.listdir(f"/proc/{process}/fd")]
        except FileNotFoundError:  # closed meanwhile
            return self.sockets(process) if os.path.exists(f"/proc/{process}") else None
        except PermissionError:
            return None
        return {name for name in opened if name.startswith("socket:")} if opened else None

    def connections(self):
        """The sockets of all threads: that of the link has a descriptor table of its own."""
        tasks = os.listdir(f"/proc/{self.client.pid}/task")
        return set().union(*(self.sockets(f"{self.client.pid}/task/{task}") or () for task in tasks))

    def stopped_child(self):
        """A child that lives on until it is continued, and what its sockets were when it had left fork(): it waits then."""
        for _ in range(20):
            print("fork", file=self.client.stdin, flush=True)
            child = int(self.answer())
            self.wait_until(lambda: self.state(child) in "SZ")
            os.kill(child, signal.SIGSTOP)
            self.wait_until(lambda: self.state(child) in "TZ")
            if self.state(child) == "T":  # not so slow that its second was over
                self.addCleanup(self.kill, child)
                return child, self.sockets(child)
        self.fail("children end too soon")

    @staticmethod
    def state(process):
        return pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]

    @staticmethod
    def kill(process):
        with contextlib.suppress(ProcessLookupError):
            os.kill(process, signal.SIGKILL)

    def test_children_let_go_of_the_socket(self):
        self.start()
        before = self.sockets(self.client.pid)
        hub = self.hub()
        self.connect(hub)
        self.assertEqual(self.sockets(self.client.pid), before, "the program sees the connection")
        connection = self.connections() - before
        self.assertEqual(len(connection), 1)
        child, inherited = self.stopped_child()
        self.assertEqual(inherited & connection, set())
        self.assertEqual(inherited & before, before)  # the X server's: what is inherited can be seen
        os.kill(child, signal.SIGCONT)
        self.set(hub, values={"ao": True})
        self.wait_until(lambda: self.state(child) == "Z")  # its exit handlers have run
        self.assertEqual(self.connections() - before, connection)
        self.assertEqual(hub.ask("get", names=["ao"])["values"]["ao"]["value"], True)
        self.assertTrue((self.runtime / "programs" / str(self.client.pid)).exists())

    def test_the_program_reuses_all_descriptors(self):
        """The link goes on, and no byte of it is in the program's files; they stay open when the link ends."""
        hub = self.linked()
        plain = self.frame()
        print("reuse", file=self.client.stdin, flush=True)
        self.assertEqual(self.answer(), "reused")
        hub.ask("observe", what=["state", "settings"], every=0.05)
        self.set(hub, values={"ao": True})
        self.assertNotEqual(self.frame(), plain)
        hub.event("state")
        data = self.folder / "data"
        self.assertEqual(data.read_text(), "mine\n" * 60)
        hub.close()
        self.assertTrue(self.frames_until(lambda: "gluray-control" not in self.threads()))
        print("check", file=self.client.stdin, flush=True)
        self.assertEqual(self.answer(), "60")
        self.connect(self.hub())
        self.client.stdin.close()
        self.client.wait(20)
        self.assertEqual(data.read_text(), "mine\n" * 60)

    def test_the_link_works_where_descriptor_tables_are_refused(self):
        """As in containers of older kinds."""
        self.before = pathlib.Path(CLIENT).parents[1] / "doors/door_forbid", "tables"
        hub = self.linked()
        plain = self.frame()
        self.set(hub, values={"ao": True})
        self.assertNotEqual(self.frame(), plain)

    def test_the_connection_ends_with_the_program(self):
        hub = self.linked()
        self.stopped_child()
        self.client.kill()
        self.client.wait()
        self.assertIsNone(hub.message())  # although the child is there
        self.code = -signal.SIGKILL


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
