"""Commands for running programs, with a hub that only pretends: cli_test.py GLURAY."""
import json
import os
import signal
import subprocess
import sys
import time
import unittest

from cli_case import GLURAY, CliCase
from memory_hub import IMAGE, FakeProgram, line_of, image_of, seek_hub

ALONE = "no program runs under GLuRay; start one with: gluray PROGRAM"
SILENT = "the hub does not answer; end it, and start gluray hub"


class Cli(CliCase):
    def test_list(self):
        self.two()
        self.assertEqual(self.output("list").split("\n")[1].split()[:3], ["1", "paraview", "4242"])
        self.assertIn("2025-11-24 16:00:00", self.output("list"))
        self.assertEqual([(p["program"], p["name"], p["pid"], p["ranks"]) for p in json.loads(self.output("list", "--json"))],
                         [(1, "paraview", 4242, 1), (2, "vmd", 77, 1)])

    def test_set(self):
        _, first, _ = self.two()
        self.assertEqual(self.output("set", "ao=on", "ao.samples=8"), "paraview (4242): ao = true, ao.samples = 8 from frame 1042\n"
                                                                      "vmd (77): ao = true, ao.samples = 8 from its next frame\n")
        self.assertEqual(first.live, {"ao": True, "ao.samples": 8})
        self.assertEqual(json.loads(self.output("set", "--json", "-p", "2", "spp=4")),
                         [{"program": 2, "name": "vmd", "pid": 77, "frame": None, "values": {"spp": 4}}])
        self.output("set", "-p1", "report=", "environment.color=#ff0000", "--reset", "ao")
        self.assertEqual(first.live, {"ao.samples": 8, "report": "", "environment.color": first.live["environment.color"]})
        self.output("unset", "report", "environment.color", "ao.samples")
        self.assertEqual(first.live, {})
        self.assertEqual(self.output("preset", "-p", "paraview", "draft"), "paraview (4242): preset = draft from frame 1042\n")

    def test_files_are_named_absolutely(self):
        _, first, _ = self.two()
        (self.folder / "sky.hdr").touch()
        self.output("set", "environment.file=sky.hdr")
        self.assertEqual(first.live, {"environment.file": str(self.folder.resolve() / "sky.hdr")})

    def test_ranks_that_were_late_are_named(self):
        hub, *_ = self.two()
        hub.instead["set"] = {"results": [{"program": 1, "frame": 7, "values": {"spp": 2}, "late": [1, 3]}]}
        self.assertEqual(self.output("set", "-p", "1", "spp=2"), "paraview (4242): spp = 2 from frame 7 (later on rank 1, 3)\n")

    def test_undo_and_redo(self):
        self.two()
        self.output("set", "spp=4")
        self.assertEqual(self.output("undo", "-p", "paraview"), "paraview (4242): spp = 1 from frame 1042\n")
        self.assertEqual(json.loads(self.output("redo", "-p", "1", "--json"))[0]["values"], {"spp": 4})
        self.assertEqual(self.failure("redo", "-p", "1"), "paraview (4242): there is nothing to redo")

    def test_programs_are_named_by_number_process_and_name(self):
        hub, *_ = self.two()
        hub.add("vmd", 1)
        for word, pids in (("1", [4242]), ("77", [77]), ("vmd", [77, 1]), ("all", [4242, 77, 1])):
            done = json.loads(self.output("set", "--json", "-p", word, "spp=4"))
            self.assertEqual([one["pid"] for one in done], pids)
        self.assertEqual(self.failure("set", "-p", "99", "spp=4"), "no program has the number or process id 99; gluray list shows them")
        self.assertEqual(self.failure("set", "-p", "paravew", "spp=4"), "no running program is called 'paravew'; did you mean 'paraview'?")

    def test_wrong_names_and_values(self):
        hub, *_ = self.two()
        for words, line in ((("set", "ao.sample=1"), "no setting is called 'ao.sample'; did you mean 'ao.samples'?"), (("set", "ao"), "ao: use NAME=VALUE"),
                            (("set", "ao.samples=0"), "ao.samples = 0: use a number from 1 to 4096"), (("set", "bvh="), "bvh = : use auto, fast"),
                            (("set",), "no setting given"), (("unset", "spq"), "did you mean 'spp'?"), (("set", "--reset", "spq"), "did you mean 'spp'?"),
                            (("unset",), "NAME"), (("preset",), "NAME"), (("undo", "spp"), "spp"), (("set", "spp=4", "--all"), "--all"),
                            (("get", "--live", "spq"), "did you mean 'spp'?"), (("watch", "spq"), "did you mean 'spp'?"), (("watch", "--seconds", "-1"), "--seconds"),
                            (("set", "lights.file=nowhere"), "nowhere")):
            self.assertIn(line, self.failure(*words, code=2))
        self.assertEqual(hub.requests, [])

    def test_programs_refuse(self):
        _, first, _ = self.two()
        first.refuses["spp"] = "spp: not \x1b[31mnow"
        done = self.run_gluray("set", "spp=4")
        self.assertEqual((done.returncode, done.stdout, done.stderr),
                         (1, "vmd (77): spp = 4 from its next frame\n", "gluray: paraview (4242): spp: not \\x1b[31mnow\n"))
        self.assertEqual(json.loads(self.run_gluray("set", "--json", "spp=4").stdout)[0],
                         {"program": 1, "name": "paraview", "pid": 4242, "why": "spp: not \x1b[31mnow"})

    def test_shot(self):
        _, first, _ = self.two()
        self.assertIn("choose one with -p", self.failure("shot", "a.png"))
        self.assertEqual(self.output("shot", "-p", "paraview", "a.png"), "paraview (4242): a.png, 5 x 3\n")
        self.assertEqual(image_of(self.folder / "a.png"), (5, 3, IMAGE))
        found = json.loads(self.output("shot", "-p", "1", "--json", "a.png"))  # replaces it
        self.assertEqual(found, {"program": 1, "name": "paraview", "pid": 4242, "frame": 1042, "file": "a.png", "width": 5, "height": 3})
        first.no_image = "its windows have shown no frame for 8 seconds"
        self.assertEqual(self.failure("shot", "-p", "1", "b.png"), "paraview (4242): its windows have shown no frame for 8 seconds")
        self.assertFalse((self.folder / "b.png").exists())

    def test_shots_replace_images_alone(self):
        hub, *_ = self.two()
        (self.folder / "notes.png").write_text("notes")
        (self.folder / "folder.png").mkdir()
        (self.folder / "link.png").symlink_to("notes.png")
        for name in ("notes.png", "folder.png", "link.png"):
            self.assertIn("is no PNG file", self.failure("shot", "-p", "1", name, code=2))
        for words in (("a.jpg",), (".png",), ()):
            self.failure("shot", *words, code=2)
        self.assertIn("No such file", self.failure("shot", "-p", "1", "nowhere/a.png"))
        self.assertEqual((self.folder / "notes.png").read_text(), "notes")
        self.assertTrue((self.folder / "link.png").is_symlink())

    def test_wrong_shots(self):
        hub, *_ = self.two()
        size = {"shot": 1, "width": 5, "height": 3}
        for value in (3, {}, size | {"width": 0}, size | {"width": 1 << 40}, size | {"height": -3}, size | {"height": "3"},
                      size | {"rows": 4, "pixels": ""}, size | {"rows": 3, "pixels": "AAAA"}, size | {"rows": 1, "pixels": "?"}):
            hub.instead["call"] = {"results": [{"program": 1, "value": value}]}
            self.assertEqual(self.failure("shot", "-p", "1", "a.png"), "paraview (4242): it sends no image", value)
        self.assertFalse((self.folder / "a.png").exists())

    def test_get(self):
        self.two()
        self.output("set", "-p", "1", "ao=on")
        self.assertEqual(self.output("get", "-p", "1", "ao"), "true\n")
        self.assertEqual(self.output("get", "-p", "1", "report"), "\n")
        self.assertEqual(self.output("get", "ao"), "false\n")
        self.assertEqual(self.output("get", "--live"), "paraview (4242): ao = true\n")
        self.assertEqual(self.output("get", "--live", "ao", "spp"),
                         "paraview (4242): ao = true\nparaview (4242): spp = 1\nvmd (77): ao = false\nvmd (77): spp = 1\n")
        self.assertEqual(self.output("get", "-p", "1", "--why", "ao"), "ao = true  (live)\n  built-in  false\n  live      true\n")
        self.assertEqual(json.loads(self.output("get", "-p", "1", "--json")),
                         [{"program": 1, "name": "paraview", "pid": 4242, "values": {"ao": {"value": True, "layer": "live", "place": ""}}}])

    def test_no_program(self):
        self.hub()
        for words in (["list"], ["set", "spp=4"], ["undo"], ["top", "--once"], ["top"], ["get", "--live"], ["get", "-p", "all"]):
            self.assertEqual(self.failure(*words), ALONE)
        self.assertEqual(self.run_gluray("list", "--json").stdout, "[]\n")

    def test_no_hub(self):
        begin = time.monotonic()
        self.assertEqual(self.failure("set", "spp=4"), ALONE)
        self.assertLess(time.monotonic() - begin, 10)
        self.assertFalse((self.folder / "run/hub.sock").exists())

    def test_without_a_hub_commands_are_one(self):
        program = FakeProgram(1, "paraview", 4242, self.ROWS)
        end = seek_hub(program, self.folder / "run")
        self.addCleanup(end)
        self.assertEqual(self.output("set", "spp=4", "ao=on"), "paraview (4242): ao = true, spp = 4 from frame 1042\n")
        self.assertEqual(self.output("get", "--live"), "ao = true\nspp = 4\n")
        self.assertEqual(self.output("undo"), "paraview (4242): ao = false, spp = 1 from frame 1042\n")
        program.refuses["spp"] = "spp: not now"
        self.assertEqual(self.failure("set", "spp=2"), "paraview (4242): spp: not now")
        self.assertFalse((self.folder / "run/hub.sock").exists())
        watch = self.watch()
        time.sleep(1.5)  # the longest that it waits for programs
        self.assertIn("paraview", self.output("list"))
        end()
        self.assertEqual(watch.stdout.readline(), "paraview (4242): ended\n")
        watch.send_signal(signal.SIGINT)
        self.assertEqual(watch.wait(20), 0)

    def test_commands_at_once_share_a_hub(self):
        for number in range(1, 6):
            program = FakeProgram(number, "paraview", 4242, self.ROWS)
            end = seek_hub(program, self.folder / "run")
            self.addCleanup(end)
            commands = [subprocess.Popen([GLURAY, "set", f"spp={n}"], env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) for n in range(2, 6)]
            for n, command in enumerate(commands, 2):
                out, error = command.communicate(timeout=60)
                self.assertEqual((out, error, command.returncode), (f"paraview (4242): spp = {n} from frame 1042\n", "", 0))
            end()

    def test_a_command_that_is_the_hub_waits_for_others(self):
        program = FakeProgram(1, "paraview", 4242, self.ROWS)
        self.addCleanup(seek_hub(program, self.folder / "run"))
        first = self.watch()
        time.sleep(1.5)
        second = self.watch("--seconds", "2")
        time.sleep(0.5)
        first.send_signal(signal.SIGINT)
        self.assertEqual(second.wait(20), 0)
        self.assertEqual(first.wait(20), 0)
        self.assertFalse((self.folder / "run/hub.sock").exists())

    def test_unsafe_directories_are_refused(self):
        (self.folder / "run").mkdir(mode=0o755)
        self.assertIn("run chmod 700", self.failure("list"))

    def test_hubs_that_fail(self):
        for instead, line in (("end", "the connection to the hub ended: the other side closed it"), ("garbage", "is not JSON"),
                              ({"why": "the hub is\nbusy"}, "the hub is\\nbusy"), ({}, "the hub's answer has no results"),
                              ({"results": [3, {"program": "x"}]}, "it does not answer"), ({"results": [{"program": 1, "why": 3}]}, "does not say why")):
            hub = self.hub()
            hub.add("paraview", 4242)
            hub.instead["set"] = instead
            self.assertIn(line, self.failure("set", "spp=4"))
            hub.end()

    def test_odd_answers_break_nothing(self):
        hub = self.hub()
        hub.add("paraview", 4242)
        hub.instead["set"] = {"results": [{"program": 1, "frame": "soon", "values": [3], "late": 7}]}
        self.assertEqual(self.output("set", "spp=4"), "paraview (4242):  from its next frame\n")
        hub.instead["get"] = {"results": [{"program": 1, "values": {"spp": 3, "ao": {"value": {"x": 1}, "layers": [1, {}]}, "new": {"value": [1]}}}]}
        self.assertEqual(self.output("get", "--live", "--why"), "ao = -  (-)\n  -  -\nnew = [1]  (-)\n")
        hub.instead["list"] = {"programs": [3, {"program": "one"}, {"program": 1, "name": 7, "pid": "x", "since": 1e300}]}
        self.assertEqual(self.output("list").split("\n")[1].split(), ["1", "0", "1", "-"])

    def test_hubs_that_never_answer(self):
        hub = self.hub()
        hub.add("paraview", 4242)
        hub.instead["list"] = "silence"
        begin = time.monotonic()
        self.assertEqual(self.failure("set", "spp=4"), SILENT)
        self.assertLess(time.monotonic() - begin, 10)

    def test_other_listeners_are_refused(self):
        for hello, line in ((line_of({"type": "hello", "version": 0, "role": "hub"}), "no hub of GLuRay"), (b"SSH-2.0-OpenSSH_9.2\n", "not JSON"),
                            (line_of({"type": "error", "why": "the hub is full"}), "the hub is full")):
            hub = self.hub(hello=hello)
            self.assertIn(line, self.failure("list"))
            hub.end()

    def test_programs_with_the_names_of_commands(self):
        (self.folder / "watch").write_text("#!/bin/sh\necho it runs\n")
        (self.folder / "watch").chmod(0o755)
        self.environment["PATH"] = f"{self.folder}:{os.environ['PATH']}"
        for words in (("--", "watch"), ("run", "watch"), ("./watch",)):
            self.assertEqual(self.run_gluray(*words).stdout, "it runs\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
