"""Hosts for tests: each has a network, host name, processes and /dev/shm of its own (Linux namespaces), and a cable to a switch. They need
root, iproute2 and util-linux. Nothing of them is left when the test ends, whatever ends it."""
import os
import pathlib
import shutil
import subprocess

NET = "10.213.0"
# The namespaces live as long as process 1 of theirs, which reads its standard input to the end.
INIT = 'hostname "$0" 2>/dev/null && ip link set lo up && mount -t sysfs sysfs /sys && mount -t tmpfs -o size=256m tmpfs /dev/shm && echo ready && exec cat'


def why_not():
    """Why this machine can have no such hosts; empty: it can."""
    if os.getuid() != 0:
        return "namespaces as hosts need root"
    if missing := [name for name in ("ip", "tc", "unshare", "nsenter", "hostname") if not shutil.which(name)]:
        return f"{', '.join(missing)} not found"
    tried = subprocess.run(["unshare", "--net", "--uts", "--ipc", "--mount", "--pid", "--fork", "true"], capture_output=True, text=True, check=False)
    return tried.stderr.strip()


def run(*words):
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)


class Machine:
    """A process with namespaces of its own."""

    def __init__(self, name, init=INIT, *arguments):
        """`init`: what its process 1 does as a shell script, with `name` as $0 and the arguments."""
        self.process = subprocess.Popen(["unshare", "--net", "--uts", "--ipc", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc", "sh", "-c", init, name,
                                         *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        if self.process.stdout.readline() != "ready\n":
            raise RuntimeError(f"host {name} does not start")
        number = self.process.pid
        self.init = int(pathlib.Path(f"/proc/{number}/task/{number}/children").read_text().split()[0])

    def inside(self, *words):
        """A command line that runs `words` there."""
        return ["nsenter", "-t", str(self.init), "-n", "-u", "-m", "-p", "-i", *words]

    def end(self):
        """All its processes end."""
        self.process.stdin.close()
        self.process.wait()
        self.process.stdout.close()


class Host(Machine):
    def __init__(self, number, folder, runtimes, *machine):
        """`runtimes`: where its runtime directory is; `machine`: further arguments of Machine."""
        super().__init__(f"host{number}", *machine)
        self.address = f"{NET}.{number + 1}"
        self.runtime = runtimes / f"run{number}"
        (folder / f"{self.address}.init").write_text(str(self.init))
        (folder / f"{self.address}.runtime").write_text(str(self.runtime))

    def command(self, *words):
        """A command line that runs `words` there, with the runtime directory of the host."""
        return self.inside("env", f"GLURAY_RUNTIME={self.runtime}", *words)

    def running(self, path):
        """The number of the process there that runs the program `path`; None: there is none."""
        for folder in os.listdir("/proc"):
            try:
                words = pathlib.Path(f"/proc/{folder}/environ").read_bytes().split(b"\0")
                if f"GLURAY_RUNTIME={self.runtime}".encode() in words and os.path.samefile(f"/proc/{folder}/exe", path):
                    return int(folder)
            except OSError:
                continue
        return None


class Network:
    """Hosts host0, host1 ... and their switch. `folder`: for files of theirs."""

    device = "bridge0"  # the switch's own interface

    def __init__(self, count, folder):
        self.machines = []
        self.runtimes = folder  # each host has its runtime directory there
        try:
            self.start(count, folder)
            self.launch_by(folder)
        except BaseException:
            self.end()
            raise

    def start(self, count, folder):
        self.switch = Machine("switch")
        self.machines.append(self.switch)
        run(*self.switch.inside("ip", "link", "add", "bridge0", "type", "bridge"))
        run(*self.switch.inside("ip", "link", "set", "bridge0", "up"))
        run(*self.switch.inside("ip", "address", "add", f"{NET}.254/24", "dev", "bridge0"))
        self.hosts = []
        for number in range(count):
            host = Host(number, folder, self.runtimes)
            self.machines.append(host)
            self.hosts.append(host)
            run(*self.switch.inside("ip", "link", "add", f"port{number}", "type", "veth", "peer", "name", "cable"))
            run("nsenter", "-t", str(self.switch.init), "-n", "ip", "link", "set", "cable", "netns", str(host.init))
            run(*self.switch.inside("ip", "link", "set", f"port{number}", "master", "bridge0", "up"))
            run(*host.inside("ip", "address", "add", f"{host.address}/24", "dev", "cable"))
            run(*host.inside("ip", "link", "set", "cable", "up"))

    def launch_by(self, folder):
        """Writes what launchers enter hosts with."""
        agent = folder / "agent"
        agent.write_text(f'#!/bin/sh\nhost=$1; shift\nexec nsenter -t "$(cat {folder}/$host.init)" -n -u -m -p -i '
                         f'env GLURAY_RUNTIME="$(cat {folder}/$host.runtime)" sh -c "$*"\n')
        agent.chmod(0o755)
        self.agent = agent  # called as ssh is: HOST COMMAND

    def mpiexec(self, count, *words):
        """As mpirun(), by MPICH. It gives its own environment to the hosts."""
        own = f'export GLURAY_RUNTIME={self.runtimes}/run$(hostname | tr -d a-z); exec "$@"'
        return ["nsenter", "-t", str(self.switch.init), "-n", "-u", "mpiexec.mpich", "-launcher", "rsh", "-launcher-exec", str(self.agent),
                "-iface", self.device, "-hosts", ",".join(host.address for host in self.hosts[:count]), "-ppn", "1", "-n", str(count),
                "sh", "-c", own, "sh", *words]

    def mpirun(self, count, *words):
        """A command line that runs `words` on the first `count` hosts, once on each, by Open MPI at the switch, as on a login node."""
        net = f"{NET}.0/24"
        choices = {"btl": "tcp,self", "pml": "ob1", "btl_tcp_if_include": net, "oob_tcp_if_include": net, "plm_rsh_agent": self.agent,
                   "orte_tmpdir_base": self.runtimes, "hwloc_base_binding_policy": "none"}
        addresses = ",".join(host.address for host in self.hosts[:count])
        return ["nsenter", "-t", str(self.switch.init), "-n", "-u", "mpirun.openmpi", "--allow-run-as-root", "--host", addresses, "-n", str(count),
                *(str(word) for name, value in choices.items() for word in ("--mca", name, value)), *words]

    def cable(self, number, is_in):
        """Pulls out the cable of a host at the switch, or puts it in."""
        run(*self.switch.inside("ip", "link", "set", f"port{number}", "up" if is_in else "down"))

    def slow(self, number, *limit):
        """Limits what the host gets: ("rate", "2mbit", ...), as tc-tbf has it; none: no limit. False: the kernel cannot."""
        action = ["replace", "dev", f"port{number}", "root", "tbf", *limit] if limit else ["del", "dev", f"port{number}", "root"]
        return subprocess.run(self.switch.inside("tc", "qdisc", *action), stderr=subprocess.DEVNULL, check=False).returncode == 0

    def end(self):
        for machine in reversed(self.machines):
            machine.end()
