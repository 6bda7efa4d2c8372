"""Known statements with placeholders ("$name", for numbers) and slots ("@name.part", for fragments of text): the twin of
src/gl/families/statement_pattern.cpp and slot_fragments.cpp, for known_code.py."""
import re

PIECE = re.compile(r"\$\w*|@(\w*)(?:(?<=\w)\.(\w+))?")
NUMBER = re.compile(r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[fF]?(?![\w.])")
SECTION = re.compile(r"^\[\[code\.fragments\]\]\n(.*?)(?=^\[|\Z)", re.S | re.M)
VALUE = re.compile(r"^(\w+) = (?:'''\n?(.*?)'''|'(.*?)'|\"((?:[^\"\\\n]|\\.)*)\")", re.S | re.M)


def needs_space(before, after):
    return bool(re.match(r"\w\w|\.\d", before + after))


def pieces(text):
    """Texts, "$", and (group, part) of slots."""
    cut, at = [], 0
    for found in PIECE.finditer(text):
        literal = text[at:found.start()]
        if cut and re.match(r" \w", literal):  # the space only keeps the name apart from the next word
            literal = literal[1:]
        cut += ([literal] if literal else []) + ["$" if found[0][0] == "$" else (found[1], found[2] or "")]
        at = found.end()
    literal = text[at:]
    if cut and re.match(r" \w", literal):
        literal = literal[1:]
    return cut + ([literal] if literal else [])


class Fragments:
    """Fragments of groups of slots by words and parts."""

    def __init__(self):
        self.words = {}  # group: {word: {part: [text]}}
        self.required = set()  # groups

    def read(self, text, normal_form):
        """Adds the [[code.fragments]] of a family file."""
        for section in SECTION.findall(text):
            values = {key: multi or single or re.sub(r"\\(.)", r"\1", plain) for key, multi, single, plain in VALUE.findall(section)}
            group = values.pop("slot")
            self.required.update([group] if re.search(r"^required = true$", section, re.M) else [])
            word = self.words.setdefault(group, {}).setdefault(values.pop("word"), {})
            for part, fragment in values.items():
                word.setdefault("" if part == "text" else part, []).append(normal_form(fragment))

    def texts(self, group, part):
        return [text for parts in self.words.get(group, {}).values() for text in parts.get(part, [])]

    def words_with(self, group, part, text):
        """The words that have this text at the part, and "" if it is empty and the group is not required."""
        found = [word for word, parts in self.words.get(group, {}).items() if text in parts.get(part, [""])]
        return found + ([""] if text == "" and group not in self.required else [])


class Matcher:
    """Compares a statement with patterns: follows all ways to read it at once, as the set of positions reached."""

    def __init__(self, statement, fragments):
        self.statement, self.fragments, self.slot_ends, self.cuts = statement, fragments, {}, {}

    def match(self, pattern):
        """[(group, part, text of the fragment)] of the slots of a pattern that fits; None if it does not."""
        if len(self.statement) not in self.stages(pattern, 0)[-1]:
            return None
        return list(self.read(pattern, 0, len(self.statement)))

    def token_from(self, at):
        text = self.statement
        if at == 0 or at >= len(text):
            return at
        if needs_space(text[at - 1], text[at]):
            return len(text)  # amid a token
        return at + (text[at] == " " and at + 1 < len(text) and needs_space(text[at - 1], text[at + 1]))

    def cut(self, pattern):
        if pattern not in self.cuts:
            self.cuts[pattern] = pieces(pattern)
        return self.cuts[pattern]

    def ends(self, piece, at):
        """Where the piece may end if it begins at `at`."""
        if isinstance(piece, tuple):
            if (piece, at) not in self.slot_ends:
                self.slot_ends[piece, at] = set()
                texts = self.fragments.texts(*piece)
                self.slot_ends[piece, at] = {at}.union(*(self.stages(text, at)[-1] for text in texts))
            return self.slot_ends[piece, at]
        start = self.token_from(at)
        if piece == "$":
            number = NUMBER.match(self.statement, start)
            return {number.end()} if number else set()
        return {start + len(piece)} if self.statement.startswith(piece, start) else set()

    def stages(self, pattern, at):
        """Where the pieces of a pattern may begin and, last, where it may end."""
        stages = [{at}]
        for piece in self.cut(pattern):
            stages.append(set().union(*(self.ends(piece, start) for start in stages[-1])))
        return stages

    def read(self, pattern, at, end):
        parts, stages, ends = self.cut(pattern), self.stages(pattern, at), [end]
        for piece, starts in zip(reversed(parts), reversed(stages[:-1])):
            ends.insert(0, min(start for start in starts if ends[0] in self.ends(piece, start)))
        for piece, start, stop in zip(parts, ends, ends[1:]):
            if not isinstance(piece, tuple):
                continue
            texts = self.fragments.texts(*piece) if start != stop else []
            text = next((text for text in texts if stop in self.stages(text, start)[-1]), "")
            yield piece + (text,)
            if text:
                yield from self.read(text, start, stop)


class Patterns:
    """Known statements with placeholders or slots."""

    def __init__(self, statements, fragments):
        self.statements, self.fragments = sorted(s for s in statements if re.search(r"[$@]", s)), fragments
        self.found = {}

    def slots(self, statement):
        """The slots of a statement that fits a pattern; None if it fits none."""
        if statement not in self.found:
            matcher = Matcher(statement, self.fragments)
            matches = (matcher.match(pattern) for pattern in self.statements if self.begins(statement, pattern))
            self.found[statement] = next((slots for slots in matches if slots is not None), None)
        return self.found[statement]

    @staticmethod
    def begins(statement, pattern):
        return statement.startswith(re.split(r"[$@]", pattern, maxsplit=1)[0].rstrip(" "))

    def wordless(self, slots):
        """The groups among slots for which no word has all the fragments."""
        possible = {}
        for group, part, text in slots:
            fit = self.fragments.words_with(group, part, text)
            possible[group] = [word for word in possible.get(group, fit) if word in fit]
        return sorted(group for group, words in possible.items() if not words)
