"""Command lines of the repository's Python scripts: `--help` prints the usage; unknown options are refused.

Scripts import it from their own folder, or after sys.path.append(".../tools"): at the front of the path, modules of tools/ would
hide others of their names.
"""
from __future__ import annotations

import argparse
import re
import sys

NEGATIVE_NUMBER = re.compile(r"-\.?\d")


class Parser(argparse.ArgumentParser):
    """A parser that describes each error in one line on standard error and exits with code 2. It reports an unknown option before
    all other errors, and names the options that there are. Options cannot be abbreviated."""

    def __init__(self, description: str, **settings):
        super().__init__(description=description, formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False, **settings)

    def parse_args(self, args=None, namespace=None):
        words = sys.argv[1:] if args is None else list(args)
        known = {name for action in self._actions for name in action.option_strings}
        for word in words[:words.index("--")] if "--" in words else words:
            name = word.split("=", 1)[0]
            if name.startswith("-") and name != "-" and name not in known and not NEGATIVE_NUMBER.match(name):
                self.exit(2, f"{self.prog}: unknown option '{name}'; {self._choices()}\n")
        return super().parse_args(words, namespace)

    def error(self, message: str):
        self.exit(2, f"{self.prog}: {message}; see {self.prog} --help\n")

    def _choices(self) -> str:
        shown = [action for action in self._actions if action.help is not argparse.SUPPRESS and action.dest != "help"]
        options = [action.option_strings[-1] for action in shown if action.option_strings]
        others = [str(action.metavar or action.dest.upper()) for action in shown if not action.option_strings]
        return f"use {', '.join(options) or ' '.join(others)} or --help"
