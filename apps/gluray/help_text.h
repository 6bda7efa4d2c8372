// What `gluray --help` prints below the options: examples and commands.
#pragma once

namespace gluray::launcher {

inline constexpr const char* kExamples = R"(
Examples:
  gluray glxgears
  gluray osgviewer head.obj
  gluray --report run.json -- meshlab model.ply    write a report of what was traced
  gluray --off osgviewer head.obj                  the real OpenGL, for comparison
  gluray --threads 4 --bvh least paraview          four threads, least memory
  gluray explain --html page.html glxgears         which draws were traced, and why others were not
  gluray --shot last.png --quit paraview           save a picture when the program is idle
  gluray doctor osgviewer                          check whether it can be traced, without starting it

Commands, each with its own --help:
  gluray run PROGRAM       the same as gluray PROGRAM
  gluray explain PROGRAM   a table of the program's draws; with --html also a page with images
  gluray doctor [PROGRAM]  how the program reaches OpenGL, and what this machine supports;
                           with --job the ranks and hosts of a gluray-worker job
  gluray quirks            workarounds for OpenGL implementations, and how to switch them
  gluray settings          all settings with their values and where these come from
  gluray get NAME          the value of a setting; with --why its value in each layer
  gluray presets           named sets of settings and their contents
  gluray report-bug        write an archive for a bug report
  gluray uninstall         list the files outside the folder of GLuRay, and how to remove it
  gluray environment       variables for shells and batch jobs whose programs are to run under GLuRay

Commands for running programs:
  gluray panel             a window with all programs and their settings
  gluray list              all running programs
  gluray set NAME=VALUE    change settings; also: gluray unset NAME, gluray preset NAME
  gluray undo              undo the last change; gluray redo repeats it
  gluray get --live NAME   the value of a setting in the running programs
  gluray watch             print changes of settings, and programs that start or end
  gluray top               what programs and the ranks of MPI programs spend, once a second
  gluray shot FILE.png     save the image of a program's window; with --size in any size
  gluray save FILE         save what a program shows as a scene (.gluray), glTF (.glb), .obj or .ply
  gluray film FILE.png     save the next frames of a window as numbered images
  gluray hub               pass messages between running programs and these commands

Commands for the scenes of running programs:
  gluray objects           list the objects with shape, color and material
  gluray pick X Y          print the object at a point of the window
  gluray material 3 glass  change the material of single objects; --hide hides them
  gluray light             list the lights; gluray light azimuth=30 changes them
  gluray camera            list the cameras; gluray camera focus X Y focuses on a surface

Pictures of saved scenes:
  gluray render SCENE.gluray FILE.png   render a picture of any size; FILE.exr: OpenEXR
  gluray render SCENE - --y4m --turntable 90 | ffmpeg -i - turn.mp4   a film; also along a --path
  gluray render --again FILE.png        repeat the command that made the picture
  gluray view SCENE.gluray              show it in a window: turn it, choose a look, save pictures
  gluray export SCENE.gluray FILE       convert it to glTF (.glb), .obj or .ply

After a run:
  gluray timeline FILE     print the work of each thread in a run with --timeline FILE

To start a program whose name is a command, such as watch: gluray run watch, or gluray -- watch.
The exit code is that of the program;
127: program not found, 126: program cannot be executed, 2: wrong usage.)";

}  // namespace gluray::launcher
