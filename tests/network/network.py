"""Hosts whose cables a switch of ours delays, limits, cuts, and lets lose frames (link.cpp), each with a /tmp and a /dev/shm of its own."""
import contextlib
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "workers"))
import hosts  # noqa: E402

# $1: what all hosts share, as a network's file system; $2, $3: sizes of /tmp and /dev/shm; the rest: more that is seen there.
INIT = """set -e
hostname "$0"
ip link set lo up
mount -t sysfs sysfs /sys
shared=$1 tmp=$2 shm=$3
mount -t tmpfs -o size=$shm tmpfs /dev/shm
mkdir -p "$shared/own"
mount -t tmpfs -o size=$tmp,mode=1777 tmpfs "$shared/own"
shift 3
for folder in "$shared" "$@"; do
  case $folder in /tmp/*) if [ -d "$folder" ]; then mkdir -p "$shared/own/${folder#/tmp/}"; mount --bind "$folder" "$shared/own/${folder#/tmp/}"; fi ;; esac
done
mount --rbind "$shared/own" /tmp
echo ready
exec cat"""
SIZES = ("256m", "256m")  # of /tmp and of /dev/shm
CABLE = "cable"


def why_not():
    """Why this machine can have no such network; empty: it can."""
    if why := hosts.why_not():
        return why
    return "" if os.path.exists("/dev/net/tun") else "the kernel has no TAP interfaces (/dev/net/tun)"


class Switched(hosts.Network):
    """Hosts host0, host1 ... on a switch, whose cables carry `mtu` bytes a frame. `folder`, below /tmp: what they share. `link`: the program."""

    device = CABLE

    def __init__(self, count, folder, link, sizes=SIZES, mtu=1500):
        self.link_path, self.sizes, self.mtu, self.link = link, sizes, mtu, None
        super().__init__(count, folder)

    def start(self, count, folder):
        self.runtimes = pathlib.Path("/tmp")
        machine = (INIT, str(folder), *self.sizes, "/tmp/.X11-unix", str(pathlib.Path(self.link_path).parents[2]))
        self.switch = hosts.Machine("switch", *machine)
        self.machines.append(self.switch)
        self.hosts = []
        for number in range(count):
            host = hosts.Host(number, folder, self.runtimes, *machine)
            self.machines.append(host)
            self.hosts.append(host)
        ends = [*self.hosts, self.switch]  # the switch's own cable is the last one
        self.link = subprocess.Popen([self.link_path, *(f"{CABLE}:{end.init}" for end in ends)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        if (said := self.link.stdout.readline()) != "ready\n":
            raise RuntimeError(f"the switch does not start: {said}")
        for number, end in enumerate(ends):
            address = self.hosts[number].address if number < count else f"{hosts.NET}.254"
            hosts.run(*end.inside("ip", "address", "add", f"{address}/24", "dev", CABLE))
            hosts.run(*end.inside("ip", "link", "set", CABLE, "mtu", str(self.mtu), "up"))

    def ask(self, *words):
        print(*words, file=self.link.stdin, flush=True)
        answer = self.link.stdout.readline().strip()
        if not answer or answer.startswith("error"):
            raise RuntimeError(f"the switch: {answer or 'ended'}")
        return answer

    def delay(self, microseconds):
        """Of a frame from any host to any other."""
        for cable in range(len(self.hosts) + 1):
            self.ask("delay", cable, microseconds / 2)

    def rate(self, bits_per_second):
        """What each cable carries each way; 0: no limit."""
        for cable in range(len(self.hosts) + 1):
            self.ask("rate", cable, bits_per_second)

    def drop(self, number, share):
        """Of the frames to and from a host."""
        self.ask("drop", number, share)

    def cable(self, number, is_in):
        self.ask("join" if is_in else "cut", number)

    def between(self, one, other, is_in):
        """Cuts or joins what two hosts say to each other; both reach all others."""
        self.ask("join" if is_in else "cut", one, other)

    def slow(self, number, *limit):
        raise NotImplementedError("the cable of one host alone: ask('rate', ...)")

    def bytes(self):
        """Bytes that were delivered, by sending and receiving host; the switch is the last one."""
        return [[int(word) for word in row.split()] for row in self.ask("bytes").split(";")]

    def crossed(self, before):
        """Bytes since `before` = bytes(), from any host to any other."""
        return sum(after - earlier for rows in zip(self.bytes(), before) for after, earlier in zip(*rows))

    def end(self):
        if self.link:
            with contextlib.suppress(BrokenPipeError):
                self.link.stdin.close()
            self.link.wait()
            self.link.stdout.close()
            self.link = None
        super().end()
