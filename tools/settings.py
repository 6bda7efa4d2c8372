"""Generates from spec/settings.toml everything that names a setting.

    python3 tools/settings.py OUTPUT_DIR                 the C++ headers, below OUTPUT_DIR/settings
    python3 tools/settings.py --pages ROOT               completions, man pages and docs/settings.md below ROOT
    python3 tools/settings.py --check ROOT               fails where one of those is stale
    --spec FILE                                          reads FILE instead of spec/settings.toml

Files are only rewritten when their content changes, so that builds stay incremental.
"""
from __future__ import annotations

import pathlib
import sys

import command_line
import settings_cpp
import settings_pages
import settings_rows


def write(path: pathlib.Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def main() -> int:
    parser = command_line.Parser(__doc__)
    parser.add_argument("out", nargs="?", type=pathlib.Path)
    parser.add_argument("--pages", type=pathlib.Path, metavar="ROOT")
    parser.add_argument("--check", type=pathlib.Path, metavar="ROOT")
    parser.add_argument("--spec", type=pathlib.Path, default=settings_rows.SPEC)
    options = parser.parse_args()
    if not (options.out or options.pages or options.check):
        parser.error("nothing to do: name OUTPUT_DIR, --pages ROOT or --check ROOT")
    rows = settings_rows.read(options.spec)
    if options.out:
        write(options.out / "settings/settings.gen.h", settings_cpp.structs(rows))
        write(options.out / "settings/rows.gen.h", settings_cpp.table(rows))
    stale = []
    for root in (options.pages, options.check):
        for name, text in settings_pages.pages(rows, root) if root else ():
            if root is options.pages:
                write(root / name, text)
            elif not (root / name).exists() or (root / name).read_text() != text:
                stale.append(name)
    if stale:
        print(f"stale: {' '.join(stale)}; run python3 tools/settings.py --pages .", file=sys.stderr)
    return 1 if stale else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except settings_rows.SettingsError as error:
        sys.exit(f"settings.py: {error}")
