"""Shared by the tests of gluray explain, whose arguments are GLURAY CLIENTS_DIRECTORY [unittest arguments].

The client's frame (client.c): 2 triangles by glBegin, 6 in a list and 200 by glDrawElements, all traced; 3 blended and
stippled quads by glDrawArrays; 4 lines. Traced are 128 x 128 + 3 x 20 x 20 + 64 x 64 pixels, of which 32 x 32 are blended over.
"""
from __future__ import annotations

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

GLURAY, CLIENTS = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
CLIENT = CLIENTS / "explain_client"
TRACED_PIXELS, GLASS_PIXELS = 128 * 128 + 3 * 20 * 20 + 64 * 64, 32 * 32


def gluray(*words, cwd=None, **environment):
    return subprocess.run([str(GLURAY), *map(str, words)], env={**os.environ, **environment}, capture_output=True,
                          text=True, timeout=100, cwd=cwd)


def explained(*words, cwd=None, **environment):
    done = gluray("explain", "--json", *words, cwd=cwd, **environment)
    if done.returncode != 0:
        raise AssertionError(f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return json.loads(done.stdout)


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
