"""Scenes in a window, with and without GLuRay: through_a_door.py GLURAY DOOR FOLDER LEAST PLAYER [SCENES ...].

PLAYER --out FOLDER SCENES... draws them, PLAYER --compare EXPECTED GOT SCENES... compares. LEAST: so many draws must be traced.
"""
import json
import pathlib
import shutil
import subprocess
import sys

gluray, door, folder, least, player, *scenes = sys.argv[1:]
out = pathlib.Path(folder)
shutil.rmtree(out, ignore_errors=True)
(out / "real").mkdir(parents=True)
(out / "traced").mkdir()
report = out / "report.json"

subprocess.run([player, "--out", out / "real", *scenes], check=True)
subprocess.run([gluray, "--door", door, "--shading", "vertex", "--report", report, "--", player, "--out", out / "traced", *scenes],
               check=True)
draws = json.loads(report.read_text())["draws"]
print(f"through the {door} door: {draws['traced']} draws traced, {sum(draws['rasterised'].values())} rasterised")
code = subprocess.run([player, "--compare", out / "real", out / "traced", *scenes]).returncode
if draws["traced"] < int(least):
    sys.exit("hardly anything was traced")
sys.exit(code)
