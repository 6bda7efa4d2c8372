#!/usr/bin/env python3
"""Checks what documents say of the repository: the paths, links and decision records that they name exist, and so do the
headers, functions and classes that ARCHITECTURE.md and CONTRIBUTING.md name; decision records are numbered without a gap.

check_documents.py ROOT        checks the documents of the source tree at ROOT; prints each fault and exits 1 where there is one
check_documents.py --self-test plants faults of every kind in a small tree and fails if it misses one
"""
import fnmatch
import pathlib
import posixpath
import re
import sys
import tempfile

TREES = "apps bench cmake completions docs examples packaging python scenes scripts spec src tests tools".split()
CODE = {".c", ".cmake", ".cpp", ".h", ".py"}
NAMING = {"ARCHITECTURE.md", "CONTRIBUTING.md"}  # documents whose names of functions and classes are checked
EXAMPLES = {"UpperCamel", "fooBar", "glFooBar"}  # names that only examples have
PATH = re.compile(rf"(?<![\w./-])(?:{'|'.join(TREES)})/[\w.*/-]*")
RECORD = re.compile(r"\b(?:adr/|ADRs? )(\d{4})")
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]+))?\)")
FILE = re.compile(r"(?<![\w./>-])[\w./-]+\.(?:cpp|h)\b")
CALL = re.compile(r"((?:\w+(?:::|\.|->))*\w+)\(")
NAME = re.compile(r"(?:\w+::)*\w+")
CAMEL = re.compile(r"[A-Z]\w*[a-z]\w*")
CHANGE = re.compile(r"\b(?:Changes|Adds to|Extends|Replaces) ([^.]*)")


def anchors(text):
    """The links to headings that a document offers, as hosts of Markdown make them."""
    for heading in re.findall(r"^#+ (.*)", text, re.MULTILINE):
        yield re.sub(r"[^\w -]", "", re.sub(r"\[(.*?)\]\(.*?\)", r"\1", heading).lower()).replace(" ", "-")


class Repository:
    def __init__(self, root):
        files = [f for f in root.iterdir() if f.is_file()] + [f for tree in TREES for f in (root / tree).rglob("*") if f.is_file()]
        self.files = {f.relative_to(root).as_posix() for f in files if "__pycache__" not in f.parts}
        self.paths = self.files | {p.as_posix() for f in self.files for p in pathlib.PurePosixPath(f).parents}
        self.rooms = {f.split("/")[1] for f in self.files if f.startswith("src/") and f.count("/") > 1}
        read = {f for f in self.files if pathlib.PurePosixPath(f).suffix in CODE and f != "tests/check_documents.py"}
        self.code = {f: re.sub(r"//.*", "", (root / f).read_text(errors="replace")) for f in read}
        self.all_code = "\n".join(self.code.values())
        self.types = set(re.findall(r"\b(?:class|struct|union|enum(?: class| struct)?|using|namespace) (?:\w+::)*(\w+)", self.all_code))
        named = sorted(f for f in self.files if re.fullmatch(r"[A-Z-]+\.md|docs/.*\.md|docs/man/.*", f))
        self.documents = {f: (root / f).read_text().replace("\\-", "-") for f in named}

    def has(self, path):
        """Whether it is a file, with or without its extension, a folder, a pattern of some, or a record by its number."""
        path = path.rstrip("/.") or "."
        return path in self.paths or any(p.startswith((path + ".", path + "-")) or ("*" in path and fnmatch.fnmatch(p, path)) for p in self.paths)

    def has_function(self, call):
        *holders, name = re.split(r"::|\.|->", call)
        if not holders or not CAMEL.fullmatch(holders[-1]):
            return re.search(rf"\b{name}\s*\(", self.all_code) is not None
        holder = rf"\b(?:class|struct) {holders[-1]}\b[^;{{]*{{(?:.|\n)*?[^\w.>]{name}\s*\("
        return f"{holders[-1]}::{name}(" in self.all_code or any(re.search(holder, text) for text in self.code.values())

    def faults(self):
        for document, text in self.documents.items():
            for number, line in enumerate(text.split("\n"), 1):
                for fault in self.faults_of_line(document, line):
                    yield f"{document}:{number}: {fault}"
        yield from self.faults_of_records()

    def faults_of_line(self, document, line):
        for path in PATH.findall(line):
            if not self.has(path):
                yield f"there is no {path}"
        for number in RECORD.findall(line):
            if not self.has(f"docs/adr/{number}"):
                yield f"there is no decision record {number}"
        for target, anchor in LINK.findall(line):
            path = posixpath.normpath(posixpath.join(posixpath.dirname(document), target)) if target else document
            if ":" in target:
                continue
            if path not in self.paths:
                yield f"links to {target}, which does not exist"
            elif anchor and anchor not in anchors(self.documents.get(path, "")):
                yield f"links to a heading #{anchor} that {path} does not have"
        for quoted in re.findall(r"`([^`]+)`", line):
            yield from self.faults_of_code(document, quoted)

    def faults_of_code(self, document, quoted):
        for path in FILE.findall(quoted):
            if not any(f"/{f}".endswith(f"/{path}") for f in self.files) and f"<{path}>" not in self.all_code:
                yield f"there is no {path}"
        for path in re.findall(r"(?<![\w./-])[a-z_]+/[\w./-]+", quoted):
            if path.split("/")[0] in self.rooms and not self.has(f"src/{path}"):
                yield f"there is no src/{path}"
        if document not in NAMING:
            return
        for call in CALL.findall(quoted):
            if not EXAMPLES & set(re.findall(r"\w+", call)) and not self.has_function(call):
                yield f"there is no function {call}()"
        if NAME.fullmatch(quoted):
            for name in quoted.split("::"):
                if CAMEL.fullmatch(name) and name not in self.types | EXAMPLES:
                    yield f"there is no class {name}"

    def faults_of_records(self):
        records = {f: text for f, text in self.documents.items() if re.match(r"docs/adr/\d{4}-", f)}
        numbers = sorted(int(f[9:13]) for f in records if f[9:13] != "0000")
        if numbers != list(range(1, len(numbers) + 1)):
            wrong = sorted(set(range(1, numbers[-1])) - set(numbers) | {n for n in numbers if numbers.count(n) > 1})
            yield f"docs/adr: each number has one page; not so {', '.join(f'{n:04}' for n in wrong)}"
        for record, text in records.items():
            for change in CHANGE.findall("\n".join(text.split("\n")[:4])):
                for number in re.findall(r"\b\d{4}\b", change):
                    if not any(f[9:13] == number and record[9:13] in other for f, other in records.items()):
                        yield f"{record} changes {number}, which does not name {record[9:13]}"


