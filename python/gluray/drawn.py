"""What a program draws: its objects, materials, lights and cameras."""
import operator

from .entries import HIDDEN, object_of, with_object, words_of
from .errors import GlurayError

RIG_FOR_HIGHLIGHT = "headlight+key"  # of the rigs with a key light, the one that keeps the brightness; fixed to the scene by lights.attached = auto
WITHOUT_KEY = ("program", "sky")     # values of lights
MOST_IN_ANSWER = 1000                # objects


class Drawn:
    """Methods of Program. A program that draws nothing is asked to draw; they raise GlurayError if it does not."""

    def objects(self):
        """The objects that it draws and GLuRay traces, in the order of their numbers: dicts with object (its number), view, shape,
        triangles, color, material, hidden, lower, upper ... (docs/control-protocol.md, What the program draws)."""
        found, last = [], 0
        while True:
            answer = self._call("objects", {"after": last, "count": MOST_IN_ANSWER})
            some = self._list(answer, "objects")
            for one in some:
                if not _is_whole(one.get("object")) or one["object"] <= last:
                    raise self._unreadable("object")
                last = one["object"]
            found += some
            total = answer.get("total")
            if not _is_whole(total):
                raise self._unreadable("total")
            if not some or len(found) >= total:
                return found

    def pick(self, x, y, width=None, height=None):
        """What is at a point of its image, in pixels from the top left: a dict with object, view, position, normal, distance, and share (where
        the point lies in its view, as shares of the view's width and height from the lower left corner); None: nothing.

        `width`, `height`: of the image that x and y are counted in; 1 and 1 for shares of it. None: that of the window.
        """
        found = self._at("pick", x, y, width, height)
        if found is not None and not (_numbers(found.get("position"), 3) and _numbers(found.get("normal"), 3)):
            raise self._unreadable("position")
        if found is not None and not _numbers(found.get("share"), 2):
            raise self._unreadable("share")
        return found

    def _at(self, name, x, y, width, height):
        arguments = {"x": x, "y": y, "width": width, "height": height}
        found = self._call(name, {key: value for key, value in arguments.items() if value is not None})
        if found.get("object", 0) is not None and not (_is_whole(found.get("object")) and found["object"]):
            raise self._unreadable("object")
        return None if found["object"] is None else found

    # Materials

    def materials(self):
        """What entries of material.objects say, by the numbers of objects: {3: "glass roughness=0.1"}."""
        entries = self._entries()
        numbers = sorted({object_of(entry) for entry in entries} - {None})
        return {number: " ".join(words_of(entries, number)) for number in numbers}

    def material(self, objects, material=None, hidden_from=None, reset=False, **values):
        """Changes what objects are made of, and which rays do not meet them: p.material(3, "glass", roughness=0.1).

        `objects`: a number, several, or "all"; `hidden_from`: "camera", "camera+shadow" or a list of such words, "all", or "none";
        `values`: settings of the group material by their short names. What is not named stays; a new material forgets the old one's values.
        `reset`: removes the entries of the objects. Returns as set(). Materials are seen with p["integrator"] = "path" or "whitted".
        """
        words = _words(material, hidden_from, values)
        if reset and words:
            raise GlurayError("reset takes objects alone")
        if not reset and not words:
            raise GlurayError("name a material, values, or hidden_from")
        if f"{HIDDEN}=none" in words and not self.get("material.file"):  # whose rules hide objects, too
            words = [f"{HIDDEN}=" if word == f"{HIDDEN}=none" else word for word in words]
        entries = self._entries()
        for number in self._chosen(objects, {object_of(entry) for entry in entries} - {None} if reset else None):
            entries = with_object(entries, number, words)
        return self.set({"material.objects": entries})

    def _entries(self):
        entries = self.get("material.objects")
        if not isinstance(entries, list) or not all(isinstance(entry, str) for entry in entries):
            raise GlurayError(f"{self.name} ({self.pid}): it does not say what material.objects is")
        return entries

    def _chosen(self, objects, known):
        """Those of the objects that are `known`, all of them for "all"; None: that the program draws, which must have them."""
        there = [one["object"] for one in self.objects()] if known is None else sorted(known)
        if isinstance(objects, str) and objects == "all":
            return there
        try:
            numbers = [operator.index(number) for number in (objects if hasattr(objects, "__iter__") else [objects])]
        except TypeError:
            raise GlurayError(f"{objects!r}: use the number of an object, a list of them, or 'all'") from None
        for number in numbers:
            if known is None and number not in there:
                raise GlurayError(f"{self.name} ({self.pid}): it draws no object {number}; objects() has them")
        return numbers

    # Lights and cameras

    def lights(self):
        """The lights of its image: dicts with name, from, kind, direction, position, azimuth, elevation, color, strength, size."""
        return self._list(self._call("lights", {}), "lights")

    def light_at(self, x, y, width=None, height=None):
        """Puts the highlight of the key light at a point of its image, as pick() takes it. Where lights is program or
        sky, which have no key light, it becomes headlight+key. Returns as set(); raises GlurayError if nothing is there."""
        found = self._at("highlight", x, y, width, height)
        if found is None:
            raise GlurayError(f"{self.name} ({self.pid}): nothing is there")
        if not _numbers([found.get("azimuth"), found.get("elevation")], 2):
            raise self._unreadable("azimuth")
        rig = {"lights": RIG_FOR_HIGHLIGHT} if self.get("lights") in WITHOUT_KEY else {}
        return self.set({"lights.azimuth": found["azimuth"], "lights.elevation": found["elevation"], **rig})

    def cameras(self):
        """The cameras of its image, one a view: dicts with view, projection, angle, height, position, direction, up, near, far,
        viewport, triangles."""
        return self._list(self._call("cameras", {}), "cameras")

    def focus_at(self, x, y, width=None, height=None):
        """Focuses on the surface at a point of its image, as pick() takes it: camera.focus-x and camera.focus-y. It counts while
        camera.aperture or camera.f-number is above 0. Returns as set(); raises GlurayError if nothing is there."""
        found = self.pick(x, y, width, height)
        if found is None:
            raise GlurayError(f"{self.name} ({self.pid}): nothing is there")
        right, up = (min(max(share, 0), 1) for share in found["share"])
        return self.set({"camera.focus": 0, "camera.focus-x": right, "camera.focus-y": up})

    # Answers

    def _list(self, answer, name):
        """A list of objects in an answer. Raises GlurayError."""
        found = answer.get(name)
        if not isinstance(found, list) or not all(isinstance(one, dict) for one in found):
            raise self._unreadable(name)
        return found

    def _unreadable(self, name):
        return GlurayError(f"{self.name} ({self.pid}): its answer cannot be read: '{name}' is missing or wrong")


def _is_whole(value):
    return isinstance(value, int) and not isinstance(value, bool) and value >= 0


def _numbers(values, count):
    return isinstance(values, list) and len(values) == count and all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in values)


def _words(material, hidden_from, values):
    """The words of an entry. Raises GlurayError where one could be two."""
    rays = hidden_from if hidden_from is None or isinstance(hidden_from, str) else "+".join(hidden_from) or "none"
    texts = {name.replace("_", "-"): str(value) for name, value in values.items()}
    words = ([material] if material else []) + [f"{name}={value}" for name, value in texts.items()] + ([] if rays is None else [f"{HIDDEN}={rays}"])
    for word in words:
        if not isinstance(word, str) or not word or any(letter.isspace() or letter == "," for letter in word) or word.endswith("="):
            raise GlurayError(f"{word!r}: use one word a value")
    return words
