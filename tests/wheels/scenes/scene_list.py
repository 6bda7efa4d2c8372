"""The command line of a list of scenes: SCENES.py --list, or SCENES.py NAME FILE."""
import sys


def main(scenes, doc):
    """`scenes`: functions by name; each draws its picture into a PNG file, whose path it gets."""
    if sys.argv[1:] == ["--list"]:
        print("\n".join(scenes))
        return 0
    if len(sys.argv) != 3 or sys.argv[1] not in scenes:
        print(f"{doc}\nusage: {sys.argv[0]} --list | NAME FILE, with a NAME of: {', '.join(scenes)}", file=sys.stderr)
        return 2
    scenes[sys.argv[1]](sys.argv[2])
    return 0
