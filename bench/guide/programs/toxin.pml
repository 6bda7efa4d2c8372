# Heat-labile enterotoxin of E. coli (1TII), of PyMOL's own data, as a cartoon with each chain in a colour of its own.
set internal_gui, 0
set internal_feedback, 0
set auto_show_classified, 0
load /usr/share/pymol/data/demo/1tii.pdb
hide everything
show cartoon
set cartoon_fancy_helices, 1
set cartoon_sampling, 14
color salmon, chain A
color wheat, chain C
color skyblue, chain D
color palegreen, chain E
color lightorange, chain F
color lightblue, chain G
color paleyellow, chain H
bg_color white
set depth_cue, 0
orient
zoom all, -3
viewport 680, 540
