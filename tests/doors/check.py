"""Runs a door test program through a door and checks that GLuRay saw every one of its calls.

    check.py [options] -- PROGRAM [ARGUMENTS]

The program draws in rounds of ten frames (tests/doors/programs/workload.h): 20 queries and 50 triangles a frame. It must end well,
print no message of GLuRay, and the report must count each call.
"""
from __future__ import annotations

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402

FRAMES, TRIANGLES, QUERIES = 10, 50, 20


def launch(options: argparse.Namespace, report: str) -> list[str]:
    if options.door == "both":
        return [options.gluray, "--door", "vendor", "--report", report, "--", options.gluray, "--door", "preload", "--"]
    return [options.gluray, "--door", options.door, "--report", report, "--"]


def main() -> int:
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--door", choices=["auto", "vendor", "preload", "both"], required=True)
    parser.add_argument("--rounds", type=int, default=1, help="how many times the program draws its ten frames")
    parser.add_argument("--contexts", type=int, default=1)
    parser.add_argument("--more-triangles", type=int, default=0, help="triangles beyond those of the rounds")
    parser.add_argument("--more-queries", type=int, default=0)
    parser.add_argument("program", nargs="+")
    options = parser.parse_args()

    problems = []
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report.json")
        run = subprocess.run(launch(options, str(report)) + options.program, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=100)
        seen = json.loads(report.read_text()) if report.exists() else {}
    if run.returncode != 0:
        problems.append(f"exit code {run.returncode}")
    if "gluray" in run.stderr:
        problems.append("GLuRay spoke on stderr")
    triangles = seen.get("triangles", {})
    expected = {
        "contexts": (options.contexts, seen.get("contexts")),
        "frames": (options.rounds * FRAMES, seen.get("frames")),
        "triangles": (options.rounds * FRAMES * TRIANGLES + options.more_triangles,
                      triangles.get("traced", 0) + triangles.get("rasterised", 0)),
        "glIsTexture": (options.rounds * FRAMES * QUERIES + options.more_queries,
                        seen.get("unknownCalls", {}).get("glIsTexture")),
    }
    problems += [f"{name}: {want} made, {got} seen" for name, (want, got) in expected.items() if want != got]
    if problems:
        print("\n".join(problems), file=sys.stderr)
        print(run.stdout, run.stderr, json.dumps(seen, indent=1), sep="\n", file=sys.stderr)
        return 1
    print(f"{seen['door']} door, {seen['gl']['renderer']}: " +
          ", ".join(f"{want} {name}" for name, (want, _) in expected.items()) +
          f"; {triangles['traced']} triangles traced")
    return 0


if __name__ == "__main__":
    sys.exit(main())