SOUND = {"src/gl/a.h": "class Part {\n  void draw(int);\n};\n", "tests/a.cpp": "#include <mpi.h>\nvoid test() {}\n", "docs/page.md": "# A page: more\n",
         "docs/adr/0001-one.md": "# 0001\n\nDate: x. Status: accepted. Changed by 0002.\n", "docs/adr/0002-two.md": "# 0002\n\nStatus: accepted. Changes 0001.\n"}
SOUND_LINES = "`src/gl/a.h` src/gl/a src/*/a.h tests/ adr/0001 docs/adr/0002 `gl/a` `gl/a.h` `mpi.h` `Part::draw()` `p.draw(1)` `test()` `Part` " \
    "`glFooBar()` [x](docs/page.md#a-page-more) [x](https://x.org/src/none)"
PLANTED = [("src/gl/b.h", "no src/gl/b.h"), ("docs/none.md", "no docs/none.md"), ("spec/*.toml", "no spec/"), ("adr/0003", "record 0003"), ("ADR 0009", "record 0009"),
           ("[x](none/a.md)", "links to none/a.md"), ("[x](docs/page.md#less)", "heading #less"), ("`b.h`", "no b.h"), ("`gl/b`", "no src/gl/b"),
           ("`none()`", "function none()"), ("`Part::test()`", "function Part::test()"), ("`x.none(1)`", "function x.none()"), ("`gl::None`", "class None")]
PLANTED_FILES = [("docs/adr/0004-x.md", "", "not so 0003"), ("docs/adr/0002-x.md", "", "not so 0002"), ("docs/adr/0003-x.md", "Status: x. Changes 0001.", "does not name 0003")]


def self_test():
    cases = [({}, "", None)] + [({}, line, words) for line, words in PLANTED] + [({file: text}, "", words) for file, text, words in PLANTED_FILES]
    for files, line, words in cases:
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**SOUND, "ARCHITECTURE.md": f"{SOUND_LINES}\n{line}\n", **files}.items():
                file = pathlib.Path(folder) / name
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            found = list(Repository(pathlib.Path(folder)).faults())
            if len(found) != (words is not None) or (words and words not in found[0]):
                yield f"planted {line or files}: expected {words}, got {found}"


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    found = list(self_test() if sys.argv[1] == "--self-test" else Repository(pathlib.Path(sys.argv[1])).faults())
    print("\n".join(found) if found else "no faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
