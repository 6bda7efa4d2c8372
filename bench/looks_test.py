"""Figures of looks (bench/looks): the order of colours and its reference, and the limits that the results in the repository keep.

The figures are tested where Python has numpy and Pillow.
"""
import json
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "bench" / "looks"), str(ROOT / "bench")]
sys.dont_write_bytecode = True
import rules  # noqa: E402

try:
    import numpy as np
    import measure
except ImportError:
    np = None
KEPT = {"brightness": 1, "lost": 0, "hue": 0, "burnt": 0, "order": 1, "depth": 0.5}


class Rules(unittest.TestCase):
    def test_figures_beyond_their_limits_are_named(self):
        self.assertEqual(rules.beyond(KEPT), [])
        for name, value in (("brightness", 0.84), ("brightness", 1.16), ("lost", 0.02), ("hue", 7), ("burnt", 0.02), ("order", 0.97), ("depth", 0.09)):
            self.assertEqual(rules.beyond({**KEPT, name: value}), [name])

    def test_only_rules_that_the_purpose_excludes_are_excused(self):
        figures = {**KEPT, "brightness": 1.5, "hue": 7}
        self.assertEqual(rules.misses("honest", "chart", figures), ["hue"])
        self.assertEqual(rules.misses("figure", "chart", figures), ["brightness", "hue"])
        self.assertEqual(rules.misses("metal", "chart", {**KEPT, "burnt": 0.02, "hue": 7}), ["hue"])
        self.assertEqual(rules.misses("metal", "bearing", {**KEPT, "burnt": 0.02, "hue": 7}), ["hue", "burnt"])


class Results(unittest.TestCase):
    def setUp(self):
        self.result = json.loads((ROOT / "bench" / "results" / "looks.json").read_text())

    def test_every_look_is_measured_on_every_scene(self):
        presets = re.findall(r"^\[presets\.([\w-]+)\]", (ROOT / "spec" / "presets.toml").read_text(), re.MULTILINE)
        looks = {name for name in presets if not name.startswith("quality-")}
        scenes = set(re.search(r"for f in \((.*)\)\}", (ROOT / "bench" / "looks" / "scenes.py").read_text()).group(1).split(", "))
        self.assertEqual({(row["look"], row["scene"]) for row in self.result["rows"]}, {(look, scene) for look in looks for scene in scenes})

    def test_every_rule_that_is_not_excluded_is_kept(self):
        for row in self.result["rows"]:
            self.assertEqual(rules.misses(row["look"], row["scene"], row), [], f"{row['look']}, {row['scene']}")

    def test_every_excluded_rule_is_broken_somewhere(self):
        broken = {(row["look"], name) for row in self.result["rows"] for name in rules.beyond(row)}
        excluded = {(look, name) for look, names in rules.NOT_KEPT.items() for name in names}
        self.assertEqual(excluded - broken, set())
        self.assertEqual(self.result["not_kept"], rules.NOT_KEPT)


@unittest.skipIf(np is None, "no numpy or Pillow")
class Order(unittest.TestCase):
    """Stripes of rising scalars, in greys that rise with them."""

    def setUp(self):
        self.values = np.repeat(np.arange(16, 256, 16, dtype=np.uint8), 8)[None, :].repeat(60, 0)
        self.colors = self.values[..., None].repeat(3, -1)
        self.all = np.ones(self.values.shape, bool)
        self.lit = (self.colors * np.linspace(1, 0.1, self.values.shape[1])[None, :, None]).astype(np.uint8)  # dark where the map is bright

    def order(self, own, look):
        return measure.measure(own, look, self.all, self.values, self.colors).order

    def test_colours_of_the_map_have_its_order_whatever_the_programs_light_does(self):
        alone = measure.order_along_map(*(measure.luminance(p[self.all]) for p in (self.lit, self.colors)), self.values[self.all])
        self.assertLess(alone, 0.9)
        self.assertEqual(self.order(self.lit, self.colors), 1)

    def test_the_programs_own_picture_keeps_the_order(self):
        self.assertEqual(self.order(self.lit, self.lit), 1)

    def test_colours_that_change_places_are_found(self):
        self.assertLess(self.order(self.colors, self.colors[:, ::-1]), 0)
        swapped = self.colors.copy()
        swapped[:, 32:48] = self.colors[:, 64:80]
        self.assertLess(self.order(self.lit, swapped), 0.98)


@unittest.skipIf(np is None, "no numpy or Pillow")
class Brightness(unittest.TestCase):
    def test_light_that_moves_from_the_middle_to_the_rim_changes_nothing(self):
        surface = np.zeros((20, 20), bool)
        surface[5:15, 5:15] = True
        inner = measure.inner(surface)
        own, look = np.zeros((2, 20, 20, 3), np.uint8)
        own[surface], own[inner] = 20, 160      # 36 pixels of the rim, 64 within
        look[surface], look[inner] = 110, 110
        figures = measure.measure(own, look, surface, np.zeros(surface.shape, np.uint8), own)
        self.assertAlmostEqual(figures.brightness, 110 * 100 / (20 * 36 + 160 * 64))


if __name__ == "__main__":
    unittest.main()
