/* Keeps the vendor door from being walked past. Mesa's GLX library exports gl* functions and makes itself
   global before it loads its driver. Where the program does not link libGL, the dynamic linker then binds the
   gl* functions that plug-ins, JNI or Python modules link to Mesa's, past libglvnd and past us. So
   libglvnd's libGL and libOpenGL are made global first (docs/adr/0031). libc only, any thread. */
#pragma once

/* Called before the real vendor is asked anything that needs its driver; `vendor` is its handle. Does nothing
   where the vendor exports no gl* function that could be bound. */
void glurayDispatchFirst(void* vendor);
