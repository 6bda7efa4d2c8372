"""Prints the mirrors of this system's release of Debian, as its package sources name them: one URI a line.

    package_mirrors.py [--etc FOLDER]    mirrors that speak HTTP or HTTPS, the most likely first; exit code 1: there is none
    package_mirrors.py --proxy URI       the proxy by which apt reaches that URI; nothing if there is none

Sources are the lines of sources.list and sources.list.d/*.list and the stanzas of sources.list.d/*.sources (sources.list(5)). A
mirror of the release provides its component main. scripts/root takes its packages from there.
"""
from __future__ import annotations

import pathlib
import re
import shlex
import subprocess
import sys
import urllib.parse
import urllib.request

from command_line import Parser

LINE = re.compile(r"deb\s+(?:\[[^\]]*\]\s*)?(\S+)\s+(\S+)\s+(.+)")
ALIASES = ("stable", "testing", "unstable", "sid", "oldstable", "oldoldstable")
OFF = ("no", "false", "without", "off", "disable", "0")  # apt takes these for false
APT_HELPER = "/usr/lib/apt/apt-helper"


def of_lines(text: str):
    """(URI, suite, components) of each line of a file of one-line sources."""
    for line in text.splitlines():
        if found := LINE.fullmatch(line.split("#")[0].strip()):
            yield found[1], found[2], found[3].split()


def fields(stanza: str) -> dict[str, str]:
    """The fields of a stanza, by their names in lower case. Lines that begin with # are comments, wherever they stand."""
    found: dict[str, str] = {}
    name = ""
    for line in stanza.splitlines():
        if line.startswith("#"):
            continue
        if line[:1].isspace():
            found[name] = f"{found.get(name, '')} {line.strip()}"
        else:
            name, _, value = line.partition(":")
            name = name.strip().lower()
            found[name] = value.strip()
    return found


def of_stanzas(text: str):
    """(URI, suite, components) of each URI and suite of a file of deb822 sources."""
    for stanza in re.split(r"\n[ \t]*(?:\n[ \t]*)+", text):
        found = fields(stanza)
        if found.get("enabled", "yes").lower() in OFF or "deb" not in found.get("types", "").split():
            continue
        for uri in found.get("uris", "").split():
            for suite in found.get("suites", "").split():
                yield uri, suite, found.get("components", "").split()


def sources(etc: pathlib.Path):
    files = [etc / "apt" / "sources.list", *sorted((etc / "apt" / "sources.list.d").glob("*"))]
    for file in files:
        if file.is_file() and file.suffix in (".list", ".sources"):
            yield from (of_stanzas if file.suffix == ".sources" else of_lines)(file.read_text(errors="replace"))


def resolved(uri: str) -> list[str]:
    """The URIs that a source's URI stands for: those of a list of mirrors (apt-transport-mirror(1)), or itself."""
    if not uri.startswith("mirror+file:"):
        return [uri]
    try:
        lines = pathlib.Path(urllib.parse.urlparse(uri).path).read_text().splitlines()
    except OSError:
        return []
    return [line.split()[0] for line in lines if line.strip() and not line.startswith("#")]


def mirrors(etc: pathlib.Path) -> list[str]:
    """Those that provide the release by its codename; if none does, by a name such as stable. First those in whose path the last
    folder is debian, as on Debian's mirrors: other archives may have a suite of that name, too."""
    file = etc / "os-release"
    release = dict(line.split("=", 1) for line in (file.read_text().splitlines() if file.exists() else []) if "=" in line)
    codename = " ".join(shlex.split(release.get("VERSION_CODENAME", "")))
    all_sources = list(sources(etc))
    for suites in ((codename,), ALIASES):
        named = [uri for uri, suite, components in all_sources if suite in suites and "main" in components]
        found = [one.rstrip("/") for uri in named for one in resolved(uri) if one.startswith(("http://", "https://"))]
        if found:
            return sorted(dict.fromkeys(found), key=lambda uri: not uri.endswith("/debian"))
    return []


def output(*command: str) -> str:
    """What the command prints; nothing where it does not exist or fails."""
    try:
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return ""


def configured_proxy(uri: urllib.parse.ParseResult) -> str:
    """The proxy of apt's configuration for this URI: that of its host, or of all hosts. DIRECT: none; empty: the configuration names none."""
    if found := re.search(r"Using proxy '([^']+)'", output(APT_HELPER, "auto-detect-proxy", uri.geturl())):
        return found[1]
    for scheme in dict.fromkeys((uri.scheme, "http")):  # https has the options of http where it has none
        words = shlex.split(output("apt-config", "shell", "proxy", f"Acquire::{scheme}::Proxy"))
        if words and words[0] != "proxy=":
            return words[0].removeprefix("proxy=")
    return ""


def proxy(text: str) -> str:
    """The proxy for this URI by apt's configuration or else by the environment; empty: none."""
    uri = urllib.parse.urlparse(text)
    if configured := configured_proxy(uri):
        return "" if configured == "DIRECT" else configured
    if urllib.request.proxy_bypass_environment(uri.hostname or ""):
        return ""
    return urllib.request.getproxies_environment().get(uri.scheme, "")


def main() -> int:
    parser = Parser(__doc__)
    parser.add_argument("--etc", type=pathlib.Path, default=pathlib.Path("/etc"), metavar="FOLDER", help="in place of /etc")
    parser.add_argument("--proxy", metavar="URI")
    given = parser.parse_args()
    if given.proxy:
        print(proxy(given.proxy))
        return 0
    found = mirrors(given.etc)
    if not found:
        print(f"package_mirrors: no source in {given.etc}/apt provides this release by HTTP or HTTPS", file=sys.stderr)
        return 1
    print("\n".join(found))
    return 0


if __name__ == "__main__":
    sys.exit(main())
