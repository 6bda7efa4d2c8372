"""An amino acid's surface and sticks, run by PyMOL."""
from pymol import cmd

cmd.viewport(600, 600)
cmd.fragment("trp")
cmd.hide("everything")
cmd.show("surface")
cmd.show("sticks")
cmd.set("surface_quality", 3)
cmd.bg_color("grey30")
cmd.turn("y", 40)
