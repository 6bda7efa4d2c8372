"""Reads and checks spec/settings.toml. The head of that file explains the fields."""
from __future__ import annotations

import dataclasses
import pathlib
import re
import tomllib

SPEC = pathlib.Path(__file__).resolve().parent.parent / "spec/settings.toml"
TYPES = ("bool", "int", "float", "choice", "color", "vector", "string", "path", "list", "quirks")
APPLIES = ("frame", "context", "process")
CHANGES = ("image", "way")
LEVELS = ("basic", "advanced", "expert")
# In the order of pages and lists.
GROUPS = ("Quality", "Speed", "Light", "Shadows", "Occlusion", "Materials", "Camera", "Background", "Files", "Diagnosis", "Control", "Cluster")
TITLE_WORDS = 4
# Environment variables that are not settings.
RESERVED = {"GLURAY_COMMAND_LINE", "GLURAY_CONFIG", "GLURAY_ENGINE_LIBRARY", "GLURAY_OIDN", "GLURAY_PID", "GLURAY_PROGRAM", "GLURAY_PROJECT", "GLURAY_REAL_EGL",
            "GLURAY_REAL_GLX", "GLURAY_ROOTS", "GLURAY_RUNTIME"}
# Names of tables in files, and words of the launcher.
RESERVED_NAMES = {"program", "presets"}


class SettingsError(Exception):
    pass


def words_of(name: str) -> list[str]:
    return re.split(r"[-.]", name)


def camel(name: str) -> str:
    first, *others = name.split("-")
    return first + "".join(w.capitalize() for w in others)


@dataclasses.dataclass
class Choice:
    word: str
    id: str = ""
    help: str = ""


@dataclasses.dataclass
class Row:
    name: str
    title: str
    type: str
    help: str
    group: str
    level: str
    since: str
    applies: str
    changes: str
    default: object = None
    range: list | None = None
    least: str = ""
    unit: str = ""
    choices: list = dataclasses.field(default_factory=list)
    enum: str = ""
    member: str = ""
    more: str = ""
    option: str = ""
    value: str = ""
    items: str = "string"
    explains: bool = True
    exists: bool = False
    in_files: bool = True
    alone: bool = False
    check: str = ""
    heads: bool = dataclasses.field(default=False, init=False)  # a switch whose name is a group's, too

    @property
    def path(self) -> list[str]:
        """The members that lead to the value: ao.max-rays is ["ao", "maxRays"], and ao beside it ["ao", "enabled"]."""
        *groups, last = map(camel, self.name.split("."))
        return [*groups, last, self.member or "enabled"] if self.heads else [*groups, self.member or last]

    @property
    def in_settings(self) -> bool:
        """Whether it is a member of Settings; of Session otherwise."""
        return self.applies != "process"

    @property
    def variable(self) -> str:
        return "GLURAY_" + "_".join(words_of(self.name)).upper()

    @property
    def words(self) -> list[str]:
        return [c.word for c in self.choices]

    @property
    def is_file(self) -> bool:
        return self.type == "path" or (self.type == "list" and self.items == "path")

    @property
    def placeholder(self) -> str:
        """Placeholder of the value in synopses."""
        plain = {"bool": "true|false", "int": "N", "float": "X", "choice": "|".join(self.words), "color": "#RRGGBB", "vector": "X,Y,Z", "string": "TEXT",
                 "path": "FILE", "list": "FILE:..." if self.items == "path" else "TEXT,...", "quirks": "NAME=on|off,..."}
        return self.value or plain[self.type]


def fail(row: str, why: str) -> None:
    raise SettingsError(f"setting '{row}': {why}")


def numbers(value: object, count: int) -> bool:
    return isinstance(value, list) and len(value) == count and all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in value)


def check_default(row: Row) -> None:
    kinds = {"bool": bool, "int": int, "float": (int, float), "choice": str, "string": str, "path": str, "list": list}
    if row.type in ("color", "vector"):
        if not numbers(row.default, 3):
            fail(row.name, "the default must be three numbers")
        values = row.default
    else:
        if row.type == "quirks":
            return None if row.default is None else fail(row.name, "the defaults of quirks are in src/settings/quirks.h")
        if not isinstance(row.default, kinds[row.type]) or (row.type != "bool" and isinstance(row.default, bool)):
            fail(row.name, f"the default is not of type {row.type}")
        values = [row.default] if row.type in ("int", "float") else []
    if row.range and any(not row.range[0] <= v <= row.range[1] for v in values):
        fail(row.name, "the default is out of range")
    if row.type == "choice" and row.default not in row.words:
        fail(row.name, f"the default must be one of {', '.join(row.words)}")


