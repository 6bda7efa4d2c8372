/* Prevents calls from bypassing the vendor door. Mesa's GLX library exports gl* functions and makes itself
   global before it loads its driver. If the program does not link libGL, the dynamic linker then binds the
   gl* functions of plug-ins, JNI or Python modules to Mesa's, so that they bypass libglvnd and GLuRay.
   Therefore libglvnd's libGL and libOpenGL are made global first (docs/adr/0031). libc only, any thread. */
#pragma once

/* Call before any call of the real vendor that loads its driver. `vendor`: the vendor's handle. Does nothing
   if the vendor exports no gl* functions. */
void glurayDispatchFirst(void* vendor);
