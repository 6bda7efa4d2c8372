"""python -m gluray [OPTIONS] [--] SCRIPT [ARGUMENTS...]: the script under GLuRay, by this Python. OPTIONS are those of gluray."""
import json
import os
import subprocess
import sys

from . import hub


def main(words):
    program = hub.executable()
    if not program:
        return "gluray: the program gluray is not on the PATH; set GLURAY to its path"
    if words and not {"-h", "--help", "--version"} & {words[0]}:
        # Which words are options says the program itself.
        done = subprocess.run([program, "environment", "--json", *words], stdout=subprocess.PIPE, text=True)
        if done.returncode:
            return done.returncode
        script = json.loads(done.stdout)["program"]
        options = [word for word in words[:len(words) - len(script)] if word != "--"]
        words = [*options, "--", sys.executable, *script]
        if not script:
            return "gluray: no script given; use python -m gluray [OPTIONS] SCRIPT"
    os.execv(program, [program, *words])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
