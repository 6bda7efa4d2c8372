"""Reads the Khronos XML registries, gl.xml and glx.xml of third_party/khronos. Python standard library only."""
from __future__ import annotations

import dataclasses
import pathlib
import re
import xml.etree.ElementTree as ET

REGISTRY = pathlib.Path(__file__).resolve().parent.parent / "third_party" / "khronos"


@dataclasses.dataclass(frozen=True)
class Param:
    type: str  # C type, for instance "const GLfloat *"
    name: str
    length: str | None  # the registry's len attribute: "4", "n", "COMPSIZE(pname)"

    @property
    def pointer(self) -> bool:
        return "*" in self.type


@dataclasses.dataclass(frozen=True)
class Command:
    name: str
    ret: str
    params: tuple[Param, ...]
    alias: str | None
    sources: tuple[str, ...]  # versions and extensions that bring it, oldest first

    @property
    def short(self) -> str:
        """glFooBar -> FooBar."""
        return re.sub(r"^(gl|glX|egl|OSMesa)(?=[A-Z])", "", self.name)

    @property
    def declaration(self) -> str:
        return ", ".join(f"{p.type} {p.name}" for p in self.params) or "void"

    @property
    def arguments(self) -> str:
        return ", ".join(p.name for p in self.params)


def _text(element: ET.Element, skip: str) -> str:
    """The C text of a proto or param without its <name>."""
    parts = [element.text or ""]
    for child in element:
        if child.tag != skip:
            parts.append(child.text or "")
        parts.append(child.tail or "")
    return re.sub(r"\s+", " ", "".join(parts)).strip()


def load(registry: str, apis: tuple[str, ...]) -> list[Command]:
    """Every command of `registry` ("gl", "glx", "egl") that one of `apis` needs, sorted by name.

    For gl, apis are ("gl", "glcore"): desktop OpenGL of every version with all extensions.
    """
    root = ET.parse(REGISTRY / f"{registry}.xml").getroot()
    sources: dict[str, list[str]] = {}
    for feature in root.findall("feature"):
        if feature.get("api") in apis:
            for command in feature.findall("require/command"):
                sources.setdefault(command.get("name"), []).append(feature.get("name"))
    for extension in root.findall("extensions/extension"):
        if set((extension.get("supported") or "").split("|")) & set(apis):
            for require in extension.findall("require"):
                if require.get("api") in (None, *apis):
                    for command in require.findall("command"):
                        sources.setdefault(command.get("name"), []).append(extension.get("name"))
    commands = []
    for element in root.findall("commands/command"):
        proto = element.find("proto")
        name = proto.find("name").text
        if name not in sources:
            continue
        params = tuple(
            Param(_text(p, "name"), p.find("name").text, p.get("len")) for p in element.findall("param"))
        alias = element.find("alias")
        commands.append(
            Command(name, _text(proto, "name"), params, alias.get("name") if alias is not None else None,
                    tuple(sources[name])))
    return sorted(commands, key=lambda c: c.name)


def desktop_gl() -> list[Command]:
    return load("gl", ("gl", "glcore"))
