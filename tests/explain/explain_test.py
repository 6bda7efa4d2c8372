"""gluray explain on a program whose draws are known (explaining.py): tables, ways to end.

    explain_test.py GLURAY CLIENTS_DIRECTORY [unittest arguments]
"""
from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
import time
import unittest

from explaining import CLIENT, CLIENTS, GLURAY, Folder, explained, gluray

ENDS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGSEGV, signal.SIGABRT, signal.SIGKILL)


class Table(Folder):
    def check_kinds(self, process, frames):
        kinds = {(k["primitive"], k["path"]): k for k in process["explain"]["kinds"]}
        self.assertEqual(len(kinds), 5, kinds)
        expected = {("surfaces", "glBegin"): (1, 2, "traced", []), ("surfaces", "list"): (1, 6, "traced", []),
                    ("surfaces", "elements"): (1, 200, "traced", []),
                    ("surfaces", "arrays"): (1, 6, "polygon stipple", ["blend"]), ("lines", "glBegin"): (1, 0, "lines", [])}
        for kind, (count, triangles, reason, state) in expected.items():
            seen = kinds[kind]
            self.assertEqual((seen["count"], seen["triangles"], seen["reason"], seen["state"]),
                             (count * frames, triangles * frames, reason, state), kind)
            self.assertEqual(seen["traced"], reason == "traced")
            self.assertGreater(seen["ms"], 0)

    def test_every_draw_is_counted_and_no_frame_more_than_asked_for(self):
        for door in ("vendor", "preload"):
            with self.subTest(door=door):
                all = explained("--frames", 25, "--door", door, CLIENT, "plain")
                [process] = all["processes"]
                self.assertEqual(process["frames"], 25)
                self.assertEqual(process["door"], door)
                self.assertEqual(all["ending"], "ended after 25 frames")
                self.check_kinds(process, 25)

    def test_contexts_framebuffers_quirks_and_unknown_functions(self):
        [process] = explained("--frames", 3, CLIENT)["processes"]
        explain = process["explain"]
        [context] = explain["contexts"]
        self.assertEqual((context["api"], context["profile"], context["doubleBuffered"], context["frames"]),
                         ("GLX", "compatibility", True, 3))
        [window] = explain["framebuffers"]
        self.assertEqual((window["name"], window["width"], window["height"]), (0, 256, 256))
        self.assertEqual((window["traced"], window["rasterised"]), (9, 6))
        self.assertIn(("material-latch", True), [(q["name"], q["on"]) for q in explain["quirks"]])

    def test_functions_that_nobody_models(self):
        plain = gluray("--off", "--door", "preload", CLIENT, "short")
        has = [line.split()[1] for line in plain.stdout.splitlines() if line.startswith("has ")]
        if not has:
            self.skipTest("the real OpenGL has none of the functions that the client asks for")
        for door in ("preload", "vendor"):
            [process] = explained("--frames", 3, "--door", door, CLIENT)["processes"]
            seen = process["explain"]["unknownFunctions"]
            self.assertTrue(set(seen) <= set(has), seen)  # none of the thousands that libglvnd asks for
            if door == "preload":
                self.assertEqual(seen, has)
                self.assertIn(has[0], gluray("explain", "--frames", 3, "--door", door, CLIENT).stdout)

    def test_the_text_says_the_same(self):
        done = gluray("explain", "--frames", 10, CLIENT)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"surfaces +elements +10 +2 000 +[\d.]+ +traced")
        self.assertRegex(done.stdout, r"surfaces +arrays +10 +60 +[\d.]+ +rasterised: polygon stipple +blend")
        self.assertRegex(done.stdout, r"lines +glBegin +10 +0 +[\d.]+ +rasterised: lines")
        self.assertIn("10 frames, 97.2 % of 2 140 triangles traced", done.stdout)

    def test_quirks_are_switched(self):
        for word in ("on", "off"):
            [process] = explained("--frames", 3, "--quirk", f"material-latch={word}", CLIENT)["processes"]
            self.assertEqual({q["name"]: q["on"] for q in process["explain"]["quirks"]}["material-latch"], word == "on")
        done = gluray("--quirk", "nothing=on", CLIENT)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
        self.assertIn("material-latch", gluray("quirks").stdout)

    def test_quirks_of_the_environment(self):
        listed = json.loads(gluray("quirks", "--json", GLURAY_QUIRKS="material-latch=off").stdout)
        self.assertEqual({q["name"]: q["on"] for q in listed}["material-latch"], False)


