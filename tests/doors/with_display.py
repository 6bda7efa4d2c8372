"""Runs a command with an X server of its own. Small scenes are traced, too, unless GLURAY_ENGINE says otherwise; no results of trials are kept."""
import os
import pathlib
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402

parser = Parser(__doc__, usage="with_display.py COMMAND [ARGUMENTS]")
parser.add_argument("command", help="its arguments follow it")
parser.parse_args(sys.argv[1:2])
reading, writing = os.pipe()
server = subprocess.Popen(["Xvfb", "-noreset", "-displayfd", str(writing), "-screen", "0", "1280x1024x24"],
                          pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
os.close(writing)
try:
    number = os.read(reading, 16).decode().strip()
    if not number:
        sys.exit("with_display.py: Xvfb did not start")
    os.environ["DISPLAY"] = f":{number}"
    os.environ.setdefault("GLURAY_ENGINE", "always")
    os.environ.setdefault("GLURAY_REMEMBER_ENGINE", "off")
    code = subprocess.run(sys.argv[1:]).returncode
finally:
    server.terminate()
    server.wait()
sys.exit(code)
