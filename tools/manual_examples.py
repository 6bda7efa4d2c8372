"""Commands of gluray in README.md, the guide, the tutorials and other pages: the examples of its manual pages."""
from __future__ import annotations

import pathlib
import re

MAX_EXAMPLES = 8  # examples on a page
COMMAND = re.compile(r"^(?:    )?(?:\w*\$ +)?gluray +([a-z]+(?:-[a-z]+)*)\b(.*)$")

MISTAKE = re.compile(r"\s*gluray: (?:no |.*: use )")  # begins the answer to a wrong command


def documents(root: pathlib.Path) -> list[pathlib.Path]:
    return [*sorted((root / "docs/guide").glob("*.md")), *sorted((root / "docs/tutorials").glob("*.md")), root / "README.md", root / "docs/explain.md", root / "docs/troubleshooting.md"]


def code(text: str):
    """Lines of blocks that are indented by four or fenced; those that end in a backslash are joined."""
    fenced, continued = False, ""
    for line in text.splitlines():
        if line.startswith("```"):
            fenced = not fenced
        elif fenced or line.startswith("    "):
            whole = continued + (line.strip() if continued else line)
            continued = whole.rstrip().removesuffix("\\").rstrip() + " " if whole.rstrip().endswith("\\") else ""
            if not continued:
                yield whole


def read(root: pathlib.Path) -> dict[str, list[tuple[str, str]]]:
    """Of each command: commands, each with the comment after it or an empty text. Mistakes that the guide shows are not examples."""
    examples: dict[str, list[tuple[str, str]]] = {}
    for file in documents(root):
        lines = list(code(file.read_text()))
        for line, following in zip(lines, [*lines[1:], ""]):
            found = COMMAND.match(line)
            if not found or MISTAKE.match(following):
                continue
            command, _, comment = found[2].partition(" #")
            entry = (f"gluray {found[1]}{command.rstrip()}", comment.strip())
            known = examples.setdefault(found[1], [])
            if len(known) < MAX_EXAMPLES and entry[0] not in [text for text, _ in known]:
                known.append(entry)
    return examples
