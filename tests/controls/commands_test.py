"""gluray get and gluray presets: commands_test.py GLURAY."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest


class Commands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "gluray").mkdir()
        self.user, self.project = self.folder / "gluray/gluray.toml", self.folder / "gluray.toml"

    def run_gluray(self, *words, **variables):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("GLURAY_")} | {"XDG_CONFIG_HOME": str(self.folder), **variables}
        return subprocess.run([GLURAY, *words], capture_output=True, text=True, cwd=self.folder, env=environment, timeout=60)

    def output(self, *words, **variables):
        done = self.run_gluray(*words, **variables)
        self.assertEqual((done.returncode, done.stderr), (0, ""), words)
        return done.stdout

    def refusal(self, *words):
        done = self.run_gluray(*words)
        self.assertEqual((done.returncode, done.stdout), (2, ""), words)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        return done.stderr

    def test_values(self):
        self.assertEqual(self.output("get", "ao.samples"), "16\n")
        self.assertEqual(self.output("get"), "")
        self.user.write_text("ao.samples = 8\n[program.viewer]\nao = true\n")
        self.assertEqual(self.output("get", "ao.samples"), "8\n")
        self.assertEqual(self.output("get", "ao", "ao.samples"), "ao = false\nao.samples = 8\n")
        self.assertEqual(self.output("get", "--program", "/usr/bin/viewer"), "ao = true\nao.samples = 8\n")
        self.assertEqual(self.output("get", "--set", "ao.samples=2", "ao.samples"), "2\n")

    def test_why_shows_every_layer(self):
        self.user.write_text("ao.samples = 8\npreset = 'streamlines'\n[presets.streamlines]\nao.samples = 9\n[program.viewer]\nao.samples = 10\n")
        self.project.write_text("ao.samples = 11\n")
        one = json.loads(self.output("get", "--why", "--json", "--program", "viewer", "--set", "ao.samples=12", "ao.samples", GLURAY_AO_SAMPLES="13"))[0]
        layers = {layer["layer"]: (layer["value"], layer["place"]) for layer in one["layers"]}
        self.assertEqual(layers, {
            "built-in": (16, ""), "system": (None, ""), "user": (8, f"{self.user}:1"), "project": (11, f"{self.project}:1"),
            "program": (10, f"{self.user}:6"), "preset": (9, f"streamlines, {self.user}:4"), "environment": (13, "GLURAY_AO_SAMPLES"),
            "command line": (12, "--set ao.samples"), "live": (None, "")})
        self.assertEqual((one["value"], one["layer"], one["default"]), (12, "command line", 16))
        text = " ".join(self.output("get", "--why", "ao.samples").split())
        for part in ("ao.samples = 9 (preset: streamlines, ", "user", "11", "Default: 16", "from the next frame on"):
            self.assertIn(part, text)

    def test_json_has_types(self):
        found = {one["name"]: one for one in json.loads(self.output("settings", "--json", "--set", "ao=on", "--set", "lights.up=z"))}
        values = {name: found[name]["value"] for name in ("ao", "ao.samples", "ao.strength", "lights.up", "report", "program-families")}
        self.assertEqual(values, {"ao": True, "ao.samples": 16, "ao.strength": 1, "lights.up": "z", "report": "", "program-families": []})
        self.assertEqual((found["ao"]["type"], found["ao"]["applies"], found["ao"]["default"]), ("boolean", "frame", False))
        self.assertEqual((found["ao.samples"]["least"], found["ao.samples"]["most"]), (1, 4096))
        self.assertIn("embree", [word["word"] for word in found["renderer"]["words"]])
        self.assertEqual(json.loads(self.output("get", "--json", "--set", "spp=4"))[0]["value"], 4)

    def test_mistakes(self):
        self.assertIn("did you mean 'ao.samples'?", self.refusal("get", "ao.sample"))
        self.assertIn("did you mean 'draft'?", self.refusal("presets", "drft"))
        for command in ("run", "explain", "get", "settings"):
            self.assertIn("did you mean 'draft'?", self.refusal(command, "--preset", "drft", *(["true"] if command in ("run", "explain") else [])))
        self.user.write_text("[presets.drft]\nspp = 2\n")
        self.assertEqual(self.output("get", "--preset", "drft", "spp"), "2\n")
        self.assertEqual(self.output("--preset", "drft", "true"), "")

    def test_presets(self):
        self.user.write_text("preset = 'mine'\n[presets.mine]\nhelp = 'For \\u001b[31mme.'\nspp = 2\nspq = 3\n")
        listing = self.run_gluray("presets")
        self.assertIn("did you mean 'spp'?", listing.stderr)
        text = listing.stdout
        for name in ("draft", "presentation", "figure", "streamlines", "molecule", "metal", "outdoor", "poster", "honest", "ospray", "mine  (chosen)"):
            self.assertIn(f"\n{name}\n", "\n" + text)
        self.assertNotIn("\x1b", text)
        mine = self.run_gluray("presets", "mine").stdout
        self.assertIn("mine, " + str(self.user) + ":4", mine)
        self.assertIn("did you mean 'spp'?", mine)
        found = {p["name"]: p for p in json.loads(self.run_gluray("presets", "--json").stdout)}
        self.assertEqual([p["name"] for p in found.values() if p["chosen"]], ["mine"])
        self.assertEqual(found["mine"]["values"][0], {"name": "spp", "value": "2", "place": f"mine, {self.user}:4", "wrong": ""})
        for preset in ("draft", "presentation", "figure", "streamlines", "molecule", "metal", "outdoor", "poster", "honest", "ospray"):
            self.assertEqual(self.output("get", "--preset", preset, "preset"), preset + "\n")


if __name__ == "__main__":
    GLURAY = sys.argv[1]
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
