#!/usr/bin/env python3
"""Finds statements of shader programs that a file of known code (spec/programs/vtk_code.toml) does not have.

    MESA_SHADER_CAPTURE_PATH=FOLDER MESA_SHADER_CACHE_DISABLE=1 PROGRAM    # Mesa writes every program it links to FOLDER
    known_code.py [--code FILE] FOLDER ... [--with NAME ...]

Prints each statement once, with how many programs have it: what a [[code]] section lacks, ready to be pasted there after a
look at what it computes. --with: only of programs whose source holds all these texts (`--with vertexMC lightColor0`).
A program whose slots have fragments of different words, or lack a word, counts for a line that says so.
`gluray explain` names the unknown statements of programs that fit a family otherwise.
"""
import collections
import pathlib
import re
import sys

from code_slots import Fragments, Patterns
from command_line import Parser

TOKEN = re.compile(r"[A-Za-z_]\w*|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\w*|\n|[^\sA-Za-z_0-9]")
PLAIN = re.compile(r"(in|out|varying|attribute) ((highp|mediump|lowp) )?\w+ \w+(\[\w*\])?(,\w+(\[\w*\])?)*;")
STAGES = re.compile(r"^\[[a-z ]+ shader\]\n(.*?)(?=^\[[a-z ]+ shader\]\n|\Z)", re.S | re.M)
ROOT = pathlib.Path(__file__).resolve().parent.parent


def number(token):
    """As src/gl/glsl/glsl_tokens.cpp writes it."""
    if not re.fullmatch(r"\d*\.\d*[fF]?", token):
        return token
    whole, fraction = token.rstrip("fF").split(".")
    whole, fraction = whole.lstrip("0"), fraction.rstrip("0")
    return (whole or ("" if fraction else "0")) + "." + fraction


def tokens(text):
    text = re.sub(r"//[^\n]*", "", re.sub(r"/\*.*?\*/", " ", text.replace("\\\n", " "), flags=re.S))
    first, directive = True, False
    for token in TOKEN.findall(text):
        if token == "\n":
            if directive:
                yield token
            first, directive = True, False
            continue
        directive = directive or (first and token == "#")
        first = False
        yield number(token) if token[0].isdigit() or len(token) > 1 and token[0] == "." else token
    if directive:
        yield "\n"


def joined(parts):
    out = ""
    for part in parts:
        out += (" " if re.match(r"\w", part) and re.search(r"\w\Z", out) else "") + part
    lights = set(re.findall(r"\blight[A-Za-z]*(\d+)\b", out))
    return re.sub(r"\b(light[A-Za-z]*)\d+\b", r"\g<1>0", out) if len(lights) == 1 else out


def statements(text):
    """Statements as src/gl/glsl/glsl_statements.h cuts them, lights numbered 0."""
    parts, current, at = list(tokens(text)), [], 0
    main, function, parentheses, braces, loops = False, False, 0, 0, 0
    while at < len(parts):
        token, at = parts[at], at + 1
        if not current and token == "#":
            end = parts.index("\n", at)
            yield f"#{joined(parts[at:at + 1])} {joined(parts[at + 1:end])}".strip()
            at = end + 1
            continue
        if not current and token == "}":
            main, loops = main and loops > 0, max(loops - 1, 0)
            continue
        if not current and token in (";", "\n"):
            continue
        current.append(token)
        parentheses += (token == "(") - (token == ")")
        if token == "{":
            function = function or (braces == 0 and current[-2:-1] == [")"])
            begins = braces == 0 and (current[0] == "for" or not main and current[:3] == ["void", "main", "("])
            if begins:
                if current[0] == "for":
                    loops += 1
                    yield joined(current)
                main, current, function = True if current[0] == "void" else main, [], False
                continue
            braces += 1
        braces -= token == "}"
        block = token == "}" and (current[0] != "do" if main else function)
        if parentheses or braces or not (block or token == ";"):
            continue
        if at < len(parts) and parts[at] == "else":
            continue
        yield joined(current)
        current, function = [], False
    if current:
        yield joined(current)


def matters(statement):
    if statement.startswith(("#version", "#extension", "#line", "#pragma", "precision ")):
        return False
    return not re.match(r"(layout\([^()]*\))?uniform [^{]*;$", statement) and not PLAIN.fullmatch(statement)


def known_code(text):
    """The statements of a family file, and those with placeholders and slots."""
    sections = re.findall(r"^(?:statements|blocks) = '''\n(.*?)^'''$", text, re.S | re.M)
    known = {statement for section in sections for statement in statements(section)}
    fragments = Fragments()
    fragments.read(text, lambda fragment: joined(list(tokens(fragment))))
    return known, Patterns(known, fragments)


def differences(program, known, patterns):
    """The unknown statements of a program, and the groups of slots that no word explains."""
    unknown, slots = set(), []
    for text in STAGES.findall(program):
        for statement in statements(text):
            if not matters(statement) or statement in known:
                continue
            found = patterns.slots(statement)
            slots += found or []
            unknown.update([statement] if found is None else [])
    return unknown | {f"no word whose fragments stand in all slots \"@{group}\"" for group in patterns.wordless(slots)}


def main():
    parser = Parser(__doc__)
    parser.add_argument("--code", default=ROOT / "spec/programs/vtk_code.toml", type=pathlib.Path)
    parser.add_argument("--with", dest="texts", nargs="+", default=[])
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    given = parser.parse_args()
    known, patterns = known_code(given.code.read_text())
    programs = {file.read_text(errors="replace") for folder in given.folders for file in sorted(folder.glob("*.shader_test"))}
    if not programs:
        sys.exit(f"known_code.py: no programs in {', '.join(map(str, given.folders))}")
    missing = collections.Counter()
    for program in programs:
        if all(text in program for text in given.texts):
            missing.update(differences(program, known, patterns))
    for statement, count in missing.most_common():
        print(f"{count:5}  {statement}")


if __name__ == "__main__":
    main()
