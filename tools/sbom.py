"""Writes what a tree that runs anywhere contains, as a software bill of materials: SPDX 2.3, JSON.

    sbom.py --tree PREFIX --version VERSION --created SECONDS --out FILE

Copies of libraries are named with the version of the Debian package that they come from, and their SHA-256. Libraries whose code is part of
GLuRay's own files (headers, static libraries) are named with the version of the package that was installed when it was built.
"""
from __future__ import annotations

import datetime
import hashlib
import json
import pathlib
import subprocess
import sys

import library_licences
from command_line import Parser
from private_libraries import NAME_SUFFIX, Unsupported, find

LICENCES = {"libembree": "Apache-2.0", "libtbb": "Apache-2.0", "libhwy": "Apache-2.0 OR BSD-3-Clause", "libOpenEXR": "BSD-3-Clause",
            "libImath": "BSD-3-Clause", "libIex": "BSD-3-Clause", "libIlmThread": "BSD-3-Clause", "libsodium": "ISC", "libz": "Zlib",
            "libstdc++": "GPL-3.0-or-later WITH GCC-exception-3.1"}
# Debian packages whose code the compiler or the linker puts into our files.
BUILT_IN = {"libglm-dev": "MIT", "libspdlog-dev": "MIT", "libfmt-dev": "MIT", "libcli11-dev": "BSD-3-Clause", "nlohmann-json3-dev": "MIT",
            "libtomlplusplus-dev": "MIT", "libasio-dev": "BSL-1.0", "libxxhash-dev": "BSD-2-Clause", "libpng-dev": "libpng-2.0",
            "libsodium-dev": "ISC", "zlib1g-dev": "Zlib"}


def version_of(package: str | None) -> str:
    """Of an installed Debian package; empty: there is none."""
    try:
        asked = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package or "-"], capture_output=True, text=True)
    except FileNotFoundError:
        return ""
    return asked.stdout.strip() if asked.returncode == 0 else ""


def entry(name: str, version: str, licence: str, **more) -> dict:
    identity = "SPDXRef-" + "".join(c if c.isalnum() or c in "-." else "-" for c in name)
    return {"name": name, "SPDXID": identity, "versionInfo": version or "NOASSERTION", "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
            "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": "NOASSERTION", **more}


def copies(tree: pathlib.Path) -> list[dict]:
    found = []
    for path in sorted((tree / "lib/gluray/private").glob("*" + NAME_SUFFIX)):
        name = path.name.removesuffix(NAME_SUFFIX)
        package = library_licences.package_of(find(name, []))
        licence = next((text for start, text in LICENCES.items() if name.startswith(start)), "NOASSERTION")
        found.append(entry(name, version_of(package), licence,
                           checksums=[{"algorithm": "SHA256", "checksumValue": hashlib.sha256(path.read_bytes()).hexdigest()}]))
    return found


def bill(tree: pathlib.Path, version: str, created: int) -> dict:
    itself = entry("gluray", version, "Apache-2.0")
    parts = copies(tree) + [entry(name, version_of(name), licence) for name, licence in BUILT_IN.items() if version_of(name)]
    relations = [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": itself["SPDXID"]}]
    relations += [{"spdxElementId": itself["SPDXID"], "relationshipType": "CONTAINS", "relatedSpdxElement": part["SPDXID"]} for part in parts]
    date = datetime.datetime.fromtimestamp(created, datetime.timezone.utc)
    digest = hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"gluray-{version}",
            "documentNamespace": f"https://spdx.org/spdxdocs/gluray-{version}-{digest[:32]}",
            "creationInfo": {"created": date.strftime("%Y-%m-%dT%H:%M:%SZ"), "creators": ["Tool: gluray-sbom"]},
            "packages": [itself, *parts], "relationships": relations}


def main(arguments: list[str]) -> None:
    parser = Parser(__doc__)
    parser.add_argument("--tree", type=pathlib.Path, required=True)
    parser.add_argument("--version", required=True)
    parser.add_argument("--created", type=int, required=True, metavar="SECONDS")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    chosen = parser.parse_args(arguments)
    chosen.out.write_text(json.dumps(bill(chosen.tree, chosen.version, chosen.created), indent=1) + "\n")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Unsupported as why:
        sys.exit(f"sbom: {why}")
