"""The switch itself: link_test.py LINK. Times and rates of the hosts' own TCP over it. Exits with 77 where there can be no such network."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import network

# On a host: PORT [BYTES]: with BYTES, takes so many of each connection and answers one; else answers byte by byte.
SERVER = """
import socket, sys
server = socket.create_server(("", int(sys.argv[1])))
print("listening", flush=True)
while True:
    connection, _ = server.accept()
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    left = int(sys.argv[2]) if len(sys.argv) > 2 else None
    while left is None or left > 0:
        got = connection.recv(1 << 16)
        if not got:
            break
        if left is None:
            connection.sendall(got)
        else:
            left -= len(got)
    if left == 0:
        connection.sendall(b"x")
"""
# ADDRESS PORT: the least of 100 round trips of a byte, in microseconds. ADDRESS PORT BYTES: the rate of so many, in bits a second.
CLIENT = """
import socket, sys, time
connection = socket.create_connection((sys.argv[1], int(sys.argv[2])), timeout=60)
connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
def passes(data):
    start = time.monotonic()
    connection.sendall(data)
    assert connection.recv(1)
    return time.monotonic() - start
if len(sys.argv) > 3:
    print(8 * int(sys.argv[3]) / passes(bytes(int(sys.argv[3]))))
else:
    print(1e6 * min(passes(b"x") for _ in range(100)))
"""
# ADDRESS COUNT: sends so many datagrams, a thousand a second; COUNT alone: says how many of them come.
DATAGRAMS = """
import socket, sys, time
one = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
if len(sys.argv) > 2:
    for _ in range(int(sys.argv[2])):
        one.sendto(bytes(100), (sys.argv[1], 7000))
        time.sleep(0.001)
else:
    one.bind(("", 7000))
    print("listening", flush=True)
    one.settimeout(30)
    count = 0
    try:
        while count < int(sys.argv[1]):
            one.recv(200)
            count += 1
            one.settimeout(2)
    except TimeoutError:
        pass
    print(count, flush=True)
"""


class Link(unittest.TestCase):
    link = ""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.net = network.Switched(3, pathlib.Path(folder.name), self.link)
        self.addCleanup(self.net.end)

    def at(self, host, script, *words):
        process = subprocess.Popen(self.net.hosts[host].inside(sys.executable, "-c", script, *map(str, words)), stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL, text=True)

        def end():
            process.kill()
            process.wait()
            process.stdout.close()
        self.addCleanup(end)
        return process

    def server(self, *words):
        process = self.at(1, SERVER, *words)
        self.assertEqual(process.stdout.readline(), "listening\n")

    def figure(self, *words, host=0):
        return float(self.at(host, CLIENT, self.net.hosts[1].address, *words).communicate(timeout=120)[0])

    def test_delays(self):
        self.server(6000)
        found = {}
        for delay in (0, 20, 200, 2000):
            self.net.delay(delay)
            found[delay] = self.figure(6000)
            self.assertGreaterEqual(found[delay], 2 * delay)
            self.assertLess(found[delay], 2 * delay + 2000)
        print("least round trips, us, by delay:", {delay: round(took) for delay, took in found.items()}, flush=True)

    def test_rates(self):
        found = {}
        for number, (rate, size) in enumerate(((100e6, 10_000_000), (1e9, 50_000_000), (0, 100_000_000))):
            self.server(6000 + number, size)
            self.net.rate(rate)
            found[rate] = self.figure(6000 + number, size)
            if rate:
                self.assertLess(found[rate], rate)
                self.assertGreater(found[rate], 0.3 * rate)  # other processes may be at work, too
        print("Mbit/s, by limit:", {rate: round(got / 1e6) for rate, got in found.items()}, flush=True)

    def test_lost_frames(self):
        count = 2000
        receiver = self.at(1, DATAGRAMS, count)
        self.assertEqual(receiver.stdout.readline(), "listening\n")
        self.net.drop(1, 0.2)
        self.at(0, DATAGRAMS, self.net.hosts[1].address, count).wait(60)
        self.assertAlmostEqual(int(receiver.stdout.readline()) / count, 0.8, delta=0.06)

    def test_cuts_and_bytes(self):
        self.server(6000)
        self.figure(6000)
        self.net.between(0, 1, False)
        before = self.net.bytes()
        nobody = self.at(0, CLIENT.replace("timeout=60", "timeout=1"), self.net.hosts[1].address, 6000)
        self.assertEqual((nobody.communicate(timeout=60)[0], nobody.returncode), ("", 1))
        self.assertEqual(self.net.bytes()[0][1], before[0][1])
        self.figure(6000, host=2)
        self.net.between(0, 1, True)
        self.figure(6000)
        self.assertGreater(self.net.bytes()[0][1], before[0][1])

    def test_hosts_share_nothing_but_the_folder(self):
        def said(host, *words):
            return subprocess.run(self.net.hosts[host].inside("sh", "-c", *words), capture_output=True, text=True, check=True).stdout.strip()
        said(0, "echo mine > /tmp/mine; echo mine > /dev/shm/mine")
        self.assertEqual(said(1, "hostname; ls /tmp/mine /dev/shm/mine 2>/dev/null || true"), "host1")
        self.assertFalse(os.path.exists("/tmp/mine"))
        said(0, f"echo ours > {self.net.agent.parent}/ours")
        self.assertEqual(said(1, f"cat {self.net.agent.parent}/ours"), "ours")


if __name__ == "__main__":
    if why := network.why_not():
        print(why)
        sys.exit(77)
    Link.link = os.path.abspath(sys.argv[1])
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
