"""An amino acid's spheres and sticks, run by PyMOL. PYMOL_SETTINGS: further settings, "NAME VALUE" separated by commas."""
import os

from pymol import cmd

cmd.viewport(600, 600)
cmd.fragment("trp")
cmd.hide("everything")
cmd.show("sticks")
cmd.show("spheres")
cmd.set("sphere_scale", 0.25)
cmd.bg_color("grey30")
cmd.turn("y", 40)
cmd.zoom("all", -2)  # some of it lies before the near plane
for setting in filter(None, os.environ.get("PYMOL_SETTINGS", "").split(",")):
    cmd.set(*setting.split())
