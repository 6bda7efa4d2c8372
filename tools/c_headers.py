"""Reads the prototypes of EGL and OSMesa from their C headers. EGL's are those that the C compiler finds: $CC, or cc."""
from __future__ import annotations

import os
import pathlib
import re
import shlex
import subprocess

import glxml

OSMESA = pathlib.Path(__file__).resolve().parent.parent / "src" / "intercept" / "window_systems" / "osmesa_api.h"

PROTOTYPE = r"\b{export}\s+([\w\s\*]+?)\s*{call}\s+(\w+)\s*\(([^)]*)\)\s*;"


def _parameter(text: str, position: int) -> glxml.Param:
    match = re.match(r"^(.*?[\s\*])(\w+)(\[\])?$", text.strip())
    if not match or text.strip() in ("void",):
        return glxml.Param(text.strip(), f"a{position}", None)
    kind = match.group(1).strip() + (" *" if match.group(3) else "")
    return glxml.Param(kind, match.group(2), None)


def found_by_compiler(header: str) -> pathlib.Path:
    """The file that `#include <header>` reads. Raises FileNotFoundError if there is none."""
    command = [*shlex.split(os.environ.get("CC") or "cc"), "-E", "-H", "-x", "c", "-"]
    done = subprocess.run(command, input=f"#include <{header}>\n", capture_output=True, text=True)
    first = next((line for line in done.stderr.splitlines() if line.startswith(". ")), None)  # one dot: no header includes it
    if done.returncode or first is None:
        raise FileNotFoundError(f"the C compiler finds no {header}")
    return pathlib.Path(first[2:])


def prototypes(header: pathlib.Path, export: str, call: str) -> list[glxml.Command]:
    """Every function that the header declares as `export RETURN call NAME (...)`."""
    text = re.sub(r"/\*.*?\*/", " ", header.read_text(), flags=re.S)
    found = {}
    for ret, name, parameters in re.findall(PROTOTYPE.format(export=export, call=call), text):
        parts = [] if parameters.strip() == "void" else parameters.split(",")
        params = tuple(_parameter(part, i) for i, part in enumerate(parts))
        found[name] = glxml.Command(name, " ".join(ret.split()), params, None, (str(header),))
    return sorted(found.values(), key=lambda c: c.name)


def egl() -> list[glxml.Command]:
    found = {c.name: c for h in ("EGL/egl.h", "EGL/eglext.h") for c in prototypes(found_by_compiler(h), "EGLAPI", "EGLAPIENTRY")}
    return sorted(found.values(), key=lambda c: c.name)


def osmesa() -> list[glxml.Command]:
    return prototypes(OSMESA, "GLAPI", "GLAPIENTRY")
