"""Every scene in a window, with and without GLuRay: through_a_door.py GLURAY PLAYER DOOR FOLDER."""
import json
import pathlib
import shutil
import subprocess
import sys

gluray, player, door, folder = sys.argv[1:]
out = pathlib.Path(folder)
shutil.rmtree(out, ignore_errors=True)
(out / "real").mkdir(parents=True)
(out / "traced").mkdir()
report = out / "report.json"

subprocess.run([player, "--out", out / "real"], check=True)
subprocess.run([gluray, "--door", door, "--shading", "vertex", "--report", report, "--", player, "--out", out / "traced"],
               check=True)
draws = json.loads(report.read_text())["draws"]
print(f"through the {door} door: {draws['traced']} draws traced, {sum(draws['rasterised'].values())} rasterised")
code = subprocess.run([player, "--compare", out / "real", out / "traced"]).returncode
if draws["traced"] < 500:
    sys.exit("hardly anything was traced")
sys.exit(code)