def check_title(row: Row) -> None:
    words = row.title.split()
    if " ".join(words) != row.title or len(words) > TITLE_WORDS:
        fail(row.name, f"a title has at most {TITLE_WORDS} words with one blank between them")
    # Sentence case: names such as OpenGL keep their capitals.
    if not words[0][0].isupper() or any(w.istitle() for w in words[1:]):
        fail(row.name, "a title is in sentence case: only its first word begins with a capital")


def checked(fields: dict) -> Row:
    name = fields.get("name", "(without name)")
    known = {f.name.replace("_", "-") for f in dataclasses.fields(Row) if f.init}
    if unknown := set(fields) - known:
        fail(name, f"unknown field {', '.join(sorted(unknown))}")
    for needed in ("name", "title", "type", "help", "group", "level", "since", "applies", "changes"):
        if not fields.get(needed):
            fail(name, f"needs a field '{needed}'")
    row = Row(**{k.replace("-", "_"): " ".join(v.split()) if isinstance(v, str) and k in ("help", "more") else v for k, v in fields.items()})
    if not re.fullmatch(r"[a-z][a-z0-9]*([-.][a-z][a-z0-9]*)*", name) or name.split(".")[0] in RESERVED_NAMES or row.variable in RESERVED:
        fail(name, "a name must be lower-case words with - or . between them, and not reserved")
    for field, allowed in (("type", TYPES), ("applies", APPLIES), ("changes", CHANGES), ("items", ("string", "path")), ("group", GROUPS), ("level", LEVELS)):
        if getattr(row, field) not in allowed:
            fail(name, f"{field} must be one of {', '.join(allowed)}")
    check_title(row)
    if row.changes == "image" and not row.in_settings:
        fail(name, "a setting that changes the image must apply to frames or contexts")
    if row.option and not re.fullmatch(r"--[a-z][a-z-]*", row.option):
        fail(name, "an option must be --word")
    if row.range is not None and not numbers(row.range, 2):
        fail(name, "a range must be [least, most]")
    if row.range is None and row.type in ("int", "float"):
        fail(name, "numbers need a range")
    if row.range is None and row.type == "color":
        row.range = [0, 1]
    if row.check and row.type != "list":
        fail(name, "only the entries of lists have a check")
    if (row.type == "choice") != bool(row.choices):
        fail(name, "the type choice, and only it, needs choices")
    row.choices = [Choice(**c) for c in row.choices]
    for choice in row.choices:
        choice.id = choice.id or camel(choice.word)
    row.enum = row.enum or "".join(w.capitalize() for w in words_of(name))
    if row.default is None:
        row.default = {"bool": False, "int": 0, "float": 0, "string": "", "path": "", "list": [], "choice": row.words[0] if row.choices else ""}.get(row.type)
    check_default(row)
    return row


def read(path: pathlib.Path = SPEC) -> list[Row]:
    rows = [checked(fields) for fields in tomllib.loads(path.read_text())["setting"]]
    for what in ("name", "title", "variable", "option"):
        seen: set[str] = set()
        for row in rows:
            value = getattr(row, what)
            if value and value in seen:
                fail(row.name, f"another setting has the {what} {value}")
            seen.add(value)
    named = {row.name: row for row in rows}
    for row in rows:
        parts = row.name.split(".")
        for i in range(1, len(parts)):
            if head := named.get(".".join(parts[:i])):
                if head.type not in ("bool", "choice"):
                    fail(row.name, f"'{head.name}' is a setting, and only switches and choices head a group")
                head.heads = True
    for head in (row for row in rows if row.heads):
        if f"{head.name}.enabled" in named:
            fail(head.name, f"files write it as {head.name}.enabled, which is another setting")
    return rows


def by_group(rows: list[Row]) -> dict[str, list[Row]]:
    """The rows of each group that has any, in the order of GROUPS; basic ones first."""
    grouped = {group: sorted((r for r in rows if r.group == group), key=lambda r: LEVELS.index(r.level)) for group in GROUPS}
    return {group: inside for group, inside in grouped.items() if inside}


def default_text(row: Row) -> str:
    """The built-in value as text that the parser takes."""
    if row.type == "bool":
        return "true" if row.default else "false"
    if row.type in ("color", "vector"):
        return ",".join(f"{v:g}" for v in row.default)
    if row.type == "list":
        return (":" if row.items == "path" else ",").join(row.default)
    return f"{row.default:g}" if row.type == "float" else "" if row.default is None else str(row.default)


def number_text(value: float) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def range_text(row: Row) -> str:
    """"from 0 (all cores) to 1024"; empty without a range."""
    if row.range is None:
        return ""
    least, most = (number_text(v) for v in row.range)
    unit = f" {row.unit}" if row.unit else ""
    return f"from {least}{f' ({row.least})' if row.least else ''} to {most}{unit}"
