"""An amino acid's surface and sticks, run by PyMOL. LIVE_DEPTH_CUE=0: without depth cue."""
import os

from pymol import cmd

cmd.viewport(600, 600)
cmd.fragment("trp")
cmd.hide("everything")
cmd.show("surface")
cmd.show("sticks")
cmd.set("surface_quality", 3)
cmd.bg_color("grey30")
cmd.set("depth_cue", int(os.environ.get("LIVE_DEPTH_CUE", "1")))
cmd.turn("y", 40)
