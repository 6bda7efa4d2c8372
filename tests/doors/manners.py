"""Shared by the tests of manners, whose arguments are GLURAY LIBRARY_DIRECTORY CLIENTS_DIRECTORY [unittest arguments]."""
from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

GLURAY, LIBRARIES, CLIENTS = (pathlib.Path(p) for p in sys.argv[1:4])


def run(*words, **environment) -> subprocess.CompletedProcess:
    variables = dict(os.environ) | {k: str(v) for k, v in environment.items() if v is not None}
    for name in (k for k, v in environment.items() if v is None):
        variables.pop(name, None)
    return subprocess.run([str(w) for w in words], env=variables, capture_output=True, text=True, timeout=100)


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
