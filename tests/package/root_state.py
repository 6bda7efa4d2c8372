"""What a Debian in a folder holds, so that two states of it can be compared."""
import hashlib
import os
import pathlib
import stat

from clean_root import CleanRoot

# What processes write, what dpkg, apt and debconf know, and indexes that their triggers make again from what is installed.
LEFT_OUT = ("proc", "dev", "sys", "run", "tmp", "packages", "var/log", "var/cache", "var/lib/apt", "etc/ld.so.cache")
DPKG = "var/lib/dpkg"
DPKG_KEPT = ("info", "alternatives", "diversions", "statoverride", "triggers/File")


def described(path: pathlib.Path) -> str:
    """Kind, mode and content. No times: those of folders change with what is in them."""
    known = path.lstat()
    text = f"{stat.filemode(known.st_mode)} {known.st_uid}:{known.st_gid}"
    if stat.S_ISLNK(known.st_mode):
        return f"{text} -> {os.readlink(path)}"
    return f"{text} {hashlib.sha256(path.read_bytes()).hexdigest()}" if stat.S_ISREG(known.st_mode) else text


def kept(name: str) -> bool:
    if name.startswith(f"{DPKG}/"):
        return name.removeprefix(f"{DPKG}/").startswith(DPKG_KEPT)
    return name not in LEFT_OUT and not name.startswith(tuple(f"{one}/" for one in LEFT_OUT))


def state(root: CleanRoot) -> dict[str, str]:
    """All files and folders of the system, alternatives and diversions."""
    found = {}
    for folder, folders, files in os.walk(root.folder):
        inside = pathlib.Path(folder).relative_to(root.folder)
        for name in folders + files:
            path = (inside / name).as_posix()
            if kept(path):
                found[path] = described(root.folder / path)
        folders[:] = [name for name in folders if (inside / name).as_posix() not in LEFT_OUT and not os.path.ismount(os.path.join(folder, name))]
    for command in (("dpkg-divert", "--list"), ("update-alternatives", "--get-selections"), ("dpkg-statoverride", "--list")):
        found[" ".join(command)] = root.run("sh", "-c", f"{' '.join(command)} || true")
    return found


def differences(before: dict[str, str], after: dict[str, str]) -> list[str]:
    """A line for each path that is new, gone or changed."""
    lines = [f"new: {name} {after[name]}" for name in sorted(after.keys() - before.keys())]
    lines += [f"gone: {name}" for name in sorted(before.keys() - after.keys())]
    return lines + [f"changed: {name}: {before[name]}, now {after[name]}" for name in sorted(before.keys() & after.keys()) if before[name] != after[name]]
