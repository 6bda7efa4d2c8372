"""Keeps every measurement, so that an interrupted run can be resumed."""
import hashlib
import json


def stamp_of(files, **what):
    """Identifies the build and the machine of measurements: a digest of the files' contents and of other conditions."""
    digest = hashlib.sha256(json.dumps(what, sort_keys=True).encode())
    for path in files:
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


class Store:
    """A file of lines of JSON: {"stamp", "key", "measured"}. Ignores lines with another stamp, and truncated ones."""

    def __init__(self, path, stamp, fresh=False):
        self.path, self.stamp = path, stamp
        self.known, self.others = {}, 0
        path.parent.mkdir(parents=True, exist_ok=True)
        if fresh:
            path.unlink(missing_ok=True)
        elif path.exists():
            self._read()

    def _read(self):
        for line in self.path.read_text().splitlines():
            try:
                entry = json.loads(line)
                key, measured, stamp = entry["key"], entry["measured"], entry["stamp"]
            except (ValueError, KeyError, TypeError):
                continue
            if stamp == self.stamp:
                self.known[key] = measured
            else:
                self.others += 1

    def __contains__(self, key):
        return key in self.known

    def __getitem__(self, key):
        return self.known[key]

    def keep(self, key, measured):
        """Writes it at once, because the next measurement may be interrupted."""
        self.known[key] = measured
        cut = self.path.exists() and self.path.stat().st_size > 0 and not self.path.read_bytes().endswith(b"\n")
        with self.path.open("a") as file:
            file.write(("\n" if cut else "") + json.dumps({"stamp": self.stamp, "key": key, "measured": measured}) + "\n")