class Ending(Folder):
    def test_programs_are_asked_to_end(self):
        done = gluray("explain", "--frames", 5, CLIENT)
        self.assertIn("asked to end", done.stdout)

    def test_programs_that_end_by_themselves(self):
        all = explained(CLIENT, "short")
        self.assertEqual(all["ending"], "it ended by itself, with exit code 3")
        self.assertEqual(all["processes"][0]["frames"], 5)

    def test_programs_at_rest(self):
        done = gluray("explain", "--rest", "0.5", CLIENT, "still")
        self.assertIn("ended at rest", done.stdout)
        self.assertIn("asked to end", done.stdout)
        self.assertIn("2 frames", done.stdout)

    def test_time_is_limited(self):
        done = gluray("explain", "--rest", 0, "--seconds", 1, CLIENT, "still")
        self.assertIn("ended by its time limit", done.stdout)

    def test_programs_behind_a_script(self):
        script = self.folder / "script"
        script.write_text(f"#!/bin/sh\n{CLIENT} plain\n")
        script.chmod(0o755)
        [process] = explained("--frames", 4, script)["processes"]
        self.assertEqual(process["frames"], 4)

    def test_programs_without_opengl(self):
        done = gluray("explain", "true")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)

    def test_programs_that_cannot_be_started(self):
        self.assertEqual(gluray("explain", "no-such-program").returncode, 127)
        (self.folder / "data").write_text("x")
        self.assertEqual(gluray("explain", self.folder / "data").returncode, 126)
        self.assertEqual(gluray("explain").returncode, 2)

    def test_nothing_is_left_behind(self):
        explained("--frames", 3, "--html", self.folder / "page.html", CLIENT, TMPDIR=str(self.folder))
        self.assertEqual([p.name for p in self.folder.iterdir()], ["page.html"])


