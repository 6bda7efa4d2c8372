"""Pictures by PyMOL, in its window."""
import pathlib
import sys
import tempfile

import pymol

import scene_list

HELIX = "fab ACDEFGHIKLMNPQRSTVWY, p, ss=1"


def shown(*commands):
    """`commands`: of PyMOL, for a short helix."""
    def draw(file):
        with tempfile.TemporaryDirectory() as folder:
            script = pathlib.Path(folder) / "scene.pml"
            script.write_text("\n".join([HELIX, "set internal_gui, 0", "set internal_feedback, 0", "bg_color grey80", "orient", "turn y, 30", *commands, "draw 500, 400", f"png {file}", "quit"]))
            pymol.launch(["pymol", "-q", str(script)])  # ends the process
    return draw


SCENES = {
    "cartoon": shown("show_as cartoon"),
    "cartoon, spectrum": shown("show_as cartoon", "spectrum count"),
    "cartoon, opacity": shown("show_as cartoon", "set cartoon_transparency, 0.5"),
    "cartoon, no depth cue": shown("show_as cartoon", "set depth_cue, 0"),
    "cartoon, orthoscopic": shown("show_as cartoon", "set orthoscopic, 1"),
    "surface": shown("show_as surface"),
    "surface, coloured": shown("show_as surface", "util.cbc"),
    "surface, opacity": shown("show_as surface", "set transparency, 0.4"),
    "surface and cartoon": shown("show_as cartoon", "show surface", "set transparency, 0.6"),
    "spheres": shown("show_as spheres"),
    "sticks": shown("show_as sticks", "zoom resi 9-11"),
    "balls and sticks": shown("preset.ball_and_stick('p')", "zoom resi 9-11"),
    "lines": shown("show_as lines"),
    "mesh": shown("show_as mesh"),
    "dots": shown("show_as dots"),
    "labels": shown("show_as cartoon", "label name CA, resn"),
    "two lights": shown("show_as cartoon", "set light_count, 4"),
}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
