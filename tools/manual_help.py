"""Reads the help text of a command of the launcher, which CLI11 formats."""
from __future__ import annotations

import dataclasses
import re

COLUMN = 26  # of descriptions; apps/gluray/command_line.cpp


@dataclasses.dataclass
class Option:
    """An option or a positional argument."""
    names: list[str]
    value: str   # placeholder; empty: a switch
    text: str    # description
    facts: str   # sentences on allowed values, default and other options


def facts_of(head: str) -> tuple[str, str]:
    """The placeholder, and sentences for what CLI11 adds to it: TYPE:{a,b}=a, N:INT in [1 - 9]=3, REQUIRED, Needs: ..., Excludes: ..."""
    sentences = []
    for word, meaning in (("Needs", "It needs {}."), ("Excludes", "It cannot be combined with {}.")):
        if found := re.search(rf" ?{word}: ((?:--[\w-]+ ?)+)", head):
            sentences.append(meaning.format(" or ".join(found[1].split()) if word == "Excludes" else " and ".join(found[1].split())))
            head = head.replace(found[0].rstrip(), "")
    head = re.sub(r" ?\bREQUIRED\b", "", head).strip()
    default = re.search(r"(?:=| \[)([^\s=\]{}]+)\]?$", head) if not head.startswith("NAME=") else None
    if default:
        head = head[:default.start()]
    if words := re.search(r":\{([^}]*)\}", head):
        listed = words[1].split(",")
        sentences.insert(0, f"Values: {', '.join(listed[:-1])} or {listed[-1]}.")
    if limits := re.search(r" in \[(\S+) - (\S+)\]", head):
        sentences.insert(0, f"From {float(limits[1]):.12g} to {float(limits[2]):.12g}.")
    if ":NONNEGATIVE" in head:
        sentences.insert(0, "Not negative.")
    if default:
        sentences.append(f"The default is {default[1]}.")
    value = re.sub(r":(?:\{[^}]*\}|INT|FLOAT|NONNEGATIVE)(?: in \[[^]]*\])?", "", head).replace("{false}", "")
    return ("HOW" if value == "TEXT" else value), " ".join(sentences)


class Help:
    def __init__(self, text: str):
        lines = text.split("\n")
        start = next(i for i, line in enumerate(lines) if line.startswith("Usage: "))
        self.description = "\n".join(lines[:start]).strip()
        self.usage = lines[start].removeprefix("Usage: ").strip()
        self.positionals = self._section(lines, "positionals:")
        self.options = self._section(lines, "options:")

    @staticmethod
    def _section(lines: list[str], title: str) -> list[Option]:
        options: list[list[str]] = []
        inside = False
        for line in lines:
            if line and not line.startswith(" "):
                inside = line.lower() == title
            elif inside and re.match(r"  \S", line):
                head, _, text = line[2:].partition("  ") if len(line) > COLUMN and "  " in line[2:COLUMN] else Help._long_head(line[2:])
                options.append([head.strip(), text.strip()])
            elif inside and line.strip():
                options[-1][1] += "\n" + line.strip()
        return [Help._option(head, text) for head, text in options]

    @staticmethod
    def _long_head(line: str) -> tuple[str, str, str]:
        """A head as long as its column or longer: a description on the same line begins there with a capital."""
        cut = COLUMN - 2
        return (line[:cut], "", line[cut:]) if len(line) > cut and line[cut - 1] == " " and line[cut].isupper() and "  " not in line else (line, "", "")

    @staticmethod
    def _option(head: str, text: str) -> Option:
        head = head.replace("{false}", "")
        if not head.startswith("-"):
            name, _, rest = head.partition(" ")
            return Option([name], "", Help._text(text), facts_of("X " + re.sub(r"^TEXT ?(?:\.\.\.)?", "", rest))[1])
        matched = re.match(r"((?:-{1,2}[\w-]+)(?:, ?-{1,2}[\w-]+)*)(.*)", head)
        value, facts = facts_of(matched[2].strip())
        return Option(re.split(r", ?", matched[1]), value, Help._text(text), facts)

    @staticmethod
    def _text(text: str) -> str:
        """Lines joined; a line "word: meaning" begins a sentence of its own."""
        joined = ""
        for line in text.split("\n"):
            if joined and re.match(r"[\w+-]+: ", line) and not joined.endswith((",", "and", "or")):
                joined += ("; " if re.search(r"(?:\.|; )[\w+-]+: ", joined.replace(". ", ".")) else ". ") + line
            else:
                joined += (" " if joined else "") + line
        return joined
