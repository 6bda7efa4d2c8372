"""Runtime directories that are not safe, and other users: strangers_test.py GLURAY CLIENT, with an X server at hand."""
import os
import socket
import subprocess
import sys
import unittest

from fake_programs import Peer
from parts import Parts

NOBODY = 65534


def as_nobody(act):
    """What act() returns, or the name of what it raises, in a process of another user."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.setgroups([]), os.setgid(NOBODY), os.setuid(NOBODY)
            said = str(act())
        except BaseException as error:  # nothing may leave the child
            said = type(error).__name__
        os.write(writing, said.encode())
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as pipe:
        said = pipe.read()
    os.waitpid(child, 0)
    return said


@unittest.skipIf(os.getuid(), "only root can be another user")
class OtherUsers(Parts):
    def setUp(self):
        super().setUp()
        self.folder.chmod(0o755)

    def test_neither_connect_nor_read_nor_list(self):
        self.two(), self.hub()
        self.listed(2)
        for act in (lambda: Peer(self.runtime), lambda: os.listdir(self.runtime), lambda: (self.runtime / "hub.lock").read_text(),
                    lambda: os.listdir(self.runtime / "programs"), lambda: (self.runtime / "mine").touch()):
            self.assertEqual(as_nobody(act), "PermissionError")

    def test_are_refused_where_they_reach_the_socket(self):
        self.hub()
        self.runtime.chmod(0o711)
        (self.runtime / "hub.sock").chmod(0o666)

        def connect():
            peer = socket.socket(socket.AF_UNIX)
            peer.settimeout(30)
            peer.connect(str(self.runtime / "hub.sock"))
            with peer:
                return peer.recv(1 << 16)
        self.assertIn(as_nobody(connect), ("b''", "ConnectionResetError"))

    def test_are_told_in_one_line(self):
        self.hub()
        try:
            done = subprocess.run([self.gluray, "list"], capture_output=True, text=True, cwd="/", env=self.environment, user=NOBODY, timeout=60)
        except PermissionError:
            self.skipTest("others may not execute the build")
        self.assertEqual(done.returncode, 1)
        self.assertIn("belongs to another user", done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1)


class Planted(Parts):
    def all_refuse(self, words):
        for command in (["hub"], ["list"], ["set", "spp=2"], ["watch", "--seconds", "1"]):
            self.assertIn(words, self.refusal(*command))

    def test_a_link_in_place_of_the_directory(self):
        (self.folder / "other").mkdir(mode=0o700)
        self.runtime.symlink_to(self.folder / "other")
        self.all_refuse("symbolic link; remove it")
        self.assertEqual(os.listdir(self.folder / "other"), [])

    def test_a_directory_that_others_may_read(self):
        self.runtime.mkdir()
        self.runtime.chmod(0o755)
        self.all_refuse("mode 755; run chmod 700")

    def test_a_file_in_place_of_the_socket(self):
        self.runtime.mkdir(mode=0o700)
        (self.runtime / "hub.sock").write_text("mine")
        self.assertIn("no socket; remove it", self.refusal("hub"))
        self.assertEqual((self.runtime / "hub.sock").read_text(), "mine")

    def test_a_link_in_place_of_the_lock(self):
        self.runtime.mkdir(mode=0o700)
        (self.runtime / "hub.lock").symlink_to(self.folder / "victim")
        self.assertIn("hub.lock is a symbolic link; remove it", self.refusal("hub"))
        self.assertFalse((self.folder / "victim").exists())

    def test_a_socket_that_an_earlier_hub_left(self):
        self.runtime.mkdir(mode=0o700)
        left = socket.socket(socket.AF_UNIX)
        left.bind(str(self.runtime / "hub.sock"))
        left.close()
        self.program("painter", "always", "10"), self.hub()
        self.listed(1)

    def test_a_link_in_place_of_the_socket(self):
        self.runtime.mkdir(mode=0o700)
        (self.folder / "victim").write_text("mine")
        (self.runtime / "hub.sock").symlink_to(self.folder / "victim")
        self.hub()
        self.assertEqual((self.folder / "victim").read_text(), "mine")
        self.assertFalse((self.runtime / "hub.sock").is_symlink())

    def test_a_second_hub(self):
        self.hub()
        self.assertIn("another hub runs already", self.refusal("hub"))


if __name__ == "__main__":
    Parts.gluray, Parts.client = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
