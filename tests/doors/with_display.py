"""Runs a command with an X server of its own: with_display.py COMMAND [ARGUMENTS]. Small scenes are traced, too,
unless GLURAY_ENGINE says otherwise."""
import os
import subprocess
import sys

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
    code = subprocess.run(sys.argv[1:]).returncode
finally:
    server.terminate()
    server.wait()
sys.exit(code)