class NeverSwapping(Folder):
    """Programs that end no frame, or are ended by a signal, are reported and explained, too."""

    def killed(self, mode, enough):
        """The report of a program that is killed as soon as the report holds enough."""
        report, seen = self.folder / "r.json", {}
        program = subprocess.Popen([GLURAY, "--report", report, CLIENT, mode], stdout=subprocess.DEVNULL)
        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        deadline = time.monotonic() + 60
        while not (seen and enough(seen)) and time.monotonic() < deadline:
            time.sleep(0.02)
            seen = json.loads(report.read_text()) if report.exists() else {}
        program.kill()
        program.wait()
        self.assertEqual([p.name for p in self.folder.iterdir() if not p.name.startswith(".gluray-")], ["r.json"])
        return json.loads(report.read_text())

    def test_single_buffered(self):
        report = self.killed("single", lambda r: r["frames"] > 40)
        self.assertGreater(report["frames"], 40)
        self.assertGreater(report["draws"]["traced"], 3 * 40)

    def test_front_buffer(self):
        report = self.killed("front", lambda r: r["frames"] > 40)
        self.assertGreater(report["frames"], 40)

    def test_nothing_shown(self):
        report = self.killed("unseen", lambda r: r["draws"]["traced"] > 30)
        self.assertGreater(report["draws"]["traced"], 30)
        self.assertEqual(report["frames"], 0)

    def test_the_last_frames_of_short_programs(self):
        for door in ("vendor", "preload"):
            for number in ENDS:
                with self.subTest(signal=number, door=door):
                    report = self.folder / f"{door}{number}.json"
                    done = gluray("--door", door, "--report", report, CLIENT, "killed", int(number), cwd=self.folder)
                    self.assertEqual(done.returncode, -number, done.stderr)
                    self.assertEqual(json.loads(report.read_text())["frames"], 5)

    def test_what_nobody_has_shown(self):
        for number in ENDS:
            with self.subTest(signal=number):
                report = self.folder / f"{number}.json"
                done = gluray("--report", report, CLIENT, "unshown", int(number), cwd=self.folder)
                self.assertEqual(done.returncode, -number, done.stderr)
                found = json.loads(report.read_text())
                self.assertEqual((found["frames"], found["draws"]["traced"]), (0, 3))

    def test_signals_stay_the_programs(self):
        words = ("--report", self.folder / "r.json", CLIENT, "signals")
        handlers = [[line for line in gluray(*more, *words).stdout.splitlines() if line.startswith("signal")]
                    for more in ((), ("--off",))]
        self.assertGreater(len(handlers[0]), 30)
        self.assertEqual(handlers[0], handlers[1])

    def test_explained_to_a_sudden_end(self):
        for number in ENDS:
            with self.subTest(signal=number):
                all = explained("--frames", 1000, CLIENT, "killed", int(number), cwd=self.folder)
                self.assertEqual(all["ending"], f"it ended by signal {int(number)} ({signal.strsignal(number)})")
                [process] = all["processes"]
                self.assertEqual(process["frames"], 5)
                kinds = {(k["primitive"], k["path"]): k for k in process["explain"]["kinds"]}
                self.assertEqual(kinds["surfaces", "elements"]["count"], 5)
                self.assertTrue(kinds["surfaces", "elements"]["traced"])

    def test_explained(self):
        [process] = explained("--frames", 25, CLIENT, "front")["processes"]
        self.assertEqual(process["frames"], 25)
        [context] = process["explain"]["contexts"]
        self.assertEqual((context["frames"], context["doubleBuffered"], context["swaps"]), (25, True, False))
        for mode in ("front", "unseen"):
            [process] = explained("--frames", 10000, "--seconds", 3, CLIENT, mode)["processes"]
            kinds = {(k["primitive"], k["path"]): k for k in process["explain"]["kinds"]}
            self.assertGreater(kinds["surfaces", "elements"]["count"], 10)
            self.assertTrue(kinds["surfaces", "elements"]["traced"])


class WalkedPast(unittest.TestCase):
    def test_nothing_is_said_where_no_call_goes_past(self):
        for door in ("vendor", "preload"):
            [process] = explained("--frames", 3, "--door", door, CLIENT)["processes"]
            self.assertEqual(process["walkedPast"], "")
        self.assertNotIn("bypass", gluray("explain", "--frames", 3, CLIENT).stdout)

    def test_a_driver_that_is_preloaded(self):
        driver = subprocess.run(["sh", "-c", "LD_PRELOAD=libGLX_mesa.so.0 ldd /bin/true"], capture_output=True, text=True).stdout
        library = re.search(r"(/\S*libGLX_mesa\.so\S*)", driver)
        names = subprocess.run(["nm", "-D", library.group(1)], capture_output=True, text=True).stdout if library else ""
        if " glDrawArrays\n" not in names:
            self.skipTest("there is no driver that exports gl functions")
        host = [CLIENTS.parent / "doors" / "door_host", next((CLIENTS.parent / "doors").glob("libdoor_plugin.so")), "lazy"]
        done = gluray("explain", "--", *host, LD_PRELOAD=library.group(1))
        self.assertIn("calls that bypass GLuRay", done.stdout, done.stderr)
        self.assertIn("libGLX_mesa", done.stdout)
        said = gluray("doctor", LD_PRELOAD=library.group(1))
        self.assertEqual(said.returncode, 1, said.stdout)
        self.assertIn("bypassed", said.stdout)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
