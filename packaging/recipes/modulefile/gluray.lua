-- GLuRay, unpacked from its archive, for Lmod. Copy this file to MODULEPATH/gluray/VERSION.lua and set `root`.
local root = "/opt/gluray-0.1.0-linux-x86_64"

whatis("Ray traces what unmodified OpenGL programs draw: gluray PROGRAM")
conflict("gluray")
prepend_path("PATH", pathJoin(root, "bin"))
prepend_path("MANPATH", pathJoin(root, "share/man"))
prepend_path("PYTHONPATH", pathJoin(root, "lib/python3/dist-packages"))
