"""Reads spec/policy.toml: how each command is treated. See the head of that file for the format."""
from __future__ import annotations

import fnmatch
import pathlib
import re
import tomllib

import glxml

POLICY = pathlib.Path(__file__).resolve().parent.parent / "spec/policy.toml"
CLASSES = {"attribute": "tracked", "track": "tracked", "own": "tracked", "forward": "forwarded"}
COVERAGES = ("traced", "tracked", "forwarded", "masked")
FIELDS = {"commands", "except", "class", "flush", "sync", "touch", "handler", "list", "begin", "copy", "fragment", "scope", "coverage", "reason"}
GROUPS = {"modelview", "projection", "viewport", "raster", "lighting", "material", "texture", "clip", "target", "arrays", "attributes", "program",
          "current", "all"}


class PolicyError(Exception):
    pass


def _matches(row: dict, command: str) -> bool:
    hit = any(fnmatch.fnmatchcase(command, pattern) for pattern in row["commands"])
    return hit and not any(fnmatch.fnmatchcase(command, pattern) for pattern in row.get("except", ()))


def _groups(command: str, touch: list[str] | str) -> str:
    """The C++ expression of the state groups that a command touches; empty for none."""
    if isinstance(touch, str):
        return touch  # {c} is replaced by the context
    if unknown := set(touch) - GROUPS:
        raise PolicyError(f"{command}: no such state group {', '.join(sorted(unknown))}")
    if "all" in touch:
        return "kAllGroups"
    return " | ".join(f"k{group.capitalize()}" for group in touch)


class Policy:
    """The merged rows of one command. Later rows override single fields of earlier ones."""

    def __init__(self, command: glxml.Command, rows: list[dict]):
        fields: dict = {}
        for row in rows:
            if _matches(row, command.name):
                fields.update({k: v for k, v in row.items() if k not in ("commands", "except")})
        self.kind: str = fields.get("class", "forward")
        self.flush: bool | str = fields.get("flush", self.kind == "forward")
        self.sync: bool = fields.get("sync", False)
        self.begin: bool = fields.get("begin", False)
        touch = fields.get("touch", ["all"] if self.kind == "forward" and self.flush else [])
        self.touch: str = _groups(command.name, touch)
        self.handler: bool = fields.get("handler", self.kind == "own" or (self.kind == "track" and not touch))
        self.immediate: bool = fields.get("list") == "immediate" or command.ret != "void"
        self.scope: str = fields.get("scope", "")
        self.fragment: str = fields.get("fragment", "")
        self.copy: dict[str, str] = fields.get("copy", {})
        self.coverage: str = fields.get("coverage", CLASSES[self.kind])
        self.reason: str = fields.get("reason", "")


def read_rows(path: pathlib.Path = POLICY) -> list[dict]:
    rows = tomllib.loads(path.read_text())["row"]
    for row in rows:
        name = row.get("commands", ["(row without commands)"])[0]
        if unknown := set(row) - FIELDS:
            raise PolicyError(f"{path.name}, row of {name}: unknown field {', '.join(sorted(unknown))}")
        if row.get("class", "forward") not in CLASSES:
            raise PolicyError(f"{path.name}, row of {name}: class must be one of {', '.join(CLASSES)}")
        if row.get("flush", True) not in (True, False, "look", "read", "redirect", "leave"):
            raise PolicyError(f"{path.name}, row of {name}: flush must be true, false, \"look\", \"read\", \"redirect\" or \"leave\"")
        if "scope" in row and row.get("class", "forward") != "forward":
            raise PolicyError(f"{path.name}, row of {name}: scope is for forwarded commands")
        if row.get("coverage", "traced") not in COVERAGES:
            raise PolicyError(f"{path.name}, row of {name}: coverage must be one of {', '.join(COVERAGES)}")
    return rows


def policies(commands: list[glxml.Command], rows: list[dict]) -> dict[str, Policy]:
    """Policy by command name. Every pattern without a wildcard must name a command that exists."""
    known = {c.name for c in commands}
    for row in rows:
        for pattern in row["commands"]:
            if not re.search(r"[*?\[]", pattern) and pattern not in known:
                raise PolicyError(f"policy.toml: no such command {pattern}")
    return {c.name: Policy(c, rows) for c in commands}


def canonical(commands: list[glxml.Command], table: dict[str, Policy]) -> dict[str, str]:
    """Name -> the command whose stub serves it: its alias if that is modelled, otherwise itself."""
    by_name = {c.name: c for c in commands}

    def resolve(name: str) -> str:
        seen = set()
        while (alias := by_name[name].alias) in by_name and alias not in seen:
            seen.add(name)
            name = alias
        return name

    return {c.name: target if table[target := resolve(c.name)].kind != "forward" else c.name for c in commands}
