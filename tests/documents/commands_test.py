"""Commands of gluray in the documents: each command, option and setting that they name exists. commands_test.py GLURAY ROOT

A command is a line of a block (indented by four, or fenced) that begins with gluray, perhaps after a prompt; and what stands between backquotes and begins so.
"""
import pathlib
import re
import shlex
import subprocess
import sys
import unittest

GLURAY, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")), *sorted((ROOT / "docs/guide").glob("*.md")), *sorted((ROOT / "docs/tutorials").glob("*.md"))]
LINE = re.compile(r"^(?:    |```.*$)?\s*(?:\$ )?((?:build/release/apps/gluray/)?gluray(?: .*)?)$")
QUOTED = re.compile(r"`(gluray [^`]+)`")
SAID = "gluray: "  # begins what gluray prints


def commands_of(text):
    """(line number, words) of each command."""
    fenced, continued = False, ""
    lines = text.splitlines()
    for number, line in enumerate(lines, 1):
        if number < len(lines) and lines[number].strip().startswith("gluray: no "):
            continue  # an example of a mistake
        if line.lstrip().startswith("```"):
            fenced = not fenced
            continue
        texts = QUOTED.findall(line)
        inside = fenced or line.startswith("    ")
        if inside:
            whole = continued + line
            if whole.rstrip().endswith("\\"):
                continued = whole.rstrip()[:-1]
                continue
            continued = ""
            found = LINE.match(whole if not fenced else "    " + whole)
            if found and not found[1].startswith(SAID):
                texts.append(found[1])
        for one in texts:
            for part in re.split(r"\s#|[;|&<>]", one):
                if part.strip().split(" ")[0].rsplit("/", 1)[-1] == "gluray":
                    try:
                        yield number, shlex.split(part.strip())
                    except ValueError:
                        continue  # a quotation that ends elsewhere


def output(*words):
    return subprocess.run([GLURAY, *words], capture_output=True, text=True).stdout


class Commands(unittest.TestCase):
    def setUp(self):
        listed = output("--help")
        self.names = set(re.findall(r"^  gluray ([a-z-]+)", listed, re.MULTILINE)) | set(re.findall(r"also: gluray ([a-z]+)|gluray (preset|redo|unset) ", listed)[0]) | {
            "unset", "preset", "redo", "timeline"}
        self.settings = set(re.findall(r'"name": *"([\w.-]+)"', output("settings", "--json")))
        self.helps = {}

    def help_of(self, command):
        if command not in self.helps:
            self.helps[command] = output(command, "--help") if command else output("--help")
        return self.helps[command]

    def faults_of(self, words):
        command = words[1] if len(words) > 1 and words[1] in self.names else ""
        helped = self.help_of(command)
        previous = ""
        for word in words[2 if command else 1:]:
            if word == "--":
                break
            if word.startswith("-") and len(word) > 1:
                option = word.split("=")[0]
                if not re.search(rf"(?<![\w-]){re.escape(option)}(?![\w-])", helped):
                    yield f"{command or 'gluray'} has no option {option}"
            elif re.fullmatch(r"[a-z][\w.-]*=.*", word) and (command == "set" or previous in ("--set", "--shot-set")):
                name = word.split("=")[0]
                if name not in self.settings:
                    yield f"there is no setting {name}"
            elif not command and not previous.startswith("-"):
                break  # the program
            previous = word

    def test_they_exist(self):
        self.assertGreater(len(self.names), 25)
        self.assertGreater(len(self.settings), 80)
        faults, count = [], 0
        for page in PAGES:
            for number, words in commands_of(page.read_text()):
                count += 1
                faults += [f"{page.relative_to(ROOT)}:{number}: {fault}" for fault in self.faults_of(words)]
        self.assertGreater(count, 100)
        self.assertEqual(faults, [])

    def test_mistakes_are_found(self):
        self.assertEqual([words for _, words in commands_of("    $ gluray --hud x  # y\ntext `gluray set a=b`\n    gluray: said\n")], [["gluray", "--hud", "x"], ["gluray", "set", "a=b"]])
        self.assertTrue(list(self.faults_of(["gluray", "--nonsense", "paraview"])))
        self.assertTrue(list(self.faults_of(["gluray", "set", "nonsense=1"])))
        self.assertTrue(list(self.faults_of(["gluray", "render", "--nonsense"])))
        self.assertEqual(list(self.faults_of(["gluray", "--set", "ao=on", "paraview", "--state=x"])), [])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
