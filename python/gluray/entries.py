"""Entries of the setting material.objects, such as "3 glass roughness=0.1": what single objects are made of."""
HIDDEN = "hidden-from"


def object_of(entry):
    """The number at its beginning; None: there is none."""
    number = entry.split(maxsplit=1)[0] if entry.strip() else ""
    return int(number) if number.isascii() and number.isdigit() and int(number) else None


def words_of(entries, number):
    """The words of an object's entry: material, values, hidden-from. Those of several entries are merged, later ones win."""
    return _merged(word for entry in entries if number and object_of(entry) == number for word in entry.split()[1:])


def with_object(entries, number, words):
    """`entries` with what `words` say of the object. What they do not name stays, but a material forgets the values that it had.
    "KEY=" takes the value out. No words: no entry. The entry keeps its place; a new one comes last."""
    old = words_of(entries, number) if words else []
    if any(_key(word) == "" for word in words):
        old = [word for word in old if _key(word) == HIDDEN]
    merged = [word for word in _merged([*old, *words]) if not word.endswith("=")]
    places = [i for i, entry in enumerate(entries) if object_of(entry) == number]
    rest = [entry for entry in entries if object_of(entry) != number]
    if merged:
        rest.insert(places[0] if places else len(rest), " ".join([str(number), *merged]))
    return rest


def _key(word):
    return word.partition("=")[0] if "=" in word else ""


def _merged(words):
    by_key = {}
    for word in words:
        by_key[_key(word)] = word
    return sorted(by_key.values(), key=lambda word: {"": 0, HIDDEN: 2}.get(_key(word), 1))
