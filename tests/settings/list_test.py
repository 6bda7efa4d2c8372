"""gluray settings: which settings the lists have, by level and group.

    list_test.py GLURAY
"""
from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

GLURAY = os.path.abspath(sys.argv.pop(1))
GROUPS = ["Quality", "Speed", "Light", "Shadows", "Occlusion", "Materials", "Camera", "Background", "Files", "Diagnosis", "Control", "Cluster"]


def output(*words: str, **variables: str) -> str:
    kept = {k: v for k, v in os.environ.items() if not k.startswith("GLURAY_")}
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([GLURAY, "settings", *words], capture_output=True, text=True, cwd=folder, env=kept | {"XDG_CONFIG_HOME": folder} | variables)
    if done.returncode or done.stderr:
        raise AssertionError(f"{words}: {done.returncode} {done.stderr}")
    return done.stdout


class Lists(unittest.TestCase):
    def setUp(self):
        self.rows = json.loads(output("--json"))

    def names(self, text: str) -> list[str]:
        """The settings of a list, which must have their titles, in groups of the fixed order."""
        group, names, groups = "", [], []
        for line in text.splitlines():
            if not line.startswith("  "):
                group = line
                groups.append(group)
                continue
            row = next(r for r in self.rows if line.startswith(f"  {r['title']}  "))
            self.assertRegex(line, rf"^  {re.escape(row['title'])} +{re.escape(row['name'])} +\S.* +(built-in|environment: \S+)$")
            self.assertEqual(row["group"], group, line)
            names.append(row["name"])
        self.assertEqual(groups, [g for g in GROUPS if g in groups])
        return names

    def test_json_has_every_setting_with_the_words_for_people(self):
        self.assertEqual(self.rows, json.loads(output("--json", "--all")))
        self.assertEqual({r["level"] for r in self.rows}, {"basic", "advanced", "expert"})
        self.assertLessEqual({r["group"] for r in self.rows}, set(GROUPS))
        self.assertEqual(len({r["title"] for r in self.rows}), len(self.rows))
        basic = [r for r in self.rows if r["level"] == "basic"]
        self.assertTrue(20 <= len(basic) <= 30, len(basic))

    def test_the_list_has_basic_settings_and_counts_the_others(self):
        *lines, last = output().splitlines(keepends=True)
        names = self.names("".join(lines))
        self.assertEqual(sorted(names), sorted(r["name"] for r in self.rows if r["level"] == "basic"))
        self.assertEqual(last, f"{len(self.rows) - len(names)} more settings: gluray settings --all\n")

    def test_all_has_every_setting_basic_ones_first(self):
        names = self.names(output("--all"))
        self.assertEqual(sorted(names), sorted(r["name"] for r in self.rows))
        levels = {r["name"]: (GROUPS.index(r["group"]), ("basic", "advanced", "expert").index(r["level"])) for r in self.rows}
        places = [levels[n] for n in names]
        self.assertEqual(places, sorted(places))

    def test_changed_has_every_level_and_nothing_else(self):
        self.assertEqual(output("--changed"), "")
        text = output("--changed", GLURAY_SPP="4", GLURAY_CULL_FROM="9")
        self.assertEqual(self.names(text), ["spp", "cull.from"])

    def test_numbers_have_units_and_least_values_their_meanings(self):
        text = output()
        self.assertRegex(text, r"lights.azimuth +30 degrees +built-in\n")
        self.assertRegex(text, r"threads +0 \(all cores\) +built-in\n")

    def test_one_setting_shows_its_title_and_level(self):
        self.assertIn("\n  Occlusion rays (Occlusion, advanced)\n", output("--why", "ao.samples"))


if __name__ == "__main__":
    unittest.main()
