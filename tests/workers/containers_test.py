"""A program in a container whose images a worker outside traces, and the other way round: containers_test.py GLURAY WORKER CLIENT, with an X server
at hand. Containers are namespaces as Docker and Apptainer make them. Exits with 77 where this user can make none."""
import os
import subprocess
import sys
import unittest

from jobs import Jobs, wait_for

# Its own /tmp and /dev/shm; of the host's, sockets of X, what is shared, and the build where that lies below /tmp.
INSIDE = """set -e
mkdir -p "$0/tmp/.X11-unix" "$0/tmp/run"
mount --bind /tmp/.X11-unix "$0/tmp/.X11-unix"
mount --bind "$1" "$0/tmp/run"
case "$2" in /tmp/*) mkdir -p "$0$2"; mount --bind "$2" "$0$2" ;; esac
mount --rbind "$0/tmp" /tmp
mount -t tmpfs tmpfs /dev/shm
shift 2
exec env GLURAY_RUNTIME=/tmp/run "$@"
"""
UNSHARE = ["unshare", "--user", "--map-root-user", "--net", "--uts", "--ipc", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc"]


class Containers(Jobs):
    def setUp(self):
        super().setUp()
        self.environment["MESA_SHADER_CACHE_DISABLE"] = "true"  # its directory is not in the container
        self.runtime.mkdir(mode=0o700)

    def contained(self, shared, *words):
        """A command line that runs `words` in a container, with the directory `shared` as runtime directory."""
        build = os.path.commonpath([str(self.gluray), str(self.worker), str(self.client)])
        return [*UNSHARE, "sh", "-c", INSIDE, str(self.folder / "container"), str(shared), build, *words]

    def program(self, *words):
        path = self.log()
        with path.open("w") as file:
            process = self.spawn(*words, stderr=file)
        found = self.frame(process)
        self.end(process)
        return found, path.read_text()

    def traced(self, *options):
        return [self.gluray, "--engine", "always", *options, "--", self.client]

    def check(self, log, *words):
        expected, _ = self.program(*self.traced())
        self.assertEqual(self.program(*words), (expected, ""))
        self.assertTrue(wait_for(lambda: "is connected" in log.read_text()), log.read_text())

    def test_the_program_is_in_a_container(self):
        _, log = self.job()
        self.check(log, *self.contained(self.runtime, *self.traced("--workers", "test")))

    def test_the_worker_is_in_a_container(self):
        _, log = self.job(*self.contained(self.runtime))
        self.check(log, *self.traced("--workers", "test"))

    def test_the_runtime_directory_is_not_shared(self):
        self.job()
        other = self.folder / "other"
        other.mkdir(mode=0o700)
        expected, _ = self.program(*self.traced())
        found, said = self.program(*self.contained(other, *self.traced("--workers", "test")))
        self.assertEqual(found, expected)
        self.assertIn("no gluray-worker --job test runs on this machine", said)


if __name__ == "__main__":
    if subprocess.run([*UNSHARE, "mount", "-t", "tmpfs", "tmpfs", "/dev/shm"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
        print("this user can make no namespaces")
        sys.exit(77)
    Jobs.gluray, Jobs.worker, Jobs.client = map(os.path.abspath, sys.argv[1:4])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
